"""Builds a Conan 2 package of the runtime, and of the library of mechanisms, from this tree.

conan create packaging/conan --build=missing
"""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy

_ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
_SOURCES = ("CMakeLists.txt", "LICENSE", "README.md", "cmake/*", "generated/*",
            "mechanism/*", "packaging/*", "runtime/*", "templates/*")


class Assur(ConanFile):
    name = "assur"
    description = "Closed-form solvers for planar linkages of dyads, triads and tetrads"
    license = "MIT"
    topics = ("kinematics", "linkages", "code generation")
    settings = "os", "arch", "compiler", "build_type"
    options = {"mechanism": [True, False], "fPIC": [True, False]}
    default_options = {"mechanism": True, "fPIC": True}

    def set_version(self):
        header = os.path.join(_ROOT, "runtime", "include", "assur", "version.hpp")
        with open(header, encoding="utf-8") as text:
            self.version = re.search(r'version = "([0-9.]+)"', text.read()).group(1)

    def export_sources(self):
        for pattern in _SOURCES:
            copy(self, pattern, src=_ROOT, dst=self.export_sources_folder)

    def config_options(self):
        if self.settings.os == "Windows":
            del self.options.fPIC

    def validate(self):
        check_min_cppstd(self, 20 if self.options.mechanism else 17)

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("eigen/[>=3.4 <4]", transitive_headers=True)
        if self.options.mechanism:
            self.requires("nlohmann_json/[>=3.11 <4]")
            self.requires("boost/[>=1.74 <2]", options={"header_only": True})

    def package_id(self):
        if not self.info.options.mechanism:
            self.info.clear()

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["ASSUR_BUILD_GENERATOR"] = False
        toolchain.cache_variables["ASSUR_BUILD_TESTS"] = False
        toolchain.cache_variables["ASSUR_PYTHON"] = "OFF"
        toolchain.cache_variables["ASSUR_BUILD_MECHANISM"] = bool(self.options.mechanism)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", src=self.source_folder,
             dst=os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        # What is installed has its own assurConfig.cmake, with the targets that users know.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs.append(os.path.join("lib", "cmake", "assur"))
