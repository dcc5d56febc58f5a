from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.output.merge3 import merge_lines, replay


def text(letters: str) -> bytes:
    """Return a text of a line for each letter."""
    return b"".join(f"{letter}\n".encode() for letter in letters)


MERGES = [
    ("abc", "abc", "abc", "abc"),
    ("abc", "aXbc", "abc", "aXbc"),
    ("abc", "abc", "aXbc", "aXbc"),
    ("abcde", "aXbcde", "abcdYe", "aXbcdYe"),
    ("abcde", "bcde", "abcd", "bcd"),
    ("abc", "aXc", "aXc", "aXc"),
    ("abc", "aXc", "aYc", None),
    ("abc", "aXbc", "aYbc", None),
    ("abc", "ac", "aXc", None),
    ("", "a", "", "a"),
    ("", "a", "b", None),
    ("abcdefg", "aXcdefg", "abcdeYg", "aXcdeYg"),
]


@pytest.mark.parametrize(("base", "ours", "theirs", "expected"), MERGES)
def test_merge(base: str, ours: str, theirs: str, expected: str | None) -> None:
    result = None if expected is None else text(expected)
    assert merge_lines(text(base), text(ours), text(theirs)) == result
    assert merge_lines(text(base), text(theirs), text(ours)) == result


SIDE_BY_SIDE = [
    ("abcd", "aXcd", "abYd", "aXYd"),
    ("abcd", "abXd", "aYcd", "aYXd"),
    ("abcd", "aXcd", "abYcd", "aXYcd"),
    ("abcd", "aXcd", "aYbcd", "aYXcd"),
    ("abcd", "aXcd", "aYcd", None),
    ("abcd", "acd", "abYd", None),  # lines that go: what follows them may have been theirs
    ("abcd", "acd", "abYcd", None),
    ("abcd", "aXbcd", "aYbcd", None),
    ("abcd", "abXcd", "abYd", None),
    ("abcd", "aXcd", "abd", None),
]


@pytest.mark.parametrize(("base", "ours", "theirs", "expected"), SIDE_BY_SIDE)
def test_lines_side_by_side(base: str, ours: str, theirs: str, expected: str | None) -> None:
    result = None if expected is None else text(expected)
    assert merge_lines(text(base), text(ours), text(theirs), side_by_side=True) == result
    assert merge_lines(text(base), text(ours), text(theirs)) is None


BELOW = [
    ("a:| b|c", "a:| b|| d|c", "a:| b||x:| y|c", "a:| b|| d||x:| y|c"),
    ("a:| b| d|c", "a:| b|c", "a:| b| d|x|c", "a:| b|x|c"),
    ("a:| b|c", "a:| b| d|c", "a:| b| x|c", None),
    ("a:| b|c", "a:| b|d|c", "a:| b|x|c", None),
    ("a:| b| d|c", "a:| b|c", "a:| b| x|x|c", None),
]
"""Lines that end a block, and others that follow it; a `|` ends a line."""


@pytest.mark.parametrize(("base", "ours", "theirs", "expected"), BELOW)
def test_lines_below_a_block(base: str, ours: str, theirs: str, expected: str | None) -> None:
    texts = [each.replace("|", "\n").encode() for each in (base, ours, theirs)]
    result = None if expected is None else expected.replace("|", "\n").encode()
    assert merge_lines(*texts, side_by_side=True) == result
    assert merge_lines(texts[0], texts[2], texts[1], side_by_side=True) == result
    assert merge_lines(*texts) is None


REPLAYS = [
    ("abc", "abc", "xyz", "xyz"),
    ("abPc", "abPXc", "abc", "abc"),  # below a line that is not there
    ("abPc", "aXbPc", "abc", "aXbc"),
    ("abPc", "XabPc", "abc", "Xabc"),
    ("abPcd", "abPd", "abcd", "abd"),
    ("abPcd", "abPXd", "abcd", "abXd"),
    ("abPcd", "abXcd", "abcd", "abcd"),  # instead of a line that is not there
    ("abcd", "abXcd", "abPcd", "abXPcd"),
    ("acd", "acdX", "abcd", "abcdX"),
    ("ad", "", "abcd", "abcd"),  # lines that are no longer side by side
]


@pytest.mark.parametrize(("base", "changed", "onto", "expected"), REPLAYS)
def test_replay(base: str, changed: str, onto: str, expected: str) -> None:
    assert replay(text(base), text(changed), text(onto)) == text(expected)


LETTERS = st.text("abcde", max_size=12)


@given(LETTERS, LETTERS)
def test_what_one_side_changed_is_what_comes_out(base: str, changed: str) -> None:
    one, other = text(base), text(changed)
    assert merge_lines(one, one, other) == other
    assert merge_lines(one, other, one) == other
    assert merge_lines(one, other, other) == other
    assert replay(one, other, one) == other
    assert replay(one, one, other) == other


@pytest.mark.parametrize("end", [b"", b"\n", b"\r\n", b"\xff"])
def test_bytes_come_through(end: bytes) -> None:
    base, ours, theirs = (b"a\r\nb\r" + end, b"X\na\r\nb\r" + end, b"a\r\nb\r" + end)
    assert merge_lines(base, ours, theirs) == ours


def test_texts_that_are_too_long_to_compare() -> None:
    base = b"".join(b"%d\n" % (i % 7) for i in range(50_000))
    ours = b"".join(b"%d\n" % (i % 5) for i in range(50_000))
    assert merge_lines(base, ours, base) == ours
    assert merge_lines(base, ours, base[:50_000] + b"x\n" + base[50_000:]) is None


@pytest.mark.parametrize(
    ("ours", "theirs", "merged"),
    [
        (b"a\nc\nz\n", b"a\nb\nc\nz\n", b"a\nb\nc\nz\n"),
        (b"a\n<d>x</d>\nz\n", b"a\n<d>y</d>\nz\n", b"a\n<d>y</d>\n<d>x</d>\nz\n"),
        (b"a\n<d/>\nz\n", b"a\nf(b)\nz\n", b"a\nf(b)\n<d/>\nz\n"),
        (b"a\nf(\n  b)\nz\n", b"a\nc\nz\n", None),
        (b"a\n<d>\n</d>\nz\n", b"a\nc\nz\n", None),
        (b"a\nb\n", b"a\nz\nc\n", None),
        (b"a\nb\n", b"a\nc\n", None),
    ],
)
def test_entries_that_both_sides_add(ours: bytes, theirs: bytes, merged: bytes | None) -> None:
    base = b"a\nz\n"
    assert merge_lines(base, ours, theirs, is_list=True) == merged
    assert merge_lines(base, ours, theirs) is None
