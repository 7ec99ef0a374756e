#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests in build-coverage and counts the lines and branches of src that they reach. Fails below 95 % of
lines or 85 % of branches. build-coverage/coverage.txt lists what is not reached.

Reads what gcov writes for every object, including those that never ran.

- A line counts once; it is reached if any object, or any instance of a template, ran it.
- A branch is one way out of a decision. Instances of one template, which begin at the same place of the
  source and have equally many branches in the line, count as one.
- A call that may throw has two ways out: it returns or it throws. It is no decision of the source, and
  neither way counts. Otherwise every call that ran would add a branch that is reached and one that is not.
- Files that this build does not compile (the sparse factor that was not chosen) do not appear.

Nothing else is excluded: no file, no line, no marker in the source.
"""

import collections
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINES, BRANCHES = 95.0, 85.0


def decisions(branches):
    """The counts of the branches without those of calls: a branch that throws and the one beside it."""
    kept = []
    for i, branch in enumerate(branches):
        if branch["throw"]:
            continue
        if branch["fallthrough"] and i + 1 < len(branches) and branches[i + 1]["throw"]:
            continue
        kept.append(branch["count"])
    return kept


def add(found, lines, branches):
    """Adds one source file of one object to the sets of all and of reached lines and branches."""
    begins = {f["name"]: (f["start_line"], f["start_column"]) for f in found["functions"]}
    for line in found["lines"]:
        number = line["line_number"]
        lines[number] = lines[number] or line["count"] != 0
        kept = decisions(line["branches"])
        place = begins.get(line.get("function_name"))
        for i, count in enumerate(kept):
            key = number, place, len(kept), i
            branches[key] = branches[key] or count != 0


def read(build):
    """The lines and branches of each file of src: {file: ({line: reached}, {branch: reached})}."""
    files = collections.defaultdict(lambda: (collections.defaultdict(bool), collections.defaultdict(bool)))
    for notes in sorted(build.rglob("*.gcno")):
        data = notes.with_suffix(".gcda")
        output = subprocess.run(
            ["gcov", "--json-format", "--stdout", "--branch-probabilities", data if data.exists() else notes],
            cwd=build, check=True, capture_output=True, text=True).stdout
        for found in json.loads(output)["files"]:
            path = pathlib.Path(os.path.normpath(build / found["file"]))
            if path.is_relative_to(ROOT / "src"):
                add(found, *files[str(path.relative_to(ROOT))])
    return files


def percent(reached):
    return 100 * sum(reached) / len(reached) if reached else 100.0


def text_of(branches):
    """LINE(REACHED/ALL) for each line with a branch that is not reached."""
    of_line = collections.defaultdict(list)
    for (line, *_), reached in branches.items():
        of_line[line].append(reached)
    return [f"{n}({sum(r)}/{len(r)})" for n, r in sorted(of_line.items()) if not all(r)]


def main():
    build = ROOT / "build-coverage"
    for counts in build.rglob("*.gcda"):
        counts.unlink()
    # The suite "checks" runs nothing of the library. Unoptimized, tests take up to ten times as long.
    subprocess.run([ROOT / "tests/slow/tree", "coverage", "--no-suite", "checks", "--timeout-multiplier", "10"], check=True)
    files = read(build)
    with open(build / "coverage.txt", "w", encoding="utf-8") as report:
        for name, (lines, branches) in sorted(files.items()):
            report.write(f"{name}: {percent(lines.values()):.1f} % of {len(lines)} lines, "
                         f"{percent(branches.values()):.1f} % of {len(branches)} branches\n")
            missed = [str(n) for n, reached in sorted(lines.items()) if not reached]
            report.write(f"  lines: {' '.join(missed)}\n  branches: {' '.join(text_of(branches))}\n")
    for name, (lines, branches) in sorted(files.items(), key=lambda f: percent(f[1][0].values()))[:8]:
        print(f"{percent(lines.values()):6.1f} % of {len(lines):4} lines, "
              f"{percent(branches.values()):5.1f} % of {len(branches):4} branches  {name}")
    lines = [reached for one, _ in files.values() for reached in one.values()]
    branches = [reached for _, one in files.values() for reached in one.values()]
    print(f"coverage of src: {percent(lines):.1f} % of {len(lines)} lines, "
          f"{percent(branches):.1f} % of {len(branches)} branches")
    return percent(lines) < LINES or percent(branches) < BRANCHES


sys.exit(main())
