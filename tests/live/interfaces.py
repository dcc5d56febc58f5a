"""Interface packages that have no wheel, built with colcon from their definitions."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from collections.abc import Mapping
from pathlib import Path

# The wheels name the Python and numpy folders of the machine that built them, which CMake
# refuses where they are not there; the packages are found here first, and are mended.
CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project({package} C CXX)
find_package(rosidl_default_generators REQUIRED)
foreach(package builtin_interfaces service_msgs unique_identifier_msgs action_msgs)
  find_package(${{package}} REQUIRED)
  set_target_properties(
    ${{package}}::${{package}}__rosidl_generator_py
    PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "{includes}")
endforeach()
rosidl_generate_interfaces(${{PROJECT_NAME}} {files})
ament_package()
"""

MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{package}</name>
  <version>1.0.0</version>
  <description>Services and actions for the tests</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>MIT</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <build_depend>rosidl_default_generators</build_depend>
  <depend>action_msgs</depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
</package>
"""


def build(definitions: Mapping[str, Mapping[str, str]], workspace: Path, prefix: Path) -> Path:
    """Build interface packages with the tools of the running Python's environment.

    Args:
        definitions: the text of each, by package and name, as `srv/AddTwoInts` is one.
        workspace: an empty folder.
        prefix: the folder of the environment that holds ROS.

    Returns:
        The folder to be first in `AMENT_PREFIX_PATH`, which is that of one merged install.
    """
    includes = _include_folders(prefix / "bin" / "python")
    for package, texts in definitions.items():
        folder = workspace / "src" / package
        files = {f"{name}.{name.partition('/')[0]}": text for name, text in texts.items()}
        for name, text in files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        text = CMAKE.format(package=package, includes=includes, files=" ".join(files))
        (folder / "CMakeLists.txt").write_text(text)
        (folder / "package.xml").write_text(MANIFEST.format(package=package))
    env = {
        **os.environ,
        "PATH": f"{prefix / 'bin'}{os.pathsep}{os.environ['PATH']}",
        "AMENT_PREFIX_PATH": str(prefix),
        "CMAKE_PREFIX_PATH": str(prefix),
        "COLCON_HOME": str(workspace / "colcon"),
    }
    done = subprocess.run(
        [
            *(prefix / "bin" / "colcon", "build", "--merge-install"),
            *("--cmake-args", f"-DPython3_EXECUTABLE={prefix / 'bin' / 'python'}"),
            *(f"-DPython3_ROOT_DIR={sysconfig.get_config_var('prefix')}", "-DBUILD_TESTING=OFF"),
            "-DCMAKE_BUILD_TYPE=Debug",
        ],
        cwd=workspace,
        env=env,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return workspace / "install"


def environ(install: Path, prefix: Path) -> dict[str, str]:
    """Return the environment in which nodes find the packages that were built."""
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    libraries = [str(install / "lib"), *os.environ.get("LD_LIBRARY_PATH", "").split(os.pathsep)]
    own = {
        **os.environ,
        "AMENT_PREFIX_PATH": f"{install}{os.pathsep}{prefix}",
        "PYTHONPATH": str(install / "lib" / version / "site-packages"),
        "LD_LIBRARY_PATH": os.pathsep.join(filter(None, libraries)),
    }
    # The wheels' start-up hook then adds its own libraries again.
    own.pop("_ROS_WHEELS_BOOTSTRAP_COMPLETE", None)
    return own


def _include_folders(python: Path) -> str:
    code = "import numpy, sysconfig; print(sysconfig.get_paths()['include'], numpy.get_include())"
    done = subprocess.run([python, "-c", code], capture_output=True, text=True, check=True)
    return ";".join(done.stdout.split())
