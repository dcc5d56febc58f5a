"""`plastron completion`."""

from __future__ import annotations

import click
from click.shell_completion import get_completion_class

from .group import cli


@click.command(epilog='Example: eval "$(plastron completion bash)"')
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
def command(shell: str) -> None:
    """Print the script that makes a shell complete commands, options and file names."""
    found = get_completion_class(shell)
    assert found is not None  # click has a class for each of the choices
    click.echo(found(cli, {}, "plastron", "_PLASTRON_COMPLETE").source())
