"""What findings say, and what they offer, where a text once misled who read it."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import LISTENER, code_of, package_of
from linted import run_over, write_tree
from packages import CATKIN, CMAKE, PYTHON, Break, found_in
from parameter_packages import CONFIG, LAUNCH, NODE, driver, found, launch, package, python

from plastron_tui.diagnostics import Severity

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
    # What both kinds of build need, at once.
    ("RK503", Break("wheels/setup.cfg", "", None),
     "write `install_scripts=$base/lib/wheels` below `[install]` "
     "and `script_dir=$base/lib/wheels` below `[develop]`"),
    ("RK503", Break("wheels/setup.cfg", "script_dir=$base/lib/wheels", ""),
     "write `script_dir=$base/lib/wheels` below `[develop]`"),
]  # fmt: skip


@pytest.mark.parametrize(("code", "case", "help_"), _CASES)
def test_help(code: str, case: Break, help_: str | None, tmp_path: Path) -> None:
    told = found_in(tmp_path, case.files(PYTHON | CMAKE))
    assert [each.diagnostic.help for each in told if each.rule.code == code] == [help_]


_ANGLE = {"rover/msg/Angle.msg": "float64 value\n"}
_USES = PYTHON["wheels/wheels/mover.py"].replace(
    "from geometry_msgs.msg import Twist", "from rover.msg import Angle as Twist"
)
_LEFT = [
    (_ANGLE, Severity.WARNING),
    (_ANGLE | {"wheels/wheels/mover.py": _USES}, Severity.ERROR),
    ({"rover/CMakeLists.txt": CMAKE["rover/CMakeLists.txt"].replace("Speed.msg", "Far.msg")}
     | {"rover/msg/Speed.msg": ""}, Severity.ERROR),
    (_ANGLE | {"rover/msg/Speed.msg": "Angle value\n"}, Severity.ERROR),
    (_ANGLE | {"rover/msg/Turn.msg": "Angle[] value\n"}, Severity.WARNING),
    # In ROS 1 what lies there of an action need not be built.
    (CATKIN | {"old/msg/Angle.msg": "bool a\n", "old/action/Go.action": "---\n---\n"}
     | {"old/msg/GoGoal.msg": "Angle value\n"}, Severity.WARNING),
]  # fmt: skip


@pytest.mark.parametrize(("files", "severity"), _LEFT)
def test_severity_of_a_definition(
    files: dict[str, str], severity: Severity, tmp_path: Path
) -> None:
    """A type that nothing uses may be there for later; what a node or a command needs, not."""
    told = found_in(tmp_path, PYTHON | CMAKE | files)
    assert next(each.diagnostic.severity for each in told if each.rule.code == "RK507") == severity


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
    (wrong,) = found_in(tmp_path, files)
    span = wrong.diagnostic.span
    assert wrong.rule.code == "RK506" and span is not None
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
    (wrong,) = found_in(tmp_path, files)
    (label,) = wrong.diagnostic.labels
    assert label.message == "CMake looks for it here, and nothing uses what it finds"


_OFFERED = [
    ("max_sped", "max_speed", True),
    ("maxSpeed", "max_speed", True),
    # Another thing, or one of another type.
    ("default_planning_pipeline", "default_planning_frame", False),
    ("gain_double", "gain_int", False),
    ("speed_double", "speed_double_array", False),
]


@pytest.mark.parametrize("is_in_file", [True, False])
@pytest.mark.parametrize(("name", "declared", "is_offered"), _OFFERED)
def test_parameter_that_is_offered(
    name: str, declared: str, is_offered: bool, is_in_file: bool, tmp_path: Path
) -> None:
    """A parameter is offered where a slip tells it from the name, or how words are joined."""
    files = {NODE: python(f"self.declare_parameter('{declared}', 0.5)")}
    if is_in_file:
        files[CONFIG] = f"driver:\n  ros__parameters:\n    {name}: 1.0\n"
    else:
        files |= {LAUNCH: launch(driver(f"{{'{name}': 1.0}}")), CONFIG: ""}
    (wrong,) = found(tmp_path, package(files), "RP301")
    assert (wrong.help == f"did you mean `{declared}`?") == is_offered
    assert is_offered or wrong.help == "declare it in the node, or take it out here"


_HEARS = code_of(LISTENER, topic="chatte")
_SLIPS = [
    # Which of the two is the slip nobody knows, or a third one says it.
    (package_of(listener=_HEARS),
     "write `/chatter` here, or `/chatte` there: one of them is a slip"),
    (package_of() | {"demo/demo/other.py": _HEARS.replace("listener", "other")},
     "did you mean `/chatter`?"),
]  # fmt: skip


@pytest.mark.parametrize(("files", "help_"), _SLIPS)
def test_name_that_may_be_the_right_one(
    files: dict[str, str | bytes], help_: str, tmp_path: Path
) -> None:
    (wrong,) = run_over(write_tree(tmp_path, files), "RG104").told
    assert wrong.diagnostic.help == help_
