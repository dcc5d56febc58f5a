from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.definition import parse_definition
from plastron_tui.ros.definition_edits import add_member, remove_member, replace_member
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.type_circles import find_circle

_LINES = st.lists(
    st.sampled_from(
        ["int8 a", "string b  # b", "# of it", "  # more", "", "---", "uint8 X = 1", "\xe9"]
    )
)


@given(_LINES, st.sampled_from(["\n", "\r\n"]), st.booleans(), st.integers(0, 2))
def test_a_member_added_and_removed_leaves_every_byte(
    lines: list[str], newline: str, has_end: bool, section: int
) -> None:
    text = newline.join(lines).encode() + (newline.encode() if has_end else b"")
    if section > sum(line == "---" for line in lines):
        with pytest.raises(ValueError, match="no section"):
            add_member(text, "int8 new", section)
        return
    assert remove_member(add_member(text, "int8 new", section), "new", section) == text


@pytest.mark.parametrize(
    ("before", "name", "after"),
    [
        (b"int8 a\n# of b\nint8 b  # it\n\nint8 c\n", "b", b"int8 a\n\nint8 c\n"),
        (b"int8 a\n# of both\nint8 b\nint8 c\n", "b", b"int8 a\n# of both\nint8 c\n"),
        (b"# the type\nint8 a\n", "a", b"# the type\n"),
        (b"int8 a\r\nint8 b", "b", b"int8 a"),
    ],
)
def test_comments_of_a_removed_member(before: bytes, name: str, after: bytes) -> None:
    assert remove_member(before, name) == after


def test_a_replaced_member_keeps_its_comment() -> None:
    assert replace_member(b"int8 a  # it\r\n", "a", "int16 a") == b"int16 a  # it\r\n"


def message(name: str, text: str) -> Interface:
    found = parse_definition(text, InterfaceName("own", name), InterfaceKind.MESSAGE, 2).interface
    assert found is not None
    return found


def test_circles() -> None:
    one = message("A", "int8 a\nint8 b\nB c\n")
    types = {each.name: each for each in (one, message("B", "A[] a\n"), message("C", "A a\n"))}
    assert {each.name for each in find_circle(types)} == {"A", "B"}
    assert find_circle({one.name: one}) == ()


def test_own_types_come_first() -> None:
    own = message("String", "int8 a\n")
    catalog = Catalog("jazzy")
    mine = catalog.with_own({(InterfaceKind.MESSAGE, own.name): own})
    assert mine.find(own.name, InterfaceKind.MESSAGE) is own
    assert mine.candidates("String", InterfaceKind.MESSAGE) == (own.name,)
    assert "own" in mine.packages(InterfaceKind.MESSAGE)
    assert catalog.find(own.name, InterfaceKind.MESSAGE) is None


def test_own_types_leave_the_types_that_are_taken_as_they_are() -> None:
    own, unknown = message("A", "int8 a\n"), InterfaceName("other", "Unknown")
    catalog = Catalog("jazzy").with_undefined([(InterfaceKind.MESSAGE, unknown)])
    mine = catalog.with_own({(InterfaceKind.MESSAGE, own.name): own})
    assert mine.find(unknown, InterfaceKind.MESSAGE) is not None
    assert mine.with_own({}).find(unknown, InterfaceKind.MESSAGE) is not None
