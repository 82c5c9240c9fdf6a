#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes docs/gallery.md, docs/reference.md, their pictures, and the figures of README.md.

    docs/generate.py --program build/release/examples/tutavia-plan           writes them
    docs/generate.py --program build/release/examples/tutavia-plan --check   names what is stale

Everything comes from tutavia-plan and from the doc comments of the headers. --check compares all
but times, which differ from run to run.
"""

import argparse
import functools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORKSPACE = "--map maze --goal 14,6"
GRID = "--grid docs/images/rooms.map --start 2.5,2.5 --goal 37.5,21.5"
CAR = (
    "--workspace tests/data/parking.json --start=-8,1.5,0 --goal 0,-4.6,90 --turning-radius 5 "
    "--reverse --footprint car:4.5,1.8,2.7"
)
TIME = re.compile(r"\d[\d.]* (?:us|ms|s)\b(?: \| [\d.–]+ \|$)?", re.MULTILINE)

# What the README shows of each task: the command, and the algorithms as C++.
CHOICES = [
    ("polygons, the shortest path", "TangentGraph", f"{WORKSPACE} --search tangent_graph --smoother none"),
    ("many polygons", "AStar, TautString", f"{WORKSPACE} --search astar --smoother taut_string"),
    ("grid map", "Jps, ClothoidSmoother", f"{GRID} --search jps --smoother clothoid"),
    ("grid map, any angle", "AnyAngle", f"{GRID} --search any_angle --smoother none"),
    ("car", "HybridAStar, VehicleShortcut", f"{CAR} --search hybrid_astar"),
    ("a curve to drive", "AutoSearch, ClothoidSmoother, SpeedProfile", f"{WORKSPACE} --smoother clothoid"),
]


class Program:
    """Runs tutavia-plan from the root of the sources."""

    def __init__(self, path):
        self.path = os.path.abspath(path)

    def text(self, arguments):
        if sys.stderr.isatty():
            print(f"\033[K{arguments[-100:]}", end="\r", file=sys.stderr, flush=True)
        done = subprocess.run(
            [self.path, *arguments.split()], cwd=ROOT, capture_output=True, encoding="utf-8", check=False
        )
        if done.returncode != 0:
            sys.exit(f"generate.py: tutavia-plan {arguments}: {done.stderr.strip()}")
        return done.stdout

    def results(self, arguments):
        return json.loads(self.text(arguments + " --json -"))["results"]

    def names(self):
        """(kind, name, where) of every algorithm; where: both, workspace, grid, vehicle."""
        kind, names, seen = "", [], set()
        places = {
            "on workspaces alone": "workspace",
            "on grid maps alone": "grid",
            "for vehicles": "vehicle",
        }
        for line in self.text("--list").splitlines():
            head, _, rest = line.partition(":")
            where = places.get(head.strip(), "both")
            if head in ("search", "smoother"):
                kind = head
            elif head.strip() not in places:
                break
            for name in rest.split():
                if (kind, name) not in seen:
                    names.append((kind, name, where))
                    seen.add((kind, name))
        return names


class Comments:
    """The doc comments of the algorithms, by their registry names."""

    def __init__(self):
        self.by_name = {}
        for folder in ("search", "smooth"):
            for header in sorted((ROOT / "include/tutavia" / folder).glob("*.hpp")):
                self.read(header)

    def read(self, header):
        comment, entity = [], None
        for line in header.read_text(encoding="utf-8").splitlines():
            if line.startswith("///"):
                comment.append(line[3:].removeprefix(" "))
                continue
            found = re.match(r"(?:class|struct) (\w+)", line)
            if found and not line.endswith(";"):
                entity = (found.group(1), comment)
            name = re.search(r'name = "(\w+)"', line)
            if name and entity:
                path = header.relative_to(ROOT).as_posix()
                self.by_name.setdefault(name.group(1), (*entity, path))
            if line and not line.startswith("template"):
                comment = []

    def paragraphs(self, name):
        """The paragraphs of a comment, wrapped anew; lists and code are unchanged."""
        _, lines, _ = self.by_name[name]
        text = "\n".join(lines).strip()
        for block in re.split(r"\n\s*\n", text):
            if block.startswith(("\\file", "Example:")):
                continue
            block = re.sub(r"\\pre\b", "Precondition:", block)
            if re.match(r"( {4}|- )", block):
                yield block
            else:
                yield "\n".join(textwrap.wrap(" ".join(block.split()), 100))


def picture_arguments(kind, name, where):
    task = {"grid": GRID, "vehicle": CAR}.get(where, WORKSPACE)
    if kind == "search":
        smoother = "vehicle_shortcut" if where == "vehicle" else "none"
        return f"{task} --search {name} --smoother {smoother} --steps 4"
    search = {"vehicle": "hybrid_astar", "grid": "jps"}.get(where, "astar")
    shown = "zones,profile,footprint" if where == "vehicle" else "zones,profile"
    return f"{task} --search {search} --smoother {name} --smoothing-steps --show {shown}"


def figures(result):
    metrics, stats = result["metrics"], result["stats"]
    optimum = result.get("optimum") or {}
    ratio = f"{optimum['ratio']:.4f}" if optimum.get("ratio") else "–"
    return {
        "length": f"{metrics['length']:.3f}",
        "ratio": ratio,
        "curvature": f"{metrics['max_curvature']:.3f}" if metrics["max_curvature"] else "0",
        "clearance": f"{metrics['min_clearance']:.3f}",
        "expanded": str(stats["expanded"]),
        "search_us": stats["search_us"],
        "smooth_us": stats["smooth_us"],
        "all_us": stats["search_us"] + stats["smooth_us"] + stats["certify_us"],
    }


def time_text(micros):
    return f"{micros / 1000:.1f} ms" if micros >= 1000 else f"{micros:.0f} us"


@functools.lru_cache(maxsize=None)
def median_figures(program, arguments, rounds):
    """The figures of one plan. Times are medians over queries of one process, but the first."""
    goal = re.search(r"--goal \S+", arguments)[0]
    runs = [figures(run) for run in program.results(arguments + f" {goal}" * rounds)]
    result = runs[0]
    for key in ("search_us", "smooth_us", "all_us"):
        result[key] = sorted(run[key] for run in runs[1:])[rounds // 2]
    return result


def gallery(program, comments, pictures, rounds):
    lines = [
        "# Gallery",
        "",
        "Every search and smoother on one task, drawn by `tutavia-plan`: the built-in map `maze`; for",
        "those of grid maps [rooms.map](images/rooms.map), and for vehicles a bay. `docs/generate.py`",
        "writes this page. Ratios are lengths over the shortest path, which the library knows. Times of",
        "the search, or of the smoother alone, are medians over later queries of one process, and tell no",
        "more than orders of magnitude on so small a map; [performance.md](performance.md) measures on",
        "large ones.",
        "",
        "Three pictures of a search show it after each third of its events, and the last one its route.",
        "Those of a smoother show the route with its waypoints, how the curve is built, and the curve with",
        "a disc around its point of least clearance, which touches the nearest obstacle. The second picture",
        "magnifies the part with most turns, which a frame marks in the first; of vehicles it is the whole",
        "map.",
        "",
    ]
    astar = median_figures(program, f"{WORKSPACE} --search astar --smoother none", rounds)
    for kind, title in (("search", "Searches"), ("smoother", "Smoothers")):
        rows = [
            f"## {title}",
            "",
            "| name | length m | / optimum | largest curvature 1/m | clearance m | expanded | time "
            "| / A\\* |",
            "|---|---|---|---|---|---|---|---|",
        ]
        sections = []
        for _, name, where in (n for n in program.names() if n[0] == kind):
            if kind == "smoother" and name == "none":
                continue
            arguments = picture_arguments(kind, name, where)
            svg = pictures / f"{name}.svg"
            program.text(f"{arguments} --svg {svg}")
            plain = re.sub(r" --(smoothing-steps|(steps|show) \S+)", "", arguments)
            got = median_figures(program, plain, rounds)
            micros = got["search_us"] if kind == "search" else got["smooth_us"]
            is_same_map = where in ("both", "workspace")
            to_astar = f"{micros / astar['search_us']:.2f}" if is_same_map else "–"
            cells = [got[k] for k in ("length", "ratio", "curvature", "clearance", "expanded")]
            rows.append(f"| [{name}](#{name}) | " + " | ".join(cells)
                        + f" | {time_text(micros)} | {to_astar} |")
            paragraph = next(comments.paragraphs(name)) if name in comments.by_name else None
            if paragraph is None:
                paragraph = sentence(program, name)
            sections += [f"### {name}", "", paragraph, "", f"![{name}](gallery/{name}.svg)", ""]
        lines += rows + [""] + sections
    return "\n".join(lines).rstrip() + "\n"


@functools.lru_cache(maxsize=None)
def help_of(program, name):
    return program.text(f"--help-{name}").splitlines()


def sentence(program, name):
    return help_of(program, name)[0].split("): ", 1)[-1]


def options_table(program, name):
    lines = help_of(program, name)
    head = next((i for i, line in enumerate(lines) if line.lstrip().startswith("option ")), None)
    if head is None:
        return []
    columns = ["option", "type", "unit", "default", "meaning"]
    starts = [lines[head].index(column) for column in columns]
    rows = ["| " + " | ".join(columns) + " |", "|---|---|---|---|---|"]
    for line in lines[head + 1 :]:
        if not line.strip():
            break
        cells = [line[a:b].strip() for a, b in zip(starts, starts[1:] + [None])]
        cells = [cell.replace("|", "\\|") for cell in cells]
        rows.append(f"| `{cells[0]}` | " + " | ".join(cells[1:]) + " |")
    return rows


def reference(program, comments):
    places = {
        "both": "workspaces and grid maps",
        "workspace": "workspaces",
        "grid": "grid maps",
        "vehicle": "vehicles, everywhere",
    }
    lines = [
        "# Reference",
        "",
        "Every search and smoother: what it guarantees, what it costs, where it comes from, and its",
        "options. `docs/generate.py` writes this page from the registry and the doc comments. Options are",
        "the members of the type; `tutavia-plan --search NAME:OPTION=VALUE` sets them, too.",
        "",
    ]
    for kind, title in (("search", "Searches"), ("smoother", "Smoothers")):
        rows = [f"## {title}", "", "| name | type | on | what it does |", "|---|---|---|---|"]
        sections = []
        for _, name, where in (n for n in program.names() if n[0] == kind):
            entity, _, path = comments.by_name.get(name, (None, None, None))
            cpp = f"[`{entity}`](../{path})" if entity else "an option of another"
            rows.append(f"| [{name}](#{name}) | {cpp} | {places[where]} | {sentence(program, name)} |")
            sections += [f"### {name}", ""]
            if entity:
                for paragraph in comments.paragraphs(name):
                    sections += [paragraph, ""]
            else:
                sections += [sentence(program, name), ""]
            table = options_table(program, name)
            sections += table + [""] if table else []
        lines += rows + [""] + sections
    return "\n".join(lines).rstrip() + "\n"


def readme(program, rounds):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    rows = ["| you have | take | length / optimum | a plan takes |", "|---|---|---|---|"]
    for task, types, arguments in CHOICES:
        got = median_figures(program, arguments, rounds)
        cpp = ", ".join(f"`{name}`" for name in types.split(", "))
        rows.append(f"| {task} | {cpp} | {got['ratio']} | {time_text(got['all_us'])} |")
    begin, end = "<!-- figures: docs/generate.py -->\n", "<!-- end -->"
    if text.count(begin) != 1:
        sys.exit(f"generate.py: README.md has no single line {begin.strip()}")
    before, rest = text.split(begin)
    return before + begin + "\n".join(rows) + "\n" + rest[rest.index(end) :]


def generate(program, folder, rounds):
    """The generated files: their contents by path below the root."""
    pictures = folder / "gallery"
    pictures.mkdir(parents=True, exist_ok=True)
    comments = Comments()
    program.text(f"{WORKSPACE} --smoother clothoid --animate --svg {folder / 'search.svg'}")
    files = {
        "docs/gallery.md": gallery(program, comments, pictures, rounds),
        "docs/reference.md": reference(program, comments),
        "README.md": readme(program, rounds),
        "docs/images/search.svg": (folder / "search.svg").read_text(encoding="utf-8"),
    }
    for svg in sorted(pictures.glob("*.svg")):
        files[f"docs/gallery/{svg.name}"] = svg.read_text(encoding="utf-8")
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, help="the path of tutavia-plan")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--rounds", type=int, default=9, help="of which times are medians")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        files = generate(
            Program(options.program), pathlib.Path(folder), 1 if options.check else options.rounds
        )
    if sys.stderr.isatty():
        print("\033[K", end="", file=sys.stderr)
    there = {f"docs/gallery/{svg.name}" for svg in (ROOT / "docs/gallery").glob("*.svg")}
    stale = sorted(there - files.keys())
    for path, text in files.items():
        target = ROOT / path
        old = target.read_text(encoding="utf-8") if target.exists() else ""
        if TIME.sub("", old) == TIME.sub("", text):
            if options.check or not TIME.search(text):
                continue
        elif options.check:
            stale.append(path)
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    if options.check and stale:
        sys.exit("stale: " + ", ".join(stale) + "; run cmake --build BUILD --target gallery")
    if not options.check:
        for path in stale:
            (ROOT / path).unlink()


if __name__ == "__main__":
    main()
