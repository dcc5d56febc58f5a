"""`plastron run` of a launch file."""

from __future__ import annotations

import sys
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

import click

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.terminal import drawn_on, visible
from plastron_tui.model.launches import Launch

from .common import Report, finish
from .run_options import refuse

if TYPE_CHECKING:
    from plastron_tui.diagnostics import LineIndex
    from plastron_tui.model.robots import Robot
    from plastron_tui.output.plan import FilePlan
    from plastron_tui.runtime.launch import Options
    from plastron_tui.session import Session
    from plastron_tui.sources.launch.xml_reader import LaunchRead


def find_launch(session: Session, names: Sequence[str]) -> Launch | Robot | None:
    """Return what is started by a launch file and is named, None where the names are of nodes.

    That is a launch file of the program, or a robot, which has one in a package. A node goes
    before a launch file of its name. Without names it is the only one of a program without nodes.
    """
    workspace = session.workspace
    nodes = {word for each in workspace.nodes.values() for word in (each.name, each.variable)}
    robots = workspace.robots.values()
    items: list[Launch | Robot] = [*workspace.launches.values(), *robots]
    if not names and not nodes and len(items) == 1:
        return items[0]
    for item in items:
        if any(name in (_stem(item), item.variable) and name not in nodes for name in names):
            return item
    return None


def _stem(item: Launch | Robot) -> str:
    """Return what a launch file is called, without its ending."""
    return item.name if isinstance(item, Launch) else item.stem


def run_launch_of(
    session: Session,
    launch: Launch | Robot,
    names: Sequence[str],
    options: Options,
    others: Sequence[str],
    report: Report,
) -> None:
    """Write a program, and start what one of its launch files says.

    Args:
        session: the program.
        launch: the launch file.
        names: the launch file's name, and arguments as `NAME:=VALUE`.
        options: how to run.
        others: options that were given, and that say nothing to a launch file.
        report: where to say what is wrong.
    """
    from .generate import show_plan, write_plan

    stem = _stem(launch)
    rest = [each for each in names if each not in (stem, launch.variable)]
    words = [each for each in rest if ":=" in each[1:]]
    if len(words) < len(rest):
        other = next(each for each in rest if each not in words)
        refuse(f"`{stem}` is a launch file, and is started without `{other}`")
    refuse(_wrong_usage(words, others))
    report.add(session.diagnostics, session.lines, session.path)
    if not report.status:
        plan, diagnostics = session.plan()
        report.add(diagnostics, session.lines, session.path)
        file = _written(session, launch, plan)
        if not report.status and file is None:
            message = f"the program does not write `{stem}`"
            remedy = "generate the package that has it"
            if isinstance(launch, Launch):
                remedy = f"add `generate_launch {launch.variable}`, or {remedy}"
            elif not launch.home:
                message = f"nothing starts `{stem}`: the launch file that does comes with a package"
                remedy = _into_package(launch.variable, session.workspace.packages)
            found = Diagnostic(codes.NOTHING_TO_GENERATE, message, launch.span, help=remedy)
            report.add([found], session.lines, session.path)
        if not report.status and file is not None:
            show_plan(plan, only_changes=True)
            if write_plan(plan, session, report):
                run_launch(file, words, options, (), report)
                return
    finish(report)


def _into_package(robot: str, packages: Collection[str]) -> str:
    """Say how a robot gets into a package that is written."""
    if packages:
        return f"put it into one: `{next(iter(packages))} contains {robot}`"
    package = "package" if robot != "package" else "home"
    made = f"create_package '{robot.lower()}_description' as {package}"
    return (
        f"put it into one: `{made}`, then `{package} contains {robot}` and "
        f"`generate_package {package}`"
    )


def _written(session: Session, launch: Launch | Robot, plan: FilePlan) -> Path | None:
    """Return where a program writes a launch file, None where it does not."""
    if isinstance(launch, Launch) and launch.source is not None:
        files = {launch.source.path.name}
    else:
        files = {f"{_stem(launch)}{ending}" for ending in (".launch.xml", ".launch.py", ".launch")}
    packages = session.workspace.packages.values()
    homes = {each.name for each in packages if launch.variable in each.contents}
    found = [each for each in plan.files if PurePath(each.name).name in files]
    for each in found:
        if PurePath(each.name).parts[0] in homes:
            return each.path
    return found[0].path if found and not homes else None


def run_launch(
    file: Path,
    words: Sequence[str],
    options: Options,
    others: Sequence[str],
    report: Report | None = None,
) -> None:
    """Start what a launch file says, until it has ended or is stopped.

    Args:
        file: the launch file.
        words: the arguments, as `NAME:=VALUE`.
        options: how to run.
        others: options of programs that were given, and that say nothing to a launch file.
        report: where to say what is wrong where its program was just written; None for one of
            its own.
    """
    from plastron_tui.regular_files import read_regular, reason
    from plastron_tui.runtime.build_progress import ProgressLine
    from plastron_tui.runtime.environment import find_environments
    from plastron_tui.runtime.launch import run_nodes
    from plastron_tui.runtime.launch_run import prepare
    from plastron_tui.sources.launch.reader import LARGEST, read_launch

    is_written, report = report is not None, report or Report()
    refuse(_wrong_usage(words, others))
    try:
        source = read_regular(file, LARGEST)
    except (OSError, ValueError) as error:
        found = Diagnostic(codes.UNREADABLE_FILE, f"cannot read `{file.name}`: {reason(error)}")
        report.unreadable([found])
        finish(report)
        return
    read = read_launch(source, file)
    report.add(read.diagnostics, _lines)
    if read.launch is not None and not report.status:
        environment, diagnostics = find_environments().choose(read.format.ros_version)
        report.add(diagnostics, _lines)
        if environment is not None:
            arguments = dict(_pair(word) for word in words)
            with ProgressLine(drawn_on(sys.stderr)) as line:
                prepared = prepare(read.launch, file, arguments, environment, tell=line.tell)
            told = (*prepared.diagnostics, *_differences(read, source, file, arguments))
            report.add(
                (*told, *([] if is_written else _stale(file, read.format.ros_version))), _lines
            )
            if prepared.nodes and not report.status:
                click.echo(visible(f"running {file.name} on {environment.words}"), err=True)
                out, err = drawn_on(sys.stdout), drawn_on(sys.stderr)
                result = run_nodes(prepared.nodes, options, out=out, err=err)
                report.add(result.diagnostics, _lines, file)
                report.status = max(report.status, result.status)
    finish(report)


def _lines(path: Path | None) -> LineIndex | None:
    """Return the lines of a launch file that something is said of."""
    from plastron_tui.project.program_file import lines_of

    return None if path is None else lines_of(path)


def _differences(
    read: LaunchRead, source: bytes, file: Path, arguments: Mapping[str, str]
) -> tuple[Diagnostic, ...]:
    """Return how what is started differs from what the file's program said."""
    from plastron_tui.project.launch_comparison import differences

    if read.launch is None:
        return ()
    return differences(read.launch, source, file, read.format.ros_version, arguments)


def _stale(file: Path, ros_version: int) -> list[Diagnostic]:
    """Return a warning where the program that wrote a launch file would write another one by now.

    A program that is older than the file, or has mistakes, says nothing.
    """
    from plastron_tui import targets
    from plastron_tui.diagnostics import Severity, has_errors
    from plastron_tui.output.plan import FileState
    from plastron_tui.project.launch_comparison import author_of
    from plastron_tui.project.program_file import read_program
    from plastron_tui.session import Options, Session

    author = author_of(file)
    if author is None or author.program.stat().st_mtime_ns <= file.stat().st_mtime_ns:
        return []
    text = read_program(author.program).text
    if text is None:
        return []
    options = Options(output=author.output)
    session = Session(text, author.program, options)
    if ros_version == 2 and targets.ros_version(session.library) != ros_version:
        # The file is for the other ROS; of which client library its nodes are, it does not show.
        session = Session(text, author.program, options._replace(target="rclpy"))
    plan, problems = session.plan(has_copies=False)
    if has_errors((*session.diagnostics, *problems)):
        return []
    real = file.resolve()
    planned = next((each for each in plan.files if each.path.resolve() == real), None)
    if planned is None or planned.state is FileState.IDENTICAL:
        return []
    name = author.program.name
    message = f"`{name}` says otherwise by now than when it wrote `{file.name}`"
    remedy = f"write it again: `plastron generate {name}`"
    found = Diagnostic(codes.LAUNCH_DIFFERS, message, None, file, help=remedy)
    return [found._replace(severity=Severity.WARNING)]


def _wrong_usage(words: Sequence[str], others: Sequence[str]) -> str | None:
    for each in others:
        return f"{each} is for programs; a launch file says so itself"
    for word in words:
        if ":=" not in word[1:]:
            return f"{word!r} is no argument of a launch file; one is written like 'name:=value'"
    return None


def _pair(word: str) -> tuple[str, str]:
    name, _, value = word.partition(":=")
    return name, value
