"""`plastron generate`."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import click

from plastron_tui.diagnostics import Diagnostic, codes, has_errors
from plastron_tui.diagnostics.terminal import wants_colour
from plastron_tui.generating.nothing import nothing_to_generate
from plastron_tui.output.diff import file_diff, visible_patch
from plastron_tui.output.plan import FilePlan, FileState, PlannedFile
from plastron_tui.output.writer import write_current
from plastron_tui.session import Options, Session

from .common import (
    Report,
    finish,
    open_sessions,
    output_option,
    programs_argument,
    shown_path,
    target_option,
)

Planned = tuple[FilePlan, tuple[Diagnostic, ...]]

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
    """Write the nodes and robots of programs.

    When a program has an error, or a file is in conflict, nothing is written. Files that were
    changed by hand are never lost: they are merged, or reported as a conflict.
    """
    report = Report()
    sessions = open_sessions(
        files, report, Options(target, output, in_place, force, is_writing=True)
    )
    for session in sessions:
        report.add(session.diagnostics, session.lines, session.path)
    if not report.status:
        plans = _plan(sessions, report)
        if not report.status:
            for plan in plans:
                if diff:
                    show_diff(plan)
                else:
                    show_plan(plan, force=force)
            if not dry_run and not diff:
                _carry_out(sessions, plans, report, force=force)
            elif not force:
                report.add([found for plan in plans for found in plan.conflicts], lambda _: None)
    finish(report)


def _plan(sessions: Sequence[Session], report: Report) -> list[FilePlan]:
    """Plan all programs before one is written, so that a mistake in the last stops the first."""
    plans = []
    texts: dict[Path, bytes] = {}
    for session in sessions:
        plan, diagnostics = session.plan()
        report.add(diagnostics, session.lines, session.path)
        is_idle = not (plan.files or session.workspace.is_written)
        if is_idle and not has_errors(diagnostics):
            report.add((nothing_to_generate(session.workspace),), session.lines, session.path)
        for file in plan.files:
            if texts.setdefault(file.path, file.text) != file.text:
                report.add((_same_file(file.name),), session.lines, session.path)
        plans.append(plan)
    return plans


def _carry_out(
    sessions: Sequence[Session], plans: Sequence[FilePlan], report: Report, *, force: bool
) -> None:
    conflicts = [found for plan in plans for found in plan.conflicts]
    is_stale = len(plans) == 1 and all(found.code == codes.CHANGED_ON_DISK for found in conflicts)
    if conflicts and not force and not is_stale:
        report.add(conflicts, lambda _: None)
        return
    for session, plan in zip(sessions, plans, strict=True):
        write_plan(plan, session, report, force=force)


def write_plan(
    plan: FilePlan,
    session: Session,
    report: Report,
    *,
    force: bool = False,
    again: Callable[[], Planned] | None = None,
) -> bool:
    """Write the files of a plan, all or, where one is in conflict, none; tell whether it was.

    Where another process wrote to the folder meanwhile, the plan is made again.

    Args:
        plan: what to write.
        session: the program.
        report: where to say what is wrong.
        force: overwrite what is in conflict.
        again: makes the plan again; without it, that of the whole program.
    """
    before = plan

    def plan_again() -> FilePlan | None:
        nonlocal before
        session.files_changed()
        plan, diagnostics = (again or session.plan)()
        problems = (*session.diagnostics, *diagnostics)
        if has_errors(problems):
            report.add(problems, session.lines, session.path)
            return None
        show_plan(_differing(plan, before), force=force)
        before = plan
        return plan

    result = write_current(plan, plan_again, force=force)
    report.add(result.diagnostics, lambda _: None, session.path)
    for written in result.written:
        if written.backup is not None:
            click.echo(f"{'backup':>9}  {shown_path(written.backup)}")
    return not has_errors(result.diagnostics)


def _differing(plan: FilePlan, before: FilePlan) -> FilePlan:
    """Return the files of a plan to which something else happens than in an earlier one."""
    known = {(file.path, file.state) for file in before.files}
    files = tuple(x for x in plan.files if (x.path, x.state) not in known)
    return replace(plan, files=files)


def show_diff(plan: FilePlan) -> None:
    """Write how files change: as a patch, byte for byte, where it is not for a terminal."""
    for file in plan.files:
        patch = file_diff(replace(file, name=_name_in_patch(plan, file)))
        if sys.stdout.isatty():
            click.echo(visible_patch(patch), nl=False)
        else:
            sys.stdout.flush()
            sys.stdout.buffer.write(patch)
    sys.stdout.buffer.flush()


def _name_in_patch(plan: FilePlan, file: PlannedFile) -> str:
    """Return the name of a file in a patch: from the output folder, or from the working folder.

    That is from the working folder for a file that is changed where it is, outside of the output
    folder, so that one patch of a node with its headers and its package names each as it lies.
    """
    folder, here = plan.folder.resolve(), Path.cwd()
    if file.path.is_relative_to(folder):
        return file.path.relative_to(folder).as_posix()
    if (folder / file.name).resolve() != file.path and file.path.is_relative_to(here):
        return file.path.relative_to(here).as_posix()
    return file.name


def show_plan(plan: FilePlan, *, only_changes: bool = False, force: bool = False) -> None:
    """Write a line for each file: what happens to it, and where it is.

    With `force` a file in conflict is replaced.
    """
    for file in plan.files:
        if only_changes and file.state is FileState.IDENTICAL:
            continue
        is_replaced = force and file.state is FileState.CONFLICT
        state = f"{'replaced' if is_replaced else file.state.value:>9}"
        is_inside = file.path.parent == plan.folder.resolve()
        # The files of a package that the output folder is are named with the package.
        path = plan.folder / file.name if is_inside and "/" not in file.name else file.path
        if wants_colour(sys.stdout):
            state = click.style(state, fg=_COLORS[file.state])
        click.echo(f"{state}  {shown_path(path)}", color=True)


def _same_file(name: str) -> Diagnostic:
    return Diagnostic(
        codes.SAME_FILE,
        f"an earlier program writes `{name}` too, with another text",
        help="give what one of them is of another name, or one of the programs another `-o`",
    )
