"""The language, and nothing of ROS: text, tree, statements, formatter.

Each name is imported from its module when it is first asked for: to show a program takes its tree,
to check one no formatter.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
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

_MODULES = {
    # Of all statements, which are declared there.
    "DECLARATIONS": "statements",
    **dict.fromkeys(("Clause", "Declaration", "Slot", "SlotKind", "Statement"), "declaration"),
    "Document": "document",
    "format_document": "formatter",
    "Program": "lowering",
    "lower": "lowering",
}


def __getattr__(name: str) -> Any:
    """Import a name of the package when it is first asked for."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = getattr(import_module(f".{_MODULES[name]}", __name__), name)
    globals()[name] = found
    return found
