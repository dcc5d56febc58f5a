"""`plastron fmt`."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from plastron_tui.diagnostics import has_errors
from plastron_tui.language import format_document
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.plan import OutputFile, make_plan
from plastron_tui.output.writer import write
from plastron_tui.project.settings import outside_program
from plastron_tui.session import Session

from .common import Report, finish, open_sessions, print_text, programs_argument, shown_path


@click.command(epilog="Example: plastron fmt *.plastron")
@programs_argument
@click.option("--check", is_flag=True, help="Only say which programs would change; exit with 1.")
def command(files: tuple[Path, ...], check: bool) -> None:
    """Lay programs out: one space between words, no stray empty lines.

    A file with a line that does not parse stays as it is. `-` reads standard input and writes the
    result to standard output, where such a line stays as it is.
    """
    report = Report()
    for session in open_sessions(files, report):
        report.add(session.program.diagnostics, session.lines, session.path)
        if session.path is not None and has_errors(session.program.diagnostics):
            # It may be no program at all.
            continue
        text = format_document(session.document)
        is_changed = text != session.document.text
        if check:
            if is_changed:
                shown = "standard input" if session.path is None else shown_path(session.path)
                click.echo(f"would reformat {shown}")
                report.status = max(report.status, 1)
        elif session.path is None:
            if sys.stdout.isatty():
                print_text(text.decode("utf-8", "replace"))
            else:
                sys.stdout.buffer.write(text)
                sys.stdout.buffer.flush()
        elif is_changed:
            _rewrite(session, session.path, text, report)
    finish(report)


def _rewrite(session: Session, path: Path, text: bytes, report: Report) -> None:
    outside = outside_program(path, session.boundary)
    if outside is not None:
        report.add([outside], lambda _: None)
        return
    file = OutputFile(
        path.name, text, is_executable=False, merged_from=session.document.text, path=path
    )
    plan, diagnostics = make_plan(path.absolute().parent, [file], Manifest())
    diagnostics = (*diagnostics, *plan.conflicts)
    if not has_errors(diagnostics):
        diagnostics = (*diagnostics, *write(plan).diagnostics)
    report.add(diagnostics, lambda _: None)
    if not has_errors(diagnostics):
        click.echo(f"reformatted {shown_path(path)}")
