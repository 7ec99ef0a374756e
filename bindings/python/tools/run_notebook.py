#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs all cells of a notebook in order, in the current directory.

Usage: run_notebook.py NOTEBOOK [--update]

The texts must be those that are stored in the notebook; pictures are not compared. With --update
the notebook is stored with its outputs.
"""

import pathlib
import sys

import nbformat
from nbclient import NotebookClient


def texts(cell):
    """Printed and shown texts of a cell, but for those that stand for pictures."""
    for output in cell.get("outputs", ()):
        data = output.get("data", {})
        if "image/png" not in data:
            yield output.get("text") or data.get("text/plain", "")


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def main(path: str, update: str | None = None) -> int:
    stored = nbformat.read(path, as_version=4)
    notebook = nbformat.read(path, as_version=4)
    client = NotebookClient(notebook, timeout=120, kernel_name="python3", record_timing=False)
    client.execute()
    if update == "--update":
        notebook.metadata.pop("language_info", None)
        nbformat.write(notebook, path)
        return 0
    pairs = zip(code_cells(stored), code_cells(notebook), strict=True)
    for number, (before, now) in enumerate(pairs, 1):
        if list(texts(before)) != list(texts(now)):
            print(f"cell {number}: stored {list(texts(before))}, found {list(texts(now))}")
            print("the outputs in the notebook are old: store new ones with --update")
            return 1
    print(f"{pathlib.Path(path).name}: {len(code_cells(notebook))} cells run")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
