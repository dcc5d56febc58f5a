"""Python names for what a program calls by ROS names."""

from __future__ import annotations

from collections.abc import Iterable
from keyword import iskeyword

from plastron_tui.sources import naming
from plastron_tui.sources.naming import capitals, class_name, label, words

__all__ = ["Scope", "capitals", "class_name", "label", "words"]


class Scope(naming.Scope):
    """The names of one scope of a Python file, each given once."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        super().__init__(taken, iskeyword)
