from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from plastron_programs import read
from slips import SLIPS

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.language import DECLARATIONS
from plastron_tui.language.line_repair import repaired
from plastron_tui.language.syntax_errors import MOST_REPAIRED_LINES

EXAMPLES = [declaration.example for declaration in DECLARATIONS.values()]
STRAY = ["of", "to", "with", "the", "is", "=", "type", "at", "and", "5", "x", "'a'", "for_each"]
BEFORE, AFTER = "// é\ncreate_node 'a' as a\n", "\ngenerate_node a\n"


def mended(text: str, found: Diagnostic) -> str:
    assert found.fix is not None
    made = text.encode()
    for edit in sorted(found.fix.edits, key=lambda edit: edit.span, reverse=True):
        made = made[: edit.span.start] + edit.text.encode() + made[edit.span.end :]
    return made.decode()


@pytest.mark.parametrize(("line", "right"), SLIPS.items(), ids=list(SLIPS))
def test_a_slip_has_the_fix_that_is_meant(line: str, right: str | None) -> None:
    text = f"{BEFORE}{line}{AFTER}"
    (found,) = read(text).diagnostics
    assert (None if found.fix is None else mended(text, found)) == (
        None if right is None else f"{BEFORE}{right}{AFTER}"
    )
    assert right is None or not read(right).diagnostics


@st.composite
def slips(draw: st.DrawFn) -> str:
    """A statement with one or two words left out, doubled, put elsewhere, or others than meant."""
    words = draw(st.sampled_from(EXAMPLES)).split(" ")
    for _ in range(draw(st.integers(1, 2))):
        at = draw(st.integers(0, len(words) - 1))
        word = words.pop(at)
        other = draw(st.sampled_from([*STRAY, word]))
        change = draw(st.sampled_from(["left out", "doubled", "elsewhere", "another", "more"]))
        if change == "elsewhere":
            words.insert(draw(st.integers(0, len(words))), word)
        else:
            more = {"doubled": [word, word], "another": [other], "more": [other, word]}
            words[at:at] = more.get(change, [])
        words = words or [word]
    return " ".join(words)


@settings(max_examples=examples(150), deadline=None)
@given(slips())
def test_a_fix_leaves_no_mistake_on_its_line_and_others_alone(line: str) -> None:
    text = f"{BEFORE}{line}{AFTER}"
    for found in read(text).diagnostics:
        if found.fix is not None:
            made = mended(text, found)
            assert made.startswith(BEFORE) and made.endswith(AFTER)
            assert "\n" not in made[len(BEFORE) : -len(AFTER)]
            assert not read(made).diagnostics, made


def test_long_lines_are_not_tried() -> None:
    (found,) = read(f"create_message m of type T and input {', '.join('1' * 300)}").diagnostics
    assert found.fix is None


def test_what_two_changes_could_mean_has_no_fix() -> None:
    # `calling` or `qos` is missing, and `on_cmd` could follow both.
    assert repaired(b"subscribe b to 'c' of message_type T with on_cmd") is None


def test_only_so_many_lines_are_tried() -> None:
    slip = "n publish m to 'a' of type T\n"
    found = read(slip * (MOST_REPAIRED_LINES + 2)).diagnostics
    assert [each.fix is None for each in found] == [*[False] * MOST_REPAIRED_LINES, True, True]
