"""`plastron inspect` of the description of a robot."""

from __future__ import annotations

import json
import os
from pathlib import Path

import click

from plastron_tui.boundary import find_boundary
from plastron_tui.diagnostics import Diagnostic, LineIndex, Span
from plastron_tui.ros.robots.macros import Arguments

from .common import Report, print_text


def show_robot(
    file: Path, text: bytes, format_: str, report: Report, given: Arguments, *, is_one: bool
) -> None:
    """Print what there is in a robot's file, and what is wrong with it.

    Macros are expanded where the project of the file is trusted; else what stands in the file
    itself is shown, and why.

    Args:
        file: the file.
        text: what it holds.
        format_: `text`, `json` or `plastron`.
        report: takes what is wrong.
        given: what its macros are given.
        is_one: whether the file is the only one.
    """
    from plastron_tui.model.robot_faults import faults_of_file
    from plastron_tui.model.robot_inspection import robot_json, robot_text
    from plastron_tui.model.robot_program import program_of_robot
    from plastron_tui.model.robots import file_stem
    from plastron_tui.project.robot_graph import read_robot_file
    from plastron_tui.session import Session

    def lines(other: Path | None) -> LineIndex | None:
        return LineIndex(text) if other in (None, file) else None

    read = read_robot_file(file, find_boundary(file.absolute().parent), os.environ, given)
    source = read.loaded.source
    found = [_placed(each, file) for each in read.diagnostics]
    if source is not None:
        found += (_placed(each, file) for each in faults_of_file(source, Span(0, 0)))
    found = list(dict.fromkeys(found))
    report.add(found, lines, file)
    if source is None:
        return
    robot = source.description if source.expanded is None else source.expanded
    if format_ == "json":
        from plastron_tui.diagnostics.render import as_json

        told = robot_json(robot, file, source.macros) | {"faults": as_json(found, lines, file)}
        click.echo(json.dumps(told, indent=2 if is_one else None))
    elif format_ == "plastron":
        program = program_of_robot(robot, file_stem(file.name), lambda x: Session(x).diagnostics)
        print_text(program)
    else:
        is_whole = source.expanded is not None
        print_text(robot_text(robot, file, None if is_whole else source.macros))


def _placed(found: Diagnostic, file: Path) -> Diagnostic:
    """Return a diagnostic as one of a file, as that was named."""
    if found.file is None or found.file == file.absolute().parent / file.name:
        span = None if found.span == Span(0, 0) else found.span
        return found._replace(file=file, span=span)
    return found
