"""What a language says of a text: one that cannot tell does not judge it as Python."""

from __future__ import annotations

import pytest

from plastron_tui.sources import find_language
from plastron_tui.sources.base import Language

LISP = b"(defun f (x) ; f\n  (print x))\n\n"
BROKEN = b"def f(:\n"
MIXED = b"if 1:\n\tif 2:\n        f()\n"
PYTHON = b"import os\n\ndef f():\n    return 'g'\n"


class Lisp(Language):
    name = "lisp"
    title = "Lisp"
    suffixes = (".lisp",)


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
def test_a_python_text_is_worse_than_those_it_came_from(
    text: bytes, others: list[bytes], is_worse: bool
) -> None:
    assert find_language("python").is_worse(text, *others) == is_worse


def test_a_text_of_another_language_is_taken_as_it_is() -> None:
    language = Lisp()
    assert not language.is_worse(LISP, PYTHON)
    assert language.definitions(LISP, "f") == 0
    assert language.mentions(LISP, "f")
    assert not language.mentions(LISP, "g")


def test_a_python_text_is_looked_into() -> None:
    language = find_language("python")
    assert language.definitions(PYTHON, "f") == 1
    assert not language.mentions(PYTHON, "g")
