"""The editor of the studio."""

from .widget import ProgramEditor

__all__ = ["ProgramEditor"]
