"""The value of a literal is what Python says it is, whether Python has to be asked or not."""

from __future__ import annotations

import ast
from itertools import product

import pytest

from plastron_tui.sources.python.literals import value_of

_PARTS = ("", "a", "é", "/", "'", '"', "\\", "\n", "\r", "\0", "\t", "\f", "{", "\udc80")


@pytest.mark.filterwarnings("ignore:invalid escape")
@pytest.mark.parametrize("prefix", ["", "r", "b", "f", " "])
@pytest.mark.parametrize("quote", ["'", '"'])
def test_a_string_has_the_value_that_python_gives_it(prefix: str, quote: str) -> None:
    for parts in product(_PARTS, _PARTS, ("", "a")):
        literal = f"{prefix}{quote}{''.join(parts)}{quote}"
        try:
            wanted = ast.literal_eval(literal)
        except (ValueError, SyntaxError):
            with pytest.raises((ValueError, SyntaxError)):
                value_of(literal)
        else:
            assert value_of(literal) == wanted
