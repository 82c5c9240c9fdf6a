#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks how the headers of tutavia are arranged.

    cmake/check_layers.py           checks this tree; exits with 1 and one line per breach
    cmake/check_layers.py --table   prints the table of layers in docs/architecture.md
    cmake/check_layers.py FOLDER    checks another tree

The rules:
  - a header includes lower layers only, and within a layer only its own module;
  - a header in a subfolder of a module is machinery: all of it is in tutavia::detail, and no other
    module includes it but as SHARED says;
  - no name is public that machinery alone uses;
  - an umbrella per module includes every header for users, tutavia.hpp every umbrella, and nothing
    else includes one;
  - nothing includes Boost but what WITH_BOOST names, and core/ not even Eigen;
  - every header begins with the licence line and #pragma once;
  - every algorithm and every concept for users names a program or a test that shows it.
"""

import argparse
import pathlib
import re
import sys

# From the bottom up: a module, or a header beside the modules, and what it holds.
LAYERS = [
    [("core", "what no standard library has yet: Expected, Budget, Random")],
    [("geometry", "points, the pieces of curves, polygons, exact predicates")],
    [("plan", "the words of planning: Query, Route, Failure, Statistics")],
    [("grid", "cells, steps and their costs, occupancy grids")],
    [("world", "workspaces, scenes, the built-in maps")],
    [("space", "free space as algorithms ask it: polygons and discs, lattices, cells")],
    [("certify", "proofs that a curve is safe")],
    [("search", "searchers: from a query to a route")],
    [("tuning", "parameters found by a swarm"), ("smooth", "smoothers: from a curve to a curve"),
     ("metrics", "measures of a curve"), ("motion", "speed along a curve, local planning")],
    [("planner.hpp", "search, smoothing and proof in one call"),
     ("optimum.hpp", "the length of the shortest path there is"),
     ("registry", "the options of every algorithm as tables")],
    [("any_algorithm.hpp", "searchers and smoothers chosen at run time"),
     ("io", "files and pictures"), ("batch.hpp", "many queries on many threads"),
     ("repair.hpp", "plans for obstacles that have changed")],
    [("registry.hpp", "every algorithm by its name")],
]
LEVEL = {unit: level for level, units in enumerate(LAYERS) for unit, _ in units}

# Machinery that other modules include, and why.
SHARED = {
    "core/parts/bytes.hpp": "prepared tables write themselves to files",
    "core/parts/compiler.hpp": "hints to the compiler in inner loops",
    "core/parts/number_text.hpp": "numbers in messages",
    "core/parts/read_number.hpp": "numbers of files and options",
    "core/parts/parallel.hpp": "loops on several threads",
    "core/parts/remove_redundant.hpp": "searches tidy their paths as a smoother does",
    "core/parts/zeroed_array.hpp": "labels of searches",
    "geometry/numeric/exact_number.hpp": "cells decide ties in exact numbers",
    "geometry/tangent/clothoid_pair.hpp": "clothoid smoothers round corners with it",
    "geometry/tangent/funnel.hpp": "searches and smoothers pull paths through portals",
    "geometry/tangent/oriented_box.hpp": "the taut string sweeps a box over its obstacles",
    "geometry/tangent/tangent_line.hpp": "searches and smoothers draw tangents to safety zones",
    "grid/bitboard/bits.hpp": "cells look at many neighbours at once",
    "grid/bitboard/corner_cells.hpp": "spaces and meshes ask what meets at a corner of cells",
    "grid/bitboard/free_runs.hpp": "searches and smoothers walk over runs of free cells",
    "grid/bitboard/places.hpp": "jumps address a grid by rows and by columns",
    "grid/bitboard/stop_planes.hpp": "spaces keep the planes in which searches jump",
    "grid/bitboard/turn_planes.hpp": "spaces keep the planes in which searches jump",
    "grid/bitboard/successors.hpp": "searches step through the tables of successors",
    "grid/bitboard/transposed.hpp": "spaces keep their columns as rows",
    "search/vehicle/drive_chain.hpp": "searches and smoothers chain drives of vehicles",
    "search/vehicle/driving_costs.hpp": "searches and smoothers weigh drives alike",
    "smooth/route/curve_side.hpp": "repairs join new parts to what stays of a curve",
    "smooth/route/risk_runs.hpp": "plans keep smoothed curves out of the zones a search avoided",
    "space/index/passing_radius.hpp": "tangents leave the rounding of a proof to each side",
}

# Public names that machinery alone uses in this tree and users may nevertheless.
FOR_USERS = {
    "polyline_obstacle": "walls without thickness in workspaces of users",
    "RectangleObserver": "observers of users model it",
}

# Headers that include Boost, and why. They are in no umbrella, and no other header includes them.
WITH_BOOST = {
    "geometry/boost_adapt.hpp": "for programs that use Boost.Geometry themselves",
}

# For programs that choose by name. The header registry.hpp is no umbrella of the folder registry/.
NOT_IN_UMBRELLA = ("any_algorithm.hpp", "registry.hpp", "registry")

LICENCE = "// SPDX-License-Identifier: MIT\n#pragma once\n"
INCLUDE = re.compile(r'#include [<"]([^">]+)[">]')
# Declarations begin in the first column: clang-format does not indent namespaces.
DECLARED = re.compile(
    r"^(?:class|struct|enum class|enum|concept)\s+(?P<type>\w+)|^using\s+(?P<alias>\w+)\s*=|"
    r"^inline constexpr\s[^=({]*?\b(?P<constant>\w+)\s*[={]|"
    r"^(?!class|struct|enum|using|concept|template|namespace|return|friend|#|static_assert)"
    r"[\w:<][\w:<>,&*\s\[\]]*?[\s&*>](?P<function>\w+)\(", re.M)


class Header:
    def __init__(self, name, text):
        self.name = name
        self.text = text
        self.parts = name.split("/")
        self.unit = self.parts[0]
        self.module = self.unit if len(self.parts) > 1 else None
        self.is_machinery = len(self.parts) > 2
        self.code = re.sub(r"//[^\n]*", "", text)

    @property
    def owner(self):
        """The module whose machinery the header may include: registry.hpp includes registry/'s."""
        return self.module or self.name.removesuffix(".hpp")

    @property
    def is_optional(self):
        """Whether the header needs a library of tutavia::json or tutavia::ros."""
        return self.name.endswith(("_json.hpp", "_yaml.hpp", "_stb.hpp"))

    def includes(self):
        for number, line in enumerate(self.text.splitlines(), 1):
            if match := INCLUDE.match(line):
                yield number, match[1]

    def public_names(self):
        """What the header declares in tutavia itself."""
        code = re.sub(r"^namespace detail \{.*?^\}  // namespace detail", "", self.code, flags=re.M | re.S)
        return {name for match in DECLARED.finditer(code) for name in match.groups() if name}


def read(root):
    folder = root / "include/tutavia"
    return {path.relative_to(folder).as_posix():
            Header(path.relative_to(folder).as_posix(), path.read_text())
            for path in sorted(folder.rglob("*.hpp"))}


def is_umbrella(name):
    return name == "tutavia.hpp" or (name not in LEVEL and name.removesuffix(".hpp") in LEVEL)


def check_includes(headers):
    for header in headers.values():
        if is_umbrella(header.name):
            continue
        if header.unit not in LEVEL:
            yield f"{header.name}: belongs to no layer"
            continue
        for line, included in header.includes():
            where = f"{header.name}:{line}"
            if included.startswith("boost/") and header.name not in WITH_BOOST:
                yield f"{where}: includes Boost, which the library does without"
            if included.startswith("Eigen/") and header.module == "core":
                yield f"{where}: includes Eigen, which core/ does without"
            if included.startswith("tutavia/"):
                yield from check_include(headers, header, included.removeprefix("tutavia/"), where)


def check_include(headers, header, included, where):
    target = headers.get(included)
    if included in WITH_BOOST:
        yield f"{where}: includes {included} and with it Boost, which the library does without"
    if target is None:
        yield f"{where}: includes {included}, which is not there"
    elif is_umbrella(included):
        yield f"{where}: includes the umbrella {included}"
    elif target.unit not in LEVEL:
        return  # told where the header itself is
    elif LEVEL[target.unit] > LEVEL[header.unit]:
        yield f"{where}: includes {included} from a higher layer"
    elif target.unit != header.unit and LEVEL[target.unit] == LEVEL[header.unit]:
        yield f"{where}: includes {included} from a neighbour in its layer"
    elif target.is_machinery and target.module != header.owner and included not in SHARED:
        yield f"{where}: includes {included}, machinery of another module"


def check_shared(headers):
    used = {included.removeprefix("tutavia/") for header in headers.values()
            for _, included in header.includes()
            if header.module != included.removeprefix("tutavia/").split("/")[0]}
    for name in SHARED:
        if name not in used:
            yield f"check_layers.py: SHARED names {name}, which no other module includes"


def check_with_boost(headers):
    for name in WITH_BOOST:
        if name not in headers or "#include <boost/" not in headers[name].text:
            yield f"check_layers.py: WITH_BOOST names {name}, which does not include Boost"


def check_machinery(headers):
    for header in headers.values():
        if not header.is_machinery:
            continue
        for line, content in enumerate(header.text.splitlines(), 1):
            if re.match(r"namespace (?!tutavia::detail\b)tutavia\b", content):
                yield f"{header.name}:{line}: machinery outside tutavia::detail"


def words_of(text):
    return set(re.findall(r"\w+", text))


def check_public_names(root, headers):
    """Compares words, so a name counts as used wherever users' code says it."""
    users = [words_of(path.read_text()) for folder in ("examples", "benchmarks", "tests")
             for path in sorted((root / folder).rglob("*.?pp"))
             if folder != "tests" or len(path.relative_to(root).parts) <= 3]
    open_headers = {h.name: words_of(h.code) for h in headers.values() if not h.is_machinery}
    machinery = set().union(*(words_of(h.code) for h in headers.values() if h.is_machinery))
    for header in headers.values():
        if header.is_machinery or is_umbrella(header.name):
            continue
        once = [name for name in header.public_names()
                if len(re.findall(rf"\b{name}\b", header.code)) == 1]
        for name in sorted(once):
            elsewhere = any(name in words for other, words in open_headers.items()
                            if other != header.name)
            if (name in machinery and not elsewhere and name not in FOR_USERS
                    and not any(name in words for words in users)):
                yield f"{header.name}: {name} is public, and machinery alone uses it"


def check_umbrellas(headers):
    modules = {header.module for header in headers.values()
               if header.module in LEVEL and header.module not in NOT_IN_UMBRELLA}
    wanted = {"tutavia.hpp": {f"{module}.hpp" for module in modules} | {
        name for name in headers if "/" not in name and name in LEVEL
        and name not in NOT_IN_UMBRELLA}}
    for module in modules:
        wanted[f"{module}.hpp"] = {h.name for h in headers.values()
                                   if h.module == module and not h.is_machinery and not h.is_optional
                                   and h.name not in WITH_BOOST}
    for umbrella, names in sorted(wanted.items()):
        if umbrella not in headers:
            yield f"{umbrella}: is not there"
            continue
        included = {i.removeprefix("tutavia/") for _, i in headers[umbrella].includes()}
        for name in sorted(names - included):
            yield f"{umbrella}: does not include {name}"
        for name in sorted(included - names):
            yield f"{umbrella}: includes {name}, which is not its own"


def check_first_lines(headers):
    for header in headers.values():
        if not header.text.startswith(LICENCE):
            yield f"{header.name}: does not begin with the licence line and #pragma once"


def check_examples(root, headers):
    """The doc comment of an entity ends with `Example: examples/name.cpp.` or `A minimal model:`."""
    entity = re.compile(r"((?:^///.*\n)*)(?:^template <.*>\n)?^(?:concept|struct) (\w+)([^;{]*[{;]\n"
                        r"  static constexpr std::string_view name)?", re.M)
    for header in headers.values():
        if header.is_machinery:
            continue
        code = re.sub(r"^namespace detail \{.*?^\}  // namespace detail", "", header.text, flags=re.M | re.S)
        for comment, name, algorithm in entity.findall(code):
            is_concept = re.search(rf"^concept {name}\b", code, re.M) is not None
            if not algorithm and not is_concept:
                continue
            shown = re.search(r"(?:Example|A minimal model): ((?:examples|tests)/[\w/]+\.[ch]pp)",
                              comment)
            if shown is None:
                yield f"{header.name}: {name} names no program that shows it"
            elif not re.search(rf"\b{name}\b", read_or_empty(root / shown[1])):
                yield f"{header.name}: {shown[1]} does not show {name}"


def read_or_empty(path):
    return path.read_text() if path.exists() else ""


def breaches(root):
    headers = read(root)
    yield from check_includes(headers)
    yield from check_shared(headers)
    yield from check_with_boost(headers)
    yield from check_machinery(headers)
    yield from check_public_names(root, headers)
    yield from check_umbrellas(headers)
    yield from check_first_lines(headers)
    yield from check_examples(root, headers)


def table():
    yield "| layer | module | holds |"
    yield "|---|---|---|"
    for level, units in enumerate(LAYERS):
        for unit, holds in units:
            yield f"| {level} | `{unit}{'' if unit.endswith('.hpp') else '/'}` | {holds} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    here = pathlib.Path(__file__).resolve().parent.parent
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=here)
    parser.add_argument("--table", action="store_true", help="print the table of layers")
    arguments = parser.parse_args()
    if arguments.table:
        print("\n".join(table()))
        return 0
    found = list(breaches(arguments.folder))
    print("\n".join(found) if found else "layers: every header is in its place")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
