# SPDX-License-Identifier: BSD-3-Clause
"""Measures this library, scikit-learn and tapkee on the same frames; see scripts/benchmark."""

import argparse
import json
import sys
from pathlib import Path

import claims
import machine
import pages
import plan
import plots
import tasks
import texts

ROOT = Path(__file__).resolve().parents[2]


def arguments():
    parser = argparse.ArgumentParser(prog="scripts/benchmark", description=__doc__)
    parser.add_argument("build", nargs="?", type=Path, default=ROOT / "build",
                        help="build folder, made where there is none (default: build)")
    parser.add_argument("--million", action="store_true", help="a million frames, too")
    parser.add_argument("--rounds", type=int, default=3,
                        help="in which what is compared takes turns (default: %(default)s)")
    parser.add_argument("--limit", type=float, default=60,
                        help="seconds after which a fit is given up (default: %(default)g)")
    parser.add_argument("--machine", default=machine.describe(),
                        help="what the figures are said to be measured on (default: %(default)s)")
    parser.add_argument("--redraw", action="store_true",
                        help="measure nothing: show the last result again")
    parser.add_argument("--update-docs", action="store_true",
                        help="put tables and figures into README.md and docs/")
    parser.add_argument("--data", type=Path, required=True, help=argparse.SUPPRESS)
    return parser.parse_args()


def measured(args, folder):
    laboratory = tasks.Laboratory(args.build, folder, args.limit)
    versions = machine.peers()
    sizes = plan.SIZES + ((plan.MILLION,) if args.million else ())
    motion, frames = plan.make_frames(laboratory, args.data, sizes[-1])
    result = {"machine": args.machine, "versions": versions}
    peers = list(versions)
    result["comparison"] = plan.measure_comparison(laboratory, frames, peers, args.rounds)
    result["angles"] = plan.measure_angles(laboratory, frames, peers)
    result["growth"] = plan.measure_growth(laboratory, motion, peers, sizes, args.rounds)
    result["neighbors"] = plan.measure_neighbors(laboratory, motion, args.rounds)
    return result


def show(result):
    for title, rows in (("The comparison", texts.comparison), ("Angles", texts.angles),
                        ("Growth", texts.growth), ("Stages", texts.stages),
                        ("Claims", texts.claims)):
        print(f"\n{title}\n")
        if rows is texts.comparison:
            print(pages.where(result) + "\n")
        print("\n".join(texts.plain(rows(result))))


def main():
    args = arguments()
    folder = args.build / "benchmark"
    folder.mkdir(exist_ok=True)
    path = folder / "benchmark.json"
    result = json.loads(path.read_text()) if args.redraw else measured(args, folder)
    result["claims"] = claims.claims_of(result)
    path.write_text(json.dumps(result, indent=1) + "\n")
    show(result)
    figure = plots.save_figure(result, folder)
    print(f"\nResult: {path}; figure: {figure}")
    if args.update_docs:
        pages.update(ROOT, result, figure)
    return 0 if all(claim["holds"] for claim in result["claims"]) else 1


if __name__ == "__main__":
    sys.exit(main())
