"""The words that C++ reserves."""

from __future__ import annotations

import re

# [lex.key] and [lex.digraph] of ISO C++20.
_WORDS = """
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t
    char32_t char8_t class co_await co_return co_yield compl concept const const_cast consteval
    constexpr constinit continue decltype default delete do double dynamic_cast else enum
    explicit export extern false float for friend goto if inline int long mutable namespace new
    noexcept not not_eq nullptr operator or or_eq private protected public register
    reinterpret_cast requires return short signed sizeof static static_assert static_cast struct
    switch template this thread_local throw true try typedef typeid typename union unsigned
    using virtual void volatile wchar_t while xor xor_eq
"""

# What ISO C has for macros in the headers that every node includes, and GCC of its own accord
# (`-std=gnu++17`): a name of the same spelling is another text to the compiler.
_MACROS = """
    EOF INFINITY NAN NULL assert errno linux offsetof stderr stdin stdout unix
"""

# Families of macros in these headers, and in those of the libraries of ROS and of Boost.
_FAMILIES = re.compile(
    r"(?:BOOST|FP|M|RCL|RCLCPP|RCUTILS|RMW|ROS|ROSCONSOLE|SIG|TOPIC)_[A-Z0-9_]+|"
    r"[A-Z0-9_]+_(?:MAX|MIN)|"
    r"SIG(?:ABRT|ALRM|CHLD|CONT|FPE|HUP|ILL|INT|KILL|PIPE|QUIT|SEGV|STOP|TERM|TRAP|USR[12])|"
    r"BUFSIZ|CHAR_BIT|EXIT_(?:FAILURE|SUCCESS)|HUGE_VALF?|SEEK_(?:CUR|END|SET)"
)

_KEYWORDS = frozenset(_WORDS.split())
_TAKEN = _KEYWORDS | frozenset(_MACROS.split())


def is_keyword(word: str) -> bool:
    """Tell whether a word is a keyword, or an alternative spelling of an operator."""
    return word in _KEYWORDS


def is_taken(word: str) -> bool:
    """Tell whether a word is a keyword or a macro, and so the name of nothing else."""
    return word in _TAKEN or _FAMILIES.fullmatch(word) is not None
