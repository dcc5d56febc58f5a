"""`plastron lint`."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from .common import Report, finish, format_option, print_text, shown_path

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from plastron_tui.diagnostics import Diagnostic, LineIndex
    from plastron_tui.lint.selection import Selection
    from plastron_tui.project.linting.rewriting import Changes
    from plastron_tui.project.linting.run import LintRun


class _Codes(click.types.StringParamType):
    """Words that mean rules, between commas: codes, what codes begin with, names."""

    name = "codes"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Refuse a word that means no rule."""
        import plastron_tui.lint.rules  # noqa: F401 - declares them
        from plastron_tui.lint.selection import unknown_words

        if isinstance(value, tuple):
            return value
        words = tuple(word.strip() for word in value.split(",") if word.strip())
        for word in unknown_words(words):
            self.fail(f"no rule is called `{word}`", param, ctx)
        return words

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """Complete the last code or name."""
        from click.shell_completion import CompletionItem

        from plastron_tui.lint.rules import RULES

        before, comma, last = incomplete.rpartition(",")
        return [
            CompletionItem(f"{before}{comma}{word}", help=rule.code.summary)
            for rule in RULES.values()
            for word in (str(rule.code), rule.name)
            if word.startswith(last) or (last and word.startswith(last.upper()))
        ]


_CODES = _Codes()


def _rules_option(name: str, text: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    return click.option(name, multiple=True, metavar="CODES", type=_CODES, help=text)


_COMPARING = frozenset({"RK508"})
"""The rules that look at nothing without `--against`."""

_NOTHING = "there is no package, node, launch file or program"

_OFTEN = 0.5
"""Seconds between two looks at how far reading is: what takes no longer shows nothing."""

_FILE = click.Path(dir_okay=False, path_type=Path)


@click.command(epilog="Example: plastron lint --select RG,RP src")
@click.argument(
    "paths", nargs=-1, metavar="[PATH]...", type=click.Path(exists=True, path_type=Path)
)
@_rules_option("--select", "Follow these rules alone: codes, what they begin with, or names.")
@_rules_option("--ignore", "Do not follow these rules.")
@click.option("--exclude", multiple=True, metavar="PATTERN", help="Do not look at such paths.")
@click.option("--fix", is_flag=True, help="Mend what can be mended safely.")
@click.option("--diff", is_flag=True, help="Show what --fix would change, and write nothing.")
@click.option("--add-noqa", is_flag=True, help="Write comments: all that is found is meant.")
@click.option("--baseline", type=_FILE, metavar="FILE", help="Tell only what this file has not.")
@click.option(
    "--write-baseline",
    "written",
    type=_FILE,
    metavar="FILE",
    help="Write what is found to a file instead of telling it.",
)
@click.option("--against", metavar="REV", help="Compare types with those of a revision of git.")
@click.option("--strict", is_flag=True, help="Exit with 1 when there are warnings, too.")
@click.option("--watch", is_flag=True, help="Look again whenever a file changes, until Ctrl-C.")
@click.option("--explain", metavar="CODE", type=_CODES, help="Say what a rule is about, and end.")
@click.option("--jobs", "-j", type=click.IntRange(1), help="How many processes read; one a core.")
@format_option("text", "json", "sarif", "github")
def command(
    paths: tuple[Path, ...],
    select: tuple[tuple[str, ...], ...],
    ignore: tuple[tuple[str, ...], ...],
    exclude: tuple[str, ...],
    fix: bool,
    diff: bool,
    add_noqa: bool,
    baseline: Path | None,
    written: Path | None,
    against: str | None,
    strict: bool,
    watch: bool,
    explain: tuple[str, ...] | None,
    jobs: int | None,
    format_: str,
) -> None:
    """Say what is wrong between the nodes, packages and launch files of a workspace.

    Nothing is built or run: it is what the files say for sure. Without a PATH it is the working
    folder. A comment `# noqa: CODE` (in C++ `// NOLINT(CODE)`) says that a line is meant so; what
    plastron.yaml has below `lint:` counts, too.

    Exits with 1 when something is found that is an error (or a warning, with --strict), or that
    --diff shows, and with 2 when a file cannot be read or written.
    """
    if explain is not None:
        _explain(explain)
        return
    _refuse_together({"--fix": fix, "--diff": diff, "--add-noqa": add_noqa, "--watch": watch,
                      "--write-baseline": written is not None})  # fmt: skip
    if against == "":
        # A variable of a CI that is not set: nothing would be compared, and nobody would know.
        raise click.UsageError("--against is given no revision.")
    from plastron_tui.lint.selection import Selection
    from plastron_tui.project.linting.run import LintOptions, LintRun

    from .lint_programs import read_program

    selection = Selection(sum(select, ()), sum(ignore, ()))
    _refuse_without_revision(selection, against)
    options = LintOptions(
        paths or (Path(),),
        selection,
        baseline,
        exclude,
        jobs,
        read_program=read_program,
        against=against or "",
        progress=_shown_progress() if sys.stderr.isatty() else None,
    )
    run = LintRun(options)
    report = Report(is_strict=strict)
    if watch:
        from plastron_tui.project.linting.watching import watched

        for number, each in enumerate(watched(options)):
            if number:
                click.echo("\na file has changed\n", err=True)
            _tell_again(each, format_)
    elif written is not None:
        _write_baseline(run, written, report)
    elif diff:
        _show_diff(run, report)
    elif fix or add_noqa:
        from plastron_tui.project.linting.rewriting import mend, note_all

        changes = mend(run) if fix else note_all(run)
        _say(changes, "mended" if fix else "noted", report)
        _tell(changes.run, format_, report)
    else:
        _tell(run, format_, report)
        fixes = sum(each.diagnostic.fix is not None for each in run.told)
        if fixes and format_ == "text":
            click.echo(f"--fix mends {fixes} of {len(run.told)}", err=True)
    if report.is_empty and format_ == "text" and not watch and run.has_nothing:
        click.echo(_NOTHING, err=True)
    elif report.is_empty and sys.stdout.isatty() and format_ == "text":
        click.echo("no problems")
    finish(report)


def _refuse_together(chosen: dict[str, bool]) -> None:
    names = [name for name, is_chosen in chosen.items() if is_chosen]
    if len(names) > 1:
        raise click.UsageError(f"{names[0]} and {names[1]} are not for one run.")


def _shown_progress() -> Callable[[int, int], None]:
    """Return what shows how far reading is, in a line of the terminal that goes again."""
    from plastron_tui.diagnostics.terminal import drawn_on

    shown, terminal = time.monotonic(), drawn_on(sys.stderr)

    def show(done: int, total: int) -> None:
        nonlocal shown
        now = time.monotonic()
        if done == total:
            terminal.write("\r\x1b[K")
        elif now - shown > _OFTEN:
            shown = now
            terminal.write(f"\rreading: {done} of {total} files\x1b[K")
        terminal.flush()

    return show


def _refuse_without_revision(selection: Selection, against: str | None) -> None:
    """Refuse to ask for a rule that has nothing to compare with: it would find nothing."""
    from plastron_tui.lint.rules import RULES

    for code in sorted(selection.asked() & _COMPARING):
        if not against:
            name = RULES[code].name
            raise click.UsageError(f"{code} ({name}) compares with a revision: give --against.")


def _explain(words: tuple[str, ...]) -> None:
    from plastron_tui.diagnostics.codes import CODES
    from plastron_tui.lint.explaining import explained
    from plastron_tui.lint.rule import rule_of
    from plastron_tui.lint.rules import RULES

    others = map(rule_of, CODES.values())
    found = [rule for rule in (*RULES.values(), *others) if any(map(rule.is_meant, words))]
    print_text("\n".join(map(explained, found)))


def _write_baseline(run: LintRun, file: Path, report: Report) -> None:
    from plastron_tui.diagnostics import counted, has_errors
    from plastron_tui.project.linting.rewriting import write_baseline

    problems = write_baseline(file, run.baseline_text().encode())
    _tell_problems(run, report)
    report.add(problems, run.lines)
    if not has_errors(problems):
        click.echo(f"wrote {counted(len(run.found), 'problem')} to {shown_path(file)}", err=True)


def _show_diff(run: LintRun, report: Report) -> None:
    from plastron_tui.project.linting.rewriting import fixed, plan_of

    from .generate import show_diff

    for rewrite in fixed(run):
        plan, diagnostics = plan_of(rewrite)
        show_diff(replace(plan, folder=run.root))
        report.add(diagnostics, run.lines)
        report.status = max(report.status, 1)
    _tell_problems(run, report)


def _say(changes: Changes, what: str, report: Report) -> None:
    from plastron_tui.diagnostics import codes, counted

    left = sum(each.diagnostic.code != codes.UNUSED_NOQA for each in changes.run.told)
    if what == "noted" and left and not changes.diagnostics:
        click.echo(
            f"{counted(left, 'problem')} can have no comment: see `per_file_ignores`", err=True
        )
    if changes.done:
        where = counted(changes.files, "file")
        click.echo(f"{what} {counted(changes.done, 'problem')} in {where}", err=True)
    report.add(changes.diagnostics, changes.run.lines)


def _tell_again(run: LintRun, format_: str) -> None:
    """Tell what is found by now."""
    report = Report()
    _tell(run, format_, report)
    report.finish()
    said = ""
    if report.is_empty:
        said = f"{_NOTHING}; " if run.has_nothing else "no problems; "
    click.echo(f"{said}watching, Ctrl-C ends", err=True)


def _tell(run: LintRun, format_: str, report: Report) -> None:
    diagnostics = [each.diagnostic for each in run.told]
    if format_ == "text":
        here = Path.cwd()
        report.add([_from(here, each) for each in diagnostics], lambda file: _lines(run, file))
    else:
        _write(report.count(diagnostics), run, format_)
    _tell_problems(run, report)


def _tell_problems(run: LintRun, report: Report) -> None:
    """Tell what is wrong with what the linter was given: settings, a baseline."""
    from plastron_tui.diagnostics import has_errors

    report.add(run.diagnostics, run.lines)
    if has_errors(run.diagnostics):
        report.status = 2


def _from(here: Path, found: Diagnostic) -> Diagnostic:
    """Return a diagnostic whose files are told from the working folder."""

    def short(file: Path | None) -> Path | None:
        return file.relative_to(here) if file is not None and file.is_relative_to(here) else file

    labels = tuple(each._replace(file=short(each.file)) for each in found.labels)
    return found._replace(file=short(found.file), labels=labels)


def _lines(run: LintRun, file: Path | None) -> LineIndex | None:
    return run.lines(None if file is None else Path.cwd() / file)


def _write(counted: Any, run: LintRun, format_: str) -> None:
    if format_ == "github":
        from plastron_tui.diagnostics.github import as_annotation

        root = _repository(Path.cwd())
        for each in counted:
            click.echo(as_annotation(each, run.lines, root))
        return
    from plastron_tui.diagnostics.json_text import json_text

    if format_ == "json":
        from plastron_tui.diagnostics.render import as_json

        click.echo(json_text(as_json(counted, run.lines)))
        return
    from plastron_tui import __version__
    from plastron_tui.diagnostics.sarif import RuleText, as_sarif

    rules = {rule.code: RuleText(rule.name, rule.why) for rule in run.rules}
    click.echo(json_text(as_sarif(counted, run.lines, run.root, __version__, rules)))


def _repository(folder: Path) -> Path:
    """Return the root of the repository that a folder is in, the folder where it is in none."""
    above = (folder, *folder.parents)
    return next((each for each in above if os.path.lexists(each / ".git")), folder)
