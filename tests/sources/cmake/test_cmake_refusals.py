# ruff: noqa: E501 - a case is a line
"""What is not changed: broken, computed and hostile files, and where the grammar is missing."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import pytest

from plastron_tui.diagnostics import codes
from plastron_tui.sources.cmake import dependencies, interfaces, programs, reader, shares, syntax

PATH = Path("CMakeLists.txt")
HEAD = "project(rover)\nfind_package(ament_cmake REQUIRED)\n"
CATKIN = "project(rover)\nfind_package(catkin REQUIRED)\n"

BROKEN = {
    "project(rover\n": 1,
    "project(rover)\nset(a (b\nset(c d)\n": 2,
    "project(rover)\nset(a\nset(c d)\n": 2,
    "project(rover))\n": 1,
    'project(rover)\nset(x "a)\n': 2,
    "project(rover)\nif(X)\n": 2,
    "project(rover)\nendif()\n": 2,
    "if(X)\nendif()\nelse()\n": 3,
    "rover\n": 1,
    "set(a b) set(c d)\n": 1,
    "set(a [[b)\n": 1,
}


@pytest.mark.parametrize("text", BROKEN)
def test_a_syntax_error_is_told_with_its_line(text: str) -> None:
    edited = programs.add_program(text.encode(), PATH, "scripts/x.py")
    assert edited.text is None
    (told,) = edited.diagnostics
    assert told.code == codes.BROKEN_BUILD_FILE
    assert told.message == f"line {BROKEN[text]} of `CMakeLists.txt` has a syntax error"
    assert told.span is not None
    assert told.file == PATH


@pytest.mark.parametrize("add", [programs.add_program, shares.add_shared])
def test_a_metapackage_installs_nothing(add) -> None:
    edited = add(f"{CATKIN}catkin_metapackage()\n".encode(), PATH, "scripts/x.py")
    assert edited.text is None
    (told,) = edited.diagnostics
    assert (told.code, told.help) == (codes.EDIT_REFUSED, "put it into another package")
    assert told.message.startswith("line 3 of `CMakeLists.txt` makes it a metapackage")


COMPUTED = [
    (
        dependencies.add_dependency,
        "if(X)\n  project(rover)\n  find_package(catkin)\nendif()\n",
        "std_msgs",
        "line 3 of `CMakeLists.txt` finds catkin under a condition",
    ),
    (
        dependencies.add_dependency,
        "project(rover)\nif(X)\n  set(C a)\nendif()\nset(C ${C} rospy)\n"
        "find_package(catkin REQUIRED COMPONENTS ${C})\nmessage(${C})\n",
        "std_msgs",
        "line 6 of `CMakeLists.txt` computes catkin's components",
    ),
    (
        interfaces.add_interface,
        HEAD + "file(GLOB m RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg)\n"
        "rosidl_generate_interfaces(rover ${m})\n",
        "srv/Go.srv",
        "line 4 of `CMakeLists.txt` computes its types",
    ),
    (
        interfaces.add_interface,
        HEAD
        + "block()\n  set(m msg/Speed.msg)\n  rosidl_generate_interfaces(rover ${m})\nendblock()\n",
        "srv/Go.srv",
        "line 5 of `CMakeLists.txt` computes its types",
    ),
    (
        shares.add_shared,
        HEAD + "install(FILES x.launch DESTINATION share/rover RENAME y.launch)\n",
        "x.launch",
        "line 3 of `CMakeLists.txt` installs `x.launch` in a way of its own",
    ),
    (
        interfaces.add_interface_dependency,
        HEAD,
        "std_msgs",
        "line 1 of `CMakeLists.txt` begins a file that makes no types",
    ),
    (
        dependencies.add_exported,
        CATKIN,
        "std_msgs",
        "line 1 of `CMakeLists.txt` begins a file that calls no `catkin_package`",
    ),
    (
        shares.add_shared,
        HEAD
        + 'install(DIRECTORY launch DESTINATION share/rover FILES_MATCHING PATTERN "*.launch.py")\n',
        "launch/x.launch.xml",
        "line 3 of `CMakeLists.txt` installs `launch`, and leaves out `launch/x.launch.xml` or "
        "puts it somewhere else",
    ),
    (
        programs.add_program,
        "project(rover)\nset(x y)\n",
        "scripts/x.py",
        "`CMakeLists.txt` finds neither catkin nor ament_cmake",
    ),
    (
        programs.remove_program,
        HEAD + "foreach(x a b)\n  install(PROGRAMS s/${x} DESTINATION lib/rover)\nendforeach()\n",
        "s/a",
        "line 4 of `CMakeLists.txt` computes `s/a`",
    ),
]


@pytest.mark.parametrize(("edit", "text", "value", "message"), COMPUTED)
def test_what_is_computed_is_refused_with_its_line(edit, text, value, message) -> None:  # type: ignore[no-untyped-def]
    edited = edit(text.encode(), PATH, value)
    assert edited.text is None
    assert [each.message for each in edited.diagnostics] == [message]


def test_a_file_is_told_of_where_the_grammar_is_not_installed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "tree_sitter_cmake", None)
    syntax._parser.cache_clear()
    read = reader.read_cmake(b"project(rover)\n", PATH)
    (told,) = read.diagnostics
    assert read.lists is None
    assert told.code == codes.MISSING_EXTRA
    assert told.help == "pip install 'plastron-tui[cmake]'"
    monkeypatch.undo()
    assert reader.read_cmake(b"project(rover)\n", PATH).lists is not None


HOSTILE = {
    "not UTF-8": (b"project(\xff)\n", "line 1 of `CMakeLists.txt` is not UTF-8"),
    "NUL": (b"project(a)\nset(\0)\n", "line 2 of `CMakeLists.txt` has a NUL byte"),
    "huge": (b"set(a b)\n" * 60_000, "`CMakeLists.txt` has more than 500 kB"),
    "deep": (
        b"if(x)\n" * 200 + b"endif()\n" * 200,
        "line 61 of `CMakeLists.txt` is within too many blocks",
    ),
    "open": (b"if(x)\n" * 30_000, "line 1 of `CMakeLists.txt` has a syntax error"),
    "parentheses": (b"a(" + b"(" * 100_000, "line 1 of `CMakeLists.txt` has a syntax error"),
    "loops": (
        b"foreach(a 1 2 3 4 5 6 7 8 9)\n" * 12 + b"set(x ${a})\n" + b"endforeach()\n" * 12,
        "line 13 of `CMakeLists.txt` is reached after 20000 commands",
    ),
    "references": (b"set(a " + b"${" * 100_000, "line 1 of `CMakeLists.txt` has a syntax error"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_files_are_refused_soon(name: str) -> None:
    text, message = HOSTILE[name]
    begun = time.process_time()
    edited = programs.add_program(text, PATH, "scripts/x.py")
    assert time.process_time() - begun < 10
    assert [each.message for each in edited.diagnostics] == [message]


GROWING = {
    "doubling": "set(a b c)\n" + "set(a ${a} ${a})\n" * 200,
    "doubling text": 'set(a "b")\n' + 'set(a "${a}${a}")\n' * 200,
    "itself": 'set(a "${a}")\nset(b "${${a}}")\n' * 50,
}


@pytest.mark.parametrize("name", GROWING)
def test_what_grows_is_bounded(name: str) -> None:
    begun = time.process_time()
    text = (HEAD + GROWING[name]).encode()
    edited = programs.add_program(text, PATH, "scripts/x.py")
    assert time.process_time() - begun < 10
    assert edited.text is not None
    assert programs.remove_program(edited.text, PATH, "scripts/x.py").text == text


def test_a_byte_order_mark_stays() -> None:
    text = b"\xef\xbb\xbf" + HEAD.encode()
    edited = programs.add_program(text, PATH, "scripts/x.py")
    assert (edited.text or b"").startswith(text)
    assert programs.remove_program(edited.text or b"", PATH, "scripts/x.py").text == text
