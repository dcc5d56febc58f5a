"""Definitions that a program loads, changes and writes, on the disk."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

MANIFEST = '<package format="3"><name>{}</name></package>\n'
DEFINITION = "# How fast the wheels turn.\nfloat64 left   # m/s\r\n\n# a section\nfloat64 right"
CHANGE = "load_type 'msg/Wheels.msg' as Wheels\nWheels has_field \"float64 slip\"\n"


@pytest.mark.parametrize("in_place", [False, True])
def test_a_definition_that_exists_keeps_all_other_bytes(tmp_path: Path, in_place: bool) -> None:
    (tmp_path / "package.xml").write_text(MANIFEST.format("robot"))
    file = tmp_path / "msg" / "Wheels.msg"
    file.parent.mkdir()
    file.write_bytes(DEFINITION.encode())
    options = Options("rclpy", tmp_path / "output", in_place=in_place)
    text = f"{CHANGE}generate_type Wheels\n"
    program = Session(text.encode(), tmp_path / "a.plastron", options, environ={})
    plan, found = program.plan()
    assert [*program.diagnostics, *found] == []
    assert write(plan).diagnostics == ()
    made = tmp_path / "output" / "robot" / "msg" / "Wheels.msg"
    written = file if in_place else made
    # The end of the text stays as it is: without a newline.
    assert written.read_bytes() == DEFINITION.encode() + b"\nfloat64 slip"
    if not in_place:
        assert file.read_bytes() == DEFINITION.encode()
    again = Session(text.encode(), tmp_path / "a.plastron", options, environ={})
    plan, found = again.plan()
    assert [*again.diagnostics, *found] == []
    assert {each.state.value for each in plan.files} <= {"identical"}


NAMESAKES = (
    "load_type 'a/msg/Wheel.msg' as first\nload_type 'b/srv/Wheel.srv' as second\n"
    "load_type 'b/msg/Wheel.msg' as third\nfirst has_field \"float64 slip\"\n"
    'second has_field "float64 grip"\nthird has_field "float64 roll"\n'
)


def two_packages(folder: Path) -> None:
    for package in ("a", "b"):
        for kind, text in ("msg", "int8 x\n"), ("srv", "int8 x\n---\n"):
            (folder / package / kind).mkdir(parents=True)
            (folder / package / kind / f"Wheel.{kind}").write_text(text)
        (folder / package / "package.xml").write_text(MANIFEST.format(package))


@pytest.mark.parametrize("in_place", [False, True])
def test_types_of_one_name_in_two_packages_are_two_files(tmp_path: Path, in_place: bool) -> None:
    two_packages(tmp_path)
    options = Options("rclpy", tmp_path / "output", in_place=in_place)
    text = f"{NAMESAKES}generate_type first\n"
    program = Session(text.encode(), tmp_path / "a.plastron", options, environ={})
    plan, found = program.plan()
    assert [*program.diagnostics, *found] == []
    assert write(plan).diagnostics == ()
    root = tmp_path if in_place else tmp_path / "output"
    assert (root / "a/msg/Wheel.msg").read_text() == "int8 x\nfloat64 slip\n"
    assert (root / "b/msg/Wheel.msg").read_text() == "int8 x\nfloat64 roll\n"
    assert (root / "b/srv/Wheel.srv").read_text() == "int8 x\nfloat64 grip\n---\n"


@pytest.mark.parametrize(
    "first",
    ["load_type 'a/msg/Wheel.msg' as first\n", "create_message_type a/Wheel with int8 y\n"],
)
def test_a_type_that_is_there_is_not_loaded(tmp_path: Path, first: str) -> None:
    two_packages(tmp_path)
    text = f"{first}load_type 'a/msg/Wheel.msg' as second\nload_type 'a/srv/Wheel.srv' as third\n"
    program = Session(text.encode(), tmp_path / "a.plastron", environ={})
    [found] = program.diagnostics
    assert (found.code, found.message) == (
        "type-exists",
        "the program has a type `a/Wheel` already",
    )


OUTSIDE = ["../Wheels.msg", "/etc/Wheels.msg", "msg/Nothing.msg", "msg", "msg/Wheels.txt"]


@pytest.mark.parametrize("path", OUTSIDE)
def test_a_definition_that_is_not_there_is_told(tmp_path: Path, path: str) -> None:
    folder = tmp_path / "project"
    (folder / "msg").mkdir(parents=True)
    (folder / "plastron.yaml").touch()
    (folder / "msg" / "Wheels.msg").write_text("int32 x\n")
    (tmp_path / "Wheels.msg").write_text("int32 x\n")
    text = f"load_type '{path}' as Wheels\n"
    program = Session(text.encode(), folder / "a.plastron", environ={})
    [found] = program.diagnostics
    assert found.code in ("outside-project", "file-not-found")
