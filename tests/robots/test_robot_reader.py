"""What `load_robot` finds, and what it says of what it does not take."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.project import robot_expansion
from plastron_tui.runtime import xacro
from plastron_tui.runtime.xacro import Expanded
from plastron_tui.session import Session
from plastron_tui.trust import TrustStore

ROBOT = b"<robot name='rover'>\n  <link name='base'/>\n</robot>\n"
WITH_MACROS = b"""\
<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="wheel.xacro"/>
  <link name="base"/>
  <xacro:wheel side="left"/>
</robot>
"""
WHEEL = b"""\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="side">
    <link name="${side}_wheel"/>
    <joint name="${side}" type="fixed">
      <parent link="base"/>
      <child link="${side}_wheel"/>
    </joint>
  </xacro:macro>
</robot>
"""
EXPANDED = (
    b"<robot name='rover'><link name='base'/><link name='left_wheel'/>"
    b"<joint name='left' type='fixed'><parent link='base'/><child link='left_wheel'/></joint>"
    b"</robot>"
)


def loading(folder: Path, name: str) -> Session:
    text = f"load_robot '{name}' as rover\n".encode()
    return Session(text, folder / "p.plastron", environ={})


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    folder = tmp_path / "project"
    for path, text in {
        "rover.urdf": ROBOT,
        "../beyond.urdf": ROBOT,
        "models/arm.urdf.xacro": WITH_MACROS,
        "models/wheel.xacro": WHEEL,
        "world.sdf": b"<sdf version='1.6'/>",
        "ant.xml": b"<mujoco model='ant'/>",
        "bringup.xml": b"<launch/>",
        "page.xml": b"<html/>",
        "base.stl": b"STL\0\0\0",
        "wide.urdf": "<robot name='r'/>".encode("utf-16"),
        "broken.urdf": b"<robot name='r'><link></robot>",
        "bomb.urdf": b"<!DOCTYPE r [<!ENTITY a 'aa'>]><robot name='&a;'/>",
    }.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(text)
    (folder / "link.urdf").symlink_to(tmp_path / "beyond.urdf")
    (folder / "empty").mkdir()
    os.mkfifo(folder / "fifo.urdf")
    with (folder / "large.urdf").open("wb") as file:
        os.truncate(file.fileno(), 2**40)
    return folder


def test_what_is_no_robot_is_told(folder: Path) -> None:
    export = "export it as URDF from what it was made with"
    cases = {
        "rovr.urdf": ("file-not-found", "no file `rovr.urdf`", "did you mean `rover.urdf`?"),
        "models/arm.xacro": ("file-not-found", "no file", "did you mean `models/arm.urdf.xacro`?"),
        "models": ("unreadable-file", "is a folder", "such as `models/arm.urdf.xacro`"),
        "empty": ("unreadable-file", "is a folder", ""),
        "fifo.urdf": ("file-not-found", "no file `fifo.urdf`", ""),
        "../beyond.urdf": ("outside-project", "is outside of the project", "plastron trust"),
        "link.urdf": ("outside-project", "is outside of the project", "plastron trust"),
        "large.urdf": ("unreadable-file", "it is larger than 4 MB", ""),
        "wide.urdf": ("unreadable-file", "is no text", "it is UTF-16: save it as UTF-8"),
        "base.stl": ("unreadable-file", "is no text", ""),
        "world.sdf": ("broken-urdf", "is a model of Gazebo (SDF), not URDF", export),
        "ant.xml": ("broken-urdf", "is a model of MuJoCo (MJCF), not URDF", export),
        "bringup.xml": ("broken-urdf", "is a launch file", "`load_launch` changes it"),
        "page.xml": ("broken-urdf", "the outermost element", ""),
        "broken.urdf": ("broken-xml", "", ""),
        "bomb.urdf": ("unsupported-xml", "declarations of its own", ""),
    }
    for name, (code, message, remedy) in cases.items():
        (found,) = loading(folder, name).diagnostics
        assert (name, found.code) == (name, code)
        assert message in found.message
        assert remedy in (found.help or "")
        assert found.span is not None


def test_macros_are_expanded_where_the_folder_is_trusted(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[bytes] = []

    def expand(path: Path, text: bytes, *_: object) -> Expanded:
        calls.append(text)
        return Expanded(EXPANDED, "", (path.parent / "wheel.xacro",))

    monkeypatch.setattr(xacro, "expand", expand)
    session = loading(folder, "models/arm.urdf.xacro")
    (found,) = session.diagnostics
    assert (found.code, found.severity) == ("untrusted-macros", "warning")
    assert found.help is not None and f"plastron trust {folder}" in found.help
    source = session.workspace.robots["rover"].source
    assert source is not None and source.macros is not None
    assert (source.expanded, source.macros.words) == (None, "1 include, 1 call")
    assert list(source.description.links) == ["base"]
    assert not calls

    TrustStore().add(folder)
    session.trust_changed()
    assert session.diagnostics == ()
    source = session.workspace.robots["rover"].source
    assert source is not None and source.expanded is not None
    assert list(source.expanded.links) == ["base", "left_wheel"]
    # The changes go to what the file itself says.
    assert list(session.workspace.robots["rover"].description.links) == ["base"]
    assert calls == [WITH_MACROS]


def test_a_file_is_expanded_again_where_it_may_come_to_something_else(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[bytes] = []

    def expand(path: Path, text: bytes, *_: object) -> Expanded:
        calls.append(text)
        return Expanded(None, "name 'x' is not defined", (path.parent / "sizes.yaml",))

    monkeypatch.setattr(xacro, "expand", expand)
    TrustStore().add(folder)
    session = loading(folder, "models/arm.urdf.xacro")

    def times() -> int:
        session.files_changed()
        (found,) = session.diagnostics
        assert found.message == "the macros are not expanded: name 'x' is not defined"
        return len(calls)

    assert [times(), times()] == [1, 1]
    for name in ("sizes.yaml", "wheel.xacro", "arm.urdf.xacro"):
        before = times()
        with (folder / "models" / name).open("ab") as file:
            file.write(b"\n")
        assert [times(), times()] == [before + 1, before + 1]


def test_what_is_in_the_way_of_expanding_is_told(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    TrustStore().add(folder)
    (folder / "models" / "wheel.xacro").unlink()
    (found,) = loading(folder, "models/arm.urdf.xacro").diagnostics
    assert found.message == "the macros are not expanded: `wheel.xacro` is not there"
    assert (found.code, found.severity) == ("not-expanded", "warning")
    assert found.file == folder / "models" / "arm.urdf.xacro"
    assert found.span is not None
    assert WITH_MACROS[found.span.start : found.span.end] == b"wheel.xacro"
    monkeypatch.setattr(xacro, "find_xacro", lambda _: None)
    (found,) = loading(folder, "models/arm.urdf.xacro").diagnostics
    assert found.help == "install it with `pip install 'plastron-tui[xacro]'`"


def test_mistakes_of_the_expanded_file_are_warnings_without_a_place(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = b"<robot name='r'><link name='base'/>" + b"<link/>" * 2
    text += b"".join(b"<joint name='j%d' type='x'/>" % number for number in range(9)) + b"</robot>"
    monkeypatch.setattr(xacro, "expand", lambda *_: Expanded(text))
    TrustStore().add(folder)
    found = loading(folder, "models/arm.urdf.xacro").diagnostics
    assert len(found) == robot_expansion._MOST_MISTAKES
    assert {each.severity for each in found} == {"warning"}
    assert found[0].message == "in the expanded file, `<link>` has no `name`"
    assert len(set(found)) == len(found)


@pytest.mark.long
def test_a_robot_is_expanded_by_the_package_itself(folder: Path) -> None:
    TrustStore().add(folder)
    session = loading(folder, "models/arm.urdf.xacro")
    assert session.diagnostics == ()
    source = session.workspace.robots["rover"].source
    assert source is not None and source.expanded is not None
    assert list(source.expanded.links) == ["base", "left_wheel"]
    assert list(source.expanded.joints) == ["left"]
