#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that every header includes lower layers only, and within a layer only its own folder."""

import pathlib
import re
import sys

LAYERS = {
    "core": 0,
    "geometry": 1, "grid": 1,
    "world": 2,
    "space": 3,
    "certify": 4,
    "pull": 5,
    "search": 6,
    "smooth": 7, "metrics": 7, "motion": 7,
    "io": 8, "planner.hpp": 8, "batch.hpp": 8, "optimum.hpp": 8,
    "any_algorithm.hpp": 8, "registry.hpp": 8,
    "tutavia.hpp": 9,
}
# Within layer 8: input and output may name the plan that they write, batches plan, the registry
# lists erased algorithms.
WITHIN_LAYER = {("io", "planner.hpp"), ("batch.hpp", "planner.hpp"),
                ("registry.hpp", "any_algorithm.hpp")}


def unit(path):
    return path.split("/")[0]


def complaints(root):
    for header in sorted((root / "include/tutavia").rglob("*.hpp")):
        name = header.relative_to(root / "include/tutavia").as_posix()
        if unit(name) not in LAYERS:
            yield f"{name}: belongs to no layer"
            continue
        text = header.read_text()
        for line, content in enumerate(text.splitlines(), 1):
            if re.match(r'#include [<"]boost/', content):
                yield f"{name}:{line}: includes Boost, which the library does without"
            match = re.match(r'#include "tutavia/(.+)"', content)
            if not match:
                continue
            included = match[1]
            here, there = LAYERS[unit(name)], LAYERS.get(unit(included))
            if there is None or not (root / "include/tutavia" / included).exists():
                yield f"{name}:{line}: includes {included}, which is not there"
            elif there > here:
                yield f"{name}:{line}: includes {included} from a higher layer"
            elif (there == here and unit(name) != unit(included)
                  and (unit(name), unit(included)) not in WITHIN_LAYER):
                yield f"{name}:{line}: includes {included} from a neighbour in its layer"
        if not text.startswith("// SPDX-License-Identifier: MIT\n#pragma once\n"):
            yield f"{name}: does not begin with the licence line and #pragma once"
    umbrella = (root / "include/tutavia/tutavia.hpp").read_text()
    for header in sorted((root / "include/tutavia").rglob("*.hpp")):
        name = header.relative_to(root / "include/tutavia").as_posix()
        left_out = (name in ("tutavia.hpp", "any_algorithm.hpp", "registry.hpp")
                    or name.endswith("_json.hpp"))
        if not left_out and f'"tutavia/{name}"' not in umbrella:
            yield f"tutavia.hpp: does not include {name}"


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    found = list(complaints(root))
    print("\n".join(found) if found else "layers: every include points downwards")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
