"""`plastron check`."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import click

from plastron_tui.diagnostics import has_errors
from plastron_tui.generating.nothing import nothing_to_generate
from plastron_tui.project.loaded_problems import loaded_problems

from .common import (
    Report,
    finish,
    format_option,
    open_sessions,
    programs_argument,
    target_option,
)


@click.command(epilog="Example: plastron check talker.plastron")
@programs_argument
@target_option
@format_option("text", "json")
def command(files: tuple[Path, ...], target: str | None, format_: str) -> None:
    """Say what is wrong with programs: all that `generate` would refuse.

    And what breaks a rule of `plastron lint` in the files that they load, as plastron.yaml has it.

    Exits with 1 when a program has errors, and with 2 when a file cannot be read. As JSON, the
    diagnostics of all programs are one list on standard output. That nothing is wrong is said on a
    terminal only.
    """
    from plastron_tui.ros.installations import sourced_version
    from plastron_tui.session import Options

    report = Report()
    found: list[dict[str, Any]] = []
    # Of a ROS that is not sourced nobody knows whether it is the one that is to run the nodes.
    options = Options(target, tells_absent=sourced_version(os.environ) is not None)
    for session in open_sessions(files, report, options):
        diagnostics = session.diagnostics
        workspace = session.workspace
        if not (workspace.is_written or has_errors(diagnostics)):
            diagnostics = (*diagnostics, nothing_to_generate(workspace))
        is_changing = any(each.node.source for each in workspace.generations)
        if (is_changing or workspace.has_more_than_nodes) and not has_errors(diagnostics):
            # What a file or a package that exists does not take shows when it is changed.
            _, found_in_files = session.plan()
            diagnostics = tuple(dict.fromkeys((*diagnostics, *found_in_files)))
        diagnostics = (*diagnostics, *loaded_problems(session))
        if format_ == "json":
            from plastron_tui.diagnostics.render import as_json

            found += as_json(report.count(diagnostics), session.lines, session.path)
        else:
            report.add(diagnostics, session.lines, session.path)
    if format_ == "json":
        from plastron_tui.diagnostics.json_text import json_text

        click.echo(json_text(found))
    elif report.is_empty and sys.stdout.isatty():
        click.echo("no problems")
    finish(report)
