from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.ros.definition import (
    MAX_DEFINITION_BYTES,
    Definition,
    first_sentence,
    parse_definition,
)
from plastron_tui.ros.definition_text import format_definition
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName

NAME = InterfaceName("pkg", "Thing")


def read(text: str | bytes, version: int, kind: str = "msg") -> Definition:
    return parse_definition(text, NAME, InterfaceKind(kind), version)


def interface(text: str | bytes, version: int, kind: str = "msg") -> Interface:
    definition = read(text, version, kind)
    assert definition.diagnostics == ()
    assert definition.interface is not None
    return definition.interface


# (line, ROS version, name, type, default)
FIELDS = [
    ("float64 x", 1, "x", "float64", None),
    ("float64\tx", 2, "x", "float64", None),
    ("  float64   x   # metres", 1, "x", "float64", None),
    ("float64 x#metres", 1, "x", "float64", None),
    ("float64[36] covariance", 1, "covariance", "float64[36]", None),
    ("string[] name", 1, "name", "string[]", None),
    ("Header header", 1, "header", "std_msgs/Header", None),
    ("Header[] headers", 1, "headers", "std_msgs/Header[]", None),
    ("Point p", 1, "p", "pkg/Point", None),
    ("geometry_msgs/Point[] points", 1, "points", "geometry_msgs/Point[]", None),
    ("time stamp", 1, "stamp", "time", None),
    ("duration[2] d", 1, "d", "duration[2]", None),
    ("float64[9]  K # 3x3", 1, "K", "float64[9]", None),
    ("byte level", 1, "level", "byte", None),
    ("char c", 2, "c", "char", None),
    ("std_msgs/Header header", 2, "header", "std_msgs/Header", None),
    ("Header header", 2, "header", "pkg/Header", None),
    ("string<=22 s", 2, "s", "string<=22", None),
    ("string<=5[<=10] s", 2, "s", "string<=5[<=10]", None),
    ("float64[<=3] dimensions", 2, "dimensions", "float64[<=3]", None),
    ("wstring w", 2, "w", "wstring", None),
    ("float64 w 1", 2, "w", "float64", 1.0),
    ("int8 x -5 # five", 2, "x", "int8", -5),
    ("bool b true", 2, "b", "bool", True),
    ('string s "a - b" # c', 2, "s", "string", "a - b"),
    ("string s 'it\\'s'", 2, "s", "string", "it's"),
    ("string s hello", 2, "s", "string", "hello"),
    ("int32[] a [1, 2]", 2, "a", "int32[]", (1, 2)),
    ("int32[3] a [1, 2, 3]", 2, "a", "int32[3]", (1, 2, 3)),
    ('string[] a ["x, y", "z"]', 2, "a", "string[]", ("x, y", "z")),
    ("int32[] a []", 2, "a", "int32[]", ()),
    ("uint8 x 0x1F", 2, "x", "uint8", 31),
]


@pytest.mark.parametrize(("line", "version", "name", "type_", "default"), FIELDS)
def test_a_field(line: str, version: int, name: str, type_: str, default: object) -> None:
    (field,) = interface(line, version).fields
    assert (field.name, str(field.type), field.default) == (name, type_, default)


CONSTANTS = [
    ("int32 X=123", 1, 123),
    ("int32 X = -123 # why", 1, -123),
    ("byte OK=0", 1, 0),
    ("float64 X=1e-3", 1, 0.001),
    ("bool B=True", 1, True),
    ('string X=  "quoted" # not a comment  ', 1, '"quoted" # not a comment'),
    ("string X=", 1, ""),
    ("string X=a=b", 1, "a=b"),
    ('string X="a = b" # comment', 2, "a = b"),
    ("string X='hi'", 2, "hi"),
    ("uint8 X_2=0x0f", 2, 15),
    ("char X=65", 2, 65),
]


@pytest.mark.parametrize(("line", "version", "value"), CONSTANTS)
def test_a_constant(line: str, version: int, value: object) -> None:
    (constant,) = interface(line, version).sections[0].constants
    assert constant.value == value
    assert type(constant.value) is type(value)


# (line, ROS version, the part that is wrong, the start of the message)
MISTAKES = [
    ("float64", 1, "float64", "this line is neither"),
    ("float64 # x", 1, "float64", "this line is neither"),
    ("???", 1, "???", "this line is neither"),
    ("float64 9x", 1, "9x", "`9x` cannot name a field"),
    ("float64 X", 2, "X", "`X` cannot name a field"),
    ("float64 a__b", 2, "a__b", "`a__b` cannot name a field"),
    ("float64 a_", 2, "a_", "`a_` cannot name a field"),
    ("int32 x=1", 2, "x", "`x` cannot name a constant"),
    ("int8 x 5", 1, "5", "a field of ROS 1 has no default value"),
    ("int8 x 500", 2, "500", "500 does not fit `int8`"),
    ("int8 x y", 2, "y", "`y` is not a value of `int8`"),
    ("Point p 5", 2, "5", "only a field of a primitive type"),
    ("int8[] a 5", 2, "5", "the default value of an array"),
    ("int8[2] a [1]", 2, "[1]", "1 elements do not fit `int8[2]`"),
    ("int8[<=2] a [1,2,3]", 2, "[1,2,3]", "3 elements do not fit"),
    ("int8[<=] a", 2, "[<=]", "the bound of this sequence is missing"),
    ("string<=5 s", 1, "<=5", "ROS 1 has no bounded types"),
    ("int8[<=5] s", 1, "[<=5]", "ROS 1 has no bounded types"),
    ("int8<=5 s", 2, "<=5", "only a string has a bound"),
    ("wstring w", 1, "wstring", "`wstring` is no type of ROS 1"),
    ("time t", 2, "time", "`time` is no type of ROS 2"),
    ("flaot64 x", 2, "flaot64", "`flaot64` is no type of ROS 2"),
    ("a/b/c/D x", 1, "a/b/c/D", "`a/b/c/D` is no type of ROS 1"),
    ("/D x", 1, "/D x", "this line is neither"),
    ("uint8 X=256", 1, "256", "256 does not fit `uint8`"),
    ("uint8 X=" + "9" * 5000, 1, "9" * 5000, "`999"),
    ("Point X=5", 1, "Point", "a constant is of a primitive type"),
    ("time T=5", 1, "time", "a constant is of a primitive type"),
    ("bool B=maybe", 1, "maybe", "`maybe` is not a `bool`"),
    ("bool B=true", 1, "true", "`true` is not a `bool`"),
    ("uint8 X=0x1F", 1, "0x1F", "`0x1F` is not a value"),
    ("float64\tx", 1, "\t", "ROS 1 wants a space"),
    ("  float64 x", 2, "  ", "a field or constant of ROS 2 starts"),
    ("std_msgs/msg/Header h", 2, "std_msgs/msg/Header", "`std_msgs/msg/Header` is no type"),
    ("int8[0] a", 2, "[0]", "an array of ROS 2"),
    ("string<=0 a", 2, "<=0", "a string of ROS 2"),
    ("My_pkg/A a", 2, "My_pkg/A", "`My_pkg/A` is no type"),
    ('string s "a=b"', 2, '"a=b"', "ROS 2 takes a line with `=`"),
    ('string X="a # b"', 2, '"a # b"', "in a ROS 2 definition `#`"),
    ("float64 x inf", 2, "inf", "a definition has no infinity"),
    ("string<=2 s abc", 2, "abc", "3 characters do not fit"),
]


@pytest.mark.parametrize(("line", "version", "wrong", "message"), MISTAKES)
def test_a_mistake_is_marked_on_its_line(line: str, version: int, wrong: str, message: str) -> None:
    before = "# grün\r\nbool fine_before\r\n"
    definition = read(f"{before}{line}\nbool fine_after\n", version)
    assert definition.interface is None
    (diagnostic,) = definition.diagnostics
    assert diagnostic.message.startswith(message)
    assert diagnostic.span is not None
    text = f"{before}{line}\n".encode()
    assert text[diagnostic.span.start : diagnostic.span.end].decode() == wrong


def test_two_members_of_one_name() -> None:
    (diagnostic,) = read("int8 x\nint8 x\n", 1).diagnostics
    assert diagnostic.message == "`x` is there twice"
    assert interface("int8 x\n---\nint8 x\n", 1, "srv").response.fields[0].name == "x"


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("", "msg", 1),
        ("---", "srv", 2),
        ("---\n", "srv", 2),
        ("int8 a\n---\nint8 b\n---\nint8 c", "action", 3),
    ],
)
def test_sections(text: str, kind: str, count: int) -> None:
    assert len(interface(text, 1, kind).sections) == count


@pytest.mark.parametrize(
    ("text", "kind"), [("---", "msg"), ("", "srv"), ("---\n---", "srv"), ("---", "action")]
)
def test_a_wrong_number_of_sections(text: str, kind: str) -> None:
    (diagnostic,) = read(text, 1, kind).diagnostics
    assert f"a `.{kind}` definition has" in diagnostic.message


def test_comments_say_what_the_type_and_its_fields_are() -> None:
    text = (
        "# A thing. It is nice.\n# More.\n\n"
        "# the first of\n# two lines\nint8 x\nint8 y # the second; e.g. a number\nint8 z\n"
    )
    found = interface(text, 1)
    assert found.comment == "A thing"
    comments = [field.comment for field in found.fields]
    assert comments == ["the first of two lines", "the second; e.g. a number", ""]


@pytest.mark.parametrize(
    ("lines", "sentence"),
    [
        ([], ""),
        (["=====", "", "Text"], "Text"),
        (["One", "Two"], "One"),
        (["A\u202eB\x07"], "AB"),
        (["word " * 100], "word " * 30 + "word…"),
    ],
)
def test_first_sentence(lines: list[str], sentence: str) -> None:
    assert first_sentence(lines) == sentence


def test_files_that_are_not_what_they_should_be() -> None:
    assert read(b"\x00\xff\xfe\x80 binary", 1).interface is None
    assert read(b"x" * (MAX_DEFINITION_BYTES + 1), 1).interface is None
    assert interface(b"\xef\xbb\xbfint8 x\r\n", 1).fields[0].name == "x"
    assert interface(b"int8 x # caf\xe9\n", 1).fields[0].name == "x"
    assert read(b"string X=caf\xe9\n", 1).interface is None


_WORDS = st.sampled_from(
    [
        "int8",
        "string",
        "float64[]",
        "Header",
        "x",
        "y",
        "X",
        "=1",
        "=",
        "1",
        "[1,2]",
        "<=3",
        "[",
        "]",
        "#",
        "---",
        "\n",
        "\n",
        "\t",
        "'",
        '"',
        "\\",
        "pkg/A",
        "\x00",
        "é",
    ]
)


@given(st.lists(_WORDS), st.sampled_from([1, 2]), st.sampled_from(list(InterfaceKind)))
def test_any_text_is_read_or_reported_and_is_written_as_it_was_read(
    words: list[str], version: int, kind: InterfaceKind
) -> None:
    text = " ".join(words)
    definition = parse_definition(text, NAME, kind, version)
    assert (definition.interface is None) == bool(definition.diagnostics)
    for diagnostic in definition.diagnostics:
        if diagnostic.span is not None:
            assert 0 <= diagnostic.span.start <= diagnostic.span.end <= len(text.encode())
    if definition.interface is not None:
        written = format_definition(definition.interface, version)
        again = parse_definition(written, NAME, kind, version)
        assert again.interface == definition.interface


@pytest.mark.parametrize(("word", "version"), [("class", 1), ("class", 2), ("lambda", 2)])
def test_only_a_new_definition_is_held_against_words_of_languages(word: str, version: int) -> None:
    name = InterfaceName("pkg", "Thing")
    there = parse_definition(f"int8 {word}\n", name, InterfaceKind.MESSAGE, version)
    assert there.interface is not None
    new = parse_definition(f"int8 {word}\n", name, InterfaceKind.MESSAGE, version, is_new=True)
    [found] = new.diagnostics
    assert found.message.startswith(f"`{word}` cannot name a field: it is a word of")
