"""`plastron graph`."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

import click

from plastron_tui.boundary import find_boundary
from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.graph import graph_of
from plastron_tui.model.robots import Robot
from plastron_tui.model.workspace import Workspace
from plastron_tui.output.graphs import FORMATS, render
from plastron_tui.project.run_setup import RunSetup, run_node
from plastron_tui.ros.launch_names import launch_language
from plastron_tui.ros.robots.macros import Arguments
from plastron_tui.ros.robots.names import FILE_ENDINGS
from plastron_tui.ros.run_names import Remap, RunNames
from plastron_tui.session import Options, Session
from plastron_tui.targets import ros_version

from .common import (
    Report,
    finish,
    format_option,
    open_sessions,
    print_text,
    read_input,
    shown_path,
    target_option,
)
from .file_words import files_and_arguments, robot_arguments, words_argument
from .run_options import namespace_option, refuse, remap_option, unknown_nodes

_MOST_NAMES = 12
_DRAWN = ("svg",)
"""The formats that show how large things are."""


@click.command(epilog="Example: plastron graph --format svg robot.plastron > robot.svg")
@words_argument
@remap_option
@namespace_option
@target_option
@click.option(
    "--launch",
    metavar="FILE",
    help="Of a folder, the nodes of one launch file alone, such as bringup.launch.py.",
)
@format_option(*FORMATS)
def command(
    words: tuple[str, ...],
    remaps: tuple[Remap, ...],
    namespace: str | None,
    target: str | None,
    launch: str | None,
    format_: str,
) -> None:
    """Show the nodes of programs, what joins them, and robots.

    Several programs give one graph. Of a program with mistakes, what is right is shown. With names
    as `plastron run` takes them, it is the graph of such a run.

    Of a launch file it is what that starts; behind it stand its arguments, as NAME:=VALUE.

    Of folders it is the workspace in them: the nodes of its packages, with the names that its
    launch files give them.

    Robots are shown below the nodes, those of programs and those of files: FILE.urdf, FILE.xacro.
    Behind a FILE.xacro stand its arguments, as NAME:=VALUE.
    """
    report = Report()
    files, arguments = files_and_arguments(words, _takes_arguments)
    folders = tuple(filter(_is_folder, files))
    if folders:
        others = [each for each in files if each not in folders]
        refuse(_wrong_with_folders(others, remaps, namespace))
        _show_folders(folders, launch, format_, report)
        finish(report)
        return
    refuse(None if launch is None else "--launch is for folders; a launch file is shown by itself")
    launches = [each for each in files if launch_language(each.name)]
    if launches:
        programs = tuple(each for each in files if each not in launches)
        refuse(_wrong_with_launch_files(programs, remaps, namespace))
        _show_launch_files(launches, arguments, format_, report)
        finish(report)
        return
    robots = [each for each in files if each.suffix in FILE_ENDINGS]
    programs = tuple(each for each in files if each not in robots)
    if not programs:
        refuse(_names_without_programs(remaps, namespace, "a robot has none of these names"))
    sessions = open_sessions(programs, report, Options(target=target)) if programs else []
    names = RunNames(namespace, remaps)
    is_drawn = format_ in _DRAWN
    shown = robots_of(robots, report, robot_arguments(arguments), is_drawn=is_drawn)
    for session in sessions if is_drawn else ():
        for robot in session.workspace.robots.values():
            session.robots.measure(robot)
    if sessions or shown:
        diagnostics = _check(sessions, names)
        whole = joined(sessions)
        for robot in shown:
            add_robot(whole, robot)
        print_text(render(graph_of(whole, names), format_))
        report.add(diagnostics, lambda _: None)
    for session in sessions:
        report.add(session.diagnostics, session.lines, session.path)
    finish(report)


def _wrong_with_folders(
    others: list[Path], remaps: tuple[Remap, ...], namespace: str | None
) -> str | None:
    for each in others:
        return f"a workspace is shown without other files, such as `{each}`"
    return _names_without_programs(remaps, namespace, "a workspace has its launch files")


def _show_folders(
    folders: tuple[Path, ...], launch: str | None, format_: str, report: Report
) -> None:
    from plastron_tui.project.linting.drawing import drawn
    from plastron_tui.project.linting.run import LintOptions, LintRun

    from .lint_programs import read_program

    run = LintRun(LintOptions(folders, read_program=read_program))
    launches = [each.path for each in run.tree.launches]
    named = [each for each in launches if launch and f"/{each}".endswith(f"/{launch}")]
    refuse(None if launch is None else _wrong_launch(launch, named or launches, len(named)))
    print_text(render(graph_of(drawn(run.tree, *named)), format_))
    report.add(run.diagnostics, run.lines)


def _wrong_launch(name: str, files: Sequence[Path], count: int) -> str | None:
    """Return why a name is not that of one launch file."""
    if count == 1:
        return None
    shown = ", ".join(f"`{shown_path(each)}`" for each in files[:_MOST_NAMES])
    more = ", …" if len(files) > _MOST_NAMES else ""
    said = f"`{name}` may be several launch files" if count else f"no launch file is `{name}`"
    return f"{said}; there are {shown}{more}" if files else f"{said}, nor any other"


def _is_folder(file: Path) -> bool:
    """Tell whether a folder is named, and not one in the place of a file."""
    return file.is_dir() and not (_takes_arguments(file) or file.suffix == ".plastron")


def _takes_arguments(file: Path) -> bool:
    return launch_language(file.name) is not None or file.suffix in FILE_ENDINGS


def _wrong_with_launch_files(
    programs: tuple[Path, ...], remaps: tuple[Remap, ...], namespace: str | None
) -> str | None:
    named = "a launch file says itself which names nodes get"
    refused = _names_without_programs(remaps, namespace, named)
    if refused is not None:
        return refused
    for each in programs:
        return f"launch files are shown without programs, such as `{each}`"
    return None


def _names_without_programs(
    remaps: tuple[Remap, ...], namespace: str | None, why: str
) -> str | None:
    for option, value in (("--remap", remaps), ("--namespace", namespace)):
        if value:
            return f"{option} is for programs; {why}"
    return None


def _show_launch_files(
    files: list[Path], arguments: dict[str, str], format_: str, report: Report
) -> None:
    from plastron_tui.project.launch_graph import launch_graph
    from plastron_tui.project.program_file import lines_of

    for file in files:
        found = launch_graph(file, arguments, find_boundary(file.absolute().parent))
        if found.workspace is not None:
            print_text(render(graph_of(found.workspace), format_))
        report.add(found.diagnostics, lambda path: None if path is None else lines_of(path))


def robots_of(
    files: Iterable[Path], report: Report, given: Arguments = (), *, is_drawn: bool = False
) -> list[Robot]:
    """Read the robots of files, whose arguments are given; what is drawn has to be measured."""
    from .robot_input import read_robot

    robots = []
    for file in files:
        text = read_input(file, report)
        if text is None:
            continue
        read = read_robot(file, text, given, is_drawn=is_drawn)
        report.add(read.diagnostics, read.lines, file)
        if read.robot is not None:
            robots.append(read.robot)
    return robots


def add_robot(whole: Workspace, robot: Robot, origin: Workspace | None = None) -> None:
    """Put a robot among those of a workspace, under a variable of its own.

    Args:
        whole: the workspace.
        robot: the robot.
        origin: what knows whether it is written, None where it is not.
    """
    name, count = robot.variable, 1
    while name in whole.robots:
        count += 1
        name = f"{robot.variable}_{count}"
    whole.robots[name] = replace(robot, variable=name)
    for made in () if origin is None else origin.written_robots:
        if made.robot.variable == robot.variable:
            whole.written_robots.append(made._replace(robot=whole.robots[name]))


def _check(sessions: Iterable[Session], names: RunNames) -> list[Diagnostic]:
    """Return what is wrong with names, or doubtful; wrong ones end the command."""
    nodes = [
        run_node(node, ros_version(node.library or session.library), node.source)
        for session in sessions
        for node in session.workspace.nodes.values()
    ]
    setup = RunSetup(names)
    refuse(setup.wrong_option(nodes))
    known = {word for node in nodes for word in (node.name, node.variable)}
    return [*unknown_nodes(setup.nodes, known, "has"), *setup.unmet(nodes)]


def joined(sessions: Iterable[Session]) -> Workspace:
    """Return the nodes and robots of several programs as one workspace.

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
        for robot in session.workspace.robots.values():
            add_robot(whole, robot, session.workspace)
    return whole


def _other(session: Session, variable: str, whole: Workspace) -> str:
    stem = "input" if session.path is None else session.path.stem
    name, count = f"{stem}.{variable}", 1
    while name in whole.nodes:
        count += 1
        name = f"{stem}.{variable}_{count}"
    return name
