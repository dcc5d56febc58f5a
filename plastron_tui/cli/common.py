"""What the commands share: their arguments, and how they report."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from plastron_tui.diagnostics import Diagnostic, Severity, codes, counted
from plastron_tui.project.other_files import other_file
from plastron_tui.project.program_file import (
    LARGEST_PROGRAM,
    ProgramText,
    check_text,
    read_program,
)
from plastron_tui.session import Options, Session
from plastron_tui.targets import LIBRARIES

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from plastron_tui.diagnostics.render import Lines

STANDARD_INPUT = "-"

_PATH = click.Path(path_type=Path, allow_dash=True)


programs_argument = click.argument("files", nargs=-1, required=True, metavar="FILE...", type=_PATH)
program_argument = click.argument("file", metavar="FILE", type=_PATH)


class _ClientLibrary(click.types.StringParamType):
    """The name of a client library; those of other distributions are looked up when they matter."""

    name = "client library"

    def get_metavar(self, param: click.Parameter, ctx: click.Context | None = None) -> str:
        """Return the names that there are."""
        return f"[{'|'.join(LIBRARIES)}]"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Refuse a name that nobody registered."""
        if value not in LIBRARIES:
            listed = ", ".join(map(repr, LIBRARIES))
            self.fail(f"{value!r} is not one of {listed}.", param, ctx)
        return value

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """Complete the names."""
        from click.shell_completion import CompletionItem

        return [CompletionItem(name) for name in LIBRARIES if name.startswith(incomplete)]


target_option = click.option(
    "--target",
    "-t",
    type=_ClientLibrary(),
    help="The client library of nodes that name none.",
)


class _Folder(click.Path):
    """The path of a folder, which need not be there."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Refuse the empty name, which a shell gives for a variable that is not set."""
        if not os.fspath(value):
            self.fail("the name of the folder is empty", param, ctx)
        return super().convert(value, param, ctx)


output_option = click.option(
    "--output",
    "-o",
    type=_Folder(path_type=Path),
    metavar="DIR",
    help="The output folder; without it that of plastron.yaml, or `output` beside the program.",
)


_Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


def format_option(*formats: str) -> _Decorator:
    """Return the option that chooses among formats, the first by default."""
    return click.option(
        "--format",
        "-f",
        "format_",
        type=click.Choice(formats),
        default=formats[0],
        show_default=True,
        help="How the result is written.",
    )


def shown_path(path: Path) -> str:
    """Return a path as a person reads it: from the working folder where it lies within."""
    from plastron_tui.diagnostics.terminal import visible

    with suppress(OSError, ValueError):
        path = path.relative_to(Path.cwd())
    return visible(str(path))


def print_text(text: str) -> None:
    """Write a result that quotes a user's files: what a terminal would obey is replaced."""
    from plastron_tui.diagnostics.terminal import visible

    lines = text.rstrip("\n").split("\n")
    click.echo("\n".join("\t".join(map(visible, line.split("\t"))) for line in lines))


class Report:
    """The diagnostics of a run of a command, written as they come, and its exit status."""

    def __init__(self, *, is_strict: bool = False) -> None:
        """Start a report; a strict one ends with 1 for warnings, too."""
        self.status = 0
        self._is_strict = is_strict
        self._errors = 0
        self._warnings = 0
        self._told: set[Diagnostic] = set()

    def add(
        self, diagnostics: Iterable[Diagnostic], lines: Lines, program: Path | None = None
    ) -> None:
        """Write diagnostics to standard error, and remember how bad they are."""
        fresh = self.count(diagnostics)
        if not fresh:
            return
        # A right program has nothing to render.
        from plastron_tui.diagnostics.render import TextRenderer
        from plastron_tui.diagnostics.terminal import wants_colour

        renderer = TextRenderer(lines, program, color=wants_colour(sys.stderr))
        for found in fresh:
            click.echo(renderer.render(found) + "\n", err=True, color=True)

    def count(self, diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
        """Remember how bad diagnostics are, and return those that were not told before.

        What is wrong with the project file is wrong for each of its programs, and is told once.
        """
        fresh = []
        for found in diagnostics:
            if found.file is not None:
                if found in self._told:
                    continue
                self._told.add(found)
            fresh.append(found)
            if found.severity is not Severity.ERROR:
                self._warnings += found.severity is Severity.WARNING
                continue
            self._errors += 1
            self.status = max(self.status, 2 if found.code.is_io else 1)
        return fresh

    def unreadable(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Write why a file that was named cannot be read."""
        self.add(diagnostics, lambda _: None)
        self.status = 2

    @property
    def is_empty(self) -> bool:
        """Whether nothing was wrong so far."""
        return not (self._errors or self._warnings or self.status)

    def finish(self) -> int:
        """Say how much was wrong, and return the exit status."""
        parts = [
            counted(count, word)
            for count, word in ((self._errors, "error"), (self._warnings, "warning"))
            if count
        ]
        if parts:
            click.echo(f"found {' and '.join(parts)}", err=True)
        return max(self.status, int(self._is_strict and bool(parts)))


def read_input(file: Path, report: Report) -> bytes | None:
    """Return what a file holds that is looked at as it is, None where it cannot be read."""
    from plastron_tui.model.source import LARGEST_FILE
    from plastron_tui.output.own_files import settled
    from plastron_tui.regular_files import read_named, reason

    report.add(settled(file.parent), lambda _: None)
    try:
        return read_named(file, LARGEST_FILE)
    except (OSError, ValueError) as error:
        message = f"`{file.name or file}` cannot be read: {reason(error)}"
        report.unreadable([Diagnostic(codes.UNREADABLE_FILE, message, file=file)])
        return None


def open_session(file: Path, report: Report, options: Options | None = None) -> Session | None:
    """Read a program; None when that fails, which is then reported."""
    if str(file) == STANDARD_INPUT:
        read = check_text(None, sys.stdin.buffer.read(LARGEST_PROGRAM + 1))
        path = None
    else:
        refusal = other_file(file)
        read = read_program(file) if refusal is None else ProgramText(None, (refusal,))
        path = file
    if read.text is None:
        report.unreadable(_with_suffix_hint(found, file) for found in read.diagnostics)
        return None
    report.add(read.diagnostics, lambda _: None)
    return Session(read.text, path, options)


def _with_suffix_hint(found: Diagnostic, file: Path) -> Diagnostic:
    """Offer the program that a name without its suffix may mean."""
    meant = file.with_name(f"{file.name}.plastron") if file.name else file
    if found.help is not None or file.exists() or not meant.is_file():
        return found
    return found._replace(help=f"did you mean `{meant.name}`?")


def open_sessions(
    files: Sequence[Path], report: Report, options: Options | None = None
) -> list[Session]:
    """Read several programs, each once; what cannot be read is reported."""
    sessions = (open_session(file, report, options) for file in dict.fromkeys(files))
    return [session for session in sessions if session is not None]


def finish(report: Report) -> None:
    """Leave the command with its exit status."""
    status = report.finish()
    if status:
        click.get_current_context().exit(status)
