"""`plastron types`."""

from __future__ import annotations

from fnmatch import fnmatchcase

import click

from plastron_tui.model.types import TypeProblem, TypeResolver
from plastron_tui.ros.catalog import DISTRIBUTIONS, Catalog
from plastron_tui.ros.definition_text import format_definition
from plastron_tui.ros.interfaces import Interface, InterfaceKind
from plastron_tui.session import Options, Session
from plastron_tui.targets import LIBRARIES

from .common import target_option


@click.command(epilog="Example: plastron types Twist")
@click.argument("pattern", required=False, metavar="[PATTERN | TYPE]")
@target_option
@click.option(
    "--distribution",
    "-d",
    type=click.Choice(list(DISTRIBUTIONS)),
    help="The ROS distribution; without it, the sourced one, or the one of the project file.",
)
def command(pattern: str | None, target: str | None, distribution: str | None) -> None:
    """List interface types, or show one.

    A TYPE such as Twist or geometry_msgs/Twist is shown with its fields. A PATTERN is a part of
    a name, or has wildcards, as in 'sensor_msgs/*'. Without either all types are listed.
    """
    session = Session(options=Options(target=target))
    if distribution is not None:
        catalog = Catalog(distribution)
    else:
        catalog = session.catalog(LIBRARIES[session.library])
    shown = [] if pattern is None else _exact(catalog, pattern)
    if shown:
        click.echo("\n\n".join(_definition(found, catalog.ros_version) for found in shown))
        return
    listed = _matching(catalog, pattern)
    if not listed:
        click.echo(_nothing(catalog, pattern or ""), err=True)
        click.get_current_context().exit(1)
    for line in listed:
        click.echo(line)


def _exact(catalog: Catalog, text: str) -> list[Interface]:
    resolver = TypeResolver(catalog)
    found = (resolver.resolve(text, kind) for kind in InterfaceKind)
    return [interface for interface in found if isinstance(interface, Interface)]


def _matching(catalog: Catalog, pattern: str | None) -> list[str]:
    return [
        f"{name.package}/{kind.value}/{name.name}"
        for kind in InterfaceKind
        for name in catalog.names(kind)
        if pattern is None or _matches(str(name), pattern)
    ]


def _matches(name: str, pattern: str) -> bool:
    name, pattern = name.lower(), pattern.lower()
    return fnmatchcase(name, pattern) if set(pattern) & set("*?[") else pattern in name


def _definition(interface: Interface, ros_version: int) -> str:
    name = interface.name
    head = f"{name.package}/{interface.kind.value}/{name.name}"
    comment = f"\n# {interface.comment}" if interface.comment else ""
    return f"{head}{comment}\n{format_definition(interface, ros_version).rstrip()}"


def _nothing(catalog: Catalog, pattern: str) -> str:
    for kind in InterfaceKind:
        problem = TypeResolver(catalog).resolve(pattern, kind) if pattern else None
        if isinstance(problem, TypeProblem) and (problem.help or "").startswith("did you mean"):
            return f"no type matches '{pattern}' in {catalog.distribution}; {problem.help}"
    return f"no type matches '{pattern}' in {catalog.distribution}"
