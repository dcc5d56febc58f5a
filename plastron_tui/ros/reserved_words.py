"""Words that cannot name what is generated from a definition, by the language that takes them.

Sources: C17 (6.4.1), C++20 ([lex.key], [lex.digraph]), the Python language reference
("Keywords"). Words of IDL are no part: `rosidl_adapter` writes member names as they are, and the
grammar of `rosidl_parser` takes them. `genpy` renames words of Python, so that in ROS 1 only
those of C++ break a build.
"""

from __future__ import annotations

_WORDS = {
    "C": (
        "auto break case char const continue default do double else enum extern float for goto "
        "if inline int long register restrict return short signed sizeof static struct switch "
        "typedef union unsigned void volatile while"
    ),
    "C++": (
        "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t "
        "char32_t char8_t class co_await co_return co_yield compl concept const const_cast "
        "consteval constexpr constinit continue decltype default delete do double dynamic_cast "
        "else enum explicit export extern false float for friend goto if inline int long mutable "
        "namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
        "register reinterpret_cast requires return short signed sizeof static static_assert "
        "static_cast struct switch template this thread_local throw true try typedef typeid "
        "typename union unsigned using virtual void volatile wchar_t while xor xor_eq"
    ),
    "Python": (
        "False None True and as assert async await break class continue def del elif else except "
        "finally for from global if import in is lambda nonlocal not or pass raise return try "
        "while with yield"
    ),
}
_TABLE = {language: frozenset(words.split()) for language, words in _WORDS.items()}
_LANGUAGES = {1: ("C++",), 2: ("C", "C++", "Python")}


def reserved_by(word: str, ros_version: int) -> str | None:
    """Return the language in which a word of a definition is reserved, None when in none."""
    return next((each for each in _LANGUAGES[ros_version] if word in _TABLE[each]), None)


def is_python_word(word: str) -> bool:
    """Tell whether no class of Python can have this name."""
    return word in _TABLE["Python"]


# What the generated code has of its own, by generation. Sources: the class that
# `genpy.generator.msg_generator` writes, `msg.h.template` of gencpp, `_msg.py.em` of
# rosidl_generator_py; and macros: those that
# GCC predefines in its GNU dialects on Linux, and those of the headers that are included.
_TAKEN = {
    1: {
        "a method of the generated Python class": (
            "serialize deserialize serialize_numpy deserialize_numpy"
        ),
        "a type of the generated C++ struct": "Type Ptr ConstPtr",
        "a macro of C++ compilers": "linux unix NULL EOF",
    },
    2: {
        "a member of the generated Python class": "get_fields_and_field_types check_fields",
        "a member that empty messages get": "structure_needs_at_least_one_member",
        "a macro of C++ compilers": "linux unix NULL EOF",
    },
}
_TAKEN_TABLE = {
    version: {word: what for what, words in groups.items() for word in words.split()}
    for version, groups in _TAKEN.items()
}


def taken_by(name: str, ros_version: int) -> str | None:
    """Return what in the generated code has the name of a member, None when nothing has."""
    return _TAKEN_TABLE[ros_version].get(name)
