"""What Plastron asks of C++, without the parser that reading needs."""

from __future__ import annotations

from pathlib import Path
from typing import ClassVar

from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.source import FileSet, SourceUnit
from plastron_tui.sources.base import Language, ReadResult

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

    def others(self, path: Path, text: bytes) -> tuple[str, ...]:
        """Return the headers of the file's package that it includes."""
        from .headers import others

        return others(path, text)

    def read(self, path: Path, files: FileSet, library: str | None = None) -> ReadResult:
        """Read the nodes and endpoints of a C++ file with the headers of its set."""
        from .reader import read_cpp  # loads tree-sitter-cpp

        return read_cpp(path, files, library)

    def mentioned_library(self, text: bytes) -> str | None:
        """Return the client library that a file mentions."""
        from .mentioned import mentioned_library

        return mentioned_library(text)

    def code_facts(self, source: SourceUnit) -> CodeFacts:
        """Return what the C++ files of a unit do besides creating endpoints."""
        from .facts import code_facts

        return code_facts(source)

    def is_worse(self, text: bytes, *others: bytes) -> bool:
        """Tell whether a text parses at fewer places than each of the others."""
        from .syntax import parse

        return parse(text).errors > max((parse(other).errors for other in others), default=0)

    def definitions(self, text: bytes, name: str) -> int:
        """Count the functions and methods of a name that a C++ text defines."""
        from .words import definitions

        return definitions(text, name)

    def mentions(self, text: bytes, name: str) -> bool:
        """Tell whether C++ code has a name; strings and comments are no code."""
        from .words import mentions

        return mentions(text, name)

    def imports(self, text: bytes) -> frozenset[str]:
        """Return the headers that a text includes from folders: `std_msgs/msg/string.hpp`."""
        return included(text)
