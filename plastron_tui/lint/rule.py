"""What a rule is, and how one is declared."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from functools import cache

from plastron_tui.diagnostics import Code, Diagnostic, Severity

from .tree import SourceTree

Files = Mapping[str, str]
"""The files of an example, by their paths from the workspace."""

Check = Callable[[SourceTree], Iterable[Diagnostic]]


class Group(Enum):
    """What rules are about; the letters that their codes begin with."""

    GRAPH = "RG"
    MESSAGES = "RM"
    PARAMETERS = "RP"
    CODE = "RC"
    PACKAGES = "RK"


@dataclass(frozen=True, slots=True, eq=False)
class Rule:
    """A rule: its code, what it finds, and how that is mended.

    Attributes:
        code: its code, with a summary and a severity.
        name: what people call it: words with hyphens.
        check: finds what breaks it in a workspace.
        why: what happens where it is broken, and what is not told since it is not sure.
        bad: a workspace that breaks it once.
        good: the workspace with that mended.
        before: what the bad example was at an earlier revision, for a rule about changes.
        is_opt_in: whether it is followed only where it is selected by its code or its name.
        told_by: the code of a rule that tells this as well where it finds something at the same
            place; "" for none.
    """

    code: Code
    name: str
    check: Check
    why: str
    bad: Files
    good: Files
    is_opt_in: bool = False
    before: Files = field(default_factory=dict)
    told_by: str = ""

    @property
    def group(self) -> Group:
        """What it is about."""
        return Group(self.code[:2])

    def is_meant(self, word: str) -> bool:
        """Tell whether a word of a selection means the rule: its name, or the start of its code."""
        return word == self.name or (word != "" and self.code.startswith(word.upper()))


RULES: dict[str, Rule] = {}
"""The rules by their codes; `rules` declares them."""


@cache
def rule_of(code: Code) -> Rule:
    """Return what stands for a code that is no rule's, such as that of a mistake in a program."""
    return Rule(code, str(code), lambda _: (), code.summary, {}, {})


def rule(
    code: str,
    name: str,
    summary: str,
    *,
    why: str,
    bad: Files,
    good: Files,
    severity: Severity = Severity.ERROR,
    is_opt_in: bool = False,
    before: Files | None = None,
    told_by: str = "",
) -> Callable[[Callable[[SourceTree, Code], Iterable[Diagnostic]]], Rule]:
    """Declare a rule, whose function gets the workspace and the code of what it finds."""

    def declare(check: Callable[[SourceTree, Code], Iterable[Diagnostic]]) -> Rule:
        declared = Code(code, summary, severity=severity)
        found = Rule(
            declared,
            name,
            lambda tree: check(tree, declared),
            why,
            bad,
            good,
            is_opt_in,
            before or {},
            told_by,
        )
        assert code not in RULES
        RULES[code] = found
        return found

    return declare
