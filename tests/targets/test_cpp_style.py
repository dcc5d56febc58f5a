"""Nodes in C++ are clean for ament_cpplint, and for ament_uncrustify where there is one.

Who has the right to copy a file, and says so in it, its user knows.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import Phase, given, settings
from machine import examples, skip_or_fail
from random_programs import random_programs

from plastron_tui.ros.catalog import Catalog
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target
from plastron_tui.targets.cpp.target import CppTarget

pytestmark = pytest.mark.long

CPPLINT = Path(sys.executable).with_name("ament_cpplint")
UNCRUSTIFY = Path(sys.executable).with_name("ament_uncrustify")


LIBRARIES = {
    "roscpp": ("rospy", "noetic"),
    "nodelet": ("rospy", "noetic"),
    "rclcpp": ("rclpy", "kilted"),
    "component": ("rclpy", "kilted"),
}
"""Each with the library that programs are for where they say none, and a distribution."""
FOLDERS = (Path(__file__).parents[1] / "programs", Path(__file__).parents[2] / "examples")
PROGRAMS = [
    file
    for folder in FOLDERS
    for file in sorted(folder.glob("*.plastron"))
    # The catalog of a distribution has no types of a program.
    if "create_message_type" not in file.read_text()
]
ACTIONS = """\
create_node 'robot' as n
subscribe n to 'heard' of message_type String
n has_parameter 'often' of parameter_type float with default 5 between 1 and 9
n provides_action 'dock' of action_type {0}
n sends_goal to 'fetch' of action_type {0} with input {1}
"""
GOALS = {"noetic": ("actionlib_tutorials/Fibonacci", "order=3"), "kilted": ("Fibonacci", "5")}


def write(folder: Path, program: str, number: int, library: str, layout: str = "") -> int:
    """Write the nodes of a program as a library has them; return their number."""
    target = find_target(library)
    assert isinstance(target, CppTarget)
    usual, distribution = LIBRARIES[library]
    target.set_layouts({"cpp": layout} if layout else {})
    nodes = Session(program.encode(), options=Options(usual)).workspace.nodes.values()
    written = [node for node in nodes if target.unwritable(node) is None]
    for at, node in enumerate(written):
        made = target.render(node, Catalog(distribution))
        assert made.files is not None, made.diagnostics
        package = folder / f"{library}_{number}_{at}{layout}"
        # A source includes its own header first, which has its name.
        own = re.match(rb'(?s)//.*?\n\n#include "\w+/(\w+)\.hpp"', made.files.main)
        stem = "node" if own is None else own[1].decode()
        for name, text in made.files.texts:
            file = package / "src" / name.format(stem)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(text)
    return len(written)


def findings(folder: Path) -> str:
    if not CPPLINT.exists():
        skip_or_fail("ament_cpplint is missing: ./dev setup dev")
    linters = [[CPPLINT, "--filters=-legal/copyright"]]
    if UNCRUSTIFY.exists() and shutil.which("uncrustify"):
        linters.append([UNCRUSTIFY])
    # Each package has its own folder of headers, which is where a linter looks for a guard's name.
    folders = sorted(folder.glob("*/src")) + sorted(folder.glob("*/include"))
    found = [
        subprocess.run([*each, *folders], capture_output=True, text=True, check=False)
        for each in linters
    ]
    lines = [line for each in found for line in (each.stdout + each.stderr).splitlines()]
    if not any(each.returncode for each in found):
        return ""
    return "\n".join(line for line in lines if not line.startswith(("Done", "DEBUG", "No code")))


@pytest.mark.parametrize("version", [1, 2])
def test_what_programs_make_is_clean(tmp_path: Path, version: int) -> None:
    libraries = ["roscpp", "nodelet"] if version == 1 else ["rclcpp", "component"]
    usual, distribution = LIBRARIES[libraries[0]]
    programs = [file.read_text() for file in PROGRAMS]
    programs.append(ACTIONS.format(*GOALS[distribution]))

    @settings(max_examples=examples(20), deadline=None, database=None, phases=[Phase.generate])
    @given(random_programs(usual))
    def draw(program: str) -> None:
        programs.append(program)

    draw()
    for number, program in enumerate(programs):
        # Each is written in the layout that a library has where nothing is said, every other
        # one in the other layout too.
        layouts = ("", "single" if libraries[0] == "component" else "split")
        for library in libraries:
            for layout in layouts[: 1 + number % 2]:
                write(tmp_path, program, number, library, layout)
    assert findings(tmp_path) == ""


def test_actions_are_written(tmp_path: Path) -> None:
    for library, (_, distribution) in LIBRARIES.items():
        assert write(tmp_path, ACTIONS.format(*GOALS[distribution]), 0, library) == 1


def test_what_is_not_clean_is_found(tmp_path: Path) -> None:
    (tmp_path / "a/src").mkdir(parents=True)
    (tmp_path / "a/src/node.cpp").write_text("int main()\n{\n\treturn 0;\n}\n")
    assert "Tab found" in findings(tmp_path)
