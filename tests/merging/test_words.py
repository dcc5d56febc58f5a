"""What a merge asks of a text: by its tree, so that strings and comments are no code."""

from __future__ import annotations

import pytest

from plastron_tui.sources.python.words import definitions, mentions

TEXT = b'''\
"""def on_a(message): on_b"""
from a.msg import (
    One,  # on_b
    Two,
)
import b; import c


class A:
    def on_a(self, message):
        # on_b is not called
        "on_b"
        self.on_c(1)

    def on_aa(self): return 2


def on_a(): pass
'''


@pytest.mark.parametrize(
    ("name", "defined", "mentioned"),
    [
        ("on_a", 2, True),
        ("on_b", 0, False),
        ("on_c", 0, True),
        ("on_aa", 1, True),
        ("on", 0, False),
    ],
)
def test_names(name: str, defined: int, mentioned: bool) -> None:
    for text in (TEXT, TEXT.replace(b"\n", b"\r\n"), b"# coding: latin-1\n# \xe4\n" + TEXT):
        assert (definitions(text, name), mentions(text, name)) == (defined, mentioned)
