"""What the lines of a program that are no statements were to do, as far as they say it."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics import Span

_NONE: frozenset[str] = frozenset()


class Undecided(NamedTuple):
    """A line such as `generate pilot`: several statements begin with its word.

    Attributes:
        span: where the word stands.
        words: those that may be meant.
        variable: what the statement is about.
    """

    span: Span
    words: tuple[str, ...]
    variable: str


class Broken(NamedTuple):
    """What later statements may miss because of broken lines: it is not missing, only broken.

    Attributes:
        words: the words and the quoted names of all such lines.
        declared: the words of those that were to declare a variable.
        unfinished: the words of those that break off before they name a topic or a service;
            an empty one stands for a line that names not even a node.
        lost: how many were to declare a variable, and do not say which.
        undecided: the lines whose statement depends on what their variable stands for.
    """

    words: frozenset[str] = _NONE
    declared: frozenset[str] = _NONE
    unfinished: frozenset[str] = _NONE
    lost: int = 0
    undecided: tuple[Undecided, ...] = ()
