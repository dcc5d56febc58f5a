"""JSON of names that are no text."""

from __future__ import annotations

import json

import pytest

from plastron_tui.diagnostics.json_text import json_text


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("a", "a"),
        ("ä\U0001f600", "ä\U0001f600"),
        ("a\udcff.py", r"a\udcff.py"),
        ("\U0001f600\udcff\udcfe\U0001f600", "\U0001f600\\udcff\\udcfe\U0001f600"),
        ("\\udcff", "\\udcff"),
        ("\\\udcff", "\\\\udcff"),
    ],
)
def test_half_a_pair_is_no_character(text: str, read: str) -> None:
    said = json_text({text: [text]})
    assert json.loads(said) == {read: [read]}
    said.encode("ascii")
    json.loads(said)[read][0].encode()
