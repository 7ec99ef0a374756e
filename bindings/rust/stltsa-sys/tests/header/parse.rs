// SPDX-License-Identifier: BSD-3-Clause
//! Reads declarations out of `stltsa.h` and out of this crate's sources, as far as both go: C's are
//! written the way Rust says them, so that the two can be compared as text.

use std::collections::BTreeMap;

/// A name and its type, in the words of Rust.
pub type Named = (String, String);

/// What a type is.
#[derive(Debug, PartialEq, Eq)]
pub enum Type {
    Opaque,
    Alias(String),
    Struct(Vec<Named>),
    Callback(Signature),
}

#[derive(Debug, PartialEq, Eq)]
pub struct Signature {
    parameters: Vec<Named>,
    result: String,
}

pub struct Header {
    pub functions: BTreeMap<String, Signature>,
    pub types: BTreeMap<String, Type>,
    pub constants: Vec<String>,
}

type Tokens = Vec<String>;

/// Words and single signs; comments are left out.
fn tokens(text: &str) -> Tokens {
    let mut found = Tokens::new();
    let mut rest = text;
    while let Some(sign) = rest.chars().next() {
        let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        let (length, is_token) = if rest.starts_with("/*") {
            (rest.find("*/").expect("a comment ends") + 2, false)
        } else if rest.starts_with("//") {
            (rest.find('\n').unwrap_or(rest.len()), false)
        } else {
            (word.max(sign.len_utf8()), !sign.is_whitespace())
        };
        if is_token {
            found.push(rest[..length].to_owned());
        }
        rest = &rest[length..];
    }
    found
}

/// Position of the first `token` from `from` on.
fn find(tokens: &[String], token: &str, from: usize) -> usize {
    let found = tokens[from..].iter().position(|t| t == token);
    from + found.unwrap_or_else(|| panic!("no {token} in {:?}", &tokens[from..]))
}

fn split<'a>(tokens: &'a [String], separator: &'a str) -> impl Iterator<Item = &'a [String]> {
    tokens.split(move |t| t == separator).filter(|part| !part.is_empty())
}

/// `const char **` is `* mut * const c_char`.
fn type_of_c(tokens: &[String]) -> String {
    let words: Vec<&str> = tokens.iter().map(String::as_str).filter(|t| *t != "*").collect();
    let base = match words.as_slice() {
        ["void"] | ["const", "void"] => "c_void",
        ["char"] | ["const", "char"] => "c_char",
        ["unsigned", "char"] => "u8",
        ["int32_t"] => "i32",
        ["int64_t"] | ["const", "int64_t"] => "i64",
        ["size_t"] => "usize",
        ["double"] => "f64",
        ["const", name] | [name] => name,
        _ => panic!("a type that this test does not know: {words:?}"),
    };
    let stars = tokens.len() - words.len();
    let innermost = if words[0] == "const" { "* const " } else { "* mut " };
    match stars {
        0 => base.to_owned(),
        _ => "* mut ".repeat(stars - 1) + innermost + base,
    }
}

/// `(TYPE NAME, ...)` of C after the parenthesis at `open`.
fn parameters_of_c(tokens: &[String], open: usize) -> Vec<Named> {
    let inside = &tokens[open + 1..find(tokens, ")", open)];
    let named = |parameter: &[String]| {
        let (name, kind) = parameter.split_last().expect("a parameter has a name");
        (name.clone(), type_of_c(kind))
    };
    match inside {
        [only] if only == "void" => Vec::new(),
        _ => split(inside, ",").map(named).collect(),
    }
}

/// `STLTSA_API TYPE NAME(PARAMETERS) STLTSA_NOEXCEPT`
fn function_of_c(declaration: &[String]) -> (String, Signature) {
    let open = find(declaration, "(", 0);
    let parameters = parameters_of_c(declaration, open);
    let result = type_of_c(&declaration[1..open - 1]);
    (declaration[open - 1].clone(), Signature { parameters, result })
}

/// `typedef struct NAME NAME`, `typedef struct NAME { FIELDS } NAME`, `typedef TYPE (*NAME)(...)`,
/// `typedef TYPE NAME`
fn type_of_typedef(declaration: &[String]) -> (String, Type) {
    let last = declaration.last().expect("a name").clone();
    if declaration[1] == "struct" {
        let is_opaque = declaration.len() == 4;
        return (
            last,
            if is_opaque { Type::Opaque } else { Type::Struct(fields_of_c(declaration)) },
        );
    }
    if !declaration.iter().any(|token| token == "(") {
        return (last, Type::Alias(type_of_c(&declaration[1..declaration.len() - 1])));
    }
    let open = find(declaration, "(", 0);
    let close = find(declaration, ")", open);
    let parameters = parameters_of_c(declaration, close + 1);
    let result = type_of_c(&declaration[1..open]);
    (declaration[close - 1].clone(), Type::Callback(Signature { parameters, result }))
}

/// `TYPE A, B;` is two fields.
fn fields_of_c(declaration: &[String]) -> Vec<Named> {
    let inside = &declaration[find(declaration, "{", 0) + 1..find(declaration, "}", 0)];
    let mut fields = Vec::new();
    for line in split(inside, ";") {
        let mut names = split(line, ",");
        let (first, kind) = names.next().and_then(<[String]>::split_last).expect("a field");
        let others = names.map(|name| &name[0]);
        fields.extend(std::iter::once(first).chain(others).map(|n| (n.clone(), type_of_c(kind))));
    }
    fields
}

/// Declarations end with a `;` that is not inside braces.
fn declarations(tokens: &[String]) -> Vec<&[String]> {
    let (mut found, mut begin, mut depth) = (Vec::new(), 0, 0);
    for (i, token) in tokens.iter().enumerate() {
        match token.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            ";" if depth == 0 => {
                found.push(&tokens[begin..i]);
                begin = i + 1;
            }
            _ => {}
        }
    }
    found
}

pub fn header(text: &str) -> Header {
    let mut code = String::new();
    let mut constants = Vec::new();
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("#define STLTSA_VERSION_") {
            constants.push(format!("STLTSA_VERSION_{}", name.split(' ').next().expect("a name")));
        }
        let of_preprocessor = line.starts_with('#') || line.starts_with("extern \"C\"");
        code += if of_preprocessor { "" } else { line };
        code += "\n";
    }
    let (mut functions, mut types) = (BTreeMap::new(), BTreeMap::new());
    let code = tokens(&code);
    for declaration in declarations(&code) {
        match declaration[0].as_str() {
            "STLTSA_API" => functions.extend([function_of_c(declaration)]),
            "typedef" => types.extend([type_of_typedef(declaration)]),
            "enum" => {
                let values = &declaration[2..declaration.len() - 1];
                constants.extend(split(values, ",").map(|value| value[0].clone()));
            }
            _ => panic!("a declaration that this test does not know: {declaration:?}"),
        }
    }
    Header { functions, types, constants }
}

fn join(tokens: &[String]) -> String {
    tokens.join(" ")
}

/// `NAME: TYPE, ...`, `pub` or not
fn named_of_rust(tokens: &[String]) -> Vec<Named> {
    let named = |part: &[String]| {
        let colon = find(part, ":", 0);
        (part[colon - 1].clone(), join(&part[colon + 1..]))
    };
    split(tokens, ",").map(named).collect()
}

/// `(NAME: TYPE, ...) -> TYPE` up to `end`
fn signature_of_rust(tokens: &[String], open: usize, end: &str) -> Signature {
    let close = find(tokens, ")", open);
    let result = match &tokens[close + 1..find(tokens, end, close + 3)] {
        [minus, arrow, result @ ..] if minus == "-" && arrow == ">" => join(result),
        _ => "c_void".to_owned(),
    };
    Signature { parameters: named_of_rust(&tokens[open + 1..close]), result }
}

fn rust_tokens(text: &str) -> Tokens {
    tokens(&text.replace("r#", ""))
}

pub fn rust_functions(text: &str) -> BTreeMap<String, Signature> {
    let code = rust_tokens(text);
    let starts = (0..code.len()).filter(|i| code[*i] == "fn");
    starts.map(|i| (code[i + 1].clone(), signature_of_rust(&code, i + 2, ";"))).collect()
}

pub fn rust_types(text: &str) -> BTreeMap<String, Type> {
    let code = rust_tokens(text);
    let mut types = BTreeMap::new();
    for i in 0..code.len() {
        let name = || code[i + 1].clone();
        match code[i].as_str() {
            "type" if code[i + 2] == "=" && code[i + 3] == "Option" => {
                let open = find(&code, "(", i);
                types.insert(name(), Type::Callback(signature_of_rust(&code, open, ">")));
            }
            "type" if code[i + 2] == "=" => {
                types.insert(name(), Type::Alias(code[i + 3].clone()));
            }
            "struct" if code[i + 2] == "{" => {
                let fields = &code[i + 3..find(&code, "}", i)];
                types.insert(name(), Type::Struct(named_of_rust(fields)));
            }
            "opaque" if code[i + 1] == "!" => {
                let names = &code[i + 3..find(&code, "}", i)];
                types.extend(names.iter().map(|name| (name.clone(), Type::Opaque)));
            }
            _ => {}
        }
    }
    types
}

pub fn rust_constants(text: &str) -> BTreeMap<String, i64> {
    let code = rust_tokens(text);
    let starts = (0..code.len()).filter(|i| code[*i] == "const");
    let value = |i: usize| code[i + 5..find(&code, ";", i)].concat().parse().expect("a number");
    starts.map(|i| (code[i + 1].clone(), value(i))).collect()
}
