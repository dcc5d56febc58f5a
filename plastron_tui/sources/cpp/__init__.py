"""C++: node files are known by their suffix; Plastron does not read or write them yet."""

from __future__ import annotations

from typing import ClassVar

from plastron_tui.sources.base import Language

from .includes import included
from .keywords import is_keyword


class Cpp(Language):
    """C++, as ROS nodes are written in it."""

    name: ClassVar[str] = "cpp"
    title: ClassVar[str] = "C++"
    is_built: ClassVar[bool] = True
    suffixes: ClassVar[tuple[str, ...]] = (".cpp", ".cc", ".cxx", ".hpp", ".h")

    def is_keyword(self, word: str) -> bool:
        """Tell whether a word is a keyword, or an alternative spelling of an operator."""
        return is_keyword(word)

    def imports(self, text: bytes) -> frozenset[str]:
        """Return the headers that a text includes from folders: `std_msgs/msg/string.hpp`."""
        return included(text)
