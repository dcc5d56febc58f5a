"""A line about the statement under the cursor."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plastron_tui.language.declaration import Element
    from plastron_tui.language.expectations import Expectation

START = "a statement starts with create_node, load, subscribe, …, or with a node"
GAP = "   "
"""What stands between a sentence and its help."""


def is_comment(line: bytes) -> bool:
    """Tell whether a line begins with a comment: no statement is started there."""
    return line.lstrip().startswith((b"//", b"/*"))


def help_of(expected: Expectation) -> str:
    """Return the sentence of the statement at a place, the current part marked, and its help.

    The line is plain text, no markup; it is empty where there is nothing to say.
    """
    declaration = expected.declaration
    if declaration is None:
        return START if expected.starts_line else ""

    def marked(element: Element, text: str) -> str:
        return f"‹{text}›" if element is expected.element else text

    from plastron_tui.language import Slot

    sentence = declaration.usage_around(expected.element, marked)
    slot = expected.element if isinstance(expected.element, Slot) else None
    return f"{sentence}{GAP}{slot.help if slot else declaration.summary}"
