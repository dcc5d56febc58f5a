"""A part of a robot's file, edited step by step in its own small text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeAlias

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.sources.splices import line_start
from plastron_tui.sources.xml.document import Element, XmlDocument, read_xml
from plastron_tui.sources.xml.edits import (
    XmlEdit,
    insert_after,
    insert_before,
    insert_last,
    remove_attribute,
    remove_element,
    replace_element,
    set_attribute,
)
from plastron_tui.sources.xml.layout import starts_line
from plastron_tui.sources.xml.new_element import NewElement

from .equality import same
from .habits import Habits
from .values import XACRO, is_computed, number_of
from .vocabulary import has_quaternions, unknown_in

Path: TypeAlias = tuple[tuple[str, int], ...]
"""Names of elements, one within the other, each with its place among those of its name."""


class RefusedError(Exception):
    """A change cannot be made; the diagnostic says why, at its place in the file."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


class PartEdits:
    """Changes of an element of a file; what follows the last one is `text`.

    The element is read as a document of its own, which is small, so that each step can be checked.

    Args:
        document: the file.
        element: a link, a joint or a material.
        habits: of the file.
        is_xacro: whether the file has macros.
    """

    def __init__(
        self, document: XmlDocument, element: Element, habits: Habits, is_xacro: bool
    ) -> None:
        start, end = element.span
        if starts_line(document.text, start):
            start = line_start(document.text, start)
        self.span = Span(start, end)
        self.habits = habits
        self._whole, self._element = document, element
        self._is_xacro = is_xacro
        self.has_quaternions = has_quaternions(document.root)
        self.told: list[Diagnostic] = []
        read = read_xml(document.text[start:end])
        if read.document is None:
            raise self.refusal(f"`<{element.name}>` cannot be read on its own", element.name_span)
        self._document = read.document

    @property
    def text(self) -> bytes:
        """The part as it is by now."""
        return self._document.text

    def find(self, path: Path) -> Element | None:
        """Return an element of the part, None where there is none; () is the part itself."""
        found = self._document.root
        for name, at in path:
            named = found.named(name)
            if at >= len(named):
                return None
            found = named[at]
        return found

    def refusal(self, message: str, span: Span | None = None) -> RefusedError:
        """Return why the part is not changed, at a place of the file."""
        where = self._element.name_span if span is None else span
        return RefusedError(Diagnostic(codes.EDIT_REFUSED, message, where, self._whole.file))

    def set_text(self, path: Path, name: str, value: str) -> None:
        """Give an attribute a value."""
        element = self._needed(path)
        found = element.attribute(name)
        if found is not None and found.value != value:
            self._check_plain(element, name, found.value)
        at = self.habits.attribute_place(element, name)
        self._take(set_attribute(self._document, element, name, value, at, self.habits.style))

    def drop(self, path: Path, name: str) -> None:
        """Take an attribute away."""
        element = self._needed(path)
        found = element.attribute(name)
        if found is not None:
            self._check_plain(element, name, found.value)
            self._take(remove_attribute(self._document, element, name))

    def set_numbers(
        self,
        path: Path,
        name: str,
        was: Sequence[float],
        values: Sequence[float],
        default: Sequence[float] = (),
    ) -> None:
        """Let an attribute have other numbers; those of it that it has stay as they are written.

        Args:
            path: the element.
            name: the attribute.
            was: the numbers so far.
            values: the numbers.
            default: what they are where the attribute is not there; () where it has to be.
        """
        if same(tuple(was), tuple(values)):
            return
        found = self._needed(path).attribute(name)
        if found is None:
            if not (default and same(tuple(values), tuple(default))):
                self.set_text(path, name, self._numbers(name, values))
            return
        words = found.value.split()
        if len(words) != len(values):
            self.set_text(path, name, self._numbers(name, values))
            return
        has = [number_of(word) for word in words]
        kept = [
            word
            if said is not None and same(said, value)
            else self.habits.number(name, value, words)
            for word, said, value in zip(words, has, values, strict=True)
        ]
        if kept != words:
            self.set_text(path, name, _filled(found.value, kept))

    def insert(self, parent: Path, new: NewElement, index: int = 0) -> None:
        """Write an element where the author would.

        Args:
            parent: what it is written into.
            new: what is written.
            index: how many of its name are before it.
        """
        holder = self._needed(parent)
        macro = next((each for each in holder.children if each.name.startswith(XACRO)), None)
        if self._is_xacro and macro is not None:
            message = f"`<{macro.name}>` may write a `<{new.name}>` here: add it where that is"
            raise self.refusal(message, self._in_file(macro.name_span))
        new = self.habits.styled(new)
        named, style = holder.named(new.name), self.habits.style
        if index and index <= len(named):
            self._take(insert_after(self._document, named[index - 1], new, style))
            return
        if named:
            self._take(insert_before(self._document, named[0], new, style))
            return
        at = self.habits.child_place(holder, new.name)
        if at:
            self._take(insert_after(self._document, holder.children[at - 1], new, style))
        elif holder.children:
            self._take(insert_before(self._document, holder.children[0], new, style))
        else:
            self._take(insert_last(self._document, holder, new, style))

    def replace(self, path: Path, new: NewElement) -> None:
        """Write an element in the place of another one."""
        element = self._needed(path)
        self._check_subtree(element)
        self._tell_lost(element, new)
        new = self.habits.styled(new)
        self._take(replace_element(self._document, element, new, self.habits.style))

    def remove(self, path: Path) -> None:
        """Take an element away."""
        element = self._needed(path)
        self._check_subtree(element)
        self._tell_lost(element)
        self._take(remove_element(self._document, element, style=self.habits.style))

    def tell(self, message: str) -> None:
        """Note what somebody is to know of the change, though it is made."""
        where, file = self._element.name_span, self._whole.file
        self.told.append(Diagnostic(codes.SIDE_EFFECT, message, where, file))

    def _tell_lost(self, element: Element, new: NewElement | None = None) -> None:
        """Tell what goes along with an element, and is no word that a description has."""
        lost = [f"`{each}`" for each in unknown_in(element, new)]
        if lost == [f"`<{element.name}>`"]:
            self.tell(f"{lost[0]} goes, with all that it says")
        elif lost:
            go = "go" if len(lost) > 1 else "goes"
            self.tell(f"{', '.join(lost)} {go} with the `<{element.name}>`")

    def _numbers(self, name: str, values: Sequence[float]) -> str:
        return " ".join(self.habits.number(name, value) for value in values)

    def _needed(self, path: Path) -> Element:
        found = self.find(path)
        if found is None:
            raise self.refusal(f"there is no `<{path[-1][0]}>` to be changed")
        return found

    def _check_subtree(self, element: Element) -> None:
        for each in element.walk():
            for one in each.attributes:
                self._check_plain(each, one.name, one.value)

    def _check_plain(self, element: Element, name: str, value: str) -> None:
        if self._is_xacro and is_computed(value):
            span = self._in_file(element.name_span)
            message = f"`{name}` of `<{element.name}>` is computed by a macro: `{value}`"
            raise self.refusal(message, span)

    def _in_file(self, span: Span) -> Span | None:
        """Return where something of the part is in the file, None behind a first change."""
        was = self._whole.text[self.span.start : self.span.end]
        return span.moved(self.span.start) if was == self.text else None

    def _take(self, edit: XmlEdit) -> None:
        if edit.document is None:
            message = _words(edit.diagnostics)
            raise self.refusal(message)
        self._document = edit.document


def _filled(text: str, words: Sequence[str]) -> str:
    """Return a text with other words between its blanks."""
    parts: list[str] = []
    rest = text
    for old, new in zip(text.split(), words, strict=True):
        before, _, rest = rest.partition(old)
        parts += (before, new)
    return "".join((*parts, rest))


def _words(diagnostics: Iterable[Diagnostic]) -> str:
    return "; ".join(each.message for each in diagnostics)
