"""`plastron graph`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import click

from plastron_tui.model.graph import graph_of
from plastron_tui.model.workspace import Workspace
from plastron_tui.output.graphs import FORMATS, render
from plastron_tui.session import Options, Session

from .common import (
    Report,
    finish,
    format_option,
    open_sessions,
    print_text,
    programs_argument,
    target_option,
)


@click.command(epilog="Example: plastron graph --format svg robot.plastron > robot.svg")
@programs_argument
@target_option
@format_option(*FORMATS)
def command(files: tuple[Path, ...], target: str | None, format_: str) -> None:
    """Show the nodes of programs, and the topics and services that join them.

    Several programs give one graph. Of a program with mistakes, what is right is shown.
    """
    report = Report()
    sessions = open_sessions(files, report, Options(target=target))
    if sessions:
        print_text(render(graph_of(joined(sessions)), format_))
    for session in sessions:
        report.add(session.diagnostics, session.lines, session.path)
    finish(report)


def joined(sessions: Iterable[Session]) -> Workspace:
    """Return the nodes of several programs as one workspace.

    A variable that an earlier program has too gets its program's name in front.
    """
    whole = Workspace()
    for session in sessions:
        names = {
            variable: variable if variable not in whole.nodes else _other(session, variable, whole)
            for variable in session.workspace.nodes
        }
        for variable, node in session.workspace.nodes.items():
            whole.nodes[names[variable]] = replace(node, variable=names[variable])
        for made in session.workspace.generations:
            node = replace(made.node, variable=names[made.node.variable])
            whole.generations.append(made._replace(node=node))
    return whole


def _other(session: Session, variable: str, whole: Workspace) -> str:
    stem = "input" if session.path is None else session.path.stem
    name, count = f"{stem}.{variable}", 1
    while name in whole.nodes:
        count += 1
        name = f"{stem}.{variable}_{count}"
    return name
