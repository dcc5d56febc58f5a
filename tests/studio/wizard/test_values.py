"""The form of a message's values, and the text that it becomes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.language.statements import CreateMessage
from plastron_tui.model.types import TypeResolver
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.session import Session
from plastron_tui.studio.wizard.values import (
    Entry,
    Heading,
    entries_of,
    input_text,
    pieces,
    problem_of,
    quoted,
)


def form(type_: str, distribution: str = "noetic") -> list[Entry | Heading]:
    catalog = Catalog(distribution)
    found = TypeResolver(catalog).resolve(type_, InterfaceKind.MESSAGE)
    return entries_of(found, catalog)  # type: ignore[arg-type]


TEXTS = [
    ("String", {"data": "hello"}, '"hello"'),
    ("String", {"data": 'say "hi"\n\\'}, r'"say \"hi\"\n\\"'),
    ("String", {"data": " "}, '" "'),
    ("String", {}, "none"),
    ("Bool", {"data": "yes"}, "True"),
    ("Point", {"x": "1", "y": "2", "z": "3"}, "1, 2, 3"),
    ("Point", {"y": "2"}, "y=2"),
    ("Twist", {"linear.x": "0.5", "angular.z": "1"}, "linear.x=0.5, angular.z=1"),
    ("LaserScan", {"ranges": "1, 2.5", "header.frame_id": "laser"},
     'header.frame_id="laser", ranges=[1, 2.5]'),
    ("LaserScan", {"ranges": "[1]"}, "ranges=[1]"),
    ("JointState", {"name": 'a, "b, c"', "position": ""}, 'name=["a", "b, c"]'),
    ("Duration", {"data": "1.5"}, "1.5"),
    ("Path", {"poses": "(pose=(position=(1, 2, 3)))"}, "poses=[(pose=(position=(1, 2, 3)))]"),
]  # fmt: skip


@pytest.mark.parametrize(("type_", "values", "text"), TEXTS)
def test_what_is_entered_becomes_the_text(type_: str, values: dict[str, str], text: str) -> None:
    given = {tuple(path.split(".")): value for path, value in values.items()}
    assert input_text(form(type_), given)[0] == text
    line = f"create_message m of message_type {type_} and input {text}\n"
    session = Session(line.encode(), environ={})
    assert session.diagnostics == ()


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("2 1", "put commas between: 2, 1"),
        ("2, 1 0.5", "put commas between: 2, 1, 0.5"),
        ("2 x", "`2 x`, value 1 of the list: ranges takes a number, such as 0.5"),
        ("2, 1", None),
    ],
)
def test_a_list_without_commas_is_told_where_they_go(text: str, problem: str | None) -> None:
    ranges = next(each for each in form("LaserScan") if each.path == ("ranges",))
    assert isinstance(ranges, Entry) and problem_of(ranges, text, 1) == problem


def test_the_form_of_nested_messages_is_open() -> None:
    shown = [(".".join(each.path), type(each).__name__) for each in form("Twist")]
    assert shown == [
        ("linear", "Heading"), ("linear.x", "Entry"), ("linear.y", "Entry"), ("linear.z", "Entry"),
        ("angular", "Heading"), ("angular.x", "Entry"), ("angular.y", "Entry"),
        ("angular.z", "Entry"),
    ]  # fmt: skip


@pytest.mark.parametrize("distribution", ["noetic", "jazzy"])
def test_a_header_is_filled_by_itself(distribution: str) -> None:
    entries = form("LaserScan", distribution)
    assert entries[0] == Heading(("header",), "time and number are filled in when it is sent")
    assert [each.path for each in entries if each.path[0] == "header"] == [
        ("header",),
        ("header", "frame_id"),
    ]


def entry(type_: str, path: str, distribution: str = "noetic") -> Entry:
    found = next(each for each in form(type_, distribution) if ".".join(each.path) == path)
    assert isinstance(found, Entry)
    return found


def test_ranges_defaults_and_constants_are_shown() -> None:
    assert entry("UInt8", "data").note == "uint8 0…255"
    assert entry("Bool", "data").is_switch
    assert "values with commas between" in entry("LaserScan", "ranges").note
    battery = entry("BatteryState", "power_supply_status")
    assert ("POWER_SUPPLY_STATUS_FULL", 4) in [(c.name, c.value) for c in battery.constants]
    assert entry("BatteryState", "present").constants == ()
    default = entry("rcl_interfaces/FloatingPointRange", "from_value", "jazzy")
    assert default.note.startswith("float64")


@pytest.mark.parametrize("distribution", ["noetic", "jazzy"])
def test_every_message_has_a_form(distribution: str) -> None:
    catalog = Catalog(distribution)
    for name in catalog.names(InterfaceKind.MESSAGE):
        found = catalog.find(name, InterfaceKind.MESSAGE)
        assert found is not None
        entries = entries_of(found, catalog)
        paths = [each.path for each in entries if isinstance(each, Entry)]
        assert len(set(paths)) == len(paths)
        assert input_text(entries, {}) == ("none", [])


@given(st.text())
def test_any_text_can_be_sent(text: str) -> None:
    line = f"create_message m of message_type String and input {quoted(text)}\n"
    session = Session(line.encode(), environ={})
    (statement,) = session.program.statements
    assert isinstance(statement, CreateMessage)
    (value,) = statement.input
    assert value.value == text  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("", []),
        ("1", ["1"]),
        ("1,2 , 3", ["1", "2", "3"]),
        ("1,", ["1", ""]),
        ('"a, b", c', ['"a, b"', "c"]),
        ('"a', ['"a']),
    ],
)
def test_lists_are_split_at_their_commas(text: str, found: list[str]) -> None:
    assert pieces(text) == found
