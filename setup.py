"""A wheel of what CMake has built: the module, the kernels that it opens, and the sources in Python."""

import os
import pathlib
import re
import shutil
import subprocess

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).resolve().parent
BUILT = pathlib.Path(os.environ.get("WHITTLE_BUILD", ROOT / "build" / "release"))
SCRATCH = "build/wheel"  # of setuptools, beside the other builds
#: Those that pictures and solids open at run time.
MODULES = ("libwhittle_kernel_v*.so", "libwhittle_pictures.so", "libwhittle_fonts.so", "libwhittle_image_io.so")


def built_module():
    """The module, built where it is missing as ./run builds the program."""
    for again in (False, True):
        found = sorted((BUILT / "python" / "whittle").glob("_whittle.*.so"))
        if found:
            return found[-1]
        if not again and BUILT == ROOT / "build" / "release":
            command = "source cmake/setup.sh; build release whittle_python whittle_pictures whittle_fonts whittle_image_io"
            subprocess.run(["bash", "-c", command], cwd=ROOT, check=True)
    raise SystemExit(f"{BUILT} has no Python module: ninja whittle_python makes it (pybind11-dev, python3-dev)")


class Build(build_py):
    def run(self):
        super().run()
        package = pathlib.Path(self.build_lib) / "whittle"
        module = built_module()
        shutil.copy(module, package)
        for pattern in MODULES:
            for file in sorted(BUILT.glob(pattern)):
                shutil.copy(file, package)


class Built(Distribution):
    def has_ext_modules(self):  # so that the wheel's name tells the processor and the Python
        return True


version = re.search(r"project\(whittle VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
(ROOT / SCRATCH).mkdir(parents=True, exist_ok=True)
setup(
    version=version,
    packages=["whittle"],
    package_dir={"": "python"},
    package_data={"whittle": ["py.typed", "*.pyi"]},
    cmdclass={"build_py": Build},
    distclass=Built,
    options={"build": {"build_base": SCRATCH}, "egg_info": {"egg_base": SCRATCH}},
)
