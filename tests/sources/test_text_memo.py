"""What is remembered of texts: the latest, no more than is allowed, in each thread its own."""

from __future__ import annotations

import gc
from concurrent.futures import ThreadPoolExecutor
from weakref import ref

from plastron_tui.sources.text_memo import MEMO, TextMemo, lent, remembered, sharing


def test_the_least_recently_used_is_forgotten_first():
    memo = TextMemo(4_000)
    for name in "abc":
        memo.keep(name, name.upper(), 1_500)
        assert memo.get("a") == "A"
    assert [memo.get(name) for name in "abc"] == ["A", None, "C"]
    assert memo.size == 3_000


def test_a_small_result_counts_as_well_and_one_that_is_too_large_is_not_kept():
    memo = TextMemo(4_096)
    for number in range(100):
        memo.keep(number, "small", 1)
    assert sum(memo.get(number) is not None for number in range(100)) == 4
    memo.keep("large", "large", 5_000)
    assert memo.get("large") is None
    assert memo.get(99) == "small"
    memo.keep(99, "larger", 2_000)
    memo.keep(99, "too large by now", 5_000)
    assert memo.get(99) is None
    assert memo.size == 2 * 1_024


def test_a_text_is_asked_about_once_in_each_thread():
    asked = []

    @remembered
    def lines(text: bytes) -> int | None:
        asked.append(text)
        return text.count(b"\n") or None

    for text in (b"a\n", b"b", b"a\n", b"b"):
        assert lines(text) == (1 if text == b"a\n" else None)
    assert asked == [b"a\n", b"b"]
    with ThreadPoolExecutor(1) as other:
        assert other.submit(lines, b"a\n").result() == 1
    assert asked == [b"a\n", b"b", b"a\n"]
    MEMO.clear()
    assert lines(b"b") is None
    assert asked == [b"a\n", b"b", b"a\n", b"b"]


def test_what_is_forgotten_is_let_go():
    class Result:
        pass

    memo = TextMemo(2_000)
    memo.keep("a", result := Result(), 1_500)
    left = ref(result)
    del result
    gc.disable()
    try:
        assert left() is not None
        memo.keep("b", Result(), 1_500)
        assert left() is None
    finally:
        gc.enable()


def test_what_is_lent_is_nobody_elses_until_it_is_given_back():
    MEMO.clear()

    def make(source: bytes) -> list[bytes]:
        return [source]

    def borrow() -> list[bytes]:
        return lent(make, b"text", b"text")

    assert borrow() is not borrow()
    with sharing():
        had = [borrow(), borrow()]
        with sharing():
            had.append(borrow())
        assert len(set(map(id, had))) == 3
    with sharing():
        again = borrow()
    assert any(again is each for each in had)
    alone = borrow()
    assert all(alone is not each for each in had)
    MEMO.clear()
