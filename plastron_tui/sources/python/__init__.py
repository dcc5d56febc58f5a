"""Reading and editing Python nodes, whoever wrote them and however."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .editor import edit_python
    from .reader import read_python

__all__ = ["edit_python", "read_python"]

_MODULES = {"edit_python": "editor", "read_python": "reader"}


def __getattr__(name: str) -> Any:
    """Import what reads or edits when it is first used: both need the parser of Python."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{_MODULES[name]}", __name__), name)
