#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks how the tests are arranged.

    tests/check_mirror.py           checks this tree; exits with 1 and one line per breach
    tests/check_mirror.py FOLDER    checks another tree

The rules:
  - a file x_test.cpp or x_BEHAVIOUR_test.cpp stands where its header x.hpp does in include/tutavia,
    or tests/README.md names it and says why;
  - every header has such a file, or tests/README.md names it and says what covers it;
  - tests/README.md names nothing else;
  - no body of a test has more than 60 lines;
  - nothing is printed.
"""

import argparse
import fnmatch
import pathlib
import re
import sys

LONGEST_BODY = 60
FILES, HEADERS = "## Files without a header of their name", "## Headers without a file of their name"
TEST_CASE = re.compile(r"(?:TEST_CASE|TEST_CASE_METHOD|TEMPLATE_\w*TEST_CASE\w*|SCENARIO)\(")
PRINTING = re.compile(r"\b(?:v?f?printf|f?puts|putchar|fwrite|cout|cerr|clog)\b")


def section_rows(text, heading):
    """The rows of the table below a heading: the names in the first column, and all others."""
    _, found, rest = text.partition(heading + "\n")
    if not found:
        return
    for line in rest.split("\n## ")[0].splitlines():
        cells = [re.findall(r"`([^`]+)`", cell) for cell in line.strip("|").split("|")]
        if line.startswith("| `"):
            yield cells[0], [name for cell in cells[1:] for name in cell]


def header_of(test, headers):
    """The header that a test file stands for, the longest name first, or None."""
    stem = test.removesuffix("_test.cpp")
    while True:
        if stem + ".hpp" in headers:
            return stem + ".hpp"
        folder, slash, name = stem.rpartition("/")
        if "_" not in name:
            return None
        stem = folder + slash + name.rpartition("_")[0]


def mirror_breaches(tests, headers, readme):
    mirrored = {test: header_of(test, headers) for test in tests}
    listed_files = {name for names, _ in section_rows(readme, FILES) for name in names}
    for test in sorted(tests):
        if mirrored[test] is None and test not in listed_files:
            yield f"tests/{test}: has no header of its name, and README.md does not name it"
    for name in sorted(listed_files):
        if mirrored.get(name, "") is not None:
            why = "has a header of its name" if name in tests else "is not there"
            yield f"tests/README.md: {name} {why}"
    without = set(headers) - set(mirrored.values())
    for names, covers in section_rows(readme, HEADERS):
        for name in names:
            covered = fnmatch.filter(without, name)
            if not covered:
                yield f"tests/README.md: {name} is no header without a file of its name"
            without.difference_update(covered)
        for cover in covers:
            if cover.endswith("_test.cpp") and cover not in tests:
                yield f"tests/README.md: {cover} is not there"
    for header in sorted(without):
        yield f"{header}: has no test file of its name, and tests/README.md does not name it"


def text_breaches(path, text):
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        if PRINTING.search(line.partition("//")[0]):
            yield f"tests/{path}:{number}: prints"
        if not TEST_CASE.match(line):
            continue
        # clang-format puts the closing brace into the first column.
        end = next((i for i, last in enumerate(lines[number - 1:], number)
                    if last.startswith("}") or (last.rstrip().endswith("}") and i == number)),
                   len(lines))
        if end - number + 1 > LONGEST_BODY:
            yield f"tests/{path}:{number}: a test of {end - number + 1} lines"


def breaches(root):
    folder, include = root / "tests", root / "include/tutavia"
    headers = {path.relative_to(include).as_posix() for path in include.rglob("*.hpp")}
    tests = {path.relative_to(folder).as_posix() for path in folder.rglob("*_test.cpp")}
    readme = folder / "README.md"
    yield from mirror_breaches(tests, headers, readme.read_text() if readme.exists() else "")
    support = {path.relative_to(folder).as_posix() for path in (folder / "support").rglob("*.?pp")}
    for path in sorted(tests | support):
        yield from text_breaches(path, (folder / path).read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", nargs="?", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent)
    found = list(breaches(parser.parse_args().root))
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
