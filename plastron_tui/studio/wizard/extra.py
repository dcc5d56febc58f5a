"""Statements that may follow the one that was asked for."""

from __future__ import annotations

from typing import NamedTuple


class Extra(NamedTuple):
    """Statements that follow the one that was asked for.

    Attributes:
        key: what it is called within the wizard.
        words: what is offered.
        lines: the statements.
        node: the variable of the node that they are about, "" where they are about none.
    """

    key: str
    words: str
    lines: tuple[str, ...]
    node: str = ""
