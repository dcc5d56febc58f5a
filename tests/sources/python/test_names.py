"""Which names the reader takes from the file, and which it leaves unknown."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.kinds import EDITABLE
from plastron_tui.sources.python import read_python

HEAD = "import sys\nimport rospy\nfrom std_msgs.msg import Int8, String\n"


def names(body: str) -> list[str | None]:
    """Read rospy code; return the names of its endpoints, a default in brackets."""
    source = read_python(Path("x.py"), one((HEAD + body).encode()), "rospy").source
    assert source is not None
    return [
        each.name if each.default is None else f"[{each.default}]"
        for each in source.endpoints
        if each.kind in EDITABLE
    ]


USE = "rospy.Publisher(t, String)\n"

VALUES_ONE_BY_ONE = [
    (f"t = 'a'\n{USE}t = 'b'\n{USE}", ["a", "b"]),
    (f"t = 'a'\nif t:\n    {USE}    t = 'b'\n    {USE}{USE}", ["a", "b", None]),
    (f"if sys.argv:\n    t = 'a'\nelse:\n    t = 'b'\n{USE}", [None]),
    (f"t = 'a'\ntry:\n    t = 'b'\nexcept OSError:\n    pass\n{USE}", [None]),
    (f"t = 'a'\nwhile t:\n    {USE}    t = 'b'\n", [None]),
    (f"t = 'x'\nwhile t:\n    t = 'a'\n    {USE}    t = 'b'\n", ["a"]),
    (f"t = 'x'\nwhile t:\n    t += 'a'\n    {USE}", [None]),
    (f"t = 'a'\nt += '/b'\n{USE}", ["a/b"]),
    (f"def f():\n    t = 'a'\n    {USE}    t = 'b'\n", ["a"]),
    (f"def f(t='a'):\n    t = '/' + t\n    {USE}", ["/a"]),
    (f"t = 'a'\nt = 'b'\ndef f():\n    {USE}", [None]),
    (f"t = 'a'\ndef f():\n    global t\n    t = 'b'\nf()\n{USE}", [None]),
    (f"def f():\n    t = 'a'\n    def g():\n        nonlocal t\n        t = ''\n    {USE}", [None]),
    ("def f():\n    t = 'a'\n    [rospy.Publisher(t, String)]\n    t = 'b'\n", ["a"]),
    (f"for t in sys.argv:\n    t = 'a'\n    {USE}", ["a"]),
    (f"t = 'a'\nif (t := 'b'):\n    {USE}", [None]),
]  # fmt: skip


@pytest.mark.parametrize(("body", "expected"), VALUES_ONE_BY_ONE)
def test_a_line_sees_the_value_that_a_name_has_there(body, expected):
    assert names(body) == expected
