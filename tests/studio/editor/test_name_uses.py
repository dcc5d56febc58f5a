"""From a name to the other statements about it."""

from __future__ import annotations

import pytest
from editor_host import editing

from plastron_tui.language import Document
from plastron_tui.studio.editor.name_uses import (
    function_at,
    is_file_at,
    name_at,
    next_use,
    uses_of,
)
from plastron_tui.studio.editor.uses import lines_of, uses_at

TEXT = """\
create_node 'speed' as one
one has_parameter 'speed' of parameter_type float with default 1
create_message go of message_type Twist and input linear.x=parameter 'speed'
one publish go to 'speed' of message_type Twist at parameter 'speed' hz
create_node 'two' as two
subscribe two to '/speed' of message_type Twist calling drive
two provides_service 'speed' of service_type Trigger
two has_parameter 'speed' of parameter_type float with default 1
load 'old.py' as old
old renames topic 'speed' to 'pace'
load other as other
subscribe two to '~speed' of message_type Twist
subscribe other to '~speed' of message_type Twist
// 'speed'
"""
ROWS = {
    "to 'speed'": [3, 5, 8, 9],
    "to '/speed'": [3, 5, 8, 9],
    "topic 'speed'": [3, 5, 8, 9],
    "provides_service 'speed'": [6],
    "one has_parameter 'speed'": [1, 2, 3],
    "two has_parameter 'speed'": [2, 7],
    "at parameter 'speed'": [1, 2, 3],
    "two to '~speed'": [11],
    "create_node 'speed'": None,
    "// 'speed'": None,
}


@pytest.mark.parametrize(("place", "rows"), ROWS.items())
def test_where_a_name_is_used(place: str, rows: list[int] | None) -> None:
    document = Document(TEXT.encode())
    name = name_at(document, TEXT.index(place) + len(place) - 3)
    assert (name is None) == (rows is None)
    if name is not None and rows is not None:
        loaded = {"old"} if name.what == "topic" and name.owner == "" else set()
        uses = uses_of(document, name, loaded)
        assert [TEXT[: each.start].count("\n") for each in uses] == rows
        assert TEXT[slice(*uses[-1])].strip("'").removeprefix("/") == name.text
        last = next_use(uses, uses[-1].end)
        assert last == (uses[0] if len(uses) > 1 else None)


def test_what_leads_to_code() -> None:
    document = Document(TEXT.encode())
    assert function_at(document, TEXT.index("drive") + 2) == "drive"
    assert function_at(document, TEXT.index("publish")) is None
    assert [is_file_at(document, TEXT.index(each)) for each in ("old.py", "other", "one")] == [
        *(True, True, False)
    ]


async def test_the_key_leads_from_statement_to_statement() -> None:
    async with editing(TEXT, cursor=TEXT.index("'speed' of message_type Twist at")) as at:
        rows = []
        for _ in range(3):
            await at.press("f12")
            rows.append(TEXT[: at.editor.cursor_offset].count("\n"))
        assert rows == [5, 9, 3]
        at.editor.go_to(TEXT.index("'pace'"))
        await at.press("f12")
        assert at.app.said == ["no other statement is about the topic `pace`"]


@pytest.mark.parametrize(
    ("place", "name", "numbers"),
    [
        ("as two", "two", [5, 6, 7, 8, 12]),
        ("to '/speed'", "speed", [4, 6, 9, 10]),
        ("calling drive", "drive", [6]),
        ("message_type Twist and", "Twist", [3, 4, 6, 12, 13]),
        ("// 'speed'", None, []),
        ("create_node", None, []),
    ],
)
def test_the_lines_that_use_something(place: str, name: str | None, numbers: list[int]) -> None:
    document = Document(TEXT.encode())
    offset = TEXT.index(place) + len(place) - (6 if place.endswith(" and") else 2)
    uses = uses_at(document, offset, lambda what, name: {"old"})
    assert (None if uses is None else uses.name) == name
    lines = () if uses is None else lines_of(document.text, uses.places)
    assert [line.number for line in lines] == numbers
    assert all(TEXT.splitlines()[line.number - 1] == line.text for line in lines)
