# SPDX-License-Identifier: BSD-3-Clause
"""Reads stltsa.h, whose comments are plain text, as sections of declarations with comments. From
these, doxygen() makes a header with Doxygen's markup, and page() makes the page of a section.

A comment belongs to the declaration below it, and to the functions that follow without a blank
line. A comment after an entry belongs to the entry; one between entries of an enum divides the enum
in two.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

SECTION = re.compile(r"/\* -{4} (.*?) -+ \*/")
ITEM = re.compile(r" {0,3}(\S+(?: \S+)*) {2,}(\S.*)")
NEXT_ITEM = re.compile(r"(\w+\.) (\S.*)")  # in a list, a word as long as the column
OPTION_TYPE = re.compile(r"^(int|real|text)(\[\])? (?=\S)")
COMMENT = r"(/\*(?!\*)(?:[^*]|\*(?!/))*\*/)"
IDENTIFIER = re.compile(r"\b(?:stltsa|STLTSA)_[A-Za-z0-9_]+|\bE_[A-Z_]+\b")
# Functions that many kinds of handles have need no comment and do not share that of their neighbor.
OWN_ENTRY = ("_free", "_info", "_new", "_json", "_warning_count")


@dataclass
class Declaration:
    text: str

    @property
    def kind(self) -> str:
        if self.text.startswith("enum"):
            return "enum"
        if self.text.startswith("typedef struct") and "{" in self.text:
            return "struct"
        return "typedef" if self.text.startswith("typedef") else "function"

    @property
    def name(self) -> str:
        """The name; for an enum, which has none in the header, its first value."""
        if self.kind == "enum":
            return self.values[0]
        text = self.text[self.text.rindex("}"):] if self.kind == "struct" else self.text
        pointer = re.search(r"\(\*(\w+)\)", text)
        return pointer[1] if pointer else re.search(r"(stltsa_\w+)(?=\(|;)", text)[1]

    @property
    def values(self) -> list[str]:
        return re.findall(r"(STLTSA_\w+) =", self.text)


@dataclass
class Cluster:
    """A comment and its declarations: one declaration, several functions, or none."""

    comment: str
    declarations: list[Declaration] = field(default_factory=list)


@dataclass
class Section:
    title: str
    clusters: list[Cluster] = field(default_factory=list)

    @property
    def slug(self) -> str:
        return re.sub(r"\W+", "-", re.sub(r" \(.*\)", "", self.title).lower()).strip("-")

    def place(self, number: int) -> str:
        """A unique name for a cluster."""
        return f"{self.slug.replace('-', '_')}_{number}"


def plain(comment: str) -> str:
    """The text of a comment, without its marks."""
    lines = re.sub(r"^/\*|\*/$", "", comment.strip()).split("\n")
    return "\n".join(re.sub(r"^ *\* ?|^ ", "", line).rstrip() for line in lines).strip("\n")


def _pieces(text: str) -> Iterator[tuple[str, str]]:
    """Sections, comments, declarations and blank lines, in order."""
    lines = iter(text.split("\n"))
    for line in lines:
        if not line.strip():
            yield "blank", ""
        elif line.startswith("/*"):
            while "*/" not in line:
                line += "\n" + next(lines)
            yield ("section", SECTION.match(line)[1]) if SECTION.match(line) else ("comment", line)
        else:
            while not _complete(line):
                line += "\n" + next(lines)
            yield "declaration", line


def _complete(text: str) -> bool:
    if text.count("/*") > text.count("*/"):
        return False
    code = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    return code.rstrip().endswith(";") and code.count("{") == code.count("}")


def intro(header: str) -> str:
    """The comment at the top of the header, without its license."""
    return plain(re.search(r"/\*\n.*?\*/", header, flags=re.DOTALL)[0])


def sections(header: str) -> list[Section]:
    body = header[header.index("/* ----"):header.rindex("#ifdef __cplusplus")]
    found: list[Section] = []
    comment, last = "", None  # the comment before the declaration; the cluster of the line above
    for kind, text in _pieces(body):
        if comment and kind != "declaration":  # stands alone
            found[-1].clusters.append(Cluster(comment))
            comment = ""
        if kind == "section":
            found.append(Section(text))
        elif kind == "comment":
            comment = plain(text)
        if kind != "declaration":
            last = None
            continue
        declaration = Declaration(text)
        if last and not comment and _shares(last, declaration):
            last.declarations.append(declaration)
        else:
            found[-1].clusters += _divided(comment, declaration)
            last = found[-1].clusters[-1]
        comment = ""
    return found


def _shares(cluster: Cluster, declaration: Declaration) -> bool:
    """Whether the comment of a cluster also describes the declaration on the next line."""
    kinds = {declaration.kind, cluster.declarations[0].kind}
    return bool(cluster.comment) and kinds == {"function"} and \
        not declaration.name.endswith(OWN_ENTRY)


def _divided(comment: str, declaration: Declaration) -> list[Cluster]:
    """One cluster, or several if comments on separate lines divide an enum."""
    if declaration.kind != "enum":
        return [Cluster(comment, [declaration])]
    first, *rest = re.split(rf"(?m)^ *{COMMENT}\n", declaration.text)
    clusters = [Cluster(comment, [Declaration(first)] if "=" in first else [])]
    clusters += [Cluster(plain(text), [Declaration("enum {\n" + body)])
                 for text, body in zip(rest[::2], rest[1::2])]
    for cluster in clusters[:-1]:
        for part in cluster.declarations:
            part.text += "};"
    return clusters


def _linked(text: str, names: set[str]) -> str:
    """Text for Doxygen, with its special characters escaped and names as links."""
    def link(match: re.Match) -> str:
        name = match[0]
        if name in names:
            return f'\\ref {name} "{name}"'
        return f'\\ref STLTSA_{name} "{name}"' if f"STLTSA_{name}" in names else name

    text = re.sub(r'([\\@&$#<>%"])', r"\\\1", text)
    return IDENTIFIER.sub(link, re.sub(r"`([^`]+)`", r"<tt>\1</tt>", text))


class _Text:
    """A comment for Doxygen: paragraphs, lists ("word   description") and code (indented)."""

    ENDS = {"list": "</li></ul>", "code": "\\endcode"}

    def __init__(self, names: set[str]) -> None:
        self.names, self.out, self.inside = names, [], ""

    def enter(self, part: str) -> bool:
        """Close the open part and begin this one; return False if this part is already open."""
        if self.inside == part:
            return False
        self.out.append(self.ENDS.get(self.inside, ""))
        self.inside = part
        return True

    def add(self, line: str) -> None:
        item = ITEM.fullmatch(line) or (self.inside == "list" and NEXT_ITEM.fullmatch(line))
        indented = line.startswith("    ")
        if not line:
            if self.inside == "paragraph":
                self.enter("")
            self.out.append("")
        elif indented and self.inside in ("", "code"):
            self.out += ["\\code{.c}"] * self.enter("code") + [line[4:]]
        elif item and not indented:
            self.out.append("<ul>" if self.enter("list") else "</li>")
            self.out.append(f"<li><b>{_linked(item[1].rstrip('.'), self.names)}:</b>")
            self.out.append(_linked(item[2], self.names))
        else:
            if not (self.inside == "list" and line.startswith(" ")):
                self.enter("paragraph")
            self.out.append(_linked(line.strip(), self.names))


def _markup(text: str, names: set[str]) -> str:
    marked = _Text(names)
    for line in text.split("\n"):
        marked.add(line)
    marked.enter("")
    return "\n".join(marked.out)


def _entries(declaration: Declaration, names: set[str]) -> str:
    """A struct or an enum with the comments of its entries."""
    def after(match: re.Match) -> str:
        text = re.sub(r"\s+", " ", plain(match[2]).replace("\n", " "))
        if declaration.name.startswith(("STLTSA_OPT_", "STLTSA_INFO_")):
            text = OPTION_TYPE.sub(r"\1\2: ", text)
        return f"{match[1]} /**< {_linked(text, names)} */"

    def before(match: re.Match) -> str:
        return f"/**\n{_markup(plain(match[1]), names)}\n*/"

    text = re.sub(r"([;,]|\b\w+) +" + COMMENT, after, declaration.text)
    return re.sub("(?m)^ *" + COMMENT, before, text)


def names_of(header: str) -> set[str]:
    """All names that a comment can refer to."""
    every = [d for s in sections(header) for c in s.clusters for d in c.declarations]
    return {name for d in every for name in (d.values if d.kind == "enum" else [d.name])}


def unknown(header: str) -> set[str]:
    """Names in comments that are not in the header; "stltsa_model_*" stands for several."""
    known = names_of(header) | set(re.findall(r"#define (\w+)", header))
    name = re.compile(r"(?<!\")\b(?:stltsa|STLTSA)_\w*[A-Za-z0-9]\b(?!_?\*|[./-])|\bE_[A-Z_]+\b")
    said = {found for comment in re.findall(COMMENT, header) for found in name.findall(comment)}
    return {name for name in said if name not in known and f"STLTSA_{name}" not in known}


def doxygen(header: str) -> str:
    """The header with Doxygen's markup."""
    names = names_of(header)
    out = ["/** \\file stltsa.h */",
           f"/** \\page about_header stltsa.h\n{_markup(intro(header), names)}\n*/",
           "#include <stddef.h>", "#include <stdint.h>"]
    for section in sections(header):
        for number, cluster in enumerate(section.clusters):
            out.append(_cluster(cluster, section.place(number), names))
    return re.sub(r"STLTSA_API | STLTSA_NOEXCEPT", "", "\n".join(out)) + "\n"


def is_single(cluster: Cluster) -> bool:
    """Whether the cluster is one named declaration, whose comment goes below the name."""
    return len(cluster.declarations) == 1 and cluster.declarations[0].kind != "enum"


def page_of(cluster: Cluster, place: str) -> str:
    """The Doxygen page for a comment that describes several names or none."""
    return f"about_{cluster.declarations[0].name if cluster.declarations else place}"


def _cluster(cluster: Cluster, place: str, names: set[str]) -> str:
    page = "" if is_single(cluster) else f"\\page {page_of(cluster, place)} {place}\n\n"
    comment = f"/** {page}{_markup(cluster.comment, names)}\n*/" if cluster.comment else ""
    return "\n".join([comment, *(_entries(d, names) for d in cluster.declarations)])


def page(section: Section) -> str:
    """The page of a section, in the order of the header, with a list of its names."""
    title = section.title
    names = [d.name for c in section.clusters for d in c.declarations if d.kind != "enum"]
    out = [title, "=" * len(title), "", ".. container:: names", "",
           *(f"   * :any:`{name}`" for name in names), ""]
    for number, cluster in enumerate(section.clusters):
        if is_single(cluster):
            declaration = cluster.declarations[0]
            out.append(f".. doxygen{declaration.kind}:: {declaration.name}")
            if declaration.kind == "struct":
                out.append("   :members:\n   :undoc-members:")
        else:
            if cluster.comment:
                name = page_of(cluster, section.place(number))
                out += [f".. doxygenpage:: {name}", "   :content-only:", ""]
            for declaration in cluster.declarations:
                if declaration.kind == "function":
                    out.append(f".. doxygenfunction:: {declaration.name}")
                else:
                    out += [f".. doxygenenumvalue:: {value}" for value in declaration.values]
        out.append("")
    return "\n".join(out)
