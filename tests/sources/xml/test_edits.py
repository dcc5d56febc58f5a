"""What is written into an XML file and taken away again leaves the same bytes."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st
from random_xml import files

from plastron_tui.sources.xml.document import Element, XmlDocument, read_xml
from plastron_tui.sources.xml.edits import (
    XmlEdit,
    insert_after,
    insert_before,
    insert_first,
    insert_last,
    remove_attribute,
    remove_element,
    set_attribute,
    set_text,
)
from plastron_tui.sources.xml.new_element import NewElement

NEW = (
    NewElement("new"),
    NewElement("new", (("name", 'a"<&>\t'),)),
    NewElement("new", text="a < b"),
    NewElement("new", (("a", "1"),), children=(NewElement("inner"), NewElement("inner", text="x"))),
)
INSERTS: tuple[Callable[[XmlDocument, Element, NewElement], XmlEdit], ...] = (
    insert_after,
    insert_before,
    insert_first,
    insert_last,
)


def read(text: bytes) -> XmlDocument:
    document, diagnostics = read_xml(text)
    assert document is not None, diagnostics
    return document


def the(document: XmlDocument, name: str) -> Element:
    (found,) = [one for one in document.root.walk() if one.name == name]
    return found


@given(files(), st.sampled_from(INSERTS), st.sampled_from(NEW), st.integers(0, 1000))
def test_an_element_that_is_taken_away_again_leaves_the_same_bytes(
    text: bytes,
    insert: Callable[[XmlDocument, Element, NewElement], XmlEdit],
    new: NewElement,
    choice: int,
) -> None:
    document = read(text)
    elements = list(document.root.walk())
    beside = insert in (insert_after, insert_before)
    if beside:
        elements = elements[1:]
    else:
        # Whether a parent with one line break in it closed itself before is not remembered.
        elements = [one for one in elements if one.end_tag is None or not is_open(document, one)]
    if not elements or not shows_how_to_close(document, elements[choice % len(elements)], new):
        return
    added = insert(document, elements[choice % len(elements)], new).document
    assert added is not None
    removed = remove_element(added, the(added, "new")).document
    assert removed is not None
    assert removed.text == text


def shows_how_to_close(document: XmlDocument, parent: Element, new: NewElement) -> bool:
    """Tell whether ` />` of a parent that is opened can be learnt from what is left."""
    closed = [one for one in document.root.walk() if one.end_tag is None]
    return parent not in closed or len(closed) > 1 or not new.text


def is_open(document: XmlDocument, element: Element) -> bool:
    content = document.slice(element.content)
    line = document.text[: element.span.start].rpartition(b"\n")[2]
    return content.strip(" \t") in ("\n", "\r\n") or (not content and line.strip() != b"")


@given(files(), st.integers(0, 1000), st.sampled_from(["", "x", "\"'<&>\t\n", "é"]))
def test_an_attribute_that_is_taken_away_again_leaves_the_same_bytes(
    text: bytes, choice: int, value: str
) -> None:
    document = read(text)
    elements = list(document.root.walk())
    at = choice % len(elements)
    added = set_attribute(document, elements[at], "new", value).document
    assert added is not None
    element = list(added.root.walk())[at]
    assert element.get("new") == value
    removed = remove_attribute(added, element, "new").document
    assert removed is not None
    assert removed.text == text


@given(files(), st.integers(0, 1000))
def test_each_element_can_be_taken_away(text: bytes, choice: int) -> None:
    document = read(text)
    elements = list(document.root.walk())[1:]
    if elements:
        assert remove_element(document, elements[choice % len(elements)]).document is not None


CASES = [
    (insert_after, "b", "<a>\n\t<b/>\n\t<c/>\n</a>", "<a>\n\t<b/>\n\t<new/>\n\t<c/>\n</a>"),
    (insert_before, "b", "<a>\n\t<b/>\n</a>", "<a>\n\t<new/>\n\t<b/>\n</a>"),
    (insert_after, "b", "<a>\r\n  <b />\r\n</a>", "<a>\r\n  <b />\r\n  <new />\r\n</a>"),
    (insert_after, "b", "<a>\n <b/> <!-- b -->\n</a>", "<a>\n <b/> <!-- b -->\n <new/>\n</a>"),
    (insert_after, "b", "<a>\n  <b/> \n</a>", "<a>\n  <b/> \n  <new/>\n</a>"),
    (insert_after, "b", "<a><b/> <c/></a>", "<a><b/><new/> <c/></a>"),
    (insert_after, "c", "<a><b/> <c/></a>", "<a><b/> <c/> <new/></a>"),
    (insert_after, "b", "<a>\n  <b/></a>", "<a>\n  <b/>\n  <new/></a>"),
    (insert_last, "b", "<a>\n  <b/>\n</a>", "<a>\n  <b>\n    <new/>\n  </b>\n</a>"),
    (insert_last, "b", "<a>\n  <b />\n</a>", "<a>\n  <b>\n    <new />\n  </b>\n</a>"),
    (insert_last, "b", "<a>\n  <b></b>\n</a>", "<a>\n  <b><new/></b>\n</a>"),
    (insert_last, "b", "<a>\n <b>\n </b>\n</a>", "<a>\n <b>\n  <new/>\n </b>\n</a>"),
    (insert_last, "a", "<a>\n <b/>\n <!-- c -->\n</a>", "<a>\n <b/>\n <!-- c -->\n <new/>\n</a>"),
    (insert_first, "a", "<a>\n <b/>\n <c/>\n</a>", "<a>\n <new/>\n <b/>\n <c/>\n</a>"),
]


@pytest.mark.parametrize(("insert", "name", "before", "after"), CASES)
def test_an_element_is_written_in_the_style_of_its_neighbours(
    insert: Callable[[XmlDocument, Element, NewElement], XmlEdit],
    name: str,
    before: str,
    after: str,
) -> None:
    document = read(before.encode())
    edit = insert(document, the(document, name), NewElement("new"))
    assert edit.document is not None
    assert edit.document.text.decode() == after


REMOVALS = [
    ("<a>\n  <b/> <!-- of b -->\n  <c/>\n</a>", "<a>\n  <c/>\n</a>"),
    ("<a>\n  <!-- above -->\n  <b/>\n  <c/>\n</a>", "<a>\n  <!-- above -->\n  <c/>\n</a>"),
    ("<a>\n  <b/> <!-- over\n lines -->\n</a>", "<a>\n  <!-- over\n lines -->\n</a>"),
    ("<a>\n  <b>\n    <x/>\n  </b>\n  <c/>\n</a>", "<a>\n  <c/>\n</a>"),
    ("<a>\n  <b/> <c/>\n</a>", "<a>\n  <c/>\n</a>"),
    ("<a>one <b/> two</a>", "<a>one  two</a>"),
    ("<a>\n  <b/>\n</a>", "<a/>"),
]


@pytest.mark.parametrize(("before", "after"), REMOVALS)
def test_an_element_goes_with_its_line(before: str, after: str) -> None:
    document = read(before.encode())
    edit = remove_element(document, the(document, "b"))
    assert edit.document is not None
    assert edit.document.text.decode() == after


def test_values_and_texts_keep_quotes_and_blanks() -> None:
    document = read(b"<a b = 'x'>\n  old\n</a>")
    edit = set_attribute(document, document.root, "b", "it's \"&")
    assert edit.document is not None
    assert edit.document.text == b"<a b = 'it&apos;s \"&amp;'>\n  old\n</a>"
    edit = set_text(edit.document, edit.document.root, "a < b")
    assert edit.document is not None
    assert edit.document.text == b"<a b = 'it&apos;s \"&amp;'>\n  a &lt; b\n</a>"


REFUSED: list[Callable[[XmlDocument], XmlEdit]] = [
    lambda document: remove_element(document, document.root),
    lambda document: insert_after(document, document.root, NewElement("new")),
    lambda document: insert_last(document, document.root, NewElement('new a="1"')),
    lambda document: insert_last(document, document.root, NewElement("new", text="\x00")),
    lambda document: insert_last(document, document.root, NewElement("new", text="\ud800")),
    lambda document: set_attribute(document, document.root, "a b", "1"),
    lambda document: set_attribute(document, document.root, "b", "\ud800"),
    lambda document: set_text(document, document.root, "text"),
]


@pytest.mark.parametrize("edit", REFUSED)
def test_what_would_break_the_file_is_refused(edit: Callable[[XmlDocument], XmlEdit]) -> None:
    document, diagnostics = edit(read(b"<a>\n  <b/>\n</a>\n"))
    assert document is None
    assert [one.code for one in diagnostics] == ["edit-refused"]
