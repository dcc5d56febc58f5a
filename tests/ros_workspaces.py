"""Workspaces of packages, built by the tools of their ROS as a user builds them."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from cpp_builds import CppLibrary
from machine import find_ros, skip_or_fail

from plastron_tui.runtime.build_tools import Workspace, find_builder

SYSTEM = "/usr/sbin:/usr/bin:/sbin:/bin"
SCRIPTS = Path(sys.executable).parent


def call(
    command: Sequence[str | Path], folder: Path, environ: Mapping[str, str], status: int = 0
) -> str:
    """Run a command that has to end with a status, and return what it says."""
    ended = subprocess.run(
        command,
        cwd=folder,
        env={"HOME": str(folder), "LC_ALL": "C.UTF-8", **environ},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=600,
        check=False,
    )
    assert ended.returncode == status, ended.stdout
    return ended.stdout


def skip_without(*programs: str, path: str) -> None:
    for program in programs:
        if shutil.which(program, path=path) is None:
            skip_or_fail(f"there is no `{program}`")


def complete_ros2(folder: Path, library: CppLibrary | None = None) -> dict[str, str]:
    """Return the environment of a ROS 2 in which `colcon build` builds interface packages.

    With a client library of C++ it also builds nodes of that.

    The wheels lack some of what an installed ROS has; `plastron run` knows what, and writes it.
    Here it is in the folder, and what CMake is told of it is in colcon's file of defaults.
    """
    environment = find_ros(2)
    [step] = find_builder(environment, {}, os.environ)(Workspace(folder))
    wanted = ("-DPython3_", "-DPLASTRON_", "-DCMAKE_PROJECT_INCLUDE")
    settings = [word for word in step.argv if word.startswith(wanted)]
    defaults = folder / "defaults.yaml"
    arguments = {"cmake-args": ["--no-warn-unused-cli", *settings]}
    defaults.write_text(json.dumps({"build": arguments}), encoding="utf-8")
    kept = ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", "CMAKE_GENERATOR")
    environ = {
        **{name: step.environ[name] for name in kept},
        "PATH": f"{SCRIPTS}:{SYSTEM}",
        "COLCON_HOME": str(folder),
        "COLCON_DEFAULTS_FILE": str(defaults),
    }
    return environ if library is None else library.building(environ)
