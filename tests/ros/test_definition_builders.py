"""What the builders of ROS take is read here as they read it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from machine import skip_or_fail

from plastron_tui.ros.definition import parse_definition
from plastron_tui.ros.definition_edits import replace_member
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

NAME = InterfaceName("own", "A")


# A line, and why it is refused here though `rosidl_adapter` takes it; None where both agree.
LINES = [
    ("int8 x", None),
    ("int8  x  5 # five", None),
    ("int8 x 128", None),
    ("int8 x = 1", None),
    ("int8 x 1_0", None),
    ("byte b 0x41", None),
    ("char c 256", None),
    ("int8[2] a [1]", None),
    ("int8[<=2] a [1, 2]", None),
    ("int8[] a [1,]", None),
    ("bool[] b [true, 0]", None),
    ("string s hello world", None),
    ("string s 'it\\'s'", None),
    ('string s "say \\"x\\""', None),
    ('wstring s "日本"', None),
    ("string<=3 s 日本語", None),
    ("string<=3 s abcd", None),
    ("string X=", None),
    ("string<=3 s 'a\\tb'", None),
    ("string<=4 s 'abc\\t'", None),
    ("string<=3[] s ['a\\tb']", None),
    ("string<=3 s 'a\tb'", None),
    ("string\ts\t'a\tb' # c\td", None),
    ("int8 a\nint8 a", None),
    ("int8 a\nint8 A=1", None),
    ("int8 é", None),
    ("int8 class", "C++ has the word"),
    ("int8 lambda", "Python has the word"),
    ("int8 linux", "a macro of the compiler"),
    ("int8 get_fields_and_field_types", "the generated class has a method of this name"),
    ("float32 x 3.4e39", "is not finite as a float32"),
    ("float64 x nan", "reaches the IDL as a text"),
]


@pytest.mark.parametrize(("text", "reason"), LINES)
def test_rosidl_adapter_takes_the_same_lines(text: str, reason: str | None) -> None:
    try:
        from rosidl_adapter import parser
    except ImportError:
        skip_or_fail("rosidl_adapter is not installed")
    found = parse_definition(text, NAME, InterfaceKind.MESSAGE, 2, is_new=True).interface
    try:
        spec = parser.parse_message_string("own", "A", text)
    except (SystemExit, Exception):
        assert found is None
        return
    assert (found is None) == (reason is not None)
    if found is None:
        return
    fields = [(each.name, each.default_value) for each in spec.fields]
    plain = [
        list(each.default) if isinstance(each.default, tuple) else each.default
        for each in found.fields
    ]
    assert [(each.name, value) for each, value in zip(found.fields, plain, strict=True)] == fields
    constants = [(each.name, each.value) for each in spec.constants]
    assert [(each.name, each.value) for each in found.sections[0].constants] == constants


def installed(share: Path) -> Iterator[Path]:
    return (file for kind in InterfaceKind for file in share.glob(f"*/{kind.value}/*.{kind.value}"))


@pytest.mark.parametrize("version", [1, 2])
def test_what_is_installed_is_read(version: int) -> None:
    shares = {1: Path("/usr/share"), 2: Path(__file__).parents[2] / ".venv" / "share"}
    files = sorted(installed(shares[version]))
    if not files:
        skip_or_fail(f"no definitions of ROS {version} are installed")
    for file in files:
        name = InterfaceName(file.parts[-3], file.stem)
        kind = InterfaceKind(file.suffix[1:])
        assert parse_definition(file.read_bytes(), name, kind, version).diagnostics == (), file


@pytest.mark.parametrize(
    "line",
    ["int8 serialize", "int8 deserialize_numpy", "int8 Ptr", "int8 unix", "int8 NULL=1"],
)
def test_names_that_the_generated_code_has(line: str) -> None:
    assert parse_definition(line, NAME, InterfaceKind.MESSAGE, 1).interface is not None
    new = parse_definition(line, NAME, InterfaceKind.MESSAGE, 1, is_new=True)
    assert new.interface is None


@pytest.mark.parametrize(
    ("before", "line", "after"),
    [
        (b"string X=a # b\n", "string X=c", b"string X=c\n"),
        (b"int8 X=1 # b\r\n", "string X=c", b"# b\r\nstring X=c\r\n"),
        (b"int8 X=1 # b\n", "int8 X=2", b"int8 X=2 # b\n"),
    ],
)
def test_a_string_constant_of_ros_1_has_no_comment(before: bytes, line: str, after: bytes) -> None:
    assert replace_member(before, "X", line, ros_version=1) == after
