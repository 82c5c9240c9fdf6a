#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the speed of two builds of a benchmark on maps, in turns.

    benchmarks/compare_speed.py OLD NEW --all DIR --search jps --queries 30 --caches warm
    benchmarks/compare_speed.py OLD NEW --turns 5 ...       five runs of each instead of three

OLD and NEW are binaries of tutavia-bench-grid or tutavia-bench-any-angle; all other options go to
both. Each runs once per turn, one after the other; of every figure the least counts. A name
OLD_NAME=NEW_NAME in --search compares two searches. Prints OLD / NEW per map and search, and
geometric means over the random maps and over all others.
"""

import argparse
import csv
import math
import pathlib
import subprocess
import sys
import tempfile


def figures(program, options):
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "figures.csv"
        run = subprocess.run([program, *options, "--csv", str(table)], stdout=subprocess.DEVNULL)
        if run.returncode == 2 or not table.exists():
            sys.exit(f"{program} failed with code {run.returncode}")
        if run.returncode != 0:
            print(f"{program}: wrong answers", file=sys.stderr)
        with table.open(newline="") as rows:
            return {(row["map"], row["search"]): float(row["mean_us"]) for row in csv.DictReader(rows)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--search", required=True)
    arguments, others = parser.parse_known_args()
    pairs = [(name.split("=") * 2)[:2] for name in arguments.search.split(",")]
    least = ({}, {})
    for _ in range(arguments.turns):
        for side, program in enumerate((arguments.old, arguments.new)):
            names = ",".join(dict.fromkeys(pair[side] for pair in pairs))
            for key, value in figures(program, [*others, "--search", names]).items():
                least[side][key] = min(value, least[side].get(key, math.inf))
    logs = {}
    for (name, old_search) in least[0]:
        for pair in pairs:
            if pair[0] != old_search or (name, pair[1]) not in least[1]:
                continue
            old, new = least[0][name, pair[0]], least[1][name, pair[1]]
            kind = "random maps" if name.startswith("random") else "other maps"
            search = "=".join(dict.fromkeys(pair))
            logs.setdefault((search, kind), []).append(math.log(old / new))
            print(f"{name:20} {search:32} {old:10.1f} us {new:10.1f} us {old / new:6.2f}")
    for (search, kind), values in sorted(logs.items()):
        print(f"{kind:20} {search:32} {math.exp(sum(values) / len(values)):34.2f}")


main()
