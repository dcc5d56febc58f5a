"""Mistakes as data: what is wrong, where, and what to write instead.

A pass returns its result together with its diagnostics, and never raises for what a user
wrote. How they look (text, JSON, an underline in an editor) is for the renderers.
"""

from .codes import CODES, IO_CODES, Code
from .data import Diagnostic, Edit, Fix, Label, Severity, Span, has_errors
from .lines import LineIndex, Position
from .suggest import did_you_mean

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
    "has_errors",
]
