#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Copies the pages of the site into a folder, with the same layout as in the repository, so that
their links work in both. Makes the pages of the C reference, the command and the schemas from the
header, the manual page and the schemas.

    docs/site/stage.py FOLDER
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys

import c_header

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# All files that a page shows or links to.
FILES = ("*.md", "LICENSE", "docs/*.md", "docs/logs/*.md", "docs/*.svg", "docs/*.png", "docs/schema/*.json",
         "bindings/python/README.md", "bindings/rust/stltsa/README.md",
         "examples/*.c", "examples/*.cpp", "include/*", "docs/site/*.md", "docs/site/*.rst",
         "docs/site/*.css", "docs/site/Doxyfile")

EXITS = {"usage": "2", "unreadable": "3", "untrustworthy": "4", "interrupted": "130", "failed": "1"}


def write(path, text):
    path.parent.mkdir(exist_ok=True, parents=True)
    path.write_text(text)


def heading(title, mark="="):
    return f"{title}\n{mark * len(title)}\n"


def copy(folder):
    for pattern in FILES:
        for file in ROOT.glob(pattern):
            place = folder / file.relative_to(ROOT)
            place.parent.mkdir(exist_ok=True, parents=True)
            shutil.copy(file, place)
    (folder / "docs/site/index.md").rename(folder / "index.md")


def c_reference(folder):
    header = (ROOT / "include/stltsa.h").read_text()
    if c_header.unknown(header):
        sys.exit(f"comments of include/stltsa.h contain unknown names: {c_header.unknown(header)}")
    write(folder / "doxygen/stltsa.h", c_header.doxygen(header))
    names = []
    for section in c_header.sections(header):
        names.append(section.slug)
        write(folder / f"docs/c/{section.slug}.rst", c_header.page(section))
    pages = "\n".join(f"   {name}" for name in names)
    write(folder / "docs/c/index.rst",
          f"{heading('C')}\n.. doxygenpage:: about_header\n   :content-only:\n\n"
          f".. toctree::\n   :caption: Subjects\n   :maxdepth: 1\n\n{pages}\n")


def check_errors():
    """Check that docs/errors.md agrees with the header, the Python package and the command."""
    header, python, command = ((ROOT / name).read_text() for name in (
        "include/stltsa.h", "bindings/python/src/stltsa/errors.py", "tools/exit_status.cpp"))
    page = (ROOT / "docs/errors.md").read_text()
    values = dict(re.findall(r"STLTSA_(E_\w+) = (-\d+)", header))
    classes = dict(re.findall(r'"STLTSA_(E_\w+)": (\w+)', python))
    groups = re.findall(r"((?:    case STLTSA_\w+:\n)+)        return Exit::(\w+);", command)
    exits = {status: name for cases, name in groups for status in re.findall("E_\\w+", cases)}
    known = {(status, value, classes[status], EXITS[exits.get(status, "failed")])
             for status, value in values.items()}
    said = set(re.findall(r"^\| `(E_\w+)` \| (-\d+) \| `(\w+)` \| (\d+) \|", page, re.M))
    explained = set(re.findall(r"^\| `(E_\w+)` \| [^-]", page, re.M))
    if known != said or explained != set(values):
        sys.exit("docs/errors.md is not up to date: "
                 f"{sorted(known ^ said)} {explained ^ set(values)}")


def command(folder):
    """Make the page of the command; each section of the manual page becomes a section."""
    html = subprocess.run(["mandoc", "-T", "html", "-O", "fragment", ROOT / "docs/man/stltsa.1"],
                          check=True, text=True, stdout=subprocess.PIPE).stdout
    out = [heading("Command")]
    parts = re.findall(r'<section class="Sh">\n<h1[^>]*><a[^>]*>(.*?)</a></h1>\n(.*?)'
                       r'(?=<section class="Sh">|</div>\n<table class="foot">)', html, re.DOTALL)
    for title, body in parts:
        body = re.sub(r"</section>\s*$", "", body)
        indented = "\n".join("   " + line for line in body.split("\n"))
        out += [heading(" ".join(title.split()).capitalize(), "-"), ".. raw:: html", "",
                f'   <div class="manual">\n{indented}\n   </div>\n']
    write(folder / "docs/command.rst", "\n".join(out))


def schemas(folder):
    out = ["# JSON", "", "Schemas (JSON Schema 2020-12) of the objects that the library and the "
           "command write.", ""]
    for file in sorted((ROOT / "docs/schema").glob("*.json")):
        schema = json.loads(file.read_text())
        out += [f"## {schema['title']}", "", schema["description"], "",
                f"[{file.name}](schema/{file.name})", "", "| member | description |", "|---|---|"]
        out += [f"| `{name}` | {value['description'].replace('|', '&#124;')} |"
                for name, value in schema["properties"].items()]
        out.append("")
    write(folder / "docs/schema.md", "\n".join(out))


def main():
    folder = pathlib.Path(sys.argv[1])
    shutil.rmtree(folder, ignore_errors=True)
    check_errors()
    copy(folder)
    c_reference(folder)
    command(folder)
    schemas(folder)


if __name__ == "__main__":
    main()
