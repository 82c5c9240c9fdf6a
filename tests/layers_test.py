#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tries cmake/check_layers.py: this tree passes, and a breach of each rule is found and named."""

import pathlib
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "cmake"))
sys.dont_write_bytecode = True

import check_layers  # noqa: E402

HEADER = "// SPDX-License-Identifier: MIT\n#pragma once\n\n"


class LayersTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)
        for folder in ("include", "examples", "tests/support"):
            shutil.copytree(ROOT / folder, self.root / folder)

    def path(self, name):
        return self.root / "include/tutavia" / name

    def append(self, name, text):
        self.path(name).write_text(self.path(name).read_text() + text)

    def write(self, name, text):
        self.path(name).parent.mkdir(parents=True, exist_ok=True)
        self.path(name).write_text(text)

    def replace(self, name, old, new):
        text = self.path(name).read_text()
        self.assertIn(old, text)
        self.path(name).write_text(text.replace(old, new))

    def assert_breach(self, *told):
        found = list(check_layers.breaches(self.root))
        for part in told:
            self.assertTrue(any(part in breach for breach in found), f"{part!r} not in {found}")

    def test_this_tree_keeps_all_rules(self):
        self.assertEqual(list(check_layers.breaches(ROOT)), [])

    def test_the_documentation_shows_the_table(self):
        self.assertIn("\n".join(check_layers.table()), (ROOT / "docs/architecture.md").read_text())

    def test_higher_layer(self):
        self.append("world/frame.hpp", '#include "tutavia/search/astar.hpp"\n')
        self.assert_breach("world/frame.hpp", "includes search/astar.hpp from a higher layer")

    def test_neighbour_in_a_layer(self):
        self.append("metrics/path_metrics.hpp", '#include "tutavia/motion/speed_profile.hpp"\n')
        self.assert_breach("includes motion/speed_profile.hpp from a neighbour in its layer")

    def test_missing_header(self):
        self.append("world/frame.hpp", '#include "tutavia/core/no_such.hpp"\n')
        self.assert_breach("includes core/no_such.hpp, which is not there")

    def test_module_without_a_layer(self):
        self.write("attic/old.hpp", HEADER)
        self.assert_breach("attic/old.hpp: belongs to no layer")

    def test_machinery_of_another_module(self):
        self.append("smooth/shortcut.hpp", '#include "tutavia/search/grid/best_first.hpp"\n')
        self.assert_breach("includes search/grid/best_first.hpp, machinery of another module")

    def test_machinery_of_the_registry_is_for_the_registry(self):
        self.append("io/plan_json.hpp", '#include "tutavia/registry/options/option_kind.hpp"\n')
        self.assert_breach("io/plan_json.hpp",
                           "includes registry/options/option_kind.hpp, machinery of another module")

    def test_registry_in_an_umbrella(self):
        self.append("tutavia.hpp", '#include "tutavia/registry/option_value.hpp"\n')
        self.assert_breach("tutavia.hpp: includes registry/option_value.hpp, which is not its own")

    def test_header_of_the_registry_includes_from_a_higher_layer(self):
        self.append("registry/option_value.hpp", '#include "tutavia/registry.hpp"\n')
        self.assert_breach("registry/option_value.hpp", "includes registry.hpp from a higher layer")

    def test_stale_exception(self):
        for path in sorted((self.root / "include/tutavia").rglob("*.hpp")):
            path.write_text(path.read_text().replace(
                '#include "tutavia/core/parts/bytes.hpp"\n', ""))
        self.assert_breach("SHARED names core/parts/bytes.hpp, which no other module includes")

    def test_machinery_in_the_open_namespace(self):
        self.append("search/grid/best_first.hpp", "namespace tutavia {\nstruct Open {};\n}\n")
        self.assert_breach("search/grid/best_first.hpp", "machinery outside tutavia::detail")

    def test_public_name_that_machinery_alone_uses(self):
        self.append("world/frame.hpp", "namespace tutavia {\nstruct OnlyInside {};\n}\n")
        self.append("search/grid/best_first.hpp",
                    "namespace tutavia::detail {\nusing Inside = OnlyInside;\n}\n")
        self.assert_breach("world/frame.hpp: OnlyInside is public, and machinery alone uses it")

    def test_public_function_that_machinery_alone_uses(self):
        self.append("world/frame.hpp", "namespace tutavia {\ninline int only_inside() { return 1; }\n}\n")
        self.append("search/grid/best_first.hpp",
                    "namespace tutavia::detail {\ninline int f() { return only_inside(); }\n}\n")
        self.assert_breach("world/frame.hpp: only_inside is public, and machinery alone uses it")

    def test_header_left_out_of_its_umbrella(self):
        self.replace("smooth.hpp", '#include "tutavia/smooth/shortcut.hpp"\n', "")
        self.assert_breach("smooth.hpp: does not include smooth/shortcut.hpp")

    def test_umbrella_left_out_of_the_whole(self):
        self.replace("tutavia.hpp", '#include "tutavia/smooth.hpp"\n', "")
        self.assert_breach("tutavia.hpp: does not include smooth.hpp")

    def test_machinery_in_an_umbrella(self):
        self.append("search.hpp", '#include "tutavia/search/grid/best_first.hpp"\n')
        self.assert_breach("search.hpp: includes search/grid/best_first.hpp, which is not its own")

    def test_umbrella_that_is_not_there(self):
        self.path("motion.hpp").unlink()
        self.assert_breach("motion.hpp: is not there")

    def test_umbrella_inside_the_library(self):
        self.append("search/astar.hpp", '#include "tutavia/space.hpp"\n')
        self.assert_breach("includes the umbrella space.hpp")

    def test_boost(self):
        self.append("io/wkt.hpp", "#include <boost/geometry.hpp>\n")
        self.assert_breach("includes Boost")

    def test_boost_through_another_header(self):
        self.append("io/wkt.hpp", '#include "tutavia/geometry/boost_adapt.hpp"\n')
        self.assert_breach("io/wkt.hpp", "includes geometry/boost_adapt.hpp and with it Boost")

    def test_boost_in_an_umbrella(self):
        self.append("geometry.hpp", '#include "tutavia/geometry/boost_adapt.hpp"\n')
        self.assert_breach("geometry.hpp: includes geometry/boost_adapt.hpp, which is not its own")

    def test_stale_exception_for_boost(self):
        self.write("geometry/boost_adapt.hpp", HEADER)
        self.assert_breach("WITH_BOOST names geometry/boost_adapt.hpp, which does not include Boost")

    def test_eigen_in_core(self):
        self.append("core/budget.hpp", "#include <Eigen/Core>\n")
        self.assert_breach("core/budget.hpp", "includes Eigen")

    def test_first_lines(self):
        self.replace("core/random.hpp", "// SPDX-License-Identifier: MIT\n", "")
        self.assert_breach("core/random.hpp: does not begin with the licence line")

    def test_algorithm_without_an_example(self):
        self.replace("search/dijkstra.hpp", "/// Example: examples/searches_on_cells.cpp.\n", "")
        self.assert_breach("search/dijkstra.hpp: Dijkstra names no program that shows it")

    def test_example_that_does_not_show_it(self):
        self.replace("search/dijkstra.hpp", "examples/searches_on_cells.cpp", "examples/smoothers.cpp")
        self.assert_breach("search/dijkstra.hpp: examples/smoothers.cpp does not show Dijkstra")


if __name__ == "__main__":
    unittest.main()
