"""A statement as a form: one field a slot."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from plastron_tui.language import Declaration, Document, Slot, SlotKind, format_document
from plastron_tui.language.declaration import Clause
from plastron_tui.language.declaration import Form as Written
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import HasLink

from .values import Path

NEW = "\0new"
"""What is entered in a slot for: one that does not exist yet."""


def new_words(slot: Slot) -> str:
    """Return what stands for one that does not exist yet."""
    kind = SlotKind.TOPIC if slot.kind is SlotKind.TRIGGER else slot.kind
    return f"a new {kind.name.lower()}"


VALUES = tuple(kind for kind in SlotKind if kind.form is Written.VALUES)
"""The slots whose values have a form of their own."""


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
        purpose: of a node that it makes, the form of what that shall do, once that is known.
        drives: whether it is to drive a robot until something is near.
    """

    declaration: Declaration
    entered: dict[str, str] = field(default_factory=dict)
    values: dict[Path, str] = field(default_factory=dict)
    parent: tuple[Form, str] | None = None
    given: dict[str, str] = field(default_factory=dict)
    makers: dict[str, Form] = field(default_factory=dict)
    purpose: Form | None = None
    drives: bool = False

    def slot_of(self, *kinds: SlotKind) -> Slot | None:
        """Return the first slot of one of some kinds."""
        return next((slot for slot in self.declaration.slots if slot.kind in kinds), None)

    @property
    def made(self) -> Slot | None:
        """The slot that gives a name to what the statement makes."""
        # The name of a link is not told from that of one which is there.
        found = self.slot_of(SlotKind.LINK) if self.declaration.type is HasLink else None
        return found or next((slot for slot in self.declaration.slots if slot.kind.makes), None)

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

    def put(self, slot: str, path: Path | None, text: str) -> None:
        """Take what the user wrote in a slot, or in a field of its values."""
        if path is None:
            self.enter(slot, text)
        else:
            self.values[path] = text

    def has_entered(self, slot: str) -> bool:
        """Tell whether something was entered in a slot, in its values or in the form it needs."""
        values_slot = self.slot_of(*VALUES)
        is_values = values_slot is not None and values_slot.name == slot
        return slot in self.entered or slot in self.makers or (is_values and bool(self.values))

    @property
    def is_filled_in(self) -> bool:
        """Whether something was entered in it, or in the forms that it needs."""
        own = bool(self.entered or self.values)
        return own or any(maker.is_filled_in for maker in self.makers.values())

    def trial(self, slot: str, text: str, cells: Cells, without: frozenset[str]) -> Form:
        """Return a form in which something else was entered; this one stays as it is.

        What is in the slots before, as `cells` has it, stays there. Of the slots in `without`
        what was entered is left out: of one that needs a form of its own, in that.
        """
        kept = {
            name: NEW if cell.is_new else cell.text
            for name, cell in cells.items()
            if not cell.reason and name != slot
        }
        values_slot = self.slot_of(*VALUES)
        has_values = values_slot is None or values_slot.name not in without
        other = Form(
            self.declaration,
            {**self.entered, **kept},
            dict(self.values) if has_values else {},
            self.parent,
            dict(self.given),
            drives=self.drives,
        )
        other.enter(slot, text)
        for name in without:
            if other.entered.get(name) != NEW:
                other.entered.pop(name, None)
        for name, maker in self.makers.items():
            if name in without:
                continue
            copy = Form(maker.declaration, dict(maker.entered), dict(maker.values), (other, name))
            copy.given.update(maker.given)
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
