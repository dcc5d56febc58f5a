"""What the engine tells of all that rules find."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from plastron_tui.diagnostics import Code, Diagnostic, Span
from plastron_tui.lint.engine import lint
from plastron_tui.lint.rule import Rule
from plastron_tui.lint.tree import SourceTree

Places = list[tuple[str, int]]


def _finds(code: Code, places: Places) -> Callable[[SourceTree], Iterable[Diagnostic]]:
    def check(_: SourceTree) -> Iterable[Diagnostic]:
        return [Diagnostic(code, said, Span(at, at + 1), Path("a.py")) for said, at in places]

    return check


def _rule(name: str, places: Places, told_by: str = "") -> Rule:
    code = Code(name, "It is wrong.")
    return Rule(code, name.lower(), _finds(code, places), "", {}, {}, told_by=told_by)


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        ([("a", 3), ("b", 1)], [], ["b", "a"]),
        ([("a", 1), ("b", 1)], [], ["a"]),
        ([("a", 1)], [("b", 1), ("c", 2)], ["a", "c"]),
        ([], [("b", 1)], ["b"]),
    ],
)
@pytest.mark.parametrize("is_turned", [False, True])
def test_first_finding_of_a_place_is_told(
    first: Places, second: Places, expected: list[str], *, is_turned: bool
) -> None:
    rules = [_rule("RX1", first), _rule("RX2", second, told_by="RX1")]
    found = lint(SourceTree(Path()), reversed(rules) if is_turned else rules)
    assert [each.diagnostic.message for each in found] == expected
