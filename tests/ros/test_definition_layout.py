"""A member comes into a definition as its neighbours are laid out."""

from __future__ import annotations

import pytest

from plastron_tui.ros.definition_edits import add_member, replace_member

WHEELS = (
    b"float64   left     # [m/s]  left wheel\n"
    b"float64   right    # [m/s]  right wheel\n"
    b"uint8     state    # one of\n"
)
STATES = b"uint8 OK  = 0\nuint8 BAD = 1\n"

# A definition, a line, and the line as it is written.
LAID_OUT = [
    (WHEELS, "float32 slip # how far", b"float32   slip     # how far"),
    (WHEELS, "float32 slip", b"float32   slip"),
    (WHEELS, "geometry_msgs/Point p  # a", b"geometry_msgs/Point p  # a"),
    (WHEELS, "float64 a_long_name # b", b"float64   a_long_name # b"),
    (STATES, "uint8 C=2", b"uint8 C   = 2"),
    (STATES, "uint8 WORSE=2", b"uint8 WORSE = 2"),
    (STATES, "string TEXT=a  # b", b"string TEXT = a  # b"),
    (b"uint8 A=0\n", "uint8 B = 1", b"uint8 B=1"),
    (b"uint8 A   =   1\nfloat64 x  2\nfloat64 y  2\n", "int8 z 3", b"int8 z     3"),
    (b"float64 left  # a\n", "int8 x # b", b"int8 x # b"),
    (b"float64 a  # a\nfloat64 b  # b\n", "int8 x # b", b"int8 x     # b"),
    (b"float64\ta\t# a\nfloat64\tb\t# b\n", "int8 x # b", b"int8 x # b"),
    (b"int8    a 1\nfloat64 b 2.5\n", "int8 x 3", b"int8    x 3"),
    (b"  int8 a\n", "int8 x", b"  int8 x"),
]


@pytest.mark.parametrize(("text", "line", "written"), LAID_OUT)
def test_a_new_member_is_laid_out_as_the_others(text: bytes, line: str, written: bytes) -> None:
    assert add_member(text, line) == text + written + b"\n"


def test_a_constant_comes_after_the_constants() -> None:
    text = b"uint8 A=0\n\n# it\nuint8 state\n"
    assert add_member(text, "uint8 B=1") == b"uint8 A=0\nuint8 B=1\n\n# it\nuint8 state\n"


def test_a_replaced_member_keeps_its_columns() -> None:
    assert replace_member(WHEELS, "state", "uint16 state").endswith(
        b"uint16    state    # one of\n"
    )
    short = b"float64 left   # a\nfloat64 right  # b\n"
    assert replace_member(short, "right", "int8 right").endswith(b"int8 right     # b\n")
