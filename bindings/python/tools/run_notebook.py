#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs all cells of a notebook in order, in the current directory.

Usage: run_notebook.py NOTEBOOK [OUTPUT] (OUTPUT: file for the notebook with its results)
"""

import pathlib
import sys

import nbformat
from nbclient import NotebookClient


def main(path: str, output: str | None = None) -> None:
    notebook = nbformat.read(path, as_version=4)
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    cells = sum(cell.cell_type == "code" for cell in notebook.cells)
    print(f"{pathlib.Path(path).name}: {cells} cells run")
    if output:
        nbformat.write(notebook, output)


if __name__ == "__main__":
    main(*sys.argv[1:])
