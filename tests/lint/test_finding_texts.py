"""What findings say, and what they offer, where a text once misled who read it."""

from __future__ import annotations

from pathlib import Path

import pytest
from packages import CMAKE, PYTHON, Break, found_in

_STARTED = '<launch>\n  <node pkg="wheels" exec="{}"/>\n</launch>\n'
_FILE = "wheels/launch/more.launch.xml"
_MOVER = "'mover = wheels.mover:main'"
_NODES = "'walker_node = wheels.mover:main'"
_TWO = f"{_NODES}, 'fast_walker = wheels.mover:main'"


def _starts(name: str, entries: str = _MOVER) -> Break:
    more = {_FILE: _STARTED.format(name)}
    # Nothing else starts what has another name now.
    if entries != _MOVER:
        more["wheels/launch/wheels.launch.py"] = ""
    return Break("wheels/setup.py", _MOVER, entries, more=more)


_CASES = [
    # A launch file is included, whatever name is near.
    ("RK506", _starts("wheels.launch.py"),
     "`wheels.launch.py` is a launch file: include it, in place of starting it"),
    # All the words of one program, as words.
    ("RK506", _starts("walker", _NODES), "did you mean `walker_node`?"),
    ("RK506", _starts("walker", _TWO), None),
    ("RK506", _starts("walk", _NODES), None),
    ("RK506", _starts("mowers"), None),
]  # fmt: skip


@pytest.mark.parametrize(("code", "case", "help_"), _CASES)
def test_help(code: str, case: Break, help_: str | None, tmp_path: Path) -> None:
    found = found_in(tmp_path, case.files(PYTHON | CMAKE))
    assert [each.diagnostic.help for each in found if each.rule.code == code] == [help_]


_UNMET = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('go', default_value='false'),
        Node(package='wheels', executable='walker',
             condition=IfCondition(LaunchConfiguration('go'))),
    ])
"""


def test_place_of_a_program_that_starts_with_other_arguments(tmp_path: Path) -> None:
    """The name is marked, as it is where the program starts at once."""
    files = PYTHON | {"wheels/launch/more.launch.py": _UNMET}
    (found,) = found_in(tmp_path, files)
    span = found.diagnostic.span
    assert found.rule.code == "RK506" and span is not None
    assert _UNMET[span.start : span.end] == "walker"


def test_what_cmake_looks_for_in_vain_says_so(tmp_path: Path) -> None:
    """The label of RK502 in CMakeLists.txt says what the line is there for."""
    depend, find = "  <depend>std_srvs</depend>\n", "find_package(std_srvs REQUIRED)\n"
    files = PYTHON | CMAKE
    files["rover/package.xml"] = files["rover/package.xml"].replace(
        "</package>", f"{depend}</package>"
    )
    files["rover/CMakeLists.txt"] = files["rover/CMakeLists.txt"].replace(
        "ament_package()", f"{find}ament_package()"
    )
    (found,) = found_in(tmp_path, files)
    (label,) = found.diagnostic.labels
    assert label.message == "CMake looks for it here, and nothing uses what it finds"
