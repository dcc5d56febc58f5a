"""Texts of C++ that are nested deeper than people write, and such as only look so."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.model.source import FileSet
from plastron_tui.sources.cpp.nesting import MOST_NESTED, is_nested_too_deep
from plastron_tui.sources.cpp.reader import read_cpp
from plastron_tui.sources.cpp.syntax import parse

_MANY = 3 * MOST_NESTED
_DEEP = ["std::vector<", "a<", "f(", "{", "[](){", "A<A,", "a<b>(", "A<1>::", "typename a::",
         "a < b<", "#if 1\nx(\n"]  # fmt: skip
_FLAT = ["std::vector<int> a;", "a < b;", "f();", "if (x < y) {}", "std::cout << a << ", "a->b, ",
         "std::max(a, b), ", "a <= ", "a > ", "x(){", "#include <a>\n", "A::x | "]  # fmt: skip


@pytest.mark.parametrize("piece", _DEEP)
def test_what_is_nested_too_deep_is_not_parsed(piece: str) -> None:
    text = b"#include <rclcpp/rclcpp.hpp>\n" + piece.encode() * _MANY
    assert is_nested_too_deep(text)
    assert parse(text).root.descendant_count < 10
    (told,) = read_cpp(Path("a.cpp"), FileSet.single(".cpp", text)).diagnostics
    assert told.code == "file-too-large"


@pytest.mark.parametrize("piece", _FLAT)
def test_what_is_not_nested_is_read(piece: str) -> None:
    text = piece + ("}" if piece.endswith("{") else "")
    assert not is_nested_too_deep(text.encode() * _MANY)
