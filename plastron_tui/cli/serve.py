"""`plastron serve`."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

import click


@click.command(epilog="Example: plastron serve talker.plastron --port 8000")
@click.argument("file", required=False, type=click.Path(path_type=Path, dir_okay=False))
@click.option("--host", default="127.0.0.1", show_default=True, help="The address to listen on.")
@click.option(
    "--port", default=8000, show_default=True, type=click.IntRange(1, 65535), help="The port."
)
def command(file: Path | None, host: str, port: int) -> None:
    """Show the studio in a browser.

    Whoever can reach the address can read and write files and run programs as you: leave it at
    this machine, and go there by an SSH tunnel.
    """
    try:
        from textual_serve.server import Server
    except ImportError:
        click.echo("error: the browser needs an extra; pip install 'plastron-tui[web]'", err=True)
        click.get_current_context().exit(2)
    words = [sys.executable, "-m", "plastron_tui.studio"]
    if file is not None:
        words.append(str(file.absolute()))
    if host not in ("127.0.0.1", "localhost", "::1"):
        click.echo(f"warning: {host} lets other machines in, to all your files", err=True)
    click.echo(f"the studio is at http://{host}:{port} - Ctrl-C ends it", err=True)
    Server(shlex.join(words), host=host, port=port, title="plastron").serve()
