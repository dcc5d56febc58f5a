"""Values of parameters that are read from files, and that commands say."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from plastron_tui.ros.launch import LaunchFile, ParameterValue, SetParameter, StartedNode
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_text import Kind, Scope, Substitution, Text, package_file, text
from plastron_tui.sources.launch.python_reader import read_launch_python
from plastron_tui.sources.launch.reader import file_content
from plastron_tui.sources.launch.xml_reader import read_launch_xml
from plastron_tui.targets.launch.python import write_python
from plastron_tui.targets.launch.xml import write_xml

FILE = package_file("demo", "urdf/rover.urdf")
CONTENT = Text((Substitution(Kind.CONTENT, FILE),))
XACRO = Text((Substitution(Kind.COMMAND, text("xacro ", FILE, " side:=left")),))
CAT = Text((Substitution(Kind.COMMAND, text("cat ", FILE)),))


def launch(value: Text, ros_version: int) -> LaunchFile:
    parameter = ParameterValue(text("robot_description"), value, is_text=True)
    if ros_version == 1:
        return LaunchFile((SetParameter(parameter),))
    node = StartedNode(text("demo"), text("eye"), text("eye"), parameters=(parameter,))
    return LaunchFile((node,))


@pytest.mark.parametrize("ros_version", [1, 2])
@pytest.mark.parametrize("value", [CONTENT, XACRO, CAT])
def test_they_are_written_and_read(value: Text, ros_version: int) -> None:
    whole = launch(value, ros_version)
    read = read_launch_xml(write_xml(whole, ros_version).encode(), ros_version=ros_version)
    assert read.diagnostics == ()
    assert read.launch == whole


@pytest.mark.parametrize("value", [CONTENT, XACRO, CAT])
def test_python_has_them_too(value: Text) -> None:
    read = read_launch_python(write_python(launch(value, 2)).encode())
    assert read.diagnostics == ()
    assert read.launch == launch(value, 2)


@pytest.mark.parametrize(
    ("source", "kind", "argument"),
    [
        ("$(file-content $(find-pkg-share demo)/urdf/rover.urdf)", Kind.CONTENT, FILE),
        ("$(command 'xacro $(find-pkg-share demo)/urdf/rover.urdf side:=left')", Kind.COMMAND,
         text("xacro ", FILE, " side:=left")),
        ('$(command "cat $(find-pkg-share demo)/urdf/rover.urdf")', Kind.COMMAND,
         text("cat ", FILE)),
        # What to do with what it says on the standard error is not read.
        ("$(command 'ls' warn)", Kind.OTHER, text("command 'ls' warn")),
    ],
)  # fmt: skip
def test_people_write_them_so(source: str, kind: Kind, argument: Text) -> None:
    escaped = source.replace('"', "&quot;")
    node = f'<node pkg="demo" exec="eye"><param name="a" value="{escaped}" type="str"/></node>'
    read = read_launch_xml(f"<launch>{node}</launch>".encode(), ros_version=2)
    assert read.launch is not None
    [item] = read.launch.items
    assert isinstance(item, StartedNode)
    [parameter] = item.parameters
    assert isinstance(parameter, ParameterValue)
    assert parameter.value == Text((Substitution(kind, argument),))


FILES: Mapping[str, str] = {"/share/demo/urdf/rover.urdf": "<robot name='a'/>\n"}


@pytest.mark.parametrize(
    ("value", "known"),
    [(CONTENT, True), (CAT, True), (XACRO, False), (text("plain"), True)],
)
def test_no_command_is_started_to_know_a_value(value: Text, known: bool) -> None:
    scope = Scope(find_package=lambda name: f"/share/{name}", read_file=FILES.get)
    resolved = resolve(launch(value, 2), 2, scope)
    assert (resolved.unresolved == ()) is known
    [node] = resolved.started
    whole = next(iter(FILES.values())) if value in (CONTENT, CAT) else "plain"
    assert node.settings == ((("robot_description", whole),) if known else ())


def test_files_are_read_within_bounds(tmp_path: Path) -> None:
    file = tmp_path / "a.urdf"
    file.write_text("<robot/>\n")
    (tmp_path / "bytes.urdf").write_bytes(b"\xff")

    def beyond(path: Path) -> str:
        return "" if path.is_relative_to(tmp_path) and path.name != "secret" else "it is beyond"

    (tmp_path / "secret").write_text("x")
    assert file_content(str(file), beyond) == "<robot/>\n"
    others = ("secret", "none.urdf", "bytes.urdf", ".", "a\0")
    assert [file_content(str(tmp_path / each), beyond) for each in others] == [None] * len(others)
    assert file_content("a.urdf", lambda _: "") is None
