"""The language, and nothing of ROS: text, tree, statements, formatter."""

from typing import TYPE_CHECKING, Any

from .declaration import DECLARATIONS, Clause, Declaration, Slot, SlotKind, Statement
from .document import Document
from .lowering import Program, lower

if TYPE_CHECKING:
    from .formatter import format_document

__all__ = [
    "DECLARATIONS",
    "Clause",
    "Declaration",
    "Document",
    "Program",
    "Slot",
    "SlotKind",
    "Statement",
    "format_document",
    "lower",
]


def __getattr__(name: str) -> Any:
    """Import the formatter when it is first asked for: checking a program needs none."""
    if name != "format_document":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from .formatter import format_document

    return format_document
