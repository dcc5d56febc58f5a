"""`plastron shell`."""

from __future__ import annotations

import signal
import sys
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from shutil import get_terminal_size
from textwrap import wrap

import click

from plastron_tui.diagnostics import Diagnostic, LineIndex, Span, did_you_mean, has_errors
from plastron_tui.diagnostics.terminal import visible
from plastron_tui.generating.generation import Generated
from plastron_tui.generating.user_edits import files_on_disk
from plastron_tui.language import DECLARATIONS, Document, lower
from plastron_tui.model.interpreter import Interpreter
from plastron_tui.model.source import place_of
from plastron_tui.model.workspace import Generation
from plastron_tui.output.writer import MOST_TRIES, write
from plastron_tui.project.program_file import check_text
from plastron_tui.session import Options, Session

from .common import Report, finish, output_option, target_option
from .generate import show_plan

_PROMPT = ">> "
_LEAVE = ("exit", "quit")
_HELP = ("help", "?")
_NARROWEST = 40


@click.command(epilog="Example: echo \"create_node 'a' as a\" | plastron shell")
@output_option
@target_option
def command(output: Path | None, target: str | None) -> None:
    """Take one statement at a time, at a prompt or from a pipe.

    A statement with a mistake has no effect. `generate_node` writes its file at once. `help` lists
    the statements, `help WORD` explains one, and `exit` leaves; so does Ctrl-D at the prompt,
    where Ctrl-C drops a line.
    """
    report = Report()
    shell = Shell(Session(options=Options(target, output, is_writing=True)), report)
    is_terminal = sys.stdin.isatty()
    if is_terminal:
        click.echo("`help` lists the statements, `help subscribe` explains one, `exit` leaves.")
        _prepare_line_editing()
    lines: Iterable[bytes] = _typed() if is_terminal else sys.stdin.buffer
    for line in lines:
        words = line.decode(errors="replace").split()
        if len(words) == 1 and words[0] in _LEAVE:
            break
        if 0 < len(words) <= 2 and words[0] in _HELP:
            _show_help(words[1:])
            continue
        shell.take(line)
    if not is_terminal:
        finish(report)


class Shell:
    """Runs lines, one after the other, in one workspace."""

    def __init__(self, session: Session, report: Report) -> None:
        self._session = session
        self._report = report
        self._interpreter = Interpreter(session.setting)
        self._done = 0
        self._said: list[bytes] = []
        self._length = 0
        self._wrote: dict[Path, tuple[str, bytes]] = {}
        report.add(session.project_problems, session.lines)

    def take(self, line: bytes) -> None:
        """Run a line, and write what is wrong with it."""
        start = self._length
        read = check_text(None, line)
        self._said.append(line if line.endswith(b"\n") else line + b"\n")
        self._length += len(self._said[-1])
        if read.text is None:
            self._report.add(read.diagnostics, lambda _: None)
            return
        found = self._interpreter.run(lower(Document(line)))
        self._add(found, start)
        self._report.add(self._session.type_problems, self._session.lines)
        generations = self._interpreter.workspace.generations
        if not has_errors(found):
            for generation in generations[self._done :]:
                self._generate(generation, start)
        self._done = len(generations)

    def _generate(self, generation: Generation, start: int) -> None:
        for _ in range(MOST_TRIES):
            made = self._over_own(self._session.generate(generation))
            generations = self._interpreter.workspace.generations
            plan, diagnostics = self._session.plan_of([made], generations=generations)
            diagnostics = (*diagnostics, *plan.conflicts)
            if has_errors(diagnostics):
                break
            result = write(plan)
            if result.is_stale:
                diagnostics = (*diagnostics, *result.diagnostics)
                continue
            show_plan(plan)
            diagnostics = (*diagnostics, *result.diagnostics)
            for file in plan.files if not has_errors(result.diagnostics) else ():
                self._wrote[file.path] = generation.node.variable, file.text
            break
        # Another place than the statement's own is in a line that was said before.
        self._add(
            [
                found if found.file or found.span == generation.span else found._replace(span=None)
                for found in diagnostics
            ],
            start,
        )

    def _over_own(self, made: Generated) -> Generated:
        """Let a loaded node be written again over what was made of it a few lines before.

        The node is still what was loaded; only a file that differs from both was changed by hand.
        """
        node, files, path = made.generation.node, made.files, made.path(self._session.output)
        if files is None or path is None or node.source is None or files.problem is not None:
            return made
        path = path.resolve()
        present = files_on_disk(path)
        is_known = present is not None and all(
            self._wrote.get(place_of(path, name)) == (node.variable, text)
            for name, text in present.texts
        )
        if not is_known:
            return made
        return replace(made, files=replace(files, merged_from=present))

    def _add(self, diagnostics: Iterable[Diagnostic], start: int) -> None:
        """Report what is wrong with the last line, at its place among all lines."""
        self._report.add((_moved(found, start) for found in diagnostics), self._lines)

    def _lines(self, file: Path | None) -> LineIndex | None:
        return LineIndex(b"".join(self._said)) if file is None else self._session.lines(file)


def _moved(found: Diagnostic, start: int) -> Diagnostic:
    if found.file is not None:
        return found
    span = found.span and Span(found.span.start + start, found.span.end + start)
    # A label points into an earlier line, and tells its place in that line only.
    return found._replace(span=span, labels=())


def _typed() -> Iterator[bytes]:
    interrupt = _Interrupt()
    signal.signal(signal.SIGINT, interrupt)
    while (line := _ask(interrupt)) is not None:
        yield line.encode("utf-8", "surrogateescape")


def _ask(interrupt: _Interrupt) -> str | None:
    try:
        interrupt.is_armed = True
        return input(_PROMPT)
    except EOFError:
        click.echo()
        return None
    except KeyboardInterrupt:
        click.echo()
        return ""


class _Interrupt:
    """Ctrl-C at the prompt: it raises once a line, so that none interrupts the answer to another.

    Attributes:
        is_armed: whether the next one raises.
    """

    def __init__(self) -> None:
        self.is_armed = True

    def __call__(self, number: int, frame: object) -> None:
        if self.is_armed:
            self.is_armed = False
            raise KeyboardInterrupt


def _prepare_line_editing() -> None:
    """Give the prompt a history and the completion of keywords, where Python has readline."""
    if hasattr(sys.stdin, "reconfigure"):
        # What is typed in another encoding is a mistake to report, not a crash.
        sys.stdin.reconfigure(errors="surrogateescape")
    try:
        import readline
    except ImportError:
        return
    from plastron_tui.language.keywords import KEYWORDS

    words = sorted(KEYWORDS)

    def complete(text: str, state: int) -> str | None:
        found = [word + " " for word in words if word.startswith(text)]
        return found[state] if state < len(found) else None

    readline.set_completer(complete)
    readline.parse_and_bind("tab: complete")


def _show_help(words: list[str]) -> None:
    """Show all statements, or those that a word is about: a keyword, or a part of one."""
    chosen = [
        declaration
        for declaration in DECLARATIONS.values()
        if not words or words[0] in (declaration.keyword, *declaration.keyword.split("_"))
    ]
    for declaration in chosen:
        _echo(declaration.usage)
        _echo(declaration.summary, "    ")
        if words:
            for slot in declaration.slots:
                _echo(f"{slot.placeholder}: {slot.help}", "    ")
            _echo(f"Example: {declaration.example}", "    ")
    if not chosen:
        known = [declaration.keyword for declaration in DECLARATIONS.values()]
        hint = did_you_mean(words[0], known) or f"there are {', '.join(known)}"
        _echo(visible(f"no statement `{words[0]}`; {hint}"))


def _echo(line: str, indent: str = "") -> None:
    """Write a line of help; a terminal would break it within a word."""
    width = max(get_terminal_size().columns, _NARROWEST)
    further = f"{indent}        "
    lines = wrap(
        line, width, initial_indent=indent, subsequent_indent=further, break_long_words=False,
        break_on_hyphens=False,
    )  # fmt: skip
    click.echo("\n".join(lines))
