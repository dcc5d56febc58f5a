"""`plastron run`."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from plastron_tui.diagnostics import Diagnostic, codes, has_errors
from plastron_tui.diagnostics.terminal import drawn_on, visible
from plastron_tui.session import Options, Session

from .common import (
    Report,
    finish,
    open_session,
    output_option,
    program_argument,
    target_option,
)
from .run_options import namespace_option, refuse, remap_option, set_option, unknown_nodes

if TYPE_CHECKING:
    from plastron_tui.generating.generation import Generated
    from plastron_tui.model.workspace import Node
    from plastron_tui.project.run_setup import RunSetup
    from plastron_tui.ros.parameter_values import Assignment
    from plastron_tui.ros.run_names import Remap
    from plastron_tui.runtime.build_progress import ProgressLine
    from plastron_tui.runtime.environment import Environment, Found
    from plastron_tui.runtime.launch import NodeFile


def _time(context: click.Context, option: click.Parameter, seconds: float | None) -> float | None:
    # A range takes it: it is neither too small nor too large.
    if seconds is not None and math.isnan(seconds):
        raise click.BadParameter("nan is no time.", context, option)
    return seconds


@click.command(epilog="Example: plastron run talker_listener.plastron --for 10")
@program_argument
@click.argument("nodes", nargs=-1, metavar="[NODE]...")
@output_option
@target_option
@click.option(
    "--for",
    "seconds",
    type=click.FloatRange(min=0, min_open=True),
    callback=_time,
    metavar="SECONDS",
    help="Stop the nodes after so long.",
)
@remap_option
@namespace_option
@set_option
@click.option("--watch", is_flag=True, help="Show a live table of topics and service calls.")
@click.option("--network", is_flag=True, help="Let the nodes speak to other machines too.")
@click.option("--announce", type=click.IntRange(min=3), hidden=True)
def command(
    file: Path,
    nodes: tuple[str, ...],
    output: Path | None,
    target: str | None,
    seconds: float | None,
    remaps: tuple[Remap, ...],
    namespace: str | None,
    settings: tuple[Assignment, ...],
    watch: bool,
    network: bool,
    announce: int | None,
) -> None:
    """Write the nodes of a program and start them, all or those that are named.

    Where a launch file of the program is named, or is all that it has to start, the program is
    written, and what that says is started.

    The nodes run with a ROS of their client library's: a sourced one, else the Python packages of
    the extra `ros2`, or Debian's ROS 1, for which a master is started where none answers. Those
    that have to be compiled are built first, in the user's cache. Ctrl-C stops everything. Exits
    with 1 when a node fails.

    A launch file is started as it is. Behind one stand its arguments, as NAME:=VALUE.
    """
    from plastron_tui.project.run_setup import RunSetup
    from plastron_tui.ros.run_names import RunNames
    from plastron_tui.runtime.environment import find_environments
    from plastron_tui.runtime.launch import Options as RunOptions
    from plastron_tui.runtime.launch import run_nodes
    from plastron_tui.sources.launch.reader import is_launch_file

    from .run_launch import find_launch, run_launch, run_launch_of

    # The studio asks for it, which monitors the nodes.
    options = RunOptions(seconds, network, watch, announce)
    given: dict[str, object] = {"--namespace": namespace, "--remap": remaps, "--set": settings}
    if is_launch_file(file):
        given |= {"--output": output, "--target": target}
        run_launch(file, nodes, options, [name for name, value in given.items() if value])
        return
    report = Report()
    session = open_session(file, report, Options(target, output, is_writing=True))
    if session is None:
        finish(report)
        return
    launch = find_launch(session, nodes)
    if launch is not None:
        refused = [name for name, value in given.items() if value]
        run_launch_of(session, launch, nodes, options, refused, report)
        return
    found = find_environments()
    setup = RunSetup(RunNames(namespace, remaps), settings)
    files = _prepare(session, nodes, setup, found, report)
    if not report.status and files:
        # The table is drawn over itself; what nodes print is escaped before it comes there.
        result = run_nodes(files, options, out=drawn_on(sys.stdout), err=drawn_on(sys.stderr))
        report.add(result.diagnostics, lambda _: None, session.path)
        report.status = max(report.status, result.status)
    finish(report)


def _prepare(
    session: Session, names: Sequence[str], setup: RunSetup, found: Found, report: Report
) -> list[NodeFile]:
    """Generate the nodes and find a ROS for each; what fails is reported."""
    from .generate import Planned, show_plan, write_plan
    from .run_built import built_files, is_built_with

    report.add(session.diagnostics, session.lines, session.path)
    if report.status:
        return []
    made = session.generated()
    chosen = [generated for generated in made if _is_chosen(generated, names)]
    launches = _launch_names(session)
    unknown = _unknown_names(session, made, (*names, *setup.nodes), launches)
    if not unknown:
        setup = _checked(session, setup, chosen, report)
    written = [each for each in made if each in chosen or is_built_with(each, chosen)]
    plan, diagnostics = session.plan_of(written)
    report.add((*unknown, *diagnostics), session.lines, session.path)
    if has_errors(diagnostics) or unknown:
        return []
    environments = _environments(session, chosen, found, report)
    nodes = _node_files(chosen, environments, setup, session, report)
    if report.status:
        return []
    for library, environment in environments.items():
        _tell(f"running {library} nodes on {environment.words}")
    show_plan(plan, only_changes=True)
    if not names:
        _hint(session)

    def again() -> Planned:
        made = session.generated()
        chosen = [each for each in made if _is_chosen(each, names)]
        return session.plan_of(
            [each for each in made if each in chosen or is_built_with(each, chosen)]
        )

    if not write_plan(plan, session, report, again=again):
        return []
    built, problems = built_files(session, chosen, environments, setup)
    report.add(problems, session.lines, session.path)
    return [] if report.status else [*built, *nodes]


def _launch_names(session: Session) -> list[str]:
    """Return what the program's launch files are called, those of robots in packages too."""
    workspace = session.workspace
    names = [each.name for each in workspace.launches.values()]
    return names + [each.stem for each in workspace.robots.values() if each.home]


def _hint(session: Session) -> None:
    """Say how a launch file of the program is started: nodes alone do not need it."""
    names = _launch_names(session)
    if names and session.path is not None:
        _tell(f"`plastron run {session.path.name} {names[0]}` starts the launch file")


def _is_chosen(generated: Generated, names: Sequence[str]) -> bool:
    node = generated.generation.node
    return not names or node.name in names or node.variable in names


def _unknown_names(
    session: Session, made: Sequence[Generated], names: Sequence[str], launches: Sequence[str]
) -> list[Diagnostic]:
    known = {
        name
        for generated in made
        for name in (generated.generation.node.name, generated.generation.node.variable)
    }
    if not made:
        from plastron_tui.generating.nothing import help_to_generate

        message = "the program generates no node, so there is nothing to run"
        if launches:
            help_ = f"`{launches[0]}` starts its launch file: name it"
        else:
            help_ = help_to_generate(session.workspace)
        return [Diagnostic(codes.NOTHING_TO_GENERATE, message, help=help_)]
    return unknown_nodes(dict.fromkeys(names), known, "generates", launches)


def _checked(
    session: Session, setup: RunSetup, chosen: Sequence[Generated], report: Report
) -> RunSetup:
    """Return the setup with what the program's parameter file says; what is wrong is reported."""
    from plastron_tui.project.run_setup import generated_node

    params, diagnostics = session.params()
    setup = setup._replace(params=params)
    nodes = [generated_node(generated, session.output) for generated in chosen]
    refuse(setup.wrong_option(nodes))
    report.add((*diagnostics, *setup.problems(nodes, session.params_path)), session.lines)
    return setup


_WHY_BUILT = (
    "types that are not installed with this ROS are built first: it takes a minute or so, once"
)


def _environments(
    session: Session, chosen: Sequence[Generated], found: Found, report: Report
) -> dict[str, Environment]:
    """Return the environment of each client library that is in use; packages are built for it."""
    from plastron_tui.runtime.build_progress import ProgressLine
    from plastron_tui.targets import LIBRARIES, ros_version

    environments = {}
    for library in dict.fromkeys(generated.generation.library for generated in chosen):
        environment, diagnostics = found.choose(ros_version(library))
        if environment is not None and LIBRARIES[library].is_built:
            # What they need is built with them, once their files are written.
            environments[library] = environment
        elif environment is not None:
            nodes = [each.generation.node for each in chosen if each.generation.library == library]
            with ProgressLine(drawn_on(sys.stderr), _WHY_BUILT) as line:
                environments[library], missing = _complete(session, nodes, environment, line)
            diagnostics += missing
        report.add(diagnostics, session.lines, session.path)
    return environments


def _complete(
    session: Session, nodes: Sequence[Node], environment: Environment, line: ProgressLine
) -> tuple[Environment, list[Diagnostic]]:
    """Return an environment with what the nodes' types are of, and why something is not there."""
    from plastron_tui.generating.loaded_types import types_of_run
    from plastron_tui.ros.interfaces import InterfaceName
    from plastron_tui.runtime.builds import overlay
    from plastron_tui.runtime.interface_packages import complete

    from .run_built import own_packages

    version = environment.ros_version
    own, refused = own_packages(session, nodes, version)
    if refused:
        return environment, refused
    named = {package.name for package in own}
    needed = {
        InterfaceName(field.type.package, field.type.name)
        for type_ in types_of_run(session.workspace, version)
        if (definition := type_.definitions.get(version)) is not None
        and definition.interface.name.package in named
        for section in definition.interface.sections
        for field in section.fields
        if field.type.package is not None
    }
    types = {type_ for node in nodes for type_ in node.types} | needed
    foreign = [type_ for type_ in types if type_.package not in named]
    definitions = session.catalog(version).table_package
    environment, missing = complete(environment, foreign, definitions, line.tell)
    if missing:
        return environment, missing
    return overlay(environment, own, line.tell)


def _tell(line: str) -> None:
    click.echo(visible(line), err=True)


def _node_files(
    chosen: Sequence[Generated],
    environments: dict[str, Environment],
    setup: RunSetup,
    session: Session,
    report: Report,
) -> list[NodeFile]:
    """Return what starts each node; one that cannot be started is reported."""
    from plastron_tui.runtime.launch import NodeFile
    from plastron_tui.targets import find_target

    files = {}
    together: dict[Path, list[Node]] = {}
    for generated in chosen:
        target = find_target(generated.generation.library)
        environment = environments.get(generated.generation.library)
        path = generated.path(session.output)
        if path is None or target is None or environment is None or target.language.is_built:
            continue
        command = target.language.command(path, environment.python)
        if command is None:
            message = f"`run` cannot start {target.language.title} nodes, such as `{path.name}`"
            found = Diagnostic(codes.UNSUPPORTED_TARGET, message, generated.generation.span)
            report.add([found], session.lines, session.path)
            continue
        script = path if target.language.is_script else None
        node = generated.generation.node
        nodes = together.setdefault(path, [])
        nodes.append(node)
        arguments = setup.arguments(environment.ros_version, nodes)
        names = setup.names
        files[path] = NodeFile(
            node.name,
            command,
            environment,
            script,
            arguments,
            names.namespace or "",
            tuple(names.full_node(each.name) for each in nodes if each.is_managed),
        )
    return list(files.values())
