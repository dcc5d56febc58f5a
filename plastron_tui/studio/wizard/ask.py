"""A question to a kind of slot: which form, which slot, in which program."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

from plastron_tui.language import Slot, SlotKind
from plastron_tui.model.kinds import INTERFACES
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.targets import LIBRARIES

from .context import Meeting, Scene
from .form import Cell, Cells, Form

MEETINGS = {
    SlotKind.TOPIC: InterfaceKind.MESSAGE,
    SlotKind.SERVICE: InterfaceKind.SERVICE,
    SlotKind.ACTION: InterfaceKind.ACTION,
}
"""The slots that name what nodes meet at, and its kind of interface."""

_INTERFACES = {**INTERFACES, **MEETINGS}


class Trial(NamedTuple):
    """What comes of a choice.

    Attributes:
        reason: why it cannot be, None when it can.
        lonely: how many topics, services and actions lack a side then.
        slot: the slot that the reason is about, or that needs what it is about; "" where it is
            about something else.
    """

    reason: str | None
    lonely: int
    slot: str = ""


@dataclass(frozen=True, slots=True)
class Choice:
    """Something that can be taken for a slot.

    Attributes:
        text: what is entered then.
        note: what it is, in a word or two.
        about: a line about it.
        closed: why it cannot be taken; "" for one that can.
        label: what is shown in the place of the text.
        swatch: the colour that it stands for, as `#3060ff`.
    """

    text: str
    note: str = ""
    about: str = ""
    closed: str = ""
    label: str = ""
    swatch: str = ""


@dataclass(slots=True)
class Ask:
    """A question about a slot; `cells` has what is in the slots before it, at least."""

    form: Form
    slot: Slot
    scene: Scene
    cells: Cells
    try_out: Callable[[str, frozenset[str]], Trial]
    """Tell what comes of a text in the slot, without what was entered in some others."""
    around: Cells = field(default_factory=dict)
    """The cells of the form that this one makes something for."""
    is_trial: bool = False
    """Whether this is about a trial: a suggestion then does without trials of its own."""

    def cell(self, *kinds: SlotKind) -> Cell | None:
        """Return what is in the first slot of some kinds."""
        slot = self.form.slot_of(*kinds)
        return None if slot is None else self.cells.get(slot.name)

    @property
    def held(self) -> frozenset[str]:
        """What is in the other slots of this kind."""
        same = (each for each in self.form.declaration.slots if each.kind is self.slot.kind)
        return frozenset(
            self.cells[each.name].text
            for each in same
            if each.name != self.slot.name and each.name in self.cells
        )

    def text(self, *kinds: SlotKind) -> str:
        """Return the text in the first slot of some kinds, "" where there is none."""
        cell = self.cell(*kinds)
        return "" if cell is None else cell.text

    def text_of(self, slot: str) -> str:
        """Return the text in a slot by its name, "" where it is not filled yet."""
        cell = self.cells.get(slot)
        return "" if cell is None else cell.text

    def parent_text(self, *kinds: SlotKind) -> str:
        """Return the text in a slot of the form that this one makes something for."""
        if self.form.parent is None:
            return ""
        slot = self.form.parent[0].slot_of(*kinds)
        return "" if slot is None else self.around.get(slot.name, Cell()).text

    @property
    def node(self) -> str:
        """The variable of the node that the statement is about, "" where there is none."""
        return self.text(SlotKind.NODE) or self.parent_text(SlotKind.NODE)

    @property
    def version(self) -> int:
        """The generation of ROS that the statement is for."""
        library = self.text(SlotKind.LIBRARY)
        if library in LIBRARIES:
            return LIBRARIES[library].ros_version
        if self.node:
            return self.scene.version_of(self.node)
        if self.form.slot_of(SlotKind.NODE_NAME) is not None:
            return self.scene.version_of(None)
        return self.scene.usual_version

    @property
    def interface(self) -> InterfaceKind:
        """Whether the statement is about messages, services or actions."""
        slots = self.form.declaration.slots
        found = (_INTERFACES[slot.kind] for slot in slots if slot.kind in _INTERFACES)
        return next(found, InterfaceKind.MESSAGE)

    @property
    def meeting(self) -> Meeting | None:
        """The topic, service or action that the statement names, None where nobody is there yet."""
        name = self.text(*MEETINGS)
        if not name:
            return None
        return self.scene.meeting(self.interface, self.node, name, self.version)
