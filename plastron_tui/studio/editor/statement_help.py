"""A line about the statement under the cursor."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plastron_tui.language.declaration import Element
    from plastron_tui.language.expectations import Expectation
    from plastron_tui.session import Session

START = "a statement starts with create_node, load, subscribe, …, or with a node"
GAP = "   "
"""What stands between a sentence and its help."""


def is_comment(line: bytes) -> bool:
    """Tell whether a line begins with a comment: no statement is started there."""
    return line.lstrip().startswith((b"//", b"/*"))


def help_in_line(line: bytes, expected: Expectation, session: Session) -> str:
    """Return what is said of the statement in a line, at a place of it; "" for a comment."""
    if is_comment(line):
        return ""
    if expected.values is None:
        return help_of(expected)
    from plastron_tui.targets import ros_version

    from .value_completion import field_help

    return help_of(expected, field_help(expected, session.catalog(ros_version(session.library))))


def help_of(expected: Expectation, about: str = "") -> str:
    """Return the sentence of the statement at a place, the current part marked, and its help.

    The line is plain text, no markup; it is empty where there is nothing to say.

    Args:
        expected: what may stand at the place.
        about: what is said of the part, where more is known than of all such parts.
    """
    declaration = expected.declaration
    if declaration is None:
        return START if expected.starts_line else ""

    def marked(element: Element, text: str) -> str:
        return f"‹{text}›" if element is expected.element else text

    from plastron_tui.language import Slot

    sentence = declaration.usage_around(expected.element, marked)
    slot = expected.element if isinstance(expected.element, Slot) else None
    return f"{sentence}{GAP}{about or (slot.help if slot else declaration.summary)}"
