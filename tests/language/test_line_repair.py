from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from plastron_programs import read
from slips import SLIPS

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.language import DECLARATIONS
from plastron_tui.language.keywords import KEYWORDS, WORDS
from plastron_tui.language.line_repair import repaired
from plastron_tui.language.repair_certainty import LIBRARIES
from plastron_tui.language.repair_words import QOS_WORDS as KNOWN_QOS
from plastron_tui.language.syntax_errors import MOST_REPAIRED_LINES
from plastron_tui.ros.qos_words import WORDS as QOS_WORDS
from plastron_tui.targets import has_target

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


def _is_unfinished(text: str) -> bool:
    """Tell whether the one mistake of a program is that a line ends too early."""
    (left,) = read(text).diagnostics
    end = len(text.removesuffix(AFTER).encode())
    return left.span is not None and left.span.end == end


@settings(max_examples=examples(150), deadline=None)
@given(slips())
def test_a_fix_leaves_no_mistake_on_its_line_and_others_alone(line: str) -> None:
    text = f"{BEFORE}{line}{AFTER}"
    for found in read(text).diagnostics:
        if found.fix is not None:
            made = mended(text, found)
            assert made.startswith(BEFORE) and made.endswith(AFTER)
            assert "\n" not in made[len(BEFORE) : -len(AFTER)]
            left = read(made).diagnostics
            # A word that is put right in a line that is not all there is a fix by itself.
            is_spelling = found.fix.edits[0].text in WORDS
            assert not left or (is_spelling and _is_unfinished(made)), made


BEGINNINGS = sorted(
    {example[:end].rstrip() for example in EXAMPLES for end in range(1, len(example))}
)


def _keeps_to_its_sentence(line: str, made: str) -> bool:
    """Tell whether a fix writes a beginning of the sentence, or only puts something behind it."""
    word = line.rpartition(" ")[2].rpartition("=")[2]
    sentences = [each for each in (*EXAMPLES, *KEYWORDS) if each.startswith(line)]
    return (
        made.startswith(line)
        or made.endswith(f'"{word}"')
        or any(each.startswith(made) for each in sentences)
    )


def test_a_fix_of_what_is_being_typed_keeps_to_its_sentence() -> None:
    wrong = []
    for line in BEGINNINGS:
        text = f"{BEFORE}{line}{AFTER}"
        for found in read(text).diagnostics:
            if found.fix is not None:
                made = mended(text, found).removeprefix(BEFORE).removesuffix(AFTER)
                if not _keeps_to_its_sentence(line, made):
                    wrong.append((line, made))
    assert not wrong


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


def test_words_that_slots_are_filled_with_are_those_there_are() -> None:
    assert set(QOS_WORDS) == KNOWN_QOS
    assert all(map(has_target, LIBRARIES))
