"""Lines of a text that give way, and the one edit that makes a text another one."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as some
from wizard_courses import MORE, SEND, choose, course, form_after, to_menu_or_review

from plastron_tui.diagnostics import Span
from plastron_tui.studio.wizard.replaced_lines import line_of, moved, whole_edit, without

TEXTS = some.lists(some.sampled_from([b"a", b"bb", b"\xc3\xbc", b""])).map(b"\n".join)


@pytest.mark.parametrize(
    ("text", "span", "line"),
    [
        (b"one\ntwo\nthree\n", Span(4, 7), b"two\n"),
        (b"one\ntwo\nthree\n", Span(0, 3), b"one\n"),
        (b"one\ntwo", Span(5, 6), b"two"),
        (b"one\n  two  # why\nthree", Span(6, 9), b"  two  # why\n"),
        (b"one\ntwo\nthree\n", Span(2, 5), b"one\ntwo\n"),
    ],
)
def test_a_line_is_taken_with_its_end(text: bytes, span: Span, line: bytes) -> None:
    start, end = line_of(text, span)
    assert text[start:end] == line


@given(TEXTS, TEXTS, TEXTS, TEXTS)
def test_a_span_is_found_again_once_the_text_has_grown(
    before: bytes, between: bytes, span: bytes, new: bytes
) -> None:
    old = before + between + span
    here = Span(len(before + between), len(old))
    grown = before + new + between + span
    found = moved(here, len(before), len(new))
    assert grown[found.start : found.end] == span
    # What stands before the place where something was written stays where it is.
    assert moved(Span(0, len(before)), len(before) + 1, len(new)) == Span(0, len(before))


@given(some.lists(some.tuples(TEXTS, some.booleans())))
def test_spans_are_found_again_once_others_are_gone(pieces: list[tuple[bytes, bool]]) -> None:
    spans, at = [], 0
    for piece, _ in pieces:
        spans.append(Span(at, at + len(piece)))
        at += len(piece)
    gone = [span for span, (_, goes) in zip(spans, pieces, strict=True) if goes]
    text = b"".join(piece for piece, goes in pieces if not goes)
    for span, (piece, goes) in zip(spans, pieces, strict=True):
        if not goes:
            found = without(span, gone)
            assert text[found.start : found.end] == piece


@given(TEXTS, TEXTS)
def test_one_edit_of_whole_lines_makes_a_text_another_one(old: bytes, new: bytes) -> None:
    (start, end), written = whole_edit(old, new)
    assert old[:start] + written.encode() + old[end:] == new
    assert start in (0, len(old)) or old[:start].endswith(b"\n")


DRIVER = """\
create_node 'driver' as driver
create_message sent of message_type Twist and input linear.x={speed}
driver publish sent to 'cmd_vel' of message_type Twist at 10 hz
generate_node driver
"""


def test_what_is_sent_at_a_rate_takes_the_place_of_nothing() -> None:
    it = course(DRIVER.format(speed=0.2))
    form = form_after(it, MORE, SEND)
    form.enter("topic", "cmd_vel")
    outcome = to_menu_or_review(it).outcome
    assert outcome is not None
    assert b"publish sent to 'cmd_vel'" in outcome.session.document.text
    assert sum("publish" in line for line in outcome.lines) == 1


@pytest.mark.parametrize(("speed", "replaced"), [(0.2, (3,)), (0, ())])
def test_what_stops_a_robot_at_a_rate_stays(speed: float, replaced: tuple[int, ...]) -> None:
    it = course(DRIVER.format(speed=speed))
    choose(it, MORE, "drive until something is near")
    outcome = to_menu_or_review(it).outcome
    assert outcome is not None and outcome.replaced == replaced
