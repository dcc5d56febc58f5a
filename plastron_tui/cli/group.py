"""The group of all commands; each is imported when it is first used."""

from __future__ import annotations

import os
import sys
from importlib import import_module
from typing import TYPE_CHECKING

import click

from plastron_tui import __version__

from .streams import discard, has_terminal

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

_COMMANDS = {
    "check": "Say what is wrong with programs.",
    "completion": "Print the completion script of a shell.",
    "describe": "Print the ROS graph that is running as a program.",
    "fmt": "Lay programs out.",
    "generate": "Write the nodes and robots of programs.",
    "graph": "Show nodes, topics, services and robots.",
    "lint": "Say what is wrong between the nodes of a workspace.",
    "inspect": "Show what files of nodes and robots hold.",
    "run": "Start the nodes of a program.",
    "serve": "Show the studio in a browser.",
    "shell": "Take one statement at a time.",
    "trust": "Trust a folder that somebody else made.",
    "types": "List interface types, or show one.",
    "wizard": "Build a program from menus, step by step.",
}

_STUDIO = "studio"
"""The command that a file's name, or nothing at all, stands for."""


class LazyGroup(click.Group):
    """A group that knows its commands' names and lines without importing them."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Open the studio where nothing is said in a terminal."""
        if not args and not ctx.resilient_parsing and has_terminal():
            args = [_STUDIO]
        try:
            return super().parse_args(ctx, args)
        except BrokenPipeError:
            # Of the help: click would make it an error.
            discard(sys.stdout)
            ctx.exit(0)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the commands."""
        return sorted(_COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import a command; None when there is none of that name."""
        if cmd_name not in _COMMANDS and cmd_name != _STUDIO:
            return None
        module = import_module(f"plastron_tui.cli.{cmd_name}")
        command: click.Command = module.command
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command of an argument list, and offer the nearest where there is none."""
        name = args[0]
        if _is_program(name):
            args = [_STUDIO, *args]
        elif name not in _COMMANDS and name != _STUDIO and not name.startswith("-"):
            ctx.fail(f"no command '{name}'{_hint(name)}")
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> object:
        """Run the command; that the reader of its result has gone (`| head`) is no error."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            discard(sys.stdout)
            return 0

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(sorted(_COMMANDS.items()))

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Complete the names of the commands without importing them."""
        from click.shell_completion import CompletionItem

        found = [
            CompletionItem(name, help=line)
            for name, line in sorted(_COMMANDS.items())
            if name.startswith(incomplete)
        ]
        return found + click.Command.shell_complete(self, ctx, incomplete)


def _is_program(name: str) -> bool:
    """Tell whether an argument in the place of a command is a program to open."""
    if name in _COMMANDS or name.startswith("-"):
        return False
    return name.endswith(".plastron") or os.path.isfile(name)  # noqa: PTH113 - a name with NUL


def _hint(name: str) -> str:
    from plastron_tui.diagnostics import did_you_mean

    hint = did_you_mean(name, _COMMANDS)
    if hint is None:
        return ", and no program: that is a file, or a name that ends in '.plastron'"
    return f"; {hint.replace('`', chr(39))}"


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    subcommand_metavar="[FILE | COMMAND [ARGS]...]",
    epilog="Examples: plastron talker.plastron    plastron generate talker.plastron",
)
@click.version_option(__version__, prog_name="plastron")
def cli() -> None:
    """Plastron: ROS nodes, described in sentences.

    With a FILE, or alone in a terminal, it opens the studio, to write programs.
    """
