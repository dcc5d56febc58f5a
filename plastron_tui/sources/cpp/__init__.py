"""C++: node files are known by their suffix; Plastron does not read or write them yet."""

from __future__ import annotations

import re
from typing import ClassVar

from plastron_tui.sources.base import Language

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


_INCLUDE = re.compile(rb"""^[ \t]*#[ \t]*include[ \t]*[<"]([\w.+-]+/[\w./+-]+)[>"]""", re.MULTILINE)

# Folders of headers that come with a compiler and the C library of a system.
_OF_SYSTEM = frozenset(
    {"arpa", "asm", "bits", "experimental", "linux", "net", "netinet", "sys", "..", "."}
)


class Cpp(Language):
    """C++, as ROS nodes are written in it."""

    name: ClassVar[str] = "cpp"
    title: ClassVar[str] = "C++"
    is_built: ClassVar[bool] = True
    suffixes: ClassVar[tuple[str, ...]] = (".cpp", ".cc", ".cxx", ".hpp", ".h")

    def is_keyword(self, word: str) -> bool:
        """Tell whether a word is a keyword, or an alternative spelling of an operator."""
        return word in _KEYWORDS.split()

    def imports(self, text: bytes) -> frozenset[str]:
        """Return the headers that a text includes from folders: `std_msgs/msg/string.hpp`."""
        found = (each.decode("ascii") for each in _INCLUDE.findall(text))
        return frozenset(each for each in found if each.partition("/")[0] not in _OF_SYSTEM)
