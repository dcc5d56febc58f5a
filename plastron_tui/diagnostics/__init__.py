"""Mistakes as data: what is wrong, where, and what to write instead.

A pass returns its result together with its diagnostics, and never raises for what a user
wrote. How they look (text, JSON, an underline in an editor) is for the renderers.
"""

from . import codes
from .code import Code
from .data import Diagnostic, Edit, Fix, Label, Span, has_errors, write
from .lines import LineIndex, Position
from .severity import Severity
from .suggest import did_you_mean, guess
from .wording import counted, either, listed, shortened

__all__ = [
    "Code",
    "Diagnostic",
    "Edit",
    "Fix",
    "Label",
    "LineIndex",
    "Position",
    "Severity",
    "Span",
    "codes",
    "counted",
    "did_you_mean",
    "either",
    "guess",
    "has_errors",
    "listed",
    "shortened",
    "write",
]
