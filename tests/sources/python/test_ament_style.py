"""The style of a file in a package of ROS 2."""

from __future__ import annotations

import ast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.sources.python.ament_style import ament_style
from plastron_tui.sources.python.literals import string

STYLED = {
    "quotes": ('print("a", f"{b}", b"c")\n', "print('a', f'{b}', b'c')\n"),
    "a quote within": ("""print("it's", f"{a['b']}")\n""", """print("it's", f"{a['b']}")\n"""),
    "an escaped quote": ('print("a \\"b\\" \'c\'")\n', 'print("a \\"b\\" \'c\'")\n'),
    "a text of several parts": ('x = ("a"\n     r"\\b")\n', "x = ('a'\n     r'\\b')\n"),
    "a docstring": ('"""The node "a"."""\n', '"""The node "a"."""\n'),
    "a long docstring": (
        'class A:\n    """One.\n\n    Two.\n    """\n',
        'class A:\n    """\n    One.\n\n    Two.\n    """\n',
    ),
    "a text that is no docstring": ('x = """a\nb"""\n', 'x = """a\nb"""\n'),
    "names": (
        "from a import C, b, d as A\nfrom b import (\n    Z,\n    y,\n)\n",
        "from a import b, C, d as A\nfrom b import (\n    y,\n    Z,\n)\n",
    ),
    "modules": (
        "import rclpy\nfrom Z import a\nfrom a.b import c\nimport sys\nfrom __future__ import d\n",
        "from __future__ import d\n\nimport sys\n\nfrom a.b import c\nimport rclpy\n"
        "from Z import a\n",
    ),
    "a comment among imports": ("import c\nimport b\n# x\nimport a\n", "import b\nimport c\n# x\n"
                                "import a\n"),
    "no Python": ('print("a"\n', 'print("a"\n'),
    "nothing": ("", ""),
}  # fmt: skip


@pytest.mark.parametrize(("before", "after"), STYLED.values(), ids=STYLED)
def test_style(before: str, after: str) -> None:
    assert ament_style(before.encode()).decode() == after
    assert ament_style(after.encode()).decode() == after


@given(st.text(st.characters(codec="utf-8")))
def test_texts_stay_the_same(value: str) -> None:
    styled = ament_style(f"x = {string(value)}\n".encode())
    assert ast.literal_eval(styled.decode().removeprefix("x = ")) == value
