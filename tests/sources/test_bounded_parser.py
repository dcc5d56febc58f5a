"""Texts that were made to keep a parser busy are given up after a bounded number of steps."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from tree_sitter import Language

from plastron_tui.sources.cmake.syntax import _with_short_blanks, parse_cmake
from plastron_tui.sources.cpp.syntax import Syntax as CppSyntax
from plastron_tui.sources.cpp.syntax import parse as parse_cpp
from plastron_tui.sources.grammars import BoundedParser, bounding
from plastron_tui.sources.python.syntax import Syntax as PythonSyntax
from plastron_tui.sources.python.syntax import parse as parse_python


@pytest.fixture(autouse=True)
def bound() -> Iterator[None]:
    with bounding():
        yield


_LANGUAGES = {"python": PythonSyntax.grammar.language, "cpp": CppSyntax.grammar.language}


@pytest.mark.parametrize("name", sorted(_LANGUAGES))
def test_text_without_a_sentence_is_given_up(name: str) -> None:
    parser = BoundedParser(_language(name))
    text = b"<!--" * 2_000
    assert parser.parse(text).root_node.has_error
    assert parser.steps <= 2_002 + len(text) // 10
    # The next text is parsed as by a new parser.
    assert not parser.parse(b"a = 1;\n").root_node.has_error


def _language(name: str) -> Language:
    return _LANGUAGES[name]()


@pytest.mark.parametrize(
    ("text", "is_given_up"),
    [
        (b"x = " + b"-" * 5_000 + b"1\n", True),
        (b"(\n" * 5_000, True),
        (b"if x:" + b"\\\n" * 5_000 + b" pass\n", True),
        (b"#" + b"-" * 5_000 + b"\nx = 1\n", False),
        (b"x = '" + b"-" * 5_000 + b"'\n", False),
        (b"x = [" + b"1,\n" * 5_000 + b"]\n", False),
    ],
)
def test_python_that_a_query_would_take_too_long_for(text: bytes, is_given_up: bool) -> None:
    read = parse_python(text)
    assert (read.root.end_byte == 1) is is_given_up
    assert (read.errors > 0) is is_given_up


@pytest.mark.parametrize(
    ("text", "is_given_up"),
    [
        (b"int x = " + b"- " * 5_000 + b"1;\n", True),
        (b"//" + b"-" * 5_000 + b"\nint x = 1;\n", False),
        (b'auto x = "' + b"-" * 5_000 + b'";\n', False),
    ],
)
def test_cpp_that_a_query_would_take_too_long_for(text: bytes, is_given_up: bool) -> None:
    read = parse_cpp(text)
    assert (read.root.end_byte == 1) is is_given_up


@pytest.mark.parametrize(
    "blanks", [b" " * 5_000, b"\t\r" * 3_000, b"\n" * 5_000, b"  \n" * 900, b"#  \n \n" * 900]
)
@pytest.mark.parametrize("line_end", [b"\n", b""])
def test_many_blanks_of_cmake_mean_nothing(blanks: bytes, line_end: bytes) -> None:
    text = (
        b"project(a)  # a]]b" + blanks + b"\n" + blanks + b"set(A" + blanks + line_end
        + b'b "c' + blanks + b'd" [=[e' + blanks + b"]=])" + blanks + b"\n# end" + blanks
    )  # fmt: skip
    assert len(_with_short_blanks(text)) == len(text)
    short = text.replace(blanks, blanks[:6])
    words = [[each.replace(blanks.decode(), "") for each in x.words] for x in _read(text)]
    assert words == [
        [each.replace(blanks[:6].decode(), "") for each in x.words] for x in _read(short)
    ]


def _read(text: bytes):
    return list(parse_cmake(text, Path("CMakeLists.txt")).commands())
