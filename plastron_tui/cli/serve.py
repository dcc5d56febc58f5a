"""`plastron serve`."""

from __future__ import annotations

import errno
import socket
from pathlib import Path

import click

from plastron_tui import import_path
from plastron_tui.diagnostics.terminal import visible


@click.command(epilog="Example: plastron serve talker.plastron --port 8000")
@click.argument("file", required=False, type=click.Path(path_type=Path, dir_okay=False))
@click.option("--host", default="127.0.0.1", show_default=True, help="The address to listen on.")
@click.option(
    "--port", default=8000, show_default=True, type=click.IntRange(1, 65535), help="The port."
)
def command(file: Path | None, host: str, port: int) -> None:
    """Show the studio in a browser.

    The URL that is printed has a token in it: whoever has it can read and write files and run
    programs as you. Leave it at this machine, and go there by an SSH tunnel.
    """
    try:
        from plastron_tui.web.server import StudioServer
    except ImportError:
        click.echo("error: the browser needs an extra; pip install 'plastron-tui[web]'", err=True)
        click.get_current_context().exit(2)
    words = import_path.command("plastron_tui.studio.app:run_served")
    if file is not None:
        words.append(str(file.absolute()))
    server = StudioServer(words, host, port)
    try:
        server.run(lambda: _tell(host, port, server.access.token))
    except UnicodeError:  # of a name with an empty part, or one too long for the Internet
        _refuse(f"{visible(host)} is no name of a machine")
    except OSError as error:
        if error.errno != errno.EADDRINUSE:
            raise
        _refuse(f"port {port} of {visible(host)} is in use; choose another with --port")


def _refuse(reason: str) -> None:
    click.echo(f"error: {reason}", err=True)
    click.get_current_context().exit(2)


def _tell(host: str, port: int, token: str) -> None:
    """Say where the studio is, and who can reach it."""
    from plastron_tui.web.access import is_any_address, is_loopback, url

    if not is_loopback(host):
        click.echo(
            f"warning: {visible(host)} lets other machines in; who sees the URL, or what travels"
            " on the network, has all your files",
            err=True,
        )
    if is_any_address(host):
        click.echo(
            f"other machines find it at\n  {url(socket.gethostname(), port, token)}", err=True
        )
        host = "127.0.0.1"
    # On a line of its own, a URL is whole in a terminal of 80 columns, to be clicked or copied.
    click.echo(f"the studio is at\n  {visible(url(host, port, token))}\nCtrl-C ends it", err=True)
