"""C++ names for what a program calls by ROS names."""

from __future__ import annotations

import re
from collections.abc import Iterable

from plastron_tui.sources import naming
from plastron_tui.sources.naming import capitals, class_name, label, words

from .keywords import is_taken

__all__ = ["Scope", "capitals", "class_name", "is_name", "label", "words"]

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


class Scope(naming.Scope):
    """The names of one scope of a C++ file, each given once."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        super().__init__(taken, is_taken)


def is_name(text: str) -> bool:
    """Tell whether a text can be a name that a program gives; the others are the compiler's own.

    Those are what has two underscores together, or begins with one ([lex.name] of ISO C++).
    """
    is_own = "__" in text or text.startswith("_")
    return bool(_NAME.fullmatch(text)) and not is_own and not is_taken(text)
