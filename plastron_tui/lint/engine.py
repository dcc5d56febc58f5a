"""Running rules over a workspace, and leaving out what somebody has said is meant."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span

from .rule import Rule
from .tree import SourceTree


class Found(NamedTuple):
    """What breaks a rule."""

    rule: Rule
    diagnostic: Diagnostic


def lint(tree: SourceTree, rules: Iterable[Rule]) -> tuple[Found, ...]:
    """Return what breaks rules in a workspace, in the order of files and places.

    Of what one rule finds at a place, the first is told; nothing of what another one tells there.
    """
    found: dict[tuple[str, Path | None, Span | None], Found] = {}
    for rule in rules:
        for each in rule.check(tree):
            if not _is_of_one_program(each):
                found.setdefault((rule.code, each.file, each.span), Found(rule, each))
    return in_order(
        each
        for (_, file, span), each in found.items()
        if (each.rule.told_by, file, span) not in found
    )


def in_order(found: Iterable[Found]) -> tuple[Found, ...]:
    """Return what is found in the order of files and places."""
    return tuple(sorted(found, key=_place))


def _is_of_one_program(found: Diagnostic) -> bool:
    """Tell whether a mistake is between statements of one program, whose own check tells it."""
    file = found.file
    if file is None or file.suffix != ".plastron" or not found.labels:
        return False
    return all(label.file in (None, file) for label in found.labels)


def _place(found: Found) -> tuple[str, int, str]:
    diagnostic = found.diagnostic
    start = -1 if diagnostic.span is None else diagnostic.span.start
    return str(diagnostic.file), start, diagnostic.code
