"""Which rules are followed, and where.

What is told besides, of programs and of comments about rules, is chosen by its code as rules are.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fnmatch import fnmatchcase
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics.codes import CODES

from .rule import RULES, Rule, rule_of


class Selection(NamedTuple):
    """What was said of rules; a word is a code, what codes begin with, or a name.

    Attributes:
        select: the rules that are followed, none for those that are by themselves.
        ignore: those of them that are not.
        per_file: patterns of paths from the workspace, and what is not told of such files.
        never: those that are not followed, however exactly they are selected.
    """

    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    per_file: Mapping[str, tuple[str, ...]] = {}
    never: tuple[str, ...] = ()

    def rules(self) -> tuple[Rule, ...]:
        """Return the rules that are followed, in the order of their codes.

        Of a rule that two words are about, the longer one counts: `--select RG --ignore RG101`.
        """
        return tuple(rule for _, rule in sorted(RULES.items()) if self.tells(rule))

    def asked(self) -> frozenset[str]:
        """Return the codes of the rules that are selected by their own codes or names."""
        return frozenset(code for code, rule in RULES.items() if self._is_asked(rule))

    def _is_asked(self, rule: Rule) -> bool:
        return rule.name in self.select or rule.code in map(str.upper, self.select)

    def tells(self, rule: Rule) -> bool:
        """Tell whether a rule is followed; an opt-in one has to be asked for by itself."""
        if rule.is_opt_in and not self._is_asked(rule):
            return False
        if any(map(rule.is_meant, self.never)):
            return False
        chosen = _strength(rule, self.select)
        if not self.select:
            chosen = 0
        return chosen > _strength(rule, self.ignore)

    def is_ignored(self, rule: Rule, file: Path, root: Path) -> bool:
        """Tell whether a rule is not followed in a file."""
        path = path_from(root, file)
        return any(
            matches(path, pattern) and any(map(rule.is_meant, words))
            for pattern, words in self.per_file.items()
        )


def unknown_words(words: Iterable[str]) -> tuple[str, ...]:
    """Return the words that no rule is meant by."""
    known = (*RULES.values(), *map(rule_of, CODES.values()))
    return tuple(word for word in words if not any(rule.is_meant(word) for rule in known))


def _strength(rule: Rule, words: Iterable[str]) -> int:
    """Return how exactly words mean a rule, -1 where none does."""
    return max(
        (
            len(rule.code) + 1 if word == rule.name else len(word)
            for word in words
            if rule.is_meant(word)
        ),
        default=-1,
    )


def path_from(root: Path, file: Path) -> str:
    """Return a path as patterns and baselines have it: from the root where it is below that."""
    return file.relative_to(root).as_posix() if file.is_relative_to(root) else str(file)


def matches(path: str, pattern: str) -> bool:
    """Tell whether a path, a folder that it is in, or its name matches a pattern."""
    parts = path.split("/")
    above = ("/".join(parts[:count]) for count in range(1, len(parts) + 1))
    return ("/" not in pattern and fnmatchcase(parts[-1], pattern)) or any(
        fnmatchcase(each, pattern.removeprefix("./").rstrip("/")) for each in above
    )
