"""What a target says of a text of its language: other languages are not judged as Python."""

from __future__ import annotations

import pytest

from plastron_tui.targets import find_target
from plastron_tui.targets.base import Target

LISP = b"(defun f (x) ; f\n  (print x))\n\n"
BROKEN = b"def f(:\n"
MIXED = b"if 1:\n\tif 2:\n        f()\n"
PYTHON = b"import os\n\ndef f():\n    return 'g'\n"


class Lisp(Target):
    name = "roslisp"
    ros_version = 1
    suffix = ".lisp"


@pytest.mark.parametrize(
    ("text", "others", "is_worse"),
    [
        (PYTHON, [PYTHON], False),
        (BROKEN, [PYTHON], True),
        (MIXED, [PYTHON], True),
        (BROKEN, [PYTHON, BROKEN], False),
        (MIXED, [MIXED], False),
    ],
)
@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_a_python_text_is_worse_than_those_it_came_from(
    library: str, text: bytes, others: list[bytes], is_worse: bool
) -> None:
    target = find_target(library)
    assert target is not None
    assert target.is_worse(text, *others) == is_worse


def test_a_text_of_another_language_is_taken_as_it_is() -> None:
    target = Lisp()
    assert not target.is_worse(LISP, PYTHON)
    assert target.definitions(LISP, "f") == 0
    assert target.mentions(LISP, "f")
    assert not target.mentions(LISP, "g")
    assert sorted(target.lines_of_code(LISP)) == [b"(defun f (x) ; f", b"(print x))"]


def test_a_python_text_is_looked_into() -> None:
    target = find_target("rospy")
    assert target is not None
    assert target.definitions(PYTHON, "f") == 1
    assert not target.mentions(PYTHON, "g")
    assert sorted(target.lines_of_code(PYTHON)) == [b"def f():", b"return 'g'"]
