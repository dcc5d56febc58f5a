"""Texts that are cut to so many cells, behind or before."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as some
from rich.cells import cell_len

from plastron_tui.studio.cells import cut, end_of, fitted

TEXTS = some.text("ab 漢é\u0301…", max_size=12)


@pytest.mark.parametrize(
    ("text", "cells", "start", "end"),
    [
        ("robot", 5, "robot", "robot"),
        ("robot", 4, "rob…", "…bot"),
        ("robot", 1, "…", "…"),
        ("robot", 0, "", ""),
        ("", 0, "", ""),
        ("漢字漢字", 6, "漢字…", "…漢字"),
        ("漢字漢字", 8, "漢字漢字", "漢字漢字"),
        ("one two", 5, "one…", "… two"),
        # A sign that is put on the one before takes no cell.
        ("abe\u0301", 3, "abe\u0301", "abe\u0301"),
    ],
)
def test_a_text_that_is_too_long_is_cut(text: str, cells: int, start: str, end: str) -> None:
    assert (cut(text, cells), end_of(text, cells)) == (start, end)


@given(TEXTS, some.integers(0, 15))
def test_what_is_cut_fits(text: str, cells: int) -> None:
    start, end = cut(text, cells), end_of(text, cells)
    assert cell_len(start) <= cells and cell_len(end) <= cells
    assert cell_len(fitted(text, cells)) == cells
    if cell_len(text) > cells > 0:
        assert start.endswith("…") and end.startswith("…")
        assert text.endswith(end[1:])
        # No more would have fitted.
        more = text[len(text) - len(end) :]
        assert cell_len(f"…{more}") > cells
    elif cells:
        assert start == end == text
