"""What Plastron asks of C++, without the parser that reading needs."""

from __future__ import annotations

from pathlib import Path
from typing import ClassVar

from plastron_tui.model.source import FileSet
from plastron_tui.sources.base import Language, ReadResult

# [lex.key] and [lex.digraph] of ISO C++20.
_KEYWORDS = """
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t
    char32_t char8_t class co_await co_return co_yield compl concept const const_cast consteval
    constexpr constinit continue decltype default delete do double dynamic_cast else enum
    explicit export extern false float for friend goto if inline int long mutable namespace new
    noexcept not not_eq nullptr operator or or_eq private protected public register
    reinterpret_cast requires return short signed sizeof static static_assert static_cast struct
    switch template this thread_local throw true try typedef typeid typename union unsigned
    using virtual void volatile wchar_t while xor xor_eq
"""


class Cpp(Language):
    """C++, as ROS nodes are written in it."""

    name: ClassVar[str] = "cpp"
    title: ClassVar[str] = "C++"
    suffixes: ClassVar[tuple[str, ...]] = (".cpp", ".cc", ".cxx", ".hpp", ".h")

    def is_keyword(self, word: str) -> bool:
        """Tell whether a word is a keyword, or an alternative spelling of an operator."""
        return word in _KEYWORDS.split()

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
        """Return the packages whose headers a C++ text includes."""
        from .mentioned import imports

        return imports(text)
