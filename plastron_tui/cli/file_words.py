"""Files, and what they are given as `name:=value`, among the words of a command line."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import click

from plastron_tui.ros.robots.macros import Arguments

from .run_options import refuse

_IS = ":="

words_argument = click.argument(
    "words",
    nargs=-1,
    required=True,
    metavar="FILE...",
    # A text: a path would make one slash of the two in a URI.
    type=click.Path(path_type=str),
)


def files_and_arguments(
    words: Sequence[str], takes: Callable[[Path], bool]
) -> tuple[tuple[Path, ...], dict[str, str]]:
    """Tell `name:=value` from files, where a file among them takes such.

    Args:
        words: what is on the command line.
        takes: tells whether a file takes arguments.
    """
    files = tuple(Path(each) for each in words if _IS not in each)
    if not any(map(takes, files)):
        return tuple(map(Path, words)), {}
    given = (each.partition(_IS) for each in words if _IS in each)
    return files, {name: value for name, _, value in given}


def robot_arguments(given: Mapping[str, str]) -> Arguments:
    """Return what the macros of robots' files are given.

    Raises:
        click.UsageError: a name or a value is one that they cannot be given.
    """
    for name, value in given.items():
        refuse(_wrong(name, value))
    return tuple(given.items())


def _wrong(name: str, value: str) -> str | None:
    from plastron_tui.model.robot_arguments import argument_text
    from plastron_tui.ros.robots.names import NAME_RULE, is_name

    if not is_name(name):
        return f"{name!r} is no name of an argument: {NAME_RULE}"
    return None if argument_text(value) is not None else f"{value!r} is no text on one line"
