"""`plastron inspect` of the description of a robot."""

from __future__ import annotations

import json
from pathlib import Path

import click

from plastron_tui.diagnostics import LineIndex

from .common import Report, print_text

ROBOT_SUFFIXES = (".urdf", ".xacro")


def show_robot(file: Path, text: bytes, format_: str, report: Report, *, is_one: bool) -> None:
    """Print what there is in a robot's file, and what is wrong with it.

    Args:
        file: the file.
        text: what it holds.
        format_: `text`, `json` or `plastron`.
        report: takes what is wrong.
        is_one: whether the file is the only one.
    """
    from plastron_tui.model.robot_inspection import robot_json, robot_text
    from plastron_tui.model.robot_program import program_of_robot
    from plastron_tui.sources.urdf.reader import read_urdf

    read = read_urdf(text, file)
    report.add(read.diagnostics, lambda _: LineIndex(text), file)
    robot = read.description
    if robot is None:
        return
    if format_ == "json":
        click.echo(json.dumps(robot_json(robot, file), indent=2 if is_one else None))
    elif format_ == "plastron":
        print_text(program_of_robot(robot, file.stem))
    else:
        print_text(robot_text(robot, file))
