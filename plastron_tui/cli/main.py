"""The group of all commands; each is imported when it is first used."""

from __future__ import annotations

import gc
import os
import sys
from importlib import import_module

import click

from plastron_tui import __version__

INTERRUPTED = 130

_COMMANDS = {
    "check": "Say what is wrong with programs.",
    "completion": "Print the completion script of a shell.",
    "describe": "Print the ROS graph that is running as a program.",
    "fmt": "Lay programs out.",
    "generate": "Write the nodes of programs.",
    "graph": "Show nodes, topics and services.",
    "inspect": "Show what node files hold.",
    "run": "Start the nodes of a program.",
    "shell": "Take one statement at a time.",
    "types": "List interface types, or show one.",
}


class LazyGroup(click.Group):
    """A group that knows its commands' names and lines without importing them."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the commands."""
        return sorted(_COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import a command; None when there is none of that name."""
        if cmd_name not in _COMMANDS:
            return None
        # Modules live as long as the process: the collector has nothing to find among them.
        gc.disable()
        module = import_module(f"plastron_tui.cli.{cmd_name}")
        gc.freeze()
        gc.enable()
        command: click.Command = module.command
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command of an argument list, and offer the nearest where there is none."""
        name = args[0]
        if name not in _COMMANDS and not name.startswith("-"):
            from plastron_tui.diagnostics import did_you_mean

            hint = did_you_mean(name, _COMMANDS)
            ctx.fail(f"no command '{name}'" + (f"; {hint.replace('`', chr(39))}" if hint else ""))
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(sorted(_COMMANDS.items()))


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="Example: plastron generate talker.plastron",
)
@click.version_option(__version__, prog_name="plastron")
def cli() -> None:
    """Plastron: ROS nodes, described in sentences."""


def main() -> None:
    """Run the command line, and exit with its status.

    0: done; 1: a program or a file has errors; 2: wrong usage, or a file that cannot be read or
    written; 130: interrupted.
    """
    try:
        status = cli.main(prog_name="plastron", standalone_mode=False)
        sys.stdout.flush()
    except click.exceptions.Abort:
        status = INTERRUPTED
    except KeyboardInterrupt:
        status = INTERRUPTED
    except click.ClickException as error:
        error.show()
        status = error.exit_code
    except BrokenPipeError:
        # The reader has gone, as in `plastron types | head`; Python would complain at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = 0
    sys.exit(status if isinstance(status, int) else 0)
