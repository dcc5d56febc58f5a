"""The lines on which something is used: of what has an owner, only that one's."""

from __future__ import annotations

import pytest

from plastron_tui.diagnostics import Span
from plastron_tui.language import Document
from plastron_tui.studio.editor.uses import lines_of, uses_at

TEXT = b"""\
load 'one.py' as one
load 'two.py' as two
subscribe one to 'scan' of message_type LaserScan calling see
subscribe two to 'scan' of message_type LaserScan calling see
one repeats see at 2 hz
one has_parameter 'speed' of parameter_type float and default 1.0
two has_parameter 'speed' of parameter_type float and default 1.0
"""


@pytest.mark.parametrize(
    ("word", "numbers"),
    [
        # The files of both nodes may have it.
        (b"scan'", [1, 2, 3, 4]),
        (b"see\none", [4]),
        (b"see at", [3, 5]),
        (b"speed' of", [1, 6]),
        (b"LaserScan", [3, 4]),
        (b"one to", [1, 3, 5, 6]),
    ],
)
def test_a_name_of_one_node_is_not_that_of_another(word: bytes, numbers: list[int]) -> None:
    found = uses_at(Document(TEXT), TEXT.index(word) + 1, lambda what, name: {"one", "two"})
    assert found is not None
    assert [line.number for line in lines_of(TEXT, found.places)] == numbers


def test_a_line_is_there_once_with_its_first_place() -> None:
    text = b"a a\n\n  b a\na"
    places = tuple(Span(at, at + 1) for at in (2, 0, 9, 11))
    assert lines_of(text, places) == (
        (1, "a a", Span(0, 1)),
        (3, "b a", Span(9, 10)),
        (4, "a", Span(11, 12)),
    )
