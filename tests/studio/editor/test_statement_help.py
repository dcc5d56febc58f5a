from __future__ import annotations

import pytest

from plastron_tui.language.expectations import expected_at
from plastron_tui.session import Session
from plastron_tui.studio.editor.statement_help import GAP, help_in_line, help_of, is_comment


@pytest.mark.parametrize(
    ("line", "is_so"),
    [(b"// why", True), (b"  /* why */", True), (b"", False), (b"a publish b // c", False)],
)
def test_no_statement_is_started_in_a_line_that_begins_with_a_comment(
    line: bytes, is_so: bool
) -> None:
    assert is_comment(line) is is_so


SCAN = "create_message scan of message_type LaserScan and input "
TWIST = "create_message go of message_type Twist and input "


@pytest.mark.parametrize(
    ("line", "said"),
    [(SCAN + "range_min=", "range_min: float32, m, what is nearer is not seen"),
     (SCAN + "range_min=0.1, ranges", "ranges: float32[], m, the distance that each ray measured"),
     (TWIST + "linear.x=", "linear.x: float64, m/s, forward, below 0 backward"),
     (TWIST + "linear=(", "the values of its fields"),
     (TWIST + "linear=(x=1, y=", "y: float64, m/s, sideways to the left; most robots cannot"),
     (TWIST, "the values of its fields"), (TWIST + "linear.x=1, ", "the values of its fields"),
     (TWIST + "no.such=", "the values of its fields"),
     ("create_message a of message_type Nothing and input b=", "the values of its fields"),
     ("create_message a of message_type Point and input 1, ", "y: float64"),
     ("// " + TWIST + "linear.x=", "")],
)  # fmt: skip
def test_the_field_at_the_cursor_is_told(line: str, said: str) -> None:
    session = Session(line.encode(), environ={})
    expected = expected_at(session.document, len(line.encode()))
    shown = help_in_line(line.encode(), expected, session)
    assert shown.rpartition(GAP)[2].startswith(said) and bool(shown) == bool(said)


@pytest.mark.parametrize(
    "line",
    ["a has_parameter 'b' of parameter_type float default 0.3 between 0 and 1",
     "create_node 'a' under x"],
)  # fmt: skip
def test_a_line_with_a_mistake_keeps_its_sentence(line: str) -> None:
    expected = expected_at(Session(line.encode()).document, len(line))
    verb = line.split()[0 if line.startswith("create") else 1]
    assert verb in help_of(expected) and "‹" not in help_of(expected)
    assert (expected.keywords, expected.slot) == ((), None)
