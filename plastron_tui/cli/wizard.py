"""`plastron wizard [FILE]`: the studio, with the wizard in front."""

from __future__ import annotations

from pathlib import Path

import click

from plastron_tui.session import Options

from .common import output_option, target_option
from .studio import open_studio


@click.command(epilog="Example: plastron wizard robot.plastron")
@click.argument("file", required=False, type=click.Path(path_type=Path, dir_okay=False))
@output_option
@target_option
def command(file: Path | None, output: Path | None, target: str | None) -> None:
    """Build a program from menus, step by step.

    The wizard asks what a node is to do, and writes the statements: into FILE, which need not
    be there yet, or into a new program. The studio is behind it.
    """
    open_studio(file, Options(target, output), "wizard")
