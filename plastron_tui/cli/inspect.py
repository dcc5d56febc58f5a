"""`plastron inspect`."""

from __future__ import annotations

from pathlib import Path

import click

from plastron_tui.diagnostics import Diagnostic, LineIndex, codes
from plastron_tui.diagnostics.json_text import json_text
from plastron_tui.model.inspection import inspect_json, inspect_text
from plastron_tui.model.program_text import program_of
from plastron_tui.model.source import SourceUnit
from plastron_tui.project.loader import read_node, with_others
from plastron_tui.project.other_files import other_file
from plastron_tui.ros.robots.names import FILE_ENDINGS
from plastron_tui.targets import ros_version

from .common import Report, finish, format_option, print_text, read_input
from .file_words import files_and_arguments, robot_arguments, words_argument
from .inspect_robot import show_robot


@click.command(epilog="Example: plastron inspect --format plastron scripts/driver.py")
@words_argument
@format_option("text", "json", "plastron")
def command(words: tuple[str, ...], format_: str) -> None:
    """Show what files hold: of nodes their topics, services and types, of robots links and joints.

    As JSON, one file gives one object, and several give an object a line. As a program, what a
    statement can say becomes a statement, and the rest a comment. Behind a robot's FILE.xacro stand
    its arguments, as NAME:=VALUE.
    """
    files, arguments = files_and_arguments(words, lambda file: file.suffix in FILE_ENDINGS)
    given = robot_arguments(arguments)
    report = Report()
    for file in files:
        text = read_input(file, report)
        if text is None:
            continue
        if file.suffix in FILE_ENDINGS:
            show_robot(file, text, format_, report, given, is_one=len(files) == 1)
            continue
        source = _read(file, text, report)
        if source is None:
            continue
        if format_ == "json":
            click.echo(json_text(inspect_json(source), indent=2 if len(files) == 1 else None))
        elif format_ == "plastron":
            print_text(program_of(source, ros_version(source.library)))
        else:
            print_text(inspect_text(source))
    finish(report)


def _read(file: Path, text: bytes, report: Report) -> SourceUnit | None:
    if file.suffix == ".plastron":
        report.add([_program(file)], lambda _: None)
        return None
    loaded = read_node(file, with_others(file, text))
    other = other_file(file, "a node file", codes.NO_NODE) if loaded.source is None else None
    if other is not None:
        report.add([other], lambda _: None)
        return None
    report.add(loaded.diagnostics, lambda _: LineIndex(text), file)
    return loaded.source


def _program(file: Path) -> Diagnostic:
    return Diagnostic(
        codes.NO_NODE,
        f"`{file.name}` is a program, not a node file",
        file=file,
        help="`plastron check` and `plastron graph` read programs",
    )
