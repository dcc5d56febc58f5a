"""`plastron inspect` of the description of a robot."""

from __future__ import annotations

from pathlib import Path

import click

from plastron_tui.diagnostics import Span
from plastron_tui.diagnostics.json_text import json_text
from plastron_tui.ros.robots.macros import Arguments

from .common import Report, print_text


def show_robot(
    file: Path, text: bytes, format_: str, report: Report, given: Arguments, *, is_one: bool
) -> None:
    """Print what there is in a robot's file, and what is wrong with it.

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
    from plastron_tui.session import Session

    from .robot_input import read_robot

    read = read_robot(file, text, given)
    found = list(read.diagnostics)
    source = None if read.robot is None else read.robot.source
    nowhere = Span(0, 0)
    for each in () if source is None else faults_of_file(source, nowhere):
        span = None if each.span == nowhere else each.span
        found.append(each._replace(file=file, span=span))
    found = list(dict.fromkeys(found))
    report.add(found, read.lines, file)
    if read.robot is None or source is None:
        return
    robot = read.robot.shown
    if format_ == "json":
        from plastron_tui.diagnostics.render import as_json

        faults = as_json(found, read.lines, file)
        told = robot_json(robot, file, source.macros) | {"faults": faults}
        click.echo(json_text(told, indent=2 if is_one else None))
    elif format_ == "plastron":
        program = program_of_robot(robot, read.robot.variable, lambda x: Session(x).diagnostics)
        print_text(program)
    else:
        is_whole = source.expanded is not None
        print_text(robot_text(robot, file, None if is_whole else source.macros))
