from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.diagnostics import Code, Diagnostic, Fix, Label, Span, listed, shortened
from plastron_tui.diagnostics.wording import LONGEST_TEXT

CODE = Code("code", "A mistake.")

_TEXTS = st.builds(
    lambda text, times: text * times, st.text(min_size=1, max_size=40), st.integers(1, 5_000)
)


def _size(text: str) -> int:
    return len(text.encode("utf-8", "surrogatepass"))


@given(_TEXTS)
def test_a_text_is_cut_to_its_bytes_and_keeps_both_ends(text: str) -> None:
    cut = shortened(text)
    assert _size(cut) <= LONGEST_TEXT
    if _size(text) <= LONGEST_TEXT:
        assert cut == text
    else:
        assert text.startswith(cut.split("…")[0])
        assert text.endswith(cut.rpartition("…")[2])


@given(st.lists(_TEXTS, max_size=30))
def test_a_list_is_short_and_tells_how_many_there_are(names: list[str]) -> None:
    assert _size(listed(names)) <= LONGEST_TEXT


def test_a_long_list_ends_in_how_many_more() -> None:
    assert listed(["a", "b"]) == "a, b"
    assert listed([]) == ""
    text = listed(f"field{number}" for number in range(1_000))
    assert text.startswith("field0, field1, ")
    shown, more = text.rsplit(" … and ", 1)
    assert shown.count(",") + 1 + int(more.removesuffix(" more")) == 1_000


def test_no_text_of_a_diagnostic_is_long() -> None:
    text = "x" * 100_000
    span = Span(0, 1)
    made = Diagnostic(CODE, text, help=text, fix=Fix(text, ()), labels=(Label(span, text),))
    replaced = Diagnostic(CODE, "short")._replace(message=text, help=text)
    for found in (made, replaced, made.moved(3)):
        assert _size(found.message) == _size(found.help or "") == LONGEST_TEXT
    assert made.fix is not None
    assert _size(made.fix.title) == _size(made.labels[0].message) == LONGEST_TEXT
