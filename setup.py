"""Builds the compiled half of the Python module by CMake, for `pip install .`; pyproject.toml tells the rest.

The compiler is that of the environment variable CXX; other options of CMake come from CMAKE_ARGS, as
`CMAKE_ARGS=-DCGAL_DIR=/where/it/is pip install .`
"""
import os
import re
import shlex
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = os.path.dirname(os.path.abspath(__file__))


def version():
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"project\(Boundary_recovery_3 VERSION ([\d.]+)", file.read()).group(1)


class BuildByCMake(build_ext):
    def build_extension(self, ext):
        target = os.path.abspath(self.get_ext_fullpath(ext.name))
        build = os.path.join(os.path.abspath(self.build_temp), "cmake")
        options = ["-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF", "-DBR3_BUILD_PYTHON=ON",
                   "-DBR3_BUILD_PROGRAMS=OFF", "-DBR3_BUILD_EXAMPLES=OFF",
                   "-DPython_EXECUTABLE=" + sys.executable]
        try:
            import pybind11  # where it is installed as a module of Python, CMake has to be told
            options.append("-Dpybind11_DIR=" + pybind11.get_cmake_dir())
        except ImportError:
            pass
        options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.run(["cmake", "-S", ROOT, "-B", build] + options, check=True)
        jobs = os.environ.get("JOBS", str(os.cpu_count() or 1))
        subprocess.run(["cmake", "--build", build, "-j", jobs, "--target", "boundary_recovery_python"], check=True)
        built = os.path.join(build, "python", "boundary_recovery", os.path.basename(target))
        self.copy_file(built, target)


setup(version=version(), ext_modules=[Extension("boundary_recovery._core", sources=[])],
      cmdclass={"build_ext": BuildByCMake})
