"""A statement as a form: one field a slot."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from plastron_tui.language import Declaration, Document, Slot, SlotKind, format_document
from plastron_tui.language.declaration import Clause
from plastron_tui.language.sentence import sentence

from .values import Path

NEW = "\0new"
"""What is entered in a slot for: one that does not exist yet."""


@dataclass(eq=False)
class Form:
    """What was entered for a statement. What was not entered follows the suggestions.

    Attributes:
        declaration: the statement.
        entered: by slot, what the user wrote or chose; "" leaves an optional slot out.
        values: by path, what the user entered for the fields of the type.
        parent: the form that this one makes something for, and its slot.
        given: by slot, what stands in it because the wizard has made it before.
        makers: by slot, the form that makes what the slot names, once `NEW` was chosen.
    """

    declaration: Declaration
    entered: dict[str, str] = field(default_factory=dict)
    values: dict[Path, str] = field(default_factory=dict)
    parent: tuple[Form, str] | None = None
    given: dict[str, str] = field(default_factory=dict)
    makers: dict[str, Form] = field(default_factory=dict)

    def slot_of(self, *kinds: SlotKind) -> Slot | None:
        """Return the first slot of one of some kinds."""
        return next((slot for slot in self.declaration.slots if slot.kind in kinds), None)

    @property
    def made(self) -> Slot | None:
        """The slot that gives a name to what the statement makes."""
        return next((slot for slot in self.declaration.slots if slot.kind.makes), None)

    @property
    def optional(self) -> frozenset[str]:
        """The slots that may be left out."""
        return frozenset(slot.name for clause in self.declaration.clauses for slot in clause.slots)

    def enter(self, slot: str, text: str) -> None:
        """Take what the user wrote; what another clause in its brackets has gives way."""
        self.entered[slot] = text
        if text:
            for other in excluded_by(self.declaration, slot):
                self.entered.pop(other, None)

    def trial(self, slot: str, text: str, cells: Cells) -> Form:
        """Return a form in which something else was entered; this one stays as it is.

        What is in the slots before, as `cells` has it, stays there.
        """
        kept = {
            name: NEW if cell.is_new else cell.text
            for name, cell in cells.items()
            if not cell.reason and name != slot
        }
        other = Form(
            self.declaration,
            {**self.entered, **kept},
            dict(self.values),
            self.parent,
            dict(self.given),
        )
        other.enter(slot, text)
        for name, maker in self.makers.items():
            copy = Form(maker.declaration, dict(maker.entered), dict(maker.values), (other, name))
            other.makers[name] = copy
        return other


@dataclass(frozen=True, slots=True)
class Cell:
    """What is in a slot.

    Attributes:
        text: as it is shown; "" for a slot that is left out.
        reason: why it is that and nothing else; "" where it can be chosen.
        is_new: whether it names something that a form of its own makes.
        written: as the program has it, without the quotes of a name, where that is another text.
    """

    text: str = ""
    reason: str = ""
    is_new: bool = False
    written: str | None = None

    @property
    def in_program(self) -> str:
        """What the program has, without the quotes of a name."""
        return self.text if self.written is None else self.written


Cells = dict[str, Cell]


def excluded_by(declaration: Declaration, slot: str) -> frozenset[str]:
    """Return the slots of the clauses that cannot stand beside the one that has a slot."""
    own = next(
        (
            each
            for each in declaration.elements
            if isinstance(each, Clause) and slot in _names(each)
        ),
        None,
    )
    return frozenset(
        name
        for each in declaration.elements
        if own is not None and isinstance(each, Clause)
        if each is not own and each.bracket == own.bracket
        for name in _names(each)
    )


def _names(clause: Clause) -> Iterator[str]:
    """Yield the slots in a clause, those of clauses within it too."""
    for element in clause.elements:
        if isinstance(element, Clause):
            yield from _names(element)
        elif not isinstance(element, str):
            yield element.name


def laid_out(declaration: Declaration, texts: dict[str, str]) -> str:
    """Return a statement, laid out as the formatter does it; `texts` has what is in its slots.

    What does not parse is not laid out.
    """
    line = sentence(declaration, texts)
    document = Document(line.encode("utf-8", "surrogatepass"))
    root = document.tree.root_node
    if root.has_error or root.child_count != 1:
        return line
    return format_document(document).decode().rstrip("\n")


def is_variable(text: str) -> bool:
    """Tell whether a text has the form of a variable."""
    return text.isascii() and text.isidentifier() and text[0].isalpha()
