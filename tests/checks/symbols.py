#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the symbols that the library exports with those that its header declares.

Usage: symbols.py stltsa.h stltsa.map libstltsa.so libstltsa.a

1. The shared library exports exactly the functions that the header declares, each at the version of
   the node that lists it in stltsa.map; the header marks each with STLTSA_API.
2. The static archive defines the same stltsa_* functions; its other global symbols are C++ names
   (namespace stltsa, or weak copies of templates, as in every C++ object), so that they cannot
   collide with a C program's names.
3. No object of the library holds writable data except the few named below.
4. The library calls LAPACKE only where the caller allocates (LAPACKE_*_work): the other routines
   print to standard output if memory runs out.
"""

import re
import subprocess
import sys

# Allowed writable statics, by demangled name, with the reason.
WRITABLE = {
    "stltsa::(anonymous namespace)::arpack_free": "waits for ARPACK",
    "stltsa::(anonymous namespace)::arpack_mutex": "guards arpack_used",
    "stltsa::(anonymous namespace)::arpack_used": "ARPACK is not reentrant",
    "stltsa::(anonymous namespace)::owns_arpack": "whether this thread has ARPACK",
    "stltsa::(anonymous namespace)::mutex": "guards the next two",
    "stltsa::(anonymous namespace)::users": "fits that run on one OpenBLAS thread",
    "stltsa::(anonymous namespace)::threads_before": "number of OpenBLAS threads to restore",
    "stltsa::Checkpoints::innermost_": "one per thread, while a call or a loop runs",
    "stltsa::Checkpoints::numbers_": "one per thread: work since the last checkpoint",
    "stltsa::Call::current_": "one per thread, while a call runs",
    "stltsa::(anonymous namespace)::shared_threads": "one per thread, while a call runs",
    "stltsa::capi::(anonymous namespace)::last_error_text": "one per thread",
}


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def declared(header):
    """Functions that the header marks with STLTSA_API, and all that it declares."""
    with open(header, encoding="utf-8") as file:
        text = re.sub(r"/\*.*?\*/", "", file.read(), flags=re.DOTALL)
    text = re.sub(r"^\s*#.*(?:\\\n.*)*$", "", text, flags=re.MULTILINE)
    marked = set(re.findall(r"STLTSA_API\b[^;(]*?\b(\w+)\s*\(", text))
    typedefs = r"\btypedef\b[^;{]*;"
    every = set(re.findall(r"\b(stltsa_\w+)\s*\(", re.sub(typedefs, "", text)))
    return marked, every


def exported(library):
    lines = run("nm", "--dynamic", "--defined-only", library).splitlines()
    # Type A is the node of the version script.
    return {line.split()[2] for line in lines if line.split()[1] != "A"}


def listed(version_script):
    """name@@NODE for each function that the version script lists."""
    with open(version_script, encoding="utf-8") as file:
        nodes = re.findall(r"([\w.]+) \{\s*global:([^}]*?)(?:local:[^}]*)?\}", file.read())
    return {f"{name}@@{node}" for node, names in nodes for name in re.findall(r"[^\s;]+", names)}


def archive_globals(archive):
    """(type, name) of each external symbol that the archive defines."""
    lines = run("nm", "--extern-only", "--defined-only", archive).splitlines()
    fields = [line.split() for line in lines]
    return {(parts[1], parts[2]) for parts in fields if len(parts) == 3}


def foreign(symbols):
    """Symbols that are not the API, not the library's own C++, and not weak copies of templates."""
    own = re.compile(r"stltsa_\w+$|_Z(?:N[KVrRO]*|T[VISTC]N?|GV|GVZ|Z)*6stltsa")
    weak = "WVuiw"
    return sorted(name for kind, name in symbols if kind not in weak and not own.match(name))


def writable(archive):
    """Demangled names of objects in sections that stay writable while the program runs."""
    found = set()
    for line in run("objdump", "--syms", "--demangle", archive).splitlines():
        match = re.match(r"[0-9a-f]{8,} (.{7}) (\.t?data\S*|\.t?bss\S*)\s+[0-9a-f]+\s+(.*)", line)
        if match and "d" not in match[1] and not match[2].startswith(".data.rel.ro"):
            found.add(re.sub(r"^\.hidden ", "", match[3]))
    of_the_compiler = ("DW.ref.", "__tls_guard", "guard variable for ")
    return {name for name in found if not name.startswith(of_the_compiler)}


def allocating(library):
    """Routines of LAPACKE that allocate."""
    names = {line.split()[-1] for line in run("nm", "-Du", library).splitlines()}
    return {name for name in names if name.startswith("LAPACKE_d") and not name.endswith("_work")}


def main(header, version_script, library, archive):
    marked, every = declared(header)
    versioned = exported(library)
    out = {name.split("@")[0] for name in versioned}
    symbols = archive_globals(archive)
    api = {name for _, name in symbols if name.startswith("stltsa_")}
    complaints = {
        "declared without STLTSA_API": every - marked,
        "exported at another version than the version script says": versioned
        - listed(version_script),
        "declared, but not exported by the shared library": marked - out,
        "exported by the shared library, but not declared": out - marked,
        "declared, but not in the static archive": marked - api,
        "stltsa_* of the static archive that is not declared": api - marked,
        "global names of the static archive outside namespace stltsa": foreign(symbols),
        "writable data that is not on this script's list": writable(archive) - set(WRITABLE),
        "a routine that prints if memory runs out": allocating(library),
    }
    for text, names in complaints.items():
        for name in sorted(names):
            print(f"{text}: {name}", file=sys.stderr)
    print(f"{len(marked)} functions declared, {len(out)} exported, {len(symbols)} global names "
          f"in the archive ({len(api)} of the API)")
    return int(any(complaints.values()) or not marked)


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
