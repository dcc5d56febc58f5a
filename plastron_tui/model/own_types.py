"""Interface types of the program's own."""

from __future__ import annotations

from dataclasses import dataclass

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceKind


@dataclass(slots=True)
class OwnType:
    """A type that the program makes, or loads to change it."""

    name: str
    kind: InterfaceKind
    span: Span
