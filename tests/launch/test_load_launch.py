"""Programs that load launch files, change them, and write them."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.output.plan import FilePlan
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

ROS1 = (
    b'<launch>\r\n\t<!-- kept -->\r\n\t<node pkg="demo" type="a.py" name="a"/> <!-- a -->\r\n'
    b"</launch>\r\n"
)
ROS2 = b"<launch>\n  <node pkg='demo' exec='a'/>\n\n  <!-- kept -->\n</launch>\n"
FILES = [("b.launch", ROS1, "rospy", b'type="b"'), ("b.launch.xml", ROS2, "rclpy", b"exec='b'")]


def run(folder: Path, program: str, library: str, *, in_place: bool = False) -> Session:
    options = Options(library, folder / "output", in_place=in_place)
    return Session(program.encode(), folder / "p.plastron", options, environ={})


def plan_of(session: Session) -> FilePlan:
    assert session.diagnostics == ()
    plan, problems = session.plan()
    assert problems == ()
    return plan


@pytest.mark.parametrize("name, text, library, written", FILES)
@pytest.mark.parametrize("in_place", [False, True])
def test_only_what_is_asked_for_changes(
    tmp_path: Path, name: str, text: bytes, library: str, written: bytes, in_place: bool
) -> None:
    file = tmp_path / name
    file.write_bytes(text)
    head, end = f"load_launch '{name}' as b\n", "generate_launch b\n"
    session = run(tmp_path, f"{head}b starts 'demo/b'\n{end}", library, in_place=in_place)
    (made,) = plan_of(session).files
    assert made.path == (file if in_place else tmp_path / "output" / name)
    assert written in made.text
    lines = made.text.splitlines(keepends=True)
    assert [line for line in lines if line in text.splitlines(keepends=True)] == (
        text.splitlines(keepends=True)
    )
    file.write_bytes(made.text)
    (undone,) = plan_of(run(tmp_path, f"{head}b no_longer_starts 'b'\n{end}", library)).files
    assert undone.text == text


def test_what_a_file_starts_is_known(tmp_path: Path) -> None:
    (tmp_path / "b.launch.xml").write_bytes(ROS2)
    head = "load_launch 'b.launch.xml' as b\n"
    for statement, code in (
        ("b starts 'demo/a'", "already-started"),
        ("b no_longer_starts 'x'", "not-started"),
        ("load_launch './b.launch.xml' as c", "launch-exists"),
    ):
        assert [
            each.code for each in run(tmp_path, head + statement + "\n", "rclpy").diagnostics
        ] == [code]


def test_a_package_gets_a_loaded_launch_file_and_its_needs(tmp_path: Path) -> None:
    (tmp_path / "b.launch.xml").write_bytes(ROS2)
    program = (
        "load_launch 'b.launch.xml' as b\nb starts 'other/c'\n"
        'create_package \'rover\' as rover described_as "x" maintained_by "A <a@b.example>"'
        ' licensed_under "MIT"\nrover contains b\ngenerate_package rover\n'
    )
    texts = {each.name: each.text for each in plan_of(run(tmp_path, program, "rclpy")).files}
    assert b"exec='c'" in texts["rover/launch/b.launch.xml"]
    for package in (b"demo", b"other"):
        assert b"<exec_depend>%s</exec_depend>" % package in texts["rover/package.xml"]


@pytest.mark.parametrize(
    "name, text, code",
    [
        ("b.launch.xml", b"<launch>", None),
        ("b.launch.xml", b"<robot/>", "broken-launch"),
        ("b.launch.xml", b"\xff\xfe\x00", None),
        ("b.launch.xml", b"", None),
        ("b.launch.py", b"", "edit-refused"),
        ("b.launch.yaml", b"", "edit-refused"),
        ("c.launch.xml", ROS2, "file-not-found"),
        ("../b.launch.xml", ROS2, "outside-project"),
    ],
)
def test_what_cannot_be_loaded_is_told(
    tmp_path: Path, name: str, text: bytes, code: str | None
) -> None:
    folder = tmp_path / "project"
    folder.mkdir()
    (folder / name).write_bytes(text)
    asked = "b.launch.xml" if code == "file-not-found" else name
    found = run(folder, f"load_launch '{asked}' as b\ngenerate_launch b\n", "rclpy").diagnostics
    assert found
    assert code in (None, found[0].code)
    if found[0].code == "file-not-found":
        assert found[0].help == "did you mean `c.launch.xml`?"


IN_NAMESPACES = b"""\
<launch>
  <node pkg="demo" exec="ear" name="ear"/>
  <group>
    <push_ros_namespace namespace="front"/>
    <node pkg="demo" exec="ear" name="ear" namespace="left"/>
  </group>
</launch>
"""


@pytest.mark.parametrize(
    "statement, told",
    [
        ("b starts 'demo/ear' in 'front'", None),
        ("b starts 'demo/ear'", "already-started"),
        ("b starts 'demo/other' as 'ear' in '/front/left'", "already-started"),
        ("b no_longer_starts 'ear'", None),
        ("b no_longer_starts 'front/left/ear'", None),
        ("b no_longer_starts 'left/ear'", "not-started"),
    ],
)
def test_nodes_of_a_file_are_told_apart_by_their_full_names(
    tmp_path: Path, statement: str, told: str | None
) -> None:
    (tmp_path / "b.launch.xml").write_bytes(IN_NAMESPACES)
    head, end = "load_launch 'b.launch.xml' as b\n", "\ngenerate_launch b\n"
    session = run(tmp_path, head + statement + end, "rclpy")
    if told is not None:
        assert [each.code for each in session.diagnostics] == [told]
        return
    (made,) = plan_of(session).files
    before, after = IN_NAMESPACES.splitlines(), made.text.splitlines()
    gone = [line for line in before if line not in after]
    assert len(gone) == ("no_longer" in statement)
    assert (b"left" in b"".join(gone)) is ("left" in statement)
    assert len(after) == len(before) + (-1 if gone else 1)


def test_a_node_of_the_same_name_elsewhere_is_undone_in_place(tmp_path: Path) -> None:
    file = tmp_path / "b.launch.xml"
    file.write_bytes(IN_NAMESPACES)
    for statement in ("b starts 'demo/ear' in 'rear'\n", ""):
        program = f"load_launch 'b.launch.xml' as b\n{statement}generate_launch b\n"
        session = run(tmp_path, program, "rclpy", in_place=True)
        write(plan_of(session))
        assert (b"rear" in file.read_bytes()) is bool(statement)
    assert file.read_bytes() == IN_NAMESPACES
