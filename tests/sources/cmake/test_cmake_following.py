"""What functions, macros and included files of a CMakeLists.txt do, and where that is not sure."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.sources.cmake.following import follow
from plastron_tui.sources.cmake.reader import CMakeLists, read_cmake

_HEAD = "project(rover)\n"
_ADD = "  add_executable(${name} src/${name}.cpp ${ARGN})\n"
_FILES = {
    "cmake/setup.cmake": b"find_library(A a)\nset(NAMES c)\nadd_library(u INTERFACE IMPORTED)\n",
    "cmake/more.cmake": b"add_executable(more more.cpp)\n",
    "cmake/defines.cmake": b"function(f name)\n  add_executable(${name} a.cpp)\nendfunction()\n",
    "cmake/finds.cmake": b"find_package(rosidl_default_generators REQUIRED)\n",
    "cmake/broken.cmake": b"set(A\n",
}


def _followed(text: str) -> CMakeLists:
    lists = read_cmake((_HEAD + text).encode(), Path("CMakeLists.txt")).lists
    assert lists is not None
    return follow(lists, _FILES.get)


def _made(lists: CMakeLists) -> list[str]:
    calls = lists.named("add_executable", "install")
    return [" ".join(each.value for each in call.items) for call in calls]


def _function(body: str, head: str = "add_it name", kind: str = "function") -> str:
    return f"{kind}({head})\n{body}end{kind}()\n"


_PARSED = (
    '  cmake_parse_arguments(ARG "QUIET" "NAME" "FILES;NEEDS" ${ARGN})\n'
    "  add_executable(${ARG_NAME} ${ARG_FILES})\n"
)

FOLLOWED = [
    # Arguments by name and the rest, in either kind, whatever case it is called in.
    (_function(_ADD) + "ADD_IT(a b.cpp c.cpp)", ["a src/a.cpp b.cpp c.cpp"]),
    (_function(_ADD, kind="macro") + "add_it(a b.cpp)\nadd_it(c)",
     ["a src/a.cpp b.cpp", "c src/c.cpp"]),
    (_function(_ADD) + "foreach(x a b)\n  add_it(${x})\nendforeach()",
     ["a src/a.cpp", "b src/b.cpp"]),
    # One that calls another one.
    (_function(_ADD) + _function("  add_it(${ARGV1})\n", "more x") + "more(a b)", ["b src/b.cpp"]),
    # Arguments with keywords.
    (_function(_PARSED, "add_it") + "add_it(QUIET NAME a FILES b.cpp c.cpp NEEDS ${x_TARGETS})",
     ["a b.cpp c.cpp"]),
    (_function(_PARSED.replace("${ARGN}", "").replace("(ARG", "(PARSE_ARGV 1 ARG")) +
     "add_it(x NAME a FILES b.cpp)", ["a b.cpp"]),
    # What it sets for its caller is not known there, and what it sets for itself is not set.
    (_function("  set(NAMES x)\n") + "set(NAMES a)\nadd_it(x)\nadd_executable(${NAMES} m.cpp)",
     ["a m.cpp"]),
    (_function("  set(${name} x PARENT_SCOPE)\n") +
     "set(NAMES a)\nadd_it(NAMES)\nadd_executable(${NAMES} m.cpp)", ["${NAMES} m.cpp"]),
    (_function("  string(TOUPPER x ${name})\n", kind="macro") +
     "set(NAMES a)\nadd_it(NAMES)\nadd_executable(${NAMES} m.cpp)", ["${NAMES} m.cpp"]),
    (_function("  set(NAMES x)\n", kind="macro") +
     "set(NAMES a)\nadd_it(q)\nadd_executable(${NAMES} m.cpp)", ["x m.cpp"]),
    # Nobody calls it, or tests alone.
    (_function("  return()\n") + "add_executable(a a.cpp)", ["a a.cpp"]),
    (_function("  set(A b)\n", "tests", "macro") + "if(BUILD_TESTING)\n  each(tests)\nendif()", []),
    ("if(BUILD_TESTING)\n" + _function("  add_test(${name})\n") + "  add_it(x)\nendif()", []),
    # Files that only configure, and what they may have set.
    ("include(cmake/setup.cmake)\nadd_executable(a a.cpp)", ["a a.cpp"]),
    ("set(NAMES a b)\nset(M m)\ninclude(${CMAKE_CURRENT_SOURCE_DIR}/cmake/setup.cmake)\n"
     "add_executable(${M} ${NAMES})", ["m ${NAMES}"]),
]  # fmt: skip

OPAQUE = [
    # Too few arguments, or it is not known how many.
    _function(_ADD, "add_it name x") + "add_it(a)",
    # It calls itself, or leaves in between.
    _function("  add_it(${name})\n") + "add_it(a)",
    _function("  if(name)\n    return()\n  endif()\n" + _ADD) + "add_it(a)",
    _function("  cmake_language(CALL ${name})\n") + "add_it(a)",
    # It defines another one, sets what is computed, or takes its arguments for variables.
    _function(_function(_ADD, "inner name")) + "add_it(a)",
    _function("  set(${X} a)\n") + "add_it(a)",
    _function("  foreach(x IN LISTS ARGN)\n    f(${x})\n  endforeach()\n", kind="macro")
    + "add_it(a b)",
    _function("  cmake_parse_arguments(${X} \"\" \"\" \"FILES\" ${ARGN})\n") + "add_it(a)",
    # Which one is called is not sure.
    "if(X)\n" + _function(_ADD) + "endif()\nadd_it(a)",
    _function(_ADD) + _function(_ADD) + "add_it(a)",
    # Something else may call it.
    _function(_ADD) + "cmake_language(CALL add_it a)",
    "if(BUILD_TESTING)\n" + _function(_ADD) + "endif()\n",
    "if(BUILD_TESTING)\n" + _function("  set(A b)\n") + "endif()\nadd_it(x)\n",
]  # fmt: skip


@pytest.mark.parametrize(("text", "made"), FOLLOWED)
def test_what_is_followed(text: str, made: list[str]) -> None:
    lists = _followed(text)
    assert _made(lists) == made
    assert not lists.opaque


@pytest.mark.parametrize("text", OPAQUE)
def test_what_is_not_followed(text: str) -> None:
    assert _followed(text).opaque


@pytest.mark.parametrize(
    ("file", "is_followed"),
    [
        ("cmake/setup.cmake", True),
        ("./cmake/setup.cmake", True),
        ("cmake/more.cmake", False),
        ("cmake/defines.cmake", False),
        ("cmake/finds.cmake", False),
        ("cmake/broken.cmake", False),
        ("cmake/nothing.cmake", False),
        ("cmake/../cmake/setup.cmake", False),
        ("${X}/cmake/setup.cmake", False),
    ],
)
def test_which_files_only_configure(file: str, is_followed: bool) -> None:
    (call,) = _followed(f"include({file})").named("include")
    assert call.is_followed == is_followed


def test_unknown_argument_is_no_name() -> None:
    """Where a list has any number of values, the names behind it are not known."""
    made = _made(_followed(_function(_ADD, "add_it first name") + "add_it(${ANY} a)"))
    assert made == ["${name} src/${name}.cpp ${ARGN}"]


def test_calls_without_end() -> None:
    """What grows with each call is not followed for ever."""
    doubled = "".join(
        _function(f"  f{at + 1}(x)\n" * 20, f"f{at} name") for at in range(6)
    ) + _function(_ADD, "f6 name")
    lists = _followed(doubled + "f0(x)")
    assert lists.opaque
