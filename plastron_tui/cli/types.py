"""`plastron types`."""

from __future__ import annotations

from fnmatch import fnmatchcase

import click

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.libraries import default_library
from plastron_tui.model.types import TypeProblem, TypeResolver
from plastron_tui.project.ros_choice import RosChoice
from plastron_tui.ros.catalog import DISTRIBUTIONS, Catalog
from plastron_tui.ros.definition_text import format_definition
from plastron_tui.ros.interfaces import Interface, InterfaceKind
from plastron_tui.ros.search import search_types
from plastron_tui.session import Options, Session
from plastron_tui.targets import LIBRARIES

from .common import Report, finish, print_text, target_option

_WILDCARDS = frozenset("*?[")


@click.command(epilog="Example: plastron types Twist")
@click.argument("pattern", required=False, metavar="[PATTERN | TYPE]")
@target_option
@click.option(
    "--distribution",
    "-d",
    type=click.Choice(list(DISTRIBUTIONS)),
    help="The ROS distribution; without it, that of the project file, or the sourced one.",
)
def command(pattern: str | None, target: str | None, distribution: str | None) -> None:
    """List interface types, or show one.

    A TYPE such as Twist or geometry_msgs/Twist is shown with its fields. A PATTERN is a part of
    a name, or has wildcards, as in 'sensor_msgs/*'; or it says what a type is to be for, as in
    distance or 'on/off'. Without either all types are listed.
    """
    report = Report()
    session = Session(options=Options(target=target, distribution=distribution))
    report.add(session.project_problems, session.lines)
    catalog = session.catalog(DISTRIBUTIONS.get(distribution or "", session.ros.ros_version))
    shown = [] if pattern is None else _exact(catalog, pattern)
    listed = [] if shown else _matching(catalog, pattern) or _for_purpose(catalog, pattern or "")
    if shown:
        _say_ros(session.ros, distribution)
        print_text("\n\n".join(_definition(found, catalog.ros_version) for found in shown))
    elif listed:
        _say_ros(session.ros, distribution)
        print_text("\n".join(listed))
    else:
        report.status = max(report.status, 1)
        click.echo(visible(_nothing(catalog, pattern or "")), err=True)
    report.add(catalog.problems, session.lines)
    finish(report)


def _exact(catalog: Catalog, text: str) -> list[Interface]:
    resolver = TypeResolver(catalog)
    found = (resolver.resolve(text, kind) for kind in InterfaceKind)
    return [interface for interface in found if isinstance(interface, Interface)]


def _matching(catalog: Catalog, pattern: str | None) -> list[str]:
    return [
        f"{name.package}/{kind.value}/{name.name}"
        for kind in InterfaceKind
        for name in catalog.names(kind)
        if pattern is None or _matches(str(name), pattern) or _matches(name.name, pattern)
    ]


def _for_purpose(catalog: Catalog, words: str) -> list[str]:
    """List what types are for, those that words of purpose lead to."""
    if set(words) & _WILDCARDS:
        return []
    found = [
        (f"{each.package}/{kind.value}/{each.name.name}", each.line)
        for kind in InterfaceKind
        for each in search_types(catalog, kind, words, is_lenient=False)
    ]
    width = max((len(name) for name, _ in found), default=0)
    return [f"{name:{width}}  {line}" for name, line in found]


def _matches(name: str, pattern: str) -> bool:
    name, pattern = name.lower(), pattern.lower()
    return fnmatchcase(name, pattern) if set(pattern) & _WILDCARDS else pattern in name


def _definition(interface: Interface, ros_version: int) -> str:
    name = interface.name
    head = f"{name.package}/{interface.kind.value}/{name.name}"
    return f"{head}\n{format_definition(interface, ros_version).rstrip()}"


def _say_ros(ros: RosChoice, named: str | None) -> None:
    """Say which distribution's types are shown and why, unless it was named; and how to choose."""
    if named is not None:
        return
    other = 3 - ros.ros_version
    remedy = f"; `--target {default_library(LIBRARIES, other)}` shows those of ROS {other}"
    click.echo(f"types of {ros.name}: {ros.why.value}{'' if ros.is_chosen else remedy}", err=True)


def _nothing(catalog: Catalog, pattern: str) -> str:
    for kind in InterfaceKind:
        problem = TypeResolver(catalog).resolve(pattern, kind) if pattern else None
        if isinstance(problem, TypeProblem) and (problem.help or "").startswith("did you mean"):
            remedy = (problem.help or "").replace("`", "'")
            return f"no type matches '{pattern}' in {catalog.distribution}; {remedy}"
    return f"no type matches '{pattern}' in {catalog.distribution}"
