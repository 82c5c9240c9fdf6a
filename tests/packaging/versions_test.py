#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that all files that name the version name that of core/version.hpp."""

import json
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEADER = (ROOT / "include/tutavia/core/version.hpp").read_text()
VERSION = ".".join(re.findall(r"#define TUTAVIA_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", HEADER))


class VersionsTest(unittest.TestCase):
    def found(self, name, pattern):
        match = re.search(pattern, (ROOT / name).read_text(), re.M)
        self.assertIsNotNone(match, name)
        return match[1]

    def test_the_changelog_begins_with_it(self):
        self.assertEqual(self.found("CHANGELOG.md", r"^## (\S+)"), VERSION)

    def test_citations_name_it(self):
        self.assertEqual(self.found("CITATION.cff", r"^version: (\S+)"), VERSION)

    def test_the_vcpkg_port_has_it(self):
        port = json.loads((ROOT / "packaging/vcpkg/tutavia/vcpkg.json").read_text())
        self.assertEqual(port["version"], VERSION)

    def test_consumers_ask_for_it(self):
        asked = self.found("tests/consumer_install/CMakeLists.txt", r"find_package\(tutavia (\S+)")
        self.assertEqual(asked, VERSION.rpartition(".")[0])


if __name__ == "__main__":
    unittest.main()
