"""What a launch file starts, with full names."""

from __future__ import annotations

import pytest

from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_started import Opened, Resolved
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.run_names import Remap, RunNames
from plastron_tui.sources.launch.unresolved import warnings_of
from plastron_tui.sources.launch.xml_reader import read_launch_xml

SOURCE = b"""<launch>
  <arg name="robot" default="rover"/>
  <arg name="wanted"/>
  <group>
    <push_ros_namespace namespace="$(var robot)"/>
    <node pkg="demo" exec="driver" name="driver" namespace="base">
      <remap from="scan" to="/laser"/>
      <param name="speed" value="0.5"/>
      <param name="label" value="$(var robot)1"/>
    </node>
    <node pkg="demo" exec="eye" name="eye" if="$(var wanted)"/>
    <node pkg="demo" exec="off" if="false"/>
  </group>
  <node pkg="demo" exec="listener"/>
  <include file="$(find-pkg-share demo)/launch/more.launch.xml"/>
</launch>
"""
CIRCLE = b"""<launch>
  <node pkg="demo" exec="inner" name="inner"/>
  <include file="more.launch.xml"/>
</launch>"""


def _resolved(**arguments: str) -> Resolved:
    launch = read_launch_xml(SOURCE).launch
    assert launch is not None
    return resolve(launch, 2, Scope(arguments), "bringup.launch.xml")


def test_names_are_full() -> None:
    found = _resolved(wanted="true")
    assert [each.full_name for each in found.started] == [
        "/rover/base/driver",
        "/rover/eye",
        None,
    ]
    driver = found.started[0]
    assert driver.remaps == (("scan", "/laser"),)
    assert driver.parameters == (("speed", 0.5), ("label", "rover1"))


def test_what_is_not_known_is_told_and_left_out() -> None:
    found = _resolved()
    assert [each.executable for each in found.started] == ["driver", "listener"]
    assert [each.message for each in found.unresolved] == [
        "what hangs on a condition is left out: `$(var wanted)` is not known here",
        "an included file is left out: `$(find-pkg-share demo)` is not known here",
    ]
    warning = warnings_of(found)[0]
    assert warning.span is not None
    where = SOURCE[warning.span.start : warning.span.end]
    assert where == b'<node pkg="demo" exec="eye" name="eye" if="$(var wanted)"/>'


def test_files_that_include_each_other_come_to_an_end() -> None:
    launch = read_launch_xml(CIRCLE).launch
    assert launch is not None
    found = resolve(launch, 2, Scope(), "a", open_include=lambda path: Opened(launch, 2, "", ""))
    assert len(found.started) == 2
    assert found.unresolved[-1].message == "`more.launch.xml` includes itself without end"


OUTER, INNER, OWN = '{0}="s" to="outer"/>', '{0}="s" to="inner"/>', '{1}="s" to="own"/>'
SAME = '{1}="/s" to="same"/>'


@pytest.mark.parametrize(
    ("outer", "inner", "own", "ros1", "ros2"),
    [
        (OUTER, "", "", "/outer", "/outer"),
        (OUTER, INNER, "", "/inner", "/outer"),
        (OUTER, INNER, OWN, "/own", "/outer"),
        (OUTER, "", OWN, "/own", "/outer"),
        ("", INNER, OWN, "/own", "/inner"),
        ("", "", OWN, "/own", "/own"),
        ("", "", OWN + SAME, "/same", "/own"),
        (OUTER + INNER, "", "", "/inner", "/outer"),
    ],
)
@pytest.mark.parametrize("ros_version", [1, 2])
def test_one_of_several_remaps_holds(
    outer: str, inner: str, own: str, ros1: str, ros2: str, ros_version: int
) -> None:
    around = "remap from" if ros_version == 1 else "set_remap from"
    words = [each.format(f"<{around}", "<remap from") for each in (outer, inner, own)]
    kind = "type" if ros_version == 1 else "exec"
    node = f'<node pkg="demo" {kind}="a" name="a">{words[2]}</node>'
    source = f"<launch>{words[0]}<group>{words[1]}{node}</group></launch>"
    launch = read_launch_xml(source.encode(), ros_version=ros_version).launch
    assert launch is not None
    (started,) = resolve(launch, ros_version, Scope()).started
    names = RunNames(started.namespace, tuple(Remap(*each) for each in started.remaps))
    assert names.resolved("a", "s") == (ros1 if ros_version == 1 else ros2)


NAMESPACE = '<push_ros_namespace namespace="robot"/>'
ARGUMENT = '<arg name="who" default="a"/>'


@pytest.mark.parametrize(
    ("ros_version", "included", "before", "after", "expected"),
    [
        (2, NAMESPACE, "", "", "/robot/after"),
        (2, "", "", "", "/after"),
        (2, NAMESPACE, NAMESPACE, "", "/robot/robot/after"),
        (2, '<push_ros_namespace namespace="/far/"/>', NAMESPACE, "", "/far/after"),
        (2, ARGUMENT, "", "$(var who)", "/aafter"),
        (2, '<let name="who" value="b"/>', ARGUMENT, "$(var who)", "/bafter"),
        (2, f"<group>{NAMESPACE}{ARGUMENT}</group>", "", "", "/after"),
        (2, f'<group scoped="false">{NAMESPACE}</group>', "", "", "/robot/after"),
        (2, f'<group if="false" scoped="false">{NAMESPACE}</group>', "", "", "/after"),
        (2, '<set_remap from="s" to="t"/>', "", "", "/after s:=t"),
        (2, '<set_parameter name="p" value="1"/>', "", "", "/after p:=1"),
        (1, '<remap from="s" to="t"/>', "", "", "/after"),
        (1, ARGUMENT, '<arg name="who" default="c"/>', "$(arg who)", "/cafter"),
    ],
)
def test_what_an_included_file_sets_holds_after_it(
    ros_version: int, included: str, before: str, after: str, expected: str
) -> None:
    kind = "type" if ros_version == 1 else "exec"
    node = f'<node pkg="demo" {kind}="a" name="{after}after"/>'
    source = f'<launch>{before}<include file="inner"/>{node}</launch>'
    found = _with_include(source, f"<launch>{included}</launch>", ros_version)
    assert found.unresolved == ()
    (started,) = found.started
    pairs = (*started.remaps, *started.parameters)
    assert [started.full_name, *(f"{old}:={new}" for old, new in pairs)] == expected.split()
    assert started.file == "outer"


def _with_include(source: str, included: str, ros_version: int) -> Resolved:
    outer = read_launch_xml(source.encode(), ros_version=ros_version).launch
    inner = read_launch_xml(included.encode(), ros_version=ros_version).launch
    assert outer is not None
    opened = Opened(inner, ros_version, "")
    return resolve(outer, ros_version, Scope(), "outer", lambda _: opened)


@pytest.mark.parametrize(
    ("ros_version", "flag", "expected"),
    [
        (1, "", ["/default"]),
        (1, 'pass_all_args="true"', ["/given"]),
        (1, 'pass_all_args="false"', ["/default"]),
        (1, 'pass_all_args="$(arg all)"', ["/given"]),
        (1, 'pass_all_args="$(env ALL)"', []),
        (2, "", ["/given"]),
    ],
)
def test_arguments_are_passed_on(ros_version: int, flag: str, expected: list[str]) -> None:
    word, kind = ("arg", "type") if ros_version == 1 else ("var", "exec")
    found = _with_include(
        '<launch><arg name="name" default="given"/><arg name="all" default="true"/>'
        f'<include file="inner" {flag}/></launch>',
        '<launch><arg name="name" default="default"/>'
        f'<node pkg="demo" {kind}="a" name="$({word} name)"/></launch>',
        ros_version,
    )
    assert [each.full_name for each in found.started] == expected
    assert len(found.unresolved) == (not expected)


@pytest.mark.parametrize(
    ("ros_version", "words", "count", "message"),
    [
        (
            2,
            '<node pkg="a" exec="b" args="--speed $(eval 1+1)"/>',
            1,
            "`args` is left out: `$(eval 1+1)` is not known here",
        ),
        (2, '<node pkg="a" exec="b" output="$(eval 1+1)"/>', 1, None),
        (
            1,
            '<include file="inner" ns="$(env ROBOT)"/>',
            0,
            "an included file is left out: `$(env ROBOT)` is not known here",
        ),
        (
            1,
            '<include file="inner" pass_all_args="$(env ALL)"/>',
            0,
            "an included file is left out: `$(env ALL)` is not known here",
        ),
        (
            1,
            '<include file="inner" pass_all_args="maybe"/>',
            0,
            "an included file is left out: `maybe` is not known here",
        ),
        (
            2,
            '<load_composable_node target="$(env C)"><composable_node pkg="a" plugin="b"/>'
            "</load_composable_node>",
            0,
            "a container is left out: `$(env C)` is not known here",
        ),
    ],
)
def test_values_that_are_not_known_are_told(
    ros_version: int, words: str, count: int, message: str | None
) -> None:
    inner = '<launch><node pkg="a" type="b" name="c"/></launch>'
    found = _with_include(f"<launch>{words}</launch>", inner, ros_version)
    assert len(found.started) == count
    assert [each.message for each in found.unresolved] == ([] if message is None else [message])
