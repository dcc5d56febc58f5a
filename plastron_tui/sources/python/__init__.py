"""Reading and editing Python nodes, whoever wrote them and however."""

from typing import TYPE_CHECKING, Any

from .reader import read_python

if TYPE_CHECKING:
    from .editor import edit_python

__all__ = ["edit_python", "read_python"]


def __getattr__(name: str) -> Any:
    """Import the editor, which is three times the reader's size, when it is first used."""
    if name != "edit_python":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from .editor import edit_python

    return edit_python
