"""`plastron graph`."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import click

from plastron_tui.model.graph import graph_of
from plastron_tui.session import Options

from .common import Report, finish, format_option, open_session, program_argument, target_option


@click.command(epilog="Example: plastron graph --format svg robot.plastron > robot.svg")
@program_argument
@target_option
@format_option("text", "json", "mermaid", "dot", "svg")
def command(file: Path, target: str | None, format_: str) -> None:
    """Show the nodes of a program, and the topics and services that join them.

    Of a program with mistakes, what is right is shown.
    """
    report = Report()
    session = open_session(file, report, Options(target=target))
    if session is not None:
        renderer = import_module(f"plastron_tui.output.graphs.{format_}")
        click.echo(renderer.render(graph_of(session.workspace)).rstrip("\n"))
        report.add(session.diagnostics, session.lines, session.path)
    finish(report)
