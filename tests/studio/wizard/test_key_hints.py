"""The keys of a page look as those of the studio."""

from __future__ import annotations

import pytest

from plastron_tui.studio.wizard.key_hints import drawn_keys


@pytest.mark.parametrize(
    ("words", "shown", "keys"),
    [
        ("Enter next  ↑↓ choice", "Enter Next  ↑↓ Choice", ["Enter", "↑↓"]),
        ("↑↓ Enter choose  F2 back", "↑↓ Enter Choose  F2 Back", ["↑↓ Enter", "F2"]),
        ("Enter code and graph", "Enter Code and graph", ["Enter"]),
        ("Esc", "Esc", ["Esc"]),
    ],
)
def test_keys_are_set_apart_from_what_they_do(words: str, shown: str, keys: list[str]) -> None:
    drawn = drawn_keys(words)
    assert drawn.plain == shown
    assert [drawn.plain[span.start : span.end] for span in drawn.spans] == keys
