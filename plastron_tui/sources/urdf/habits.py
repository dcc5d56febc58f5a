"""How the author of a robot's file writes: in which order, how far apart, and what is left out."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from enum import Enum
from functools import cached_property
from itertools import pairwise

from plastron_tui.sources.xml.document import Element, XmlDocument
from plastron_tui.sources.xml.layout import Style, style_of
from plastron_tui.sources.xml.new_element import NewElement

from .new_elements import number
from .values import number_of
from .vocabulary import ATTRIBUTES, CHILDREN

_DEFAULTS: Mapping[tuple[str, str], tuple[float, ...]] = {
    ("origin", "rpy"): (0, 0, 0),
    ("mesh", "scale"): (1, 1, 1),
    ("mimic", "multiplier"): (1,),
    ("mimic", "offset"): (0,),
}
_NUMBERS = frozenset(
    (
        *("xyz", "rpy", "size", "radius", "length", "scale", "rgba", "value"),
        *("ixx", "ixy", "ixz", "iyy", "iyz", "izz", "lower", "upper", "effort", "velocity"),
        *("damping", "friction", "multiplier", "offset"),
    )
)
"""The attributes that have numbers."""
_WHOLE = re.compile(r"[+-]?[0-9]+(\.0)?")
_PARTS = ("material", "link", "joint")
_MOST_BETWEEN = 3
"""The most empty lines that are kept up between parts."""


class Order(Enum):
    """How links and joints stand to each other."""

    JOINT_FIRST = "a joint, and the link that it holds right behind it"
    LINK_FIRST = "a link, and the joint that holds it right behind it"
    APART = "links here and joints there"


class Habits:
    """What most of a file does; where it does not tell, what the specification does.

    Args:
        document: the file.
    """

    def __init__(self, document: XmlDocument) -> None:
        self._document = document
        self.style: Style = style_of(document)
        self._before: Counter[tuple[str, str, str]] = Counter()
        self._said_defaults: set[tuple[str, str]] = set()
        self._points: Counter[str] = Counter()
        self._turned = 0
        for element in document.root.walk():
            self._note_order(element.name, [child.name for child in element.children])
            self._note_order(f"@{element.name}", [one.name for one in element.attributes])
            self._note_defaults(element)
            if element.name == "origin":
                self._turned += 1 if element.attribute("rpy") is not None else -1
            for one in element.attributes:
                if one.name in _NUMBERS and ":" not in element.name:
                    self._note_points(one.name, one.value)

    def _note_points(self, name: str, value: str) -> None:
        for word in value.split():
            whole = _WHOLE.fullmatch(word)
            if whole is not None:
                self._points[name] += 1 if whole.group(1) else -1

    def _note_order(self, parent: str, names: Sequence[str]) -> None:
        known = CHILDREN.get(parent) or ATTRIBUTES.get(parent.removeprefix("@"), ())
        seen = [name for name in dict.fromkeys(names) if name in known]
        for at, name in enumerate(seen):
            for other in seen[at + 1 :]:
                self._before[parent, name, other] += 1

    def _note_defaults(self, element: Element) -> None:
        for one in element.attributes:
            default = _DEFAULTS.get((element.name, one.name))
            if default is None:
                continue
            words = one.value.split()
            if len(words) == len(default) and tuple(map(number_of, words)) == default:
                self._said_defaults.add((element.name, one.name))
        if element.name == "origin" and all(
            number_of(word) == 0 for one in element.attributes for word in one.value.split()
        ):
            self._said_defaults.add(("origin", "xyz"))

    def number(self, attribute: str, value: float, before: Sequence[str] = ()) -> str:
        """Return a number as it is written in an attribute: `5`, or `5.0` if the author does so.

        Args:
            attribute: its name.
            value: the number.
            before: what the attribute says so far, which tells more than the rest of the file.
        """
        text = number(value)
        if _WHOLE.fullmatch(text) is None:
            return text
        found = filter(None, map(_WHOLE.fullmatch, before))
        ways = {each.group(1) is not None for each in found}
        is_pointed = ways.pop() if len(ways) == 1 else self._points[attribute] > 0
        return f"{text}.0" if is_pointed else text

    def styled(self, new: NewElement) -> NewElement:
        """Return an element as the author writes it: its numbers, and what comes first in it."""
        attributes: list[tuple[str, str]] = []
        said_besides: tuple[tuple[str, str], ...] = ()
        says_turns = self._turned > 0 and self.says_default("origin", "rpy")
        if new.name == "origin" and says_turns and len(new.attributes) == 1:
            # Its author says of each origin how it is turned, also where it is not.
            said_besides = (("rpy", "0 0 0"),)
        for name, value in (*new.attributes, *said_besides):
            said = self._numbers(name, value) if name in _NUMBERS else value
            at = self._attribute_place(new.name, [each for each, _ in attributes], name)
            attributes.insert(at, (name, said))
        children: list[NewElement] = []
        for child in new.children:
            at = self._child_place(new.name, [each.name for each in children], child.name)
            children.insert(at, self.styled(child))
        return new._replace(attributes=tuple(attributes), children=tuple(children))

    def _numbers(self, name: str, value: str) -> str:
        if self._points[name] <= 0:
            return value
        words = (f"{word}.0" if _WHOLE.fullmatch(word) else word for word in value.split())
        return " ".join(words)

    def says_default(self, element: str, attribute: str) -> bool:
        """Tell whether the file says somewhere what would be so without being said."""
        return (element, attribute) in self._said_defaults

    def child_place(self, parent: Element, name: str) -> int:
        """Return how many children are before a new one of a name."""
        return self._child_place(parent.name, [child.name for child in parent.children], name)

    def attribute_place(self, element: Element, name: str) -> int:
        """Return how many attributes are before a new one of a name."""
        names = [one.name for one in element.attributes]
        return self._attribute_place(element.name, names, name)

    def _child_place(self, parent: str, names: Sequence[str], new: str) -> int:
        return self._place(parent, names, new, CHILDREN.get(parent, ()))

    def _attribute_place(self, element: str, names: Sequence[str], new: str) -> int:
        return self._place(f"@{element}", names, new, ATTRIBUTES.get(element, ()))

    def _place(self, parent: str, names: Sequence[str], new: str, usual: Sequence[str]) -> int:
        last = [at for at, name in enumerate(names) if self._comes_before(parent, name, new, usual)]
        if last:
            return last[-1] + 1
        known = [at for at, name in enumerate(names) if name in usual]
        return known[0] if known else len(names)

    def _comes_before(self, parent: str, name: str, new: str, usual: Sequence[str]) -> bool:
        if name == new:
            return True
        if name not in usual or new not in usual:
            return False
        before, behind = self._before[parent, name, new], self._before[parent, new, name]
        return before > behind if before != behind else usual.index(name) < usual.index(new)

    @cached_property
    def order(self) -> Order:
        """How links and joints stand to each other."""
        parts = [each for each in self._document.root.children if each.name in ("link", "joint")]
        counts: Counter[Order] = Counter()
        places = {each.get("name"): at for at, each in enumerate(parts) if each.name == "link"}
        for at, joint in enumerate(parts):
            child = next((each for each in joint.children if each.name == "child"), None)
            if joint.name == "link" or child is None or child.get("link") not in places:
                continue
            apart = places[child.get("link")] - at
            found = {1: Order.JOINT_FIRST, -1: Order.LINK_FIRST}.get(apart, Order.APART)
            counts[found] += 1
        if not counts:
            return Order.JOINT_FIRST
        return max(Order, key=lambda each: counts[each])

    def lines_between(self, name: str, other: str) -> int:
        """Return how many empty lines are between two neighbours, parts of these names."""
        both = name == other == "material"
        counts = self._gaps[both]
        if counts:
            return counts.most_common(1)[0][0]
        return 0 if both else 1

    @cached_property
    def _gaps(self) -> Mapping[bool, Counter[int]]:
        found: dict[bool, Counter[int]] = {True: Counter(), False: Counter()}
        text = self._document.text
        for one, other in pairwise(self._document.root.children):
            between = text[one.span.end : other.span.start]
            # What is before the first comment tells.
            breaks = between[: len(between) - len(between.lstrip())].count(b"\n")
            if one.name in _PARTS and other.name in _PARTS and breaks:
                both = one.name == other.name == "material"
                found[both][min(breaks - 1, _MOST_BETWEEN)] += 1
        return found
