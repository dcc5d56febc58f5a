"""What somebody writes for a field who knows another language, and what is said of it."""

from __future__ import annotations

import pytest
from workspaces import marked, run

A = "create_message_type A with int32 x\n"
FIRST = "the type of a field comes before its name"
DEFAULT = "or, for a field that starts from this value: "

# What is written for a field, the text of the span, the message, the help, what the fix writes.
SLIPS: list[tuple[str, str, str, str, str | None]] = [
    ("left float64", "left float64", FIRST, "write `float64 left`", "float64 left"),
    ("left float", "left float", FIRST, "write `float64 left`", "float64 left"),
    ("left Point", "left Point", FIRST, "write `Point left`", "Point left"),
    ("int left", "int", "`int`", "did you mean `int32`?", "int32"),
    ("int[3] left", "int[3]", "`int`", "did you mean `int32`?", "int32"),
    ("uint left", "uint", "`uint`", "did you mean `uint32`?", "uint32"),
    ("integer left", "integer", "`integer`", "did you mean `int32`?", "int32"),
    ("long left", "long", "`long`", "did you mean `int64`?", "int64"),
    ("short left", "short", "`short`", "did you mean `int16`?", "int16"),
    ("float left", "float", "`float`", "did you mean `float64`?", "float64"),
    ("double left", "double", "`double`", "did you mean `float64`?", "float64"),
    ("str left", "str", "`str`", "did you mean `string`?", "string"),
    ("text left", "text", "`text`", "did you mean `string`?", "string"),
    ("boolean left", "boolean", "`boolean`", "did you mean `bool`?", "bool"),
    ("uint8_t left", "uint8_t", "`uint8_t`", "did you mean `uint8`?", "uint8"),
    ("flot64 left", "flot64", "`flot64`", "did you mean `float64`?", "float64"),
]


def fixed(text: str) -> str:
    [found] = run(text, "rclpy").diagnostics
    assert found.fix is not None
    [edit] = found.fix.edits
    return f"{text[: edit.span.start]}{edit.text}{text[edit.span.end :]}"


@pytest.mark.parametrize(
    ("before", "behind"),
    [("create_message_type B with ", "\n"), (f'{A}A has_field "', '"\n')],
    ids=["made", "changed"],
)
@pytest.mark.parametrize("case", SLIPS, ids=[each[0] for each in SLIPS])
def test_a_slip_in_a_field(
    case: tuple[str, str, str, str, str | None], before: str, behind: str
) -> None:
    field, where, message, remedy, right = case
    text = f"{before}{field}{behind}"
    [found] = run(text, "rclpy").diagnostics
    assert marked(text, found) == where
    assert message in found.message and found.help == remedy
    assert right is not None and fixed(text).startswith(f"{before}{right}")
    assert list(run(fixed(text), "rclpy").diagnostics) == []


@pytest.mark.parametrize(
    "statement",
    [
        f'{A}A has_field "string y \\ud800"',
        'create_message_type B with string x default "\\ud800"',
    ],
)
def test_half_of_a_surrogate_pair_is_no_text(statement: str) -> None:
    [found] = run(f"{statement}\n", "rclpy").diagnostics
    assert "surrogate pair" in found.message


def test_a_colon_in_quotes() -> None:
    assert fixed(f'{A}A has_field "y: float64"\n') == f'{A}A has_field "float64 y"\n'


@pytest.mark.parametrize(
    ("text", "remedy"),
    [
        ("create_message_type B with float64 left = 0.5\n", "`float64 left default 0.5`"),
        (f'{A}A has_field "float64 left = 0.5"\n', "`float64 left 0.5`"),
        (f'{A}A has_field "float64 left=0.5"\n', "`float64 left 0.5`"),
    ],
)
def test_a_constant_that_was_to_be_a_default(text: str, remedy: str) -> None:
    [found] = run(text, "rclpy").diagnostics
    assert marked(text, found) == "left"
    assert (found.help or "").startswith("use upper-case letters")
    assert (found.help or "").endswith(f"{DEFAULT}{remedy}")


@pytest.mark.parametrize("field", ["uint8 Max = 3", "uint8 class = 3"])
def test_a_name_of_no_field_gets_no_default(field: str) -> None:
    [found] = run(f"create_message_type B with {field}\n", "rclpy").diagnostics
    assert DEFAULT not in (found.help or "")


def test_where_a_type_is_made_is_shown() -> None:
    text = "create_message_type B with A a\ncreate_message_type A with int32 x\n"
    [found] = run(text, "rclpy").diagnostics
    [label] = found.labels
    start, end = label.span
    assert text[start:end] == "create_message_type A with int32 x"
