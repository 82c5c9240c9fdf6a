#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tries cmake/single_header.py: headers come once and in order, and what cannot is refused."""

import pathlib
import re
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "cmake"))
sys.dont_write_bytecode = True

import single_header  # noqa: E402

OWN = re.compile(r'^#include "(tutavia/[^"]+)"', re.M)


class SingleHeaderTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)
        shutil.copytree(ROOT / "include", self.root / "include")
        shutil.copy(ROOT / "LICENSE", self.root)

    def append(self, name, text):
        path = self.root / "include/tutavia" / name
        path.write_text(path.read_text() + text)

    def reached(self, name="tutavia/tutavia.hpp", found=None):
        found = set() if found is None else found
        if name not in found:
            found.add(name)
            for included in OWN.findall((ROOT / "include" / name).read_text()):
                self.reached(included, found)
        return found

    def test_every_header_comes_once_after_those_it_includes(self):
        text = single_header.single_header(ROOT)
        parts = re.findall(r"^// (tutavia/\S+\.hpp)$", text, re.M)
        self.assertEqual(len(parts), len(set(parts)))
        self.assertGreater(len(parts), 200)
        for name in self.reached():
            code = (ROOT / "include" / name).read_text()
            if name not in parts:  # nothing but includes
                self.assertNotIn("namespace tutavia", code)
                continue
            for included in OWN.findall(code):
                if included in parts:
                    self.assertLess(parts.index(included), parts.index(name))
        self.assertEqual(set(parts) - self.reached(), set())

    def test_what_is_included_stands_on_top_once(self):
        text = single_header.single_header(ROOT)
        includes = re.findall(r"^\s*#\s*include\s*(.*)", text, re.M)
        self.assertEqual(len(includes), len(set(includes)))
        # Below stand those of the standard library that not every one has.
        below = text.partition("\nnamespace ")[2]
        self.assertEqual(re.findall(r"#if(?:def)? .*\n#include (.*)", below), ["<stop_token>"])
        self.assertEqual(below.count("#include"), 1)
        self.assertNotIn("#pragma once", text)
        self.assertEqual(text.count("SPDX-License-Identifier"), 1)

    def test_a_standard_header_under_a_condition_stays_there(self):
        lines = "#ifdef __linux__\n#include <unistd.h>\n#endif\n"
        self.append("core/random.hpp", lines)
        self.assertIn(lines, single_header.single_header(self.root))

    def test_a_header_of_the_library_under_a_condition_is_refused(self):
        self.append("core/random.hpp",
                    '#ifdef __linux__\n#include "tutavia/core/budget.hpp"\n#endif\n')
        with self.assertRaisesRegex(SystemExit, "core/random.hpp:.*under a condition"):
            single_header.single_header(self.root)

    def test_another_library_is_refused(self):
        self.append("core/random.hpp", "#include <boost/version.hpp>\n")
        with self.assertRaisesRegex(SystemExit, "boost/version.hpp"):
            single_header.single_header(self.root)


if __name__ == "__main__":
    unittest.main()
