"""Parameter files that launch files name: copied into the package, installed, found again."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.diagnostics import Diagnostic, has_errors
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

TEXTS = {"rclpy": "talker:\n  ros__parameters:\n    speed: 0.5\n", "rospy": "speed: 0.5\n"}
HEAD = """\
create_node 'talker' as talker
create_message m of message_type String and input "hi"
talker publish m to 'chatter' of message_type String at 1 hz
create_launch 'bringup' as bringup
"""
PACKAGE = """\
create_package 'demo' as demo described_as "x" maintained_by "A <a@b.example>" licensed_under "MIT"
demo contains talker
demo contains bringup
generate_package demo
"""


def run(folder: Path, statements: str, library: str = "rclpy") -> tuple[str, list[Diagnostic]]:
    """Run a program and write what it makes, unless there is a mistake in it."""
    text = HEAD + statements
    options = Options(library, folder / "output")
    session = Session(text.encode(), folder / "p.plastron", options, environ={})
    if has_errors(session.diagnostics):
        return text, list(session.diagnostics)
    plan, problems = session.plan()
    if not has_errors(problems):
        write(plan)
    return text, [*session.diagnostics, *problems]


@pytest.fixture
def project(tmp_path: Path) -> Path:
    (tmp_path / "plastron.yaml").write_text("")
    folder = tmp_path / "programs"
    folder.mkdir()
    return folder


@pytest.mark.parametrize(
    "library, find, installs",
    [
        ("rclpy", 'from="$(find-pkg-share demo)/config/own.yaml"', "setup.py"),
        ("rospy", 'file="$(find demo)/config/own.yaml"', "CMakeLists.txt"),
    ],
)
@pytest.mark.parametrize("place", ["own.yaml", "deep/own.yaml", "../own.yaml"])
def test_a_parameter_file_is_put_into_the_package(
    project: Path, place: str, library: str, find: str, installs: str
) -> None:
    file = project / place
    file.parent.mkdir(exist_ok=True)
    file.write_text(TEXTS[library])
    program = f"bringup starts talker with parameters '{place}'\n{PACKAGE}"
    assert run(project, program, library)[1] == []
    made = project / "output" / "demo"
    assert (made / "config" / "own.yaml").read_text() == TEXTS[library]
    name = "bringup.launch" if library == "rospy" else "bringup.launch.xml"
    assert find in (made / "launch" / name).read_text()
    assert "config" in (made / installs).read_text()
    inside = {path.name for path in project.iterdir()}
    assert inside == {"output", Path(place).parts[0]} - {".."}


def _broken(project: Path, kind: str) -> None:
    file = project / "own.yaml"
    match kind:
        case "folder":
            file.mkdir()
        case "fifo":
            os.mkfifo(file)
        case "bytes":
            file.write_bytes(b"talker: \xff")
        case "large":
            file.write_text("# " + "x" * 300_000)
        case "deep":
            file.write_text("[" * 5000)
        case "yaml":
            file.write_text("talker:\n  ros__parameters: [1\n")
        case "bare":
            file.write_text("speed: 0.5\n")
        case "empty":
            file.write_text("")
        case "loop":
            file.symlink_to(file)
        case "outside":
            file.symlink_to("/etc/hostname")
        case _:
            (project / "owm.yaml").write_text("")


@pytest.mark.parametrize(
    "kind, code",
    [
        ("folder", "unreadable-file"), ("fifo", "unreadable-file"), ("bytes", "bad-parameters"),
        ("large", "unreadable-file"), ("deep", "bad-parameters"), ("yaml", "bad-parameters"),
        ("bare", "bad-parameters"), ("empty", "bad-parameters"), ("loop", "unreadable-file"),
        ("outside", "outside-project"), ("missing", "file-not-found"),
    ],
)  # fmt: skip
def test_what_is_no_parameter_file_is_told_at_the_word(project: Path, kind: str, code: str) -> None:
    _broken(project, kind)
    text, found = run(project, f"bringup starts talker with parameters 'own.yaml'\n{PACKAGE}")
    assert [each.code for each in found] == [code]
    assert found[0].span is not None
    assert text[found[0].span.start : found[0].span.end] == "'own.yaml'"
    assert not (project / "output").exists()
    if kind == "missing":
        assert found[0].help == "did you mean `owm.yaml`?"


@pytest.mark.parametrize(
    "place, code", [("own.txt", "bad-parameters"), ("/etc/x.yaml", "outside-project")]
)
def test_other_files_are_not_taken(project: Path, place: str, code: str) -> None:
    found = run(project, f"bringup starts talker with parameters '{place}'\n{PACKAGE}")[1]
    assert [each.code for each in found] == [code]


def test_two_files_of_one_name_are_told(project: Path) -> None:
    for place in ("own.yaml", "deep/Own.yaml"):
        (project / place).parent.mkdir(exist_ok=True)
        (project / place).write_text(TEXTS["rclpy"])
    starts = "bringup starts {} with parameters '{}'\n"
    first = starts.format("talker", "own.yaml")
    same = starts.format("talker as 'other'", "deep/../own.yaml")
    assert run(project, f"{first}{same}{PACKAGE}")[1] == []
    (project / "deep/own.yaml").write_text(TEXTS["rclpy"])
    equal = starts.format("talker as 'other'", "deep/own.yaml")
    assert run(project, f"{first}{equal}{PACKAGE}")[1] == []
    second = starts.format("talker as 'other'", "deep/Own.yaml")
    text, found = run(project, f"{first}{second}{PACKAGE}")
    assert [each.code for each in found] == ["bad-package-file"]
    assert found[0].span is not None
    assert text[found[0].span.start : found[0].span.end] == "'deep/Own.yaml'"


def test_a_launch_file_in_no_package_has_no_parameter_file(project: Path) -> None:
    (project / "own.yaml").write_text(TEXTS["rclpy"])
    program = "bringup starts 'demo/ear' with parameters 'own.yaml'\ngenerate_launch bringup\n"
    text, found = run(project, program)
    assert [each.code for each in found] == ["in-no-package"]
    assert found[0].span is not None
    assert text[found[0].span.start : found[0].span.end] == "'own.yaml'"
    assert not (project / "output").exists()


def test_a_changed_parameter_file_is_copied_again(project: Path) -> None:
    (project / "own.yaml").write_text(TEXTS["rclpy"])
    program = f"bringup starts talker with parameters 'own.yaml'\n{PACKAGE}"
    run(project, program)
    (project / "own.yaml").write_text(TEXTS["rclpy"].replace("0.5", "0.7"))
    assert run(project, program)[1] == []
    assert "0.7" in (project / "output/demo/config/own.yaml").read_text()


@pytest.mark.parametrize(
    "statement, code, wrong",
    [
        ("bringup starts 'eye/eye::Eye' inside 'eyes'", "not-a-component", "'eyes'"),
        ("bringup starts 'eye/eye' setting 'home' = \"$(env HOME)\"", "bad-launch-name", None),
    ],
)
def test_what_ros_1_cannot_say_is_told_where_it_is_said(
    project: Path, statement: str, code: str, wrong: str | None
) -> None:
    text, found = run(project, f"{statement}\ngenerate_launch bringup\n", "rospy")
    assert [each.code for each in found] == [code]
    assert found[0].span is not None
    assert text[found[0].span.start : found[0].span.end] == (wrong or statement)
