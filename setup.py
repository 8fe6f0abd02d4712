"""Builds the Python package by setuptools, whose extension module CMake and Ninja compile.

CMake reads its own variables of the environment, such as CXX and CMAKE_CXX_COMPILER_LAUNCHER, and
this file CMAKE_ARGS, further arguments for CMake: CMAKE_ARGS=-DASSUR_FAST_MECHANISM=ON.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.errors import ExecError

SOURCE = pathlib.Path(__file__).resolve().parent
# CMake's folder is in the source tree, so that a second build compiles only what has changed. What
# CMake has found is found anew: an earlier build may have had another environment.
FOLDER = SOURCE / f"build-{sys.implementation.cache_tag}"
SETTINGS = {"ASSUR_BUILD_GENERATOR": "OFF", "ASSUR_BUILD_MECHANISM": "ON",
            "ASSUR_BUILD_TESTS": "OFF", "ASSUR_PYTHON": "ON", "Python3_EXECUTABLE": sys.executable}
REMEDY = ("on Debian: apt-get install g++ cmake ninja-build libeigen3-dev nlohmann-json3-dev "
          "libboost-dev pybind11-dev python3-dev python3-numpy")


def version():
    header = SOURCE / "runtime/include/assur/version.hpp"
    return re.search(r'version = "([0-9.]+)"', header.read_text())[1]


def fault(said):
    """The first error that CMake tells, as one line."""
    error = re.search(r"CMake Error[^\n]*:\n+(.*?)(?:\n\n\n|Call Stack|\Z)", said, re.DOTALL)
    return " ".join((error[1] if error else said).split())


class CMakeBuild(build_ext):
    """Has CMake build the module, and copies it to where setuptools collects it."""

    def build_extension(self, ext):
        for program in ("cmake", "ninja"):
            if shutil.which(program) is None:
                raise ExecError(f"{program} is not installed; {REMEDY}")
        self.configure()
        subprocess.run(["cmake", "--build", FOLDER, "--target", "assur_python"], check=True)
        built = FOLDER / "python" / self.get_ext_filename(ext.name)
        self.copy_file(built, self.get_ext_fullpath(ext.name))

    def configure(self):
        settings = dict(SETTINGS)
        try:
            import pybind11
            settings["pybind11_DIR"] = pybind11.get_cmake_dir()
        except ImportError:
            pass  # CMake looks where the system has it
        configured = subprocess.run(
            ["cmake", "--fresh", "--preset", "release", "-B", FOLDER,
             *(f"-D{name}={value}" for name, value in settings.items()),
             *shlex.split(os.environ.get("CMAKE_ARGS", ""))],
            cwd=SOURCE, capture_output=True, text=True, check=False)
        print(configured.stdout)
        if configured.returncode != 0:
            raise ExecError(f"CMake: {fault(configured.stderr)}; {REMEDY}")

    def copy_file(self, infile, outfile, *args, **options):
        self.mkpath(os.path.dirname(outfile))
        return super().copy_file(str(infile), outfile, *args, **options)


setup(version=version(), ext_modules=[Extension("assur._assur", sources=[])],
      cmdclass={"build_ext": CMakeBuild}, options={"build": {"build_base": f"{FOLDER.name}/setuptools"}})
