"""What a run gives its nodes, and what is doubtful about that."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.generating.params_file import params_path
from plastron_tui.project.run_setup import RunNode, RunSetup, run_node
from plastron_tui.ros.parameter_values import Assignment, NodeParameters, parse_assignment
from plastron_tui.ros.run_names import Remap, RunNames, parse_remap
from plastron_tui.runtime.parameters import SetStatus
from plastron_tui.session import Session

ROSPY = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

rospy.init_node("gain")
speed = rospy.get_param("~speed", 1.0)
steps = rospy.get_param("~pid/steps", [0])
frame = rospy.get_param("/frame", "map")
rospy.Subscriber("chatter", String, print)
rospy.spin()
"""

RCLPY = """\
#!/usr/bin/env python3
import rclpy
from rclpy.node import Node


class Gain(Node):
    def __init__(self):
        super().__init__("gain")
        self.declare_parameter("speed", 1.0)
        self.declare_parameter("pid.steps", [0])


def main():
    rclpy.init()
    rclpy.spin(Gain())
"""


def setup_of(*settings: str, remaps: tuple[str, ...] = (), namespace: str = "") -> RunSetup:
    found = [parse_assignment(text) for text in settings]
    rules = [parse_remap(text) for text in remaps]
    return RunSetup(
        RunNames(namespace, tuple(each for each in rules if isinstance(each, Remap))),
        tuple(each for each in found if isinstance(each, Assignment)),
    )


def node_of(folder: Path, text: str, version: int) -> RunNode:
    (folder / "gain.py").write_text(text)
    session = Session(b"load 'gain.py' as g\n", folder / "p.plastron")
    (node,) = session.workspace.nodes.values()
    return run_node(node, version, node.source, text)


@pytest.mark.parametrize(("version", "text"), [(1, ROSPY), (2, RCLPY)])
@pytest.mark.parametrize(
    ("setting", "help_"),
    [
        ("g.speed=1", None),
        ("gain.pid.steps=[1]", None),
        ("g.use_sim_time=true", None),
        ("g.sped=1", "did you mean `speed`?"),
        ("g.pid.stps=[1]", "did you mean"),
        ("other.sped=1", None),
    ],
)
def test_a_parameter_that_a_node_has_not(
    tmp_path: Path, version: int, text: str, setting: str, help_: str | None
) -> None:
    found = list(setup_of(setting).problems([node_of(tmp_path, text, version)], None))
    assert [each.code for each in found] == ["undeclared-parameter"] * (help_ is not None)
    assert all(help_ in (each.help or "") for each in found if help_)


@pytest.mark.parametrize(("version", "text"), [(1, ROSPY), (2, RCLPY)])
@pytest.mark.parametrize(
    ("pattern", "name", "help_"),
    [
        ("/gain", "speed", None),
        ("/gain", "sped", "did you mean `speed`?"),
        ("/r/gain", "sped", "did you mean `speed`?"),
        ("/other", "sped", None),
        ("/**", "sped", None),
        ("/r/*", "sped", None),
    ],
)
def test_a_parameter_of_the_file_that_a_node_has_not(
    tmp_path: Path, version: int, text: str, pattern: str, name: str, help_: str | None
) -> None:
    setup = setup_of(namespace="/r")._replace(params=(NodeParameters(pattern, {name: 1.0}),))
    file = tmp_path / "p.yaml"
    found = list(setup.problems([node_of(tmp_path, text, version)], file))
    expected = [] if help_ is None else [("undeclared-parameter", file, help_)]
    assert [(each.code, each.file, each.help) for each in found] == expected


@pytest.mark.parametrize(
    ("version", "text"),
    [
        (1, ROSPY.replace('"~speed"', "NAME")),
        (1, f"{ROSPY}print(rospy.get_param_names())\n"),
        (2, RCLPY.replace('"speed"', "NAME")),
        (2, RCLPY.replace('declare_parameter("speed", 1.0)', 'declare_parameters("", LISTED)')),
        (2, RCLPY.replace('"gain"', '"gain", allow_undeclared_parameters=True')),
    ],
)
def test_nothing_is_said_where_a_node_may_have_others(
    tmp_path: Path, version: int, text: str
) -> None:
    node = node_of(tmp_path, text, version)
    assert not list(setup_of("g.sped=1").problems([node], None))


def test_what_is_set_goes_before_what_the_file_has() -> None:
    params = (
        NodeParameters("/**", {"a": 1, "b": 1, "c": 1}),
        NodeParameters("/n", {"b": 2, "c": 2}),
        NodeParameters("/r/n", {"d": 4}),
        NodeParameters("/m", {"a": 5}),
    )
    setup = setup_of("v.c=3", "m.a=6", namespace="/r")._replace(params=params)
    assert setup.values("n", "v") == {"a": 1, "b": 2, "c": 3, "d": 4}


@pytest.mark.parametrize("version", [1, 2])
def test_a_value_is_one_of_its_parameter(version: int) -> None:
    program = (
        b"create_node 'n' as n using " + (b"rospy" if version == 1 else b"rclpy") + b"\n"
        b"n has_parameter 'speed' of parameter_type float with default 0.5\n"
        b"n has_parameter 'gains' of parameter_type float_list with default [0.5]\n"
        b"n has_parameter 'count' of parameter_type int with default 1\n"
    )
    nodes = list(Session(program).workspace.nodes.values())
    given = setup_of("n.speed=1", "n.gains=[1, 2]", "n.count=3", "n.other=4").arguments(
        version, nodes
    )
    sign = "_" if version == 1 else ""
    expected = {"speed:=1.0", "gains:=[1.0, 2.0]", "count:=3", "other:=4"}
    assert {f"{sign}{each}" for each in expected} <= set(given)


RANGES = """\
import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.node import Node


class Gain(Node):
    def __init__(self):
        super().__init__("gain")
        self.declare_parameter("speed", 1.0, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.5, to_value=2.0)]))
        self.declare_parameter("count", 1, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=-3, to_value=3)]))
        self.declare_parameter("gain", 1.0)
        self.declare_parameter("frames", ["map"])
        self.declare_parameter("other", self.anything())
"""


@pytest.mark.parametrize(
    ("setting", "wrong"),
    [
        ("speed=2", None),
        ("speed=0.5", None),
        ("speed=2.01", "2.01 is not between 0.5 and 2"),
        ("speed=.nan", ".nan is not between 0.5 and 2"),
        ("speed=fast", '"fast" is no `float`'),
        ("count=-3", None),
        ("count=-4", "-4 is not between -3 and 3"),
        ("count=1.5", "1.5 is no `int`"),
        ("gain=.inf", None),
        ("gain=-100", None),
        ("frames=[a, b]", None),
        ("frames=[1]", "[1] is no `string_list`"),
        ("other=[1]", None),
    ],
)
def test_a_value_that_the_node_refuses(tmp_path: Path, setting: str, wrong: str | None) -> None:
    node = node_of(tmp_path, RANGES, 2)
    name = setting.partition("=")[0]
    message = None if wrong is None else f"`g.{name}`: {wrong}"
    assert setup_of(f"g.{setting}").wrong_option([node]) == message
    # rclpy lets such a parameter have any type; and rospy checks nothing.
    anything = RANGES.replace("1.0)", "1.0, ParameterDescriptor(dynamic_typing=True))")
    assert setup_of(f"g.{setting}").wrong_option([node_of(tmp_path, anything, 2)]) is None
    assert setup_of(f"g.{setting}").wrong_option([node_of(tmp_path, RANGES, 1)]) is None


def test_a_file_is_for_the_ros_of_its_nodes() -> None:
    setup = RunSetup(params=(NodeParameters("/n", {"a": 2**40}),))
    nodes = [RunNode("n", "n", version, ()) for version in (2, 1)]
    assert not list(setup.problems(nodes[:1], None))
    (found,) = setup.problems(nodes[1:], Path("p.yaml"))
    assert (found.code, found.file) == ("bad-parameters", Path("p.yaml"))


def test_arguments_of_both_ros() -> None:
    program = b"create_node 'n' as v\ncreate_node 'm' as w\n"
    node, other = Session(program).workspace.nodes.values()
    setup = setup_of(
        *("v.a.b=0.5", 'n.t="1"', "m.x=1"),
        remaps=("a:=~/b", "n:c:=d", "m:e:=f"),
        namespace="/r",
    )
    assert setup.arguments(1, [node]) == (*("a:=~b", "c:=d", "__ns:=/r", "_a/b:=0.5", '_t:="1"'),)
    assert setup.arguments(2, [node]) == (
        *("--ros-args", "-r", "a:=~/b", "-r", "c:=d", "-r", "__ns:=/r"),
        *("-p", "a.b:=0.5", "-p", 't:="1"'),
    )
    assert "_x:=1" in setup.arguments(1, [node, other])
    for version in (1, 2):
        assert RunSetup().arguments(version, [node]) == ()


def test_an_action_is_remapped_with_all_that_it_is(tmp_path: Path) -> None:
    text = ROSPY.replace(
        "rospy.spin()",
        "import actionlib\nfrom actionlib.msg import TestAction\n"
        "server = actionlib.SimpleActionServer('dock', TestAction, print, False)\nrospy.spin()",
    )
    (tmp_path / "gain.py").write_text(text)
    session = Session(b"load 'gain.py' as g\n", tmp_path / "p.plastron")
    given = setup_of(remaps=("dock:=park", "chatter:=news")).arguments(
        1, list(session.workspace.nodes.values())
    )
    assert {"dock:=park", "dock/goal:=park/goal", "dock/result:=park/result"} < set(given)
    assert "chatter/goal:=news/goal" not in given


def test_the_file_is_beside_the_output() -> None:
    assert params_path(Path("/a/output"), Path("/b/robot.plastron")) == Path("/a/config/robot.yaml")


def test_a_node_that_the_program_has_not_is_not_asked() -> None:
    assert Session(b"").set_parameter("x", "speed", 1.0).status is SetStatus.ABSENT
