"""The language, and nothing of ROS: text, tree, statements, formatter."""

from .declaration import DECLARATIONS, Clause, Declaration, Slot, SlotKind, Statement
from .document import Document
from .formatter import format_document
from .lowering import Program, lower

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
