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
