"""`plastron fmt`."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from plastron_tui.language import format_document
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.plan import OutputFile, make_plan
from plastron_tui.output.writer import write
from plastron_tui.session import Session

from .common import Report, finish, open_sessions, programs_argument, shown_path


@click.command(epilog="Example: plastron fmt *.plastron")
@programs_argument
@click.option("--check", is_flag=True, help="Only say which programs would change; exit with 1.")
def command(files: tuple[Path, ...], check: bool) -> None:
    """Lay programs out: one space between words, no stray empty lines.

    A line that does not parse stays as it is. `-` reads standard input and writes the result to
    standard output.
    """
    report = Report()
    for session in open_sessions(files, report):
        report.add(session.program.diagnostics, session.lines, session.path)
        text = format_document(session.document)
        is_changed = text != session.document.text
        if check:
            if is_changed:
                shown = "standard input" if session.path is None else shown_path(session.path)
                click.echo(f"would reformat {shown}")
                report.status = max(report.status, 1)
        elif session.path is None:
            sys.stdout.buffer.write(text)
            sys.stdout.buffer.flush()
        elif is_changed:
            _rewrite(session, session.path, text, report)
    finish(report)


def _rewrite(session: Session, path: Path, text: bytes, report: Report) -> None:
    file = OutputFile(
        path.name, text, is_executable=False, merged_from=session.document.text, path=path
    )
    plan, diagnostics = make_plan(path.absolute().parent, [file], Manifest())
    diagnostics = (*diagnostics, *plan.conflicts)
    if not diagnostics:
        diagnostics = write(plan).diagnostics
    report.add(diagnostics, lambda _: None)
    if not diagnostics:
        click.echo(f"reformatted {shown_path(path)}")
