"""`plastron [FILE]`: the studio."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from plastron_tui.session import Options

from .common import output_option, shown_path, target_option
from .streams import has_terminal


@click.command(
    name="plastron",
    epilog="Without a file it opens with a welcome. All else is a command: see plastron --help.",
)
@click.argument("files", nargs=-1, type=click.Path(path_type=Path, dir_okay=False))
@output_option
@target_option
def command(files: tuple[Path, ...], output: Path | None, target: str | None) -> None:
    """Open the studio, with programs to write or to change, each in a tab."""
    open_studio(files[0] if files else None, Options(target, output), others=files[1:])


def open_studio(
    file: Path | None,
    options: Options,
    first: str | None = None,
    others: Sequence[Path] = (),
) -> None:
    """Open the studio in this terminal, and exit with its status where that is not 0.

    Args:
        file: the program; None for a new one.
        options: what the command line sets.
        first: what is done first, as the name of an action of the main screen.
        others: more programs, each for a tab of its own.
    """
    context = click.get_current_context()
    if not has_terminal():
        name = "FILE" if file is None else shown_path(file)
        click.echo(
            f"error: the studio needs a terminal; without one: plastron check {name}", err=True
        )
        context.exit(2)
    from plastron_tui.studio.app import run

    status = run(file, options, first, others)
    if status:
        context.exit(status)
