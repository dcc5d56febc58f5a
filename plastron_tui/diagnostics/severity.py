"""How bad a mistake is."""

from enum import Enum


class Severity(str, Enum):
    """How bad it is. A program with an error generates nothing; a warning stops nothing.

    A note says what was done where nothing is wrong.
    """

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"
