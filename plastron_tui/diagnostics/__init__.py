"""Mistakes as data: what is wrong, where, and what to write instead.

A pass returns its result together with its diagnostics, and never raises for what a user
wrote. How they look (text, JSON, an underline in an editor) is for the renderers.
"""

from typing import TYPE_CHECKING, Any

from .data import Diagnostic, Edit, Fix, Label, Severity, Span, has_errors, write
from .lines import LineIndex, Position
from .suggest import did_you_mean, guess
from .wording import listed, shortened

if TYPE_CHECKING:
    from .codes import CODES, IO_CODES, Code

__all__ = [
    "CODES",
    "IO_CODES",
    "Code",
    "Diagnostic",
    "Edit",
    "Fix",
    "Label",
    "LineIndex",
    "Position",
    "Severity",
    "Span",
    "did_you_mean",
    "guess",
    "has_errors",
    "listed",
    "shortened",
    "write",
]


def __getattr__(name: str) -> Any:
    """Import the list of codes when it is first asked for: a diagnostic carries only a name."""
    if name not in {"CODES", "IO_CODES", "Code"}:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import codes

    return getattr(codes, name)
