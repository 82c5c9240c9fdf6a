#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Counts what a reader of the library meets: names, headers and functions, with the largest of each.

    cmake/code_figures.py              the figures of this tree
    cmake/code_figures.py --names      also every name in tutavia and in tutavia::detail
    cmake/code_figures.py FOLDER       the figures of another tree

Reads the headers with libclang (python3-clang-19), as a compiler does: a name counts once, however
often it is overloaded; a function spans from its first line to its closing brace. Exits with 1 where
a header is longer than 300 lines, a function than 45, or more than 200 names are public.
"""

import argparse
import collections
import pathlib
import re
import statistics
import subprocess
import sys

from clang import cindex
from clang.cindex import CursorKind

MAX_HEADER, MAX_FUNCTION, MAX_NAMES, MAX_COLUMNS = 300, 45, 200, 100

FUNCTIONS = {CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR,
             CursorKind.DESTRUCTOR, CursorKind.CONVERSION_FUNCTION, CursorKind.FUNCTION_TEMPLATE}
SCOPES = {CursorKind.NAMESPACE, CursorKind.CLASS_DECL, CursorKind.STRUCT_DECL,
          CursorKind.CLASS_TEMPLATE, CursorKind.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION,
          CursorKind.FRIEND_DECL}


def eigen_flags():
    found = subprocess.run(["pkg-config", "--cflags", "eigen3"], capture_output=True, text=True)
    return found.stdout.split() or ["-I/usr/include/eigen3"]


def parse(root):
    """Every header of the tree in one translation unit."""
    headers = sorted((root / "include/tutavia").rglob("*.hpp"))
    source = "".join(f'#include "tutavia/{h.relative_to(root / "include/tutavia").as_posix()}"\n'
                     for h in headers)
    unit = cindex.Index.create().parse(
        "all.cpp", args=["-x", "c++", "-std=c++20", f"-I{root / 'include'}", *eigen_flags()],
        unsaved_files=[("all.cpp", source)])
    errors = [d for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if errors:
        sys.exit("\n".join(str(e) for e in errors[:5]))
    return headers, unit


def is_operator(name):
    return re.match(r"operator\b|operator[^\w]", name) is not None


class Figures:
    def __init__(self, root):
        self.root = root
        self.headers, unit = parse(root)
        self.names = collections.defaultdict(dict)  # namespace -> name -> header
        self.functions = {}                         # (header, line) -> (lines, name)
        self.visit(unit.cursor, [])

    def header_of(self, cursor):
        if cursor.location.file is None:
            return None
        path = pathlib.Path(cursor.location.file.name)
        try:
            return path.relative_to(self.root / "include/tutavia").as_posix()
        except ValueError:
            return None

    def visit(self, cursor, namespaces, is_direct_member=True):
        for child in cursor.get_children():
            header = self.header_of(child)
            if header is None:
                continue
            try:
                kind = child.kind
            except ValueError:  # a kind that the bindings do not know, such as concepts of old ones
                kind = None
            if kind == CursorKind.NAMESPACE:
                self.visit(child, namespaces + [child.spelling])
                continue
            if is_direct_member and namespaces and child.semantic_parent is not None and (
                    child.semantic_parent.kind == CursorKind.NAMESPACE):
                self.take_name(child, namespaces, header)
            if kind in FUNCTIONS and child.is_definition():
                lines = child.extent.end.line - child.extent.start.line + 1
                self.functions[header, child.extent.start.line] = (lines, child.spelling)
            if kind in SCOPES:
                self.visit(child, namespaces, is_direct_member=False)

    def take_name(self, child, namespaces, header):
        name = child.spelling
        if name and name[0] != "<" and not is_operator(name):
            self.names["::".join(namespaces)].setdefault(name, header)

    def lines(self):
        return {h.relative_to(self.root / "include/tutavia").as_posix():
                len(h.read_text().splitlines()) for h in self.headers}


def long_lines(root):
    """Lines of prose over MAX_COLUMNS: tables and code blocks may be longer."""
    found = collections.Counter()
    for page in [*root.glob("*.md"), *(root / "docs").rglob("*.md")]:
        in_code = False
        for line in page.read_text().splitlines():
            in_code ^= line.startswith("```")
            if len(line) > MAX_COLUMNS and not in_code and not line.startswith(("|", "    ")):
                found[page.relative_to(root).as_posix()] += 1
    return found


def report(root, with_names):
    figures = Figures(root)
    public, hidden = figures.names["tutavia"], figures.names["tutavia::detail"]
    print(f"names in tutavia {len(public)}, in tutavia::detail {len(hidden)}")

    modules = collections.defaultdict(lambda: [0, 0])
    for name in figures.lines():
        parts = name.split("/")
        modules[parts[0] if len(parts) > 1 else "."][len(parts) > 2] += 1
    print("headers for users, machinery:")
    for module, (users, machinery) in sorted(modules.items()):
        print(f"  {module:10} {users:3} {machinery:3}")
    total = [sum(m[i] for m in modules.values()) for i in (0, 1)]
    print(f"  {'all':10} {total[0]:3} {total[1]:3}")

    lines = figures.lines()
    print(f"header: median {statistics.median(lines.values()):g} lines, largest:")
    for name, count in sorted(lines.items(), key=lambda e: -e[1])[:8]:
        print(f"  {count:4} {name}")
    functions = sorted(((n, f"{header}:{line} {name}")
                        for (header, line), (n, name) in figures.functions.items()), reverse=True)
    print(f"function: {len(functions)}, median "
          f"{statistics.median(n for n, _ in functions):g} lines, largest:")
    shown = [f for f in functions if f[0] > MAX_FUNCTION]
    for count, name in functions[:max(5, len(shown))]:
        print(f"  {count:4} {name}")
    prose = long_lines(root)
    print(f"lines of prose over {MAX_COLUMNS} columns: {sum(prose.values())}", *(
        f"\n  {count:4} {page}" for page, count in prose.most_common()), sep="")
    if with_names:
        for namespace in ("tutavia", "tutavia::detail"):
            print(f"\n{namespace}:")
            for name, header in sorted(figures.names[namespace].items()):
                print(f"  {name:40} {header}")
    return (max(lines.values()) <= MAX_HEADER and not shown and len(public) <= MAX_NAMES
            and not prose)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    here = pathlib.Path(__file__).resolve().parent.parent
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=here)
    parser.add_argument("--names", action="store_true", help="list every name and its header")
    arguments = parser.parse_args()
    return 0 if report(arguments.folder.resolve(), arguments.names) else 1


if __name__ == "__main__":
    sys.exit(main())
