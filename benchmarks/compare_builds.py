#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the results of two builds of tutavia-plan, to the last bit.

    benchmarks/compare_builds.py OLD NEW                    the built-in maps, 200 random worlds of
                                                            polygons and discs, and 50 random grids
    benchmarks/compare_builds.py OLD NEW --worlds 20        fewer worlds, and a quarter as many grids
    benchmarks/compare_builds.py OLD NEW FILE.json ...      these workspaces as well

Each program plans every goal with every search and every smoother (--compare); what it writes with
--json must be equal but for the times. Prints what differs, and exits with 1 where anything does.
"""

import argparse
import concurrent.futures
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

MAPS = ("maze", "array", "complex", "rrt_scene_1", "rrt_scene_2")


def random_world(seed):
    """Polygons and discs in a square of 20 m; every third world is so full that queries may fail."""
    draw = random.Random(seed)
    obstacles = []
    for _ in range(draw.randrange(3, 30 if seed % 3 == 0 else 14)):
        x, y = draw.uniform(0, 20), draw.uniform(0, 20)
        size = draw.uniform(0.3, 2.5)
        if draw.random() < 0.3:
            obstacles.append({"center": [x, y], "radius": size})
            continue
        corners = draw.randrange(3, 9)
        turn = draw.uniform(0, 2 * math.pi)
        obstacles.append({"polygon": [
            [x + size * draw.uniform(0.4, 1) * math.cos(turn + 2 * math.pi * i / corners),
             y + size * draw.uniform(0.4, 1) * math.sin(turn + 2 * math.pi * i / corners)]
            for i in range(corners)]})
    return {"bounds": [0, 0, 20, 20], "safety_radius": draw.choice([0, 0.2, 0.5]),
            "obstacles": obstacles, "start": [draw.uniform(0, 20), draw.uniform(0, 20)],
            "goals": [[draw.uniform(0, 20), draw.uniform(0, 20)]],
            "resolution": draw.choice([0.25, 0.5])}


def random_grid(seed):
    """A MovingAI map of up to 80 x 80 cells, and the options for a query between two free cells."""
    draw = random.Random(seed)
    width, height = draw.randrange(10, 80), draw.randrange(10, 80)
    density = draw.choice([0.05, 0.2, 0.35])
    rows = [["@" if draw.random() < density else "." for _ in range(width)] for _ in range(height)]
    ends = [(draw.randrange(width), draw.randrange(height)) for _ in range(2)]
    for x, y in ends:
        rows[y][x] = "."
    text = "\n".join(["type octile", f"height {height}", f"width {width}", "map",
                      *map("".join, rows)]) + "\n"
    start, goal = (f"{x + 0.5},{y + 0.5}" for x, y in ends)
    return text, ["--start", start, "--goal", goal]


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(v) for key, v in value.items() if not key.endswith("_us")}
    if isinstance(value, list):
        return [without_times(v) for v in value]
    return value


def results(program, arguments):
    done = subprocess.run([program, *arguments, "--compare", "--json", "-", "--svg", "/dev/null"],
                          capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        return {"exit": done.returncode, "error": done.stderr}
    return {"exit": done.returncode, "results": without_times(json.loads(done.stdout))}


def first_difference(old, new, where=""):
    if isinstance(old, dict) and isinstance(new, dict) and old.keys() == new.keys():
        pairs = [(f"{where}.{key}", old[key], new[key]) for key in old]
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        pairs = [(f"{where}[{i}]", a, b) for i, (a, b) in enumerate(zip(old, new))]
    else:
        return f"{where}: {str(old)[:200]} became {str(new)[:200]}"
    for path, a, b in pairs:
        if a != b:
            return first_difference(a, b, path)
    return None


def compare(old, new, name, arguments):
    before, after = results(old, arguments), results(new, arguments)
    failed = sum(r["status"] != "success" for r in before.get("results", {}).get("results", []))
    count = len(before.get("results", {}).get("results", []))
    return name, count, failed, None if before == after else first_difference(before, after)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", help="tutavia-plan of the one build")
    parser.add_argument("new", help="tutavia-plan of the other")
    parser.add_argument("workspaces", nargs="*", help="workspace files")
    parser.add_argument("--worlds", type=int, default=200, help="random worlds (default 200)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        tasks = [(name, ["--map", name]) for name in MAPS]
        tasks += [(file, ["--workspace", file]) for file in arguments.workspaces]
        for seed in range(arguments.worlds):
            file = pathlib.Path(folder) / f"{seed}.json"
            file.write_text(json.dumps(random_world(seed)))
            tasks.append((f"random world {seed}", ["--workspace", str(file)]))
        for seed in range(arguments.worlds // 4):
            file = pathlib.Path(folder) / f"{seed}.map"
            text, ends = random_grid(seed)
            file.write_text(text)
            tasks.append((f"random grid {seed}", ["--grid", str(file), *ends]))
        with concurrent.futures.ThreadPoolExecutor() as pool:
            done = list(pool.map(lambda t: compare(arguments.old, arguments.new, *t), tasks))
    differences = [(name, difference) for name, _, _, difference in done if difference]
    for name, difference in differences:
        print(f"{name}: {difference}")
    print(f"{len(done)} workspaces and grids, {sum(d[1] for d in done)} results, "
          f"{sum(d[2] for d in done)} of them without a path: {len(differences)} differ")
    return 1 if differences else 0


if __name__ == "__main__":
    sys.exit(main())
