"""Values of attributes, as urdfdom takes them, and the mistakes in them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from math import isfinite

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.ros.robots.description import ORIGIN, Rgba, Vector
from plastron_tui.ros.robots.quaternions import Quaternion
from plastron_tui.sources.xml.document import Attribute, Element, XmlDocument

_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_BLANKS = " \t\r\n"
_COMPUTED = ("${", "$(")
_BROKEN = re.compile(rb"[^ \t\r\n][\t\r\n]")
XACRO = "xacro:"
"""What the names of elements begin with that macros replace."""


MOST_TOLD = 100
"""The most mistakes of a file that are told one by one."""


def number_of(text: str) -> float | None:
    """Return a number as a stream of C++ reads it in the locale "C"; None for what is none."""
    if not _NUMBER.fullmatch(text):
        return None
    number = float(text)
    return number if isfinite(number) else None


def is_xacro(document: XmlDocument) -> bool:
    """Tell whether a file has macros, whose values are computed.

    What is only included by other files need not name their namespace.
    """
    if document.file is not None and document.file.suffix == ".xacro":
        return True
    return any(
        each.name.startswith(XACRO) or any(one.name == "xmlns:xacro" for one in each.attributes)
        for each in document.root.walk()
    )


def is_computed(value: str) -> bool:
    """Tell whether a value of a file with macros is an expression."""
    return any(mark in value for mark in _COMPUTED)


@dataclass(slots=True)
class Values:
    """Reads the values of a file, and keeps what is wrong with them.

    What is computed by macros counts as not said, and is no mistake.

    Attributes:
        document: the file.
        is_xacro: whether it has macros.
        diagnostics: what was wrong so far.
        untold: how many mistakes there are besides.
    """

    document: XmlDocument
    is_xacro: bool
    diagnostics: list[Diagnostic] = field(default_factory=list)
    untold: int = 0

    def tell(
        self,
        message: str,
        span: Span,
        help_text: str | None = None,
        *,
        labels: tuple[Label, ...] = (),
        severity: Severity | None = None,
    ) -> None:
        """Note a mistake, or that there are more than anybody reads."""
        if len(self.diagnostics) >= MOST_TOLD:
            self.untold += 1
            return
        file = self.document.file
        found = Diagnostic(
            codes.BROKEN_URDF, message, span, file, help_text, labels=labels, severity=severity
        )
        self.diagnostics.append(found)

    def needed(self, element: Element, name: str) -> Attribute | None:
        """Return an attribute that has to be there, with a value."""
        found = element.attribute(name)
        if found is None:
            self.tell(f"`<{element.name}>` has no `{name}`", element.name_span)
        elif not found.value.strip(_BLANKS):
            self.tell(f"`{name}` is empty", found.span)
            return None
        return found

    def needed_child(self, element: Element, name: str) -> Element | None:
        """Return an element that another one has to have in it."""
        found = first(element, name)
        if found is None and not self.has_macros_in(element):
            self.tell(f"`<{element.name}>` has no `<{name}>`", element.name_span)
        return found

    def number(self, element: Element, name: str, *, is_needed: bool = False) -> float | None:
        """Return the number of an attribute, None where there is none."""
        found = self.needed(element, name) if is_needed else element.attribute(name)
        if found is None:
            return None
        value = found.value.strip(_BLANKS)
        number = number_of(value)
        if number is None:
            self._bad_number(found, value)
        elif found.value != found.value.rstrip(_BLANKS):
            # `stream >> number` has to reach the end (urdfdom_headers: `strToDouble`).
            message = f"`{name}` has a blank behind the number, which urdfdom does not take"
            self.tell(message, found.value_span, severity=Severity.WARNING)
        return number

    def vector(self, element: Element, name: str, *, is_needed: bool = False) -> Vector | None:
        """Return three numbers of an attribute, None where there are none."""
        found = self.needed(element, name) if is_needed else element.attribute(name)
        if found is None:
            return None
        numbers = self._numbers(found, 3)
        if numbers is None:
            return None
        x, y, z = numbers
        return x, y, z

    def quaternion(self, found: Attribute) -> Quaternion | None:
        """Return the four numbers of an attribute, None where there are none."""
        numbers = self._numbers(found, 4)
        if numbers is None:
            return None
        x, y, z, w = numbers
        return x, y, z, w

    def rgba(self, element: Element) -> Rgba | None:
        """Return the colour of an element."""
        found = self.needed(element, "rgba")
        numbers = None if found is None else self._numbers(found, 4)
        if found is None or numbers is None:
            return None
        red, green, blue, opacity = numbers
        if not all(0 <= each <= 1 for each in numbers):
            message = "a part of a colour is a number from 0 to 1"
            self.tell(message, found.value_span)
        return red, green, blue, opacity

    def _numbers(self, found: Attribute, count: int) -> list[float] | None:
        words = found.value.split()
        numbers: list[float] = []
        for word in words:
            number = number_of(word)
            if number is None:
                self._bad_number(found, word)
                return None
            numbers.append(number)
        if len(numbers) == count:
            start, end = found.value_span
            if _BROKEN.search(self.document.text[start:end]):
                # Cut at spaces only, by a parser that leaves them as they are (`split_string`).
                message = f"`{found.name}` has a tab or a line break behind a number"
                help_text = "urdfdom takes spaces only"
                span, severity = found.value_span, Severity.WARNING
                self.tell(message, span, help_text, severity=severity)
            return numbers
        message = f"`{found.name}` has {len(numbers)} numbers, and {count} are wanted"
        self.tell(message, found.value_span)
        return None

    def _bad_number(self, found: Attribute, word: str) -> None:
        if self.is_xacro and is_computed(found.value):
            return
        help_text = None
        if "," in found.value:
            help_text = "numbers have a point in them, and blanks between them"
        elif is_computed(found.value):
            help_text = "a file with macros names `xmlns:xacro` in its `<robot>`"
        self.tell(f"`{word}` in `{found.name}` is no number", found.value_span, help_text)

    def has_macros_in(self, element: Element) -> bool:
        """Tell whether macros may write something into an element."""
        return self.is_xacro and any(each.name.startswith(XACRO) for each in element.children)


def first(element: Element, name: str) -> Element | None:
    """Return the first child of a name: the one that counts."""
    return next((each for each in element.children if each.name == name), None)


def or_else(vector: Vector | None, default: Vector = ORIGIN) -> Vector:
    """Return a vector, the default for none."""
    return default if vector is None else vector


def has_any(element: Element, names: Iterable[str]) -> bool:
    """Tell whether an element has one of some attributes."""
    return any(element.attribute(name) is not None for name in names)
