"""Changing the files of a workspace, none of which reads worse than before."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Fix, Severity, codes, has_errors
from plastron_tui.lint.baseline import LARGEST, read_baseline
from plastron_tui.lint.comment_syntax import CommentStyle, style_of
from plastron_tui.lint.fixing import with_fixes
from plastron_tui.lint.noting import with_comments
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.own_files import settled
from plastron_tui.output.plan import FilePlan, OutputFile, make_plan
from plastron_tui.output.target_paths import cannot_write
from plastron_tui.output.writer import write
from plastron_tui.regular_files import read_named
from plastron_tui.targets import language_of

from .run import LintRun

MOST_ROUNDS = 20
"""How often fixes that touch others get their turn."""

_NEVER_MEANT = {
    codes.UNUSED_NOQA, codes.BROKEN_XML, codes.UNSUPPORTED_XML, codes.BROKEN_PACKAGE,
    codes.BROKEN_PYTHON, codes.BROKEN_LAUNCH, codes.BROKEN_BUILD_FILE, codes.BAD_PARAMETERS,
    codes.UNREADABLE_FILE, codes.FILE_TOO_LARGE, *codes.GROUPS["sentences"],
}  # fmt: skip


class Rewrite(NamedTuple):
    """A file, what it holds and what it shall hold.

    Attributes:
        path: the file.
        before: what it holds, None where there is no such file.
        after: what it shall hold.
        fixes: what of it mends something.
    """

    path: Path
    before: bytes | None
    after: bytes
    fixes: tuple[Fix, ...] = ()


class Changes(NamedTuple):
    """What was written.

    Attributes:
        run: what is found now.
        done: how many things were mended, or noted.
        files: how many files were written.
        diagnostics: what could not be written.
    """

    run: LintRun
    done: int
    files: int
    diagnostics: tuple[Diagnostic, ...] = ()


def fixed(
    run: LintRun,
    refused: Collection[tuple[Path, Fix]] = (),
    careful: Collection[Path] = (),
) -> tuple[Rewrite, ...]:
    """Return the files that the fixes of what is found change.

    Fixes that touch each other wait for their turn, as do those of a file that somebody has changed
    since it was read. A file that would read worse gets its fixes one by one, without those that do
    harm.

    Args:
        run: what is found.
        refused: fixes that have done harm.
        careful: files that get one fix at a time.
    """
    found = []
    for path, fixes in _fixes(run, refused).items():
        before = run.text(path)
        if before is not None and not run.is_changed(path):
            after, applied = _applied(path, before, fixes[:1] if path in careful else fixes)
            if after != before:
                found.append(Rewrite(path, before, after, applied))
    return tuple(found)


def _fixes(run: LintRun, refused: Collection[tuple[Path, Fix]]) -> Mapping[Path, list[Fix]]:
    found: dict[Path, list[Fix]] = {}
    for each in run.told:
        file, fix = each.diagnostic.file, each.diagnostic.fix
        if file is not None and fix is not None and (file, fix) not in refused:
            found.setdefault(file, []).append(fix)
    return found


def _applied(path: Path, before: bytes, fixes: list[Fix]) -> tuple[bytes, tuple[Fix, ...]]:
    together = with_fixes(before, fixes)
    if not _is_worse(path, before, together.text):
        return together.text, together.applied
    good: list[Fix] = []
    for fix in together.applied:
        if not _is_worse(path, before, with_fixes(before, [*good, fix]).text):
            good.append(fix)
    return with_fixes(before, good).text, tuple(good)


def mend(run: LintRun) -> Changes:
    """Write the fixes of what is found, read it again, and go on until there are no more.

    What makes more rules be broken is put back: that of a file in which they are, and its fixes are
    tried one by one. Where they are in others the half of what was written is tried.
    """
    count, files = 0, set[Path]()
    refused: set[tuple[Path, Fix]] = set()
    careful: set[Path] = set()
    problems: list[Diagnostic] = []
    changed: list[Diagnostic] = []
    known = _broken(run)
    most: int | None = None
    for _ in range(MOST_ROUNDS):
        rewrites = fixed(run, refused, careful)[:most]
        found = write_all(rewrites)
        # What somebody else has changed meanwhile is read again, and has its turn then.
        later = {path for path in _unwritten(found) if all(map(_is_change, _errors(found[path])))}
        changed = list(chain(*(_errors(found[path]) for path in later)))
        if not rewrites and not any(map(run.is_changed, _fixes(run, refused))):
            break
        problems += (x for x in chain(*found.values()) if x not in changed)
        kept = [each for each in rewrites if each.path not in _unwritten(found)]
        failed = [each for each in rewrites if each not in kept and each.path not in later]
        refused |= {(each.path, fix) for each in failed for fix in each.fixes}
        most = 2 * most if most else None
        now = run.again()
        while kept and (worse := _broken(now) - known):
            harmed = [each for each in kept if any(each.path == file for file, _ in worse)] or kept
            before = ((x.path, x.after, x.before) for x in harmed if x.before is not None)
            back = write_all(Rewrite(*each) for each in before)
            problems += chain(*back.values())
            if harmed is kept and len(kept) > 1:
                most = len(kept) // 2
            else:
                refused |= {(each.path, each.fixes[0]) for each in harmed if len(each.fixes) == 1}
                careful |= {each.path for each in harmed}
            kept = [each for each in kept if each not in harmed]
            now = run.again()
        count += sum(len(each.fixes) for each in kept)
        files |= {each.path for each in kept}
        run, known = now, _broken(now)
    return Changes(run, count, len(files), (*problems, *changed))


def _is_change(problem: Diagnostic) -> bool:
    return problem.code == codes.CHANGED_ON_DISK


def _errors(problems: Iterable[Diagnostic]) -> list[Diagnostic]:
    return [each for each in problems if each.severity is Severity.ERROR]


def _unwritten(problems: Mapping[Path, tuple[Diagnostic, ...]]) -> set[Path]:
    return {path for path, found in problems.items() if has_errors(found)}


def _broken(run: LintRun) -> Counter[tuple[Path | None, str]]:
    """Count what breaks each rule in each file, be it a rule that was not selected.

    Of a comment that nothing breaks a rule for any more a fix may well be the reason.
    """

    def counted(run: LintRun) -> Counter[tuple[Path | None, str]]:
        found = (each.diagnostic for each in run.found)
        return Counter((x.file, str(x.code)) for x in found if x.code != codes.UNUSED_NOQA)

    return counted(run) | counted(run.unselected())


def note_all(run: LintRun) -> Changes:
    """Write a comment for each thing that is found: it is meant.

    That a comment is about nothing is not noted: it is to be taken away. Nor is it meant that a
    file breaks the rules of its language.
    """
    rewrites, counts = [], dict[Path, int]()
    told = [each for each in run.told if each.diagnostic.code not in _NEVER_MEANT]
    for path in dict.fromkeys(each.diagnostic.file for each in told):
        before = None if path is None else run.text(path)
        if path is None or before is None or run.is_changed(path):
            continue
        here = [
            (span, str(x.rule.code))
            for x in told
            if x.diagnostic.file == path and (span := x.diagnostic.span) is not None
        ]
        noted = with_comments(path, before, here)
        if noted.done and not _is_worse(path, before, noted.text):
            rewrites.append(Rewrite(path, before, noted.text))
            counts[path] = noted.done
    problems = write_all(rewrites)
    for path in _unwritten(problems):
        counts.pop(path, None)
    now = run.again() if rewrites else run
    return Changes(now, sum(counts.values()), len(counts), tuple(chain(*problems.values())))


def write_all(rewrites: Iterable[Rewrite]) -> dict[Path, tuple[Diagnostic, ...]]:
    """Write files, each as a whole; return what went wrong, by the file that was to be written."""
    problems = {}
    for each in rewrites:
        # What a killed process has left beside a file would count as another name of it.
        notes = settled(each.path.parent)
        plan, diagnostics = plan_of(each)
        found = (*notes, *diagnostics, *plan.conflicts)
        if not has_errors(found):
            found += write(plan).diagnostics
        if found:
            # What else could be done is said to those who generate a file.
            problems[each.path] = tuple(
                x if _is_change(x) else x._replace(help=None) for x in found
            )
    return problems


def write_baseline(path: Path, text: bytes) -> tuple[Diagnostic, ...]:
    """Write a baseline, over nothing that may be somebody's work."""
    try:
        if path.exists() and not path.is_file():
            # A pipe, or a terminal, has no work that could be lost.
            path.write_bytes(text)
            return ()
        before = read_named(path, LARGEST) if path.exists() else None
        if before:
            read_baseline(before)
    except OSError as error:
        return (cannot_write(path, error),)
    except ValueError:
        message = f"`{path.name}` is no baseline, and would be written over"
        remedy = "name another file, or remove this one"
        return (Diagnostic(codes.CANNOT_WRITE, message, file=path, help=remedy),)
    return tuple(chain(*write_all([Rewrite(path, before, text)]).values()))


def plan_of(rewrite: Rewrite) -> tuple[FilePlan, tuple[Diagnostic, ...]]:
    """Return what writing a file does, and why it cannot be written."""
    path = rewrite.path
    file = OutputFile(
        path.name,
        rewrite.after,
        is_executable=False,
        merged_from=rewrite.before,
        path=path,
        has_handwork=True,
    )
    return make_plan(path.parent, [file], Manifest())


def _is_worse(path: Path, before: bytes, after: bytes) -> bool:
    """Tell whether a text breaks the rules of its language, which it did not before."""
    language = language_of(path, before)
    if language is not None:
        return language.is_worse(after, before)
    style = style_of(path)
    if style is CommentStyle.XML:
        return _is_xml(before) and not _is_xml(after)
    if style is CommentStyle.YAML:
        return _is_yaml(before) and not _is_yaml(after)
    return False


def _is_xml(text: bytes) -> bool:
    from xml.parsers.expat import ExpatError, ParserCreate

    try:
        ParserCreate().Parse(text, True)
    except ExpatError:
        return False
    return True


def _is_yaml(text: bytes) -> bool:
    import yaml

    try:
        yaml.compose(text.decode(), Loader=yaml.SafeLoader)
    except (yaml.YAMLError, ValueError, RecursionError):
        return False
    return True
