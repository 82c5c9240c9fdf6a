# SPDX-License-Identifier: MIT
"""The recipe of tutavia for Conan 2: conan create packaging/conan"""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, load


class TutaviaConan(ConanFile):
    name = "tutavia"
    description = ("Safe, smooth, short paths for a disc-shaped robot, "
                   "proved on the continuous curve")
    license = "MIT"
    topics = ("path-planning", "robotics", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"with_json": [True, False]}
    default_options = {"with_json": True}
    no_copy_source = True

    def _root(self):
        return os.path.join(self.recipe_folder, os.pardir, os.pardir)

    def set_version(self):
        header = load(self, os.path.join(self._root(), "include/tutavia/core/version.hpp"))
        parts = re.findall(r"#define TUTAVIA_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header)
        self.version = ".".join(parts)

    def export_sources(self):
        for pattern in ("include/*", "LICENSE"):
            copy(self, pattern, self._root(), self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/[>=3.4]")
        if self.options.with_json:
            self.requires("nlohmann_json/[>=3.9]")

    def validate(self):
        check_min_cppstd(self, 20)

    def package_id(self):
        # Only whether the headers of JSON are there tells packages apart.
        self.info.settings.clear()
        self.info.requires.clear()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        excluded = ["*_yaml.hpp", "*_stb.hpp"]  # tutavia::ros needs stb_image as a library
        if not self.options.with_json:
            excluded.append("*_json.hpp")
        copy(self, "*.hpp", os.path.join(self.source_folder, "include"),
             os.path.join(self.package_folder, "include"), excludes=excluded)

    def package_info(self):
        # The targets have the names that the CMake package of the library gives them.
        self.cpp_info.set_property("cmake_file_name", "tutavia")
        core = self.cpp_info.components["tutavia"]
        core.set_property("cmake_target_name", "tutavia::tutavia")
        core.set_property("pkg_config_name", "tutavia")
        core.requires = ["eigen::eigen"]
        core.bindirs = core.libdirs = []
        if self.settings.os in ("Linux", "FreeBSD"):
            core.system_libs = ["pthread", "m"]
        if self.options.with_json:
            json = self.cpp_info.components["json"]
            json.set_property("cmake_target_name", "tutavia::json")
            json.requires = ["tutavia", "nlohmann_json::nlohmann_json"]
            json.bindirs = json.libdirs = []
