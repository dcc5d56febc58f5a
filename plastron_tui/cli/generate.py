"""`plastron generate`."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from plastron_tui.diagnostics import Diagnostic, Severity, has_errors
from plastron_tui.output.diff import file_diff
from plastron_tui.output.plan import FilePlan, FileState
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

from .common import (
    Report,
    finish,
    open_sessions,
    output_option,
    programs_argument,
    target_option,
    use_color,
)

_COLORS = {
    FileState.CREATE: "green",
    FileState.IDENTICAL: "bright_black",
    FileState.CHANGED: "yellow",
    FileState.CONFLICT: "red",
}


@click.command(epilog="Example: plastron generate talker.plastron -o nodes")
@programs_argument
@output_option
@target_option
@click.option("--dry-run", is_flag=True, help="Show what would be written, and write nothing.")
@click.option("--diff", is_flag=True, help="Show how files would change, and write nothing.")
@click.option("--in-place", is_flag=True, help="Write loaded nodes over the files they come from.")
@click.option("--force", is_flag=True, help="Overwrite what was changed by hand; keep a backup.")
def command(
    files: tuple[Path, ...],
    output: Path | None,
    target: str | None,
    dry_run: bool,
    diff: bool,
    in_place: bool,
    force: bool,
) -> None:
    """Write the nodes of programs.

    A program with an error generates nothing. Files that were changed by hand are never lost:
    they are merged, or reported as a conflict.
    """
    report = Report()
    sessions = open_sessions(files, report, Options(target, output, in_place))
    for session in sessions:
        report.add(session.diagnostics, session.lines, session.path)
    if not report.status:
        for session in sessions:
            _generate(session, report, is_dry=dry_run or diff, diff=diff, force=force)
    finish(report)


def _generate(session: Session, report: Report, *, is_dry: bool, diff: bool, force: bool) -> None:
    plan, diagnostics = session.plan()
    report.add(diagnostics, session.lines, session.path)
    if has_errors(diagnostics):
        return
    if not plan.files:
        report.add((_nothing_to_generate(),), session.lines, session.path)
        return
    if diff:
        for file in plan.files:
            sys.stdout.flush()
            sys.stdout.buffer.write(file_diff(file))
        sys.stdout.buffer.flush()
    else:
        show_plan(plan, session)
    if is_dry:
        report.add(() if force else plan.conflicts, lambda _: None, session.path)
    else:
        write_plan(plan, session, report, force=force)


def write_plan(plan: FilePlan, session: Session, report: Report, *, force: bool = False) -> bool:
    """Write the files of a plan, all or, where one is in conflict, none; tell whether it was."""
    if plan.conflicts and not force:
        report.add(plan.conflicts, lambda _: None, session.path)
        return False
    result = write(plan, force=force)
    report.add(result.diagnostics, lambda _: None, session.path)
    for written in result.written:
        if written.backup is not None:
            click.echo(f"{'backup':>9}  {written.backup}")
    return not result.diagnostics


def show_plan(plan: FilePlan, session: Session) -> None:
    """Write a line for each file: what happens to it, and where it is."""
    for file in plan.files:
        state = f"{file.state.value:>9}"
        shown = file.path if session.options.in_place else plan.folder / file.name
        if use_color(sys.stdout):
            state = click.style(state, fg=_COLORS[file.state])
        click.echo(f"{state}  {shown}", color=True)


def _nothing_to_generate() -> Diagnostic:
    return Diagnostic(
        "nothing-to-generate",
        "the program generates no node",
        help="end it with `generate_node` and the variable of a node",
        severity=Severity.WARNING,
    )
