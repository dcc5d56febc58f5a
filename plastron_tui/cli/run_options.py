"""The options that say which names and parameters nodes run with."""

from __future__ import annotations

from collections.abc import Iterable

import click

from plastron_tui.diagnostics import Diagnostic, codes, did_you_mean
from plastron_tui.ros.parameter_values import Assignment, Mistake, parse_assignment
from plastron_tui.ros.run_names import REMAP_FORM, Remap, parse_namespace, parse_remap


def _remaps(
    context: click.Context, option: click.Parameter, texts: tuple[str, ...]
) -> tuple[Remap, ...]:
    found = []
    for text in texts:
        remap = parse_remap(text)
        if isinstance(remap, str):
            raise click.BadParameter(f"{text!r}: {remap}.", context, option)
        found.append(remap)
    return tuple(found)


def _namespace(context: click.Context, option: click.Parameter, text: str | None) -> str | None:
    if text is None:
        return None
    namespace = parse_namespace(text)
    if namespace is None:
        message = f"{text!r} is no namespace; one is written like '/robot1'."
        raise click.BadParameter(message, context, option)
    return namespace


def _settings(
    context: click.Context, option: click.Parameter, texts: tuple[str, ...]
) -> tuple[Assignment, ...]:
    found = []
    for text in texts:
        setting = parse_assignment(text)
        if isinstance(setting, Mistake):
            remedy = "" if setting.help is None else f"; {setting.help}"
            raise click.BadParameter(f"{text!r}: {setting.message}{remedy}.", context, option)
        found.append(setting)
    return tuple(found)


remap_option = click.option(
    "--remap",
    "remaps",
    multiple=True,
    callback=_remaps,
    metavar=REMAP_FORM,
    help="Give a topic or service another name; NODE:FROM:=TO for one node.",
)
namespace_option = click.option(
    "--namespace",
    callback=_namespace,
    metavar="NAMESPACE",
    help="The namespace of the nodes, such as /robot1.",
)
set_option = click.option(
    "--set",
    "settings",
    multiple=True,
    callback=_settings,
    metavar="NODE.NAME=VALUE",
    help="Set a parameter; the value is written as in YAML.",
)


def unknown_nodes(
    names: Iterable[str], known: Iterable[str], verb: str, others: Iterable[str] = ()
) -> list[Diagnostic]:
    """Return a diagnostic for each name that is no node's.

    Args:
        names: the names.
        known: those of nodes.
        verb: what a program does with a node.
        others: what may be meant besides.
    """
    there = set(known)
    return [
        Diagnostic(
            codes.UNKNOWN_NODE,
            f"the program {verb} no node `{name}`",
            help=did_you_mean(name, (*there, *others)),
        )
        for name in names
        if name not in there
    ]


def refuse(problem: str | None) -> None:
    """End the command as one of wrong usage where there is a problem."""
    if problem is not None:
        raise click.UsageError(f"{problem}.", click.get_current_context())
