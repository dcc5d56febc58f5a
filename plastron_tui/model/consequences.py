"""What follows from an earlier mistake, and is none of its own."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product

from plastron_tui.language import DECLARATIONS, SlotKind, Statement
from plastron_tui.language import statements as st
from plastron_tui.language.broken_lines import Broken
from plastron_tui.ros.names import spelled

from .kinds.facts import NAMES
from .workspace import Node

_PARTS: dict[type[Statement], str] = {
    st.HasLink: "link",
    st.NoLongerHasLink: "link",
    st.HasJoint: "joint",
    st.NoLongerHasJoint: "joint",
}
"""The slots of the parts of robots that statements make, change or take away."""

_NAMES = NAMES | {SlotKind.OLD_NAME, SlotKind.NEW_NAME}


class Consequences:
    """What statements with a mistake, and lines that are no statements, were to make."""

    def __init__(self) -> None:
        """Start with no mistake."""
        self.is_used = False
        """Whether a mistake was added, or anything asked: what the broken lines say counted."""
        self.begin(Broken())

    def begin(self, lines: Broken) -> None:
        """Forget the mistakes, and start with what the broken lines of a program say of it."""
        self._lines = lines
        self._lost = lines.lost
        self._declared = set(lines.declared)
        self._endpoints: set[tuple[str, str]] = set()
        self._nodes: set[str] = set()
        self._uncreated: set[str] = set()
        self._parts: set[str] = set()

    def add(self, statement: Statement) -> None:
        """Remember what a statement without effect was to make: it is broken, not missing."""
        self.is_used = True
        declaration = DECLARATIONS[type(statement)]
        filled = [(slot.kind, getattr(statement, slot.name)) for slot in declaration.slots]
        made = (text for kind, text in filled if kind.makes is not None)
        # A type is called by its name, whether its package is written or not.
        self._declared.update(text.rpartition("/")[2] for text in made)
        self._uncreated.update(text for kind, text in filled if kind is SlotKind.NODE_NAME)
        part = _PARTS.get(type(statement))
        if part is not None:
            self._parts.add(getattr(statement, part))
        names = [spelled(text) for kind, text in filled if kind in _NAMES]
        if names and declaration.undoes is None:
            nodes = [text for kind, text in filled if kind is SlotKind.NODE]
            self._endpoints.update(product(nodes, names))
            self._nodes.update(nodes)

    def add_nodes(self, variables: set[str]) -> None:
        """Note that nodes lack something that a statement meant for them."""
        self.is_used = True
        self._nodes |= variables

    def declares(self, variable: str) -> bool:
        """Tell whether a variable that is not there was to be declared by a broken statement."""
        self.is_used = True
        if variable not in self._declared and self._lost > 0:
            self._lost -= 1
            self._declared.add(variable)
        return variable in self._declared

    def mentions(self, name: str) -> bool:
        """Tell whether a broken line has a word or a quoted name."""
        self.is_used = True
        return name in self._lines.words

    def has_part(self, name: str) -> bool:
        """Tell whether a statement about a link or a joint of this name has no effect."""
        self.is_used = True
        return name in self._parts

    def explains(self, node: Node, name: str) -> bool:
        """Tell whether what a node has under a name may be so because of an earlier mistake.

        A program writes the private name of a parameter of ROS 1 without what says so.
        """
        self.is_used = True
        variable, lines = node.variable, self._lines
        return (
            variable in lines.unfinished
            or "" in lines.unfinished
            or any(
                (variable, each) in self._endpoints
                or (variable in lines.words and each in lines.words)
                for each in (name, name.removeprefix("~/"))
            )
        )

    def may_name(self, file: str, nodes: Mapping[str, Node]) -> bool:
        """Tell whether a file may be that of a node which a mistake kept from what it was to be."""
        self.is_used = True
        names = {*self._uncreated, *(n.name for n in nodes.values() if self.is_unfinished(n))}
        return any(file == name or file.startswith(f"{name}_") for name in names)

    def is_unfinished(self, node: Node) -> bool:
        """Tell whether a mistake kept a node from having what it was to have."""
        self.is_used = True
        variable, lines = node.variable, self._lines
        return variable in self._nodes or variable in lines.words or "" in lines.unfinished
