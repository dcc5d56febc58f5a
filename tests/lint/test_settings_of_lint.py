"""What plastron.yaml sets for the linter, and which rules words mean."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import NO_QUEUE, run_over, told, write_tree

from plastron_tui.diagnostics import Severity
from plastron_tui.lint.rule import RULES, rule_of
from plastron_tui.lint.rules import RULES as DECLARED
from plastron_tui.lint.selection import Selection, matches, unknown_words
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.project.linting.run import LintOptions, LintRun

assert DECLARED is RULES
FOUND = [("RC407", 3)]


@pytest.mark.parametrize(
    ("settings", "found"),
    [
        ("", FOUND),
        ("lint:\n  select: RG\n", []),
        ("lint:\n  select: [RG, RC407]\n", FOUND),
        ("lint:\n  ignore: queue-size-missing\n", []),
        ("lint:\n  per_file_ignores:\n    p/*: RC\n", []),
        ("lint:\n  per_file_ignores:\n    '*.py': [RC407]\n", []),
        ("lint:\n  per_file_ignores:\n    q/*: RC\n", FOUND),
        ("lint:\n  exclude: p\n", []),
        ("lint:\n  exclude: ['*.py']\n", []),
        ("lint:\n  exclude: [q, p/*.xml]\n", FOUND),
    ],
)
def test_what_is_set(tmp_path: Path, settings: str, found: list[tuple[str, int]]) -> None:
    root = write_tree(tmp_path, {"p/a.py": NO_QUEUE, "plastron.yaml": settings})
    run = run_over(root)
    assert told(run) == found
    assert run.diagnostics == []


@pytest.mark.parametrize(
    ("settings", "message", "place"),
    [
        ("lint: 5", "`lint` is a list of `key: value` lines", "5"),
        ("lint: {selct: RG}", "`selct` is no key of `lint`", "selct"),
        ("lint: {select: RX9}", "no rule is called `RX9`", "RX9"),
        ("lint: {select: {a: b}}", "`select` is a list of words", "{a: b}"),
        (
            "lint: {per_file_ignores: RG}",
            "`per_file_ignores` is a list of `pattern: codes` lines",
            "RG",
        ),
        ("lint: {per_file_ignores: {a: RX}}", "no rule is called `RX`", "RX"),
        ("lint: {baseline: [a]}", "`baseline` is to be the path of a file", "[a]"),
    ],
)
def test_mistake_in_the_settings(tmp_path: Path, settings: str, message: str, place: str) -> None:
    root = write_tree(tmp_path, {"a.py": NO_QUEUE, "plastron.yaml": settings})
    run = run_over(root)
    assert run.told is not None
    (found,) = run.diagnostics
    assert found.message == message
    assert found.span is not None
    assert settings[found.span.start : found.span.end] == place


def test_a_folder_is_left_out_by_its_name_alone(tmp_path: Path) -> None:
    files = {"q/third/a.py": NO_QUEUE, "q/thirds/a.py": NO_QUEUE}
    root = write_tree(tmp_path, {**files, "plastron.yaml": "lint: {exclude: third}"})
    (found,) = run_over(root).told
    assert found.diagnostic.file == root / "q/thirds/a.py"


def test_nobody_has_to_trust_a_project_that_is_looked_at(tmp_path: Path) -> None:
    settings = "templates: ../t\nlint: {select: RC407}"
    root = write_tree(tmp_path, {"a.py": NO_QUEUE, "plastron.yaml": settings})
    run = run_over(root)
    assert told(run) == FOUND
    (found,) = run.diagnostics
    assert (found.code, found.severity) == ("outside-project", Severity.WARNING)


@pytest.mark.parametrize(
    ("settings", "given", "found"),
    [
        ("select: RG", Selection(("RC407",)), FOUND),
        ("ignore: RC407", Selection(("RC407",)), FOUND),
        ("ignore: queue-size-missing", Selection(("RC",)), FOUND),
        ("select: RC407", Selection((), ("RC",)), []),
        ("select: queue-size-missing", Selection((), ("RC407",)), []),
        ("select: RC407", Selection((), ("RG",)), FOUND),
        ("ignore: RC", Selection((), ("RG",)), []),
        ("per_file_ignores: {a.py: RC}", Selection(("RC407",)), []),
    ],
)
def test_the_command_line_goes_before_the_settings(
    tmp_path: Path, settings: str, given: Selection, found: list[tuple[str, int]]
) -> None:
    files = {"a.py": NO_QUEUE, "b.py": NO_QUEUE, "plastron.yaml": f"lint: {{{settings}}}"}
    root = write_tree(tmp_path, files)
    cache = FactCache(root, tmp_path / "cache")
    options = LintOptions((root,), given, exclude=("b.py",), workers=1, cache=cache)
    assert told(LintRun(options)) == found


@pytest.mark.parametrize(
    ("select", "ignore", "is_followed"),
    [
        ((), (), True),
        (("R",), (), True),
        (("RC",), (), True),
        (("rc407",), (), True),
        (("queue-size-missing",), (), True),
        (("RG",), (), False),
        ((), ("RC",), False),
        (("RC407",), ("RC",), True),
        (("RC",), ("RC407",), False),
        (("RC",), ("queue-size-missing",), False),
        (("unused-noqa",), (), False),
    ],
)
def test_the_more_exact_word_counts(
    select: tuple[str, ...], ignore: tuple[str, ...], is_followed: bool
) -> None:
    assert unknown_words((*select, *ignore)) == ()
    assert (RULES["RC407"] in Selection(select, ignore).rules()) is is_followed


def test_what_is_no_rule_is_chosen_by_its_code() -> None:
    from plastron_tui.diagnostics import codes

    unused = rule_of(codes.UNUSED_NOQA)
    assert Selection().tells(unused)
    assert not Selection(("RC",)).tells(unused)
    assert not Selection((), ("unused-noqa",)).tells(unused)
    assert unknown_words(("unused-no",)) == ("unused-no",)


@pytest.mark.parametrize(
    ("path", "pattern", "is_meant"),
    [
        ("a/b/c.py", "c.py", True),
        ("a/b/c.py", "*.py", True),
        ("a/b/c.py", "a", True),
        ("a/b/c.py", "a/b/", True),
        ("a/b/c.py", "b", False),
        ("a/b/c.py", "*/b", True),
        ("a/b/c.py", "a/*.cpp", False),
        ("a/b/c.py", "./a", True),
        ("a/b/c.py", "./c.py", False),
    ],
)
def test_patterns(path: str, pattern: str, is_meant: bool) -> None:
    assert matches(path, pattern) is is_meant
