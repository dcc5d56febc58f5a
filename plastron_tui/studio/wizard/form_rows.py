"""What the rows of a form are: for each slot, and for each field of the values."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from plastron_tui.language import Slot, SlotKind
from plastron_tui.language.declaration import Form as Written
from plastron_tui.model.workspace import Workspace

from .definition_rows import field_slots, row_path
from .filling import Filled
from .form import new_words
from .libraries import ros_of
from .rows import Row
from .values import Entry, Heading, Path

Key = tuple[str, "Path | None"]

_LEFT_OUT = {
    SlotKind.TRIGGER: "or when something arrives",
    SlotKind.CONDITION: "always",
}
"""What is shown in a slot that is left out, where there is more to say of it."""


_NOTES = {
    SlotKind.NODE_NAME: "its name in ROS",
    SlotKind.NEW_NODE: "its name in here",
    SlotKind.MANAGED: "switched on later",
    SlotKind.RATE: "times a second",
}
"""What stands beside a slot, for who reads the form before going through it."""


class Spec(NamedTuple):
    """A row, or a heading between rows."""

    key: Key | None
    slot: Slot | None
    entry: Entry | None
    label: str
    text: str
    note: str
    is_fixed: bool
    placeholder: str = ""

    @property
    def shape(self) -> tuple[object, ...]:
        """What must be the same for a row to be kept."""
        note = self.note if self.key is None else ""
        return self.key, self.is_fixed, self.label, self.entry, note


def specs(filled: Filled) -> list[Spec]:
    """Return the rows of a form."""
    specs: list[Spec] = []
    optional = filled.form.optional
    for slot in filled.form.declaration.slots:
        cell = filled.cells[slot.name]
        if slot.name in filled.parts:
            specs += _part_specs(slot, filled)
            continue
        if slot.kind.form is Written.VALUES:
            specs += _value_specs(slot, filled)
            continue
        if slot.kind.form is Written.FIELDS:
            specs += _field_specs(slot, filled)
            continue
        text = new_words(slot) if cell.is_new else cell.text
        label = slot.name.replace("_", " ")
        is_flag = slot.kind.form is Written.FLAG
        left_out = _LEFT_OUT.get(slot.kind, "may stay empty")
        placeholder = left_out if slot.name in optional and not is_flag else ""
        is_fixed = bool(cell.reason)
        note = cell.reason or _NOTES.get(slot.kind, "")
        if slot.kind is SlotKind.LIBRARY:
            note = ros_of(filled.scene, cell.text)
            # What it is as long as nobody says another one.
            placeholder = filled.scene.session.library
        key = (slot.name, None)
        specs.append(Spec(key, slot, None, label, text, note, is_fixed, placeholder))
    return specs


def _value_specs(slot: Slot, filled: Filled) -> list[Spec]:
    specs = []
    if not any(isinstance(each, Entry) for each in filled.entries):
        return [Spec(None, None, None, slot.name, "", "takes no values", False)]
    for each in filled.entries:
        indent = "  " * (len(each.path) - 1)
        if isinstance(each, Heading):
            specs.append(Spec(None, None, None, indent + each.path[-1], "", each.note, False))
            continue
        text = filled.given.get(each.path, "")
        key = (slot.name, each.path)
        label = indent + each.path[-1]
        kind = str(each.type).rpartition("/")[2]
        note = each.meaning.said if each.meaning is not None else kind
        specs.append(Spec(key, slot, each, label, text, note, False, each.default))
    return specs


def _part_specs(slot: Slot, filled: Filled) -> list[Spec]:
    """Return the rows of a place, or of a shape."""
    return [
        Spec((slot.name, path), slot, None, f"{slot.name} {part.name}", text, part.note, False,
              part.without)
        for part, path, text in filled.parts[slot.name]
    ]  # fmt: skip


def _field_specs(slot: Slot, filled: Filled) -> list[Spec]:
    """Return the rows of the fields of a definition."""
    several = len(field_slots(filled.form)) > 1
    specs = []
    if several:
        specs.append(Spec(None, None, None, slot.name, "", slot.help, False))
    for number, text in enumerate(filled.rows[slot.name]):
        key = (slot.name, row_path(slot, number))
        label = f"{'  ' if several else ''}field {number + 1}"
        more = "another field, or none" if number else "none"
        specs.append(Spec(key, slot, None, label, text, "", False, more))
    return specs


def matters(row: Row, workspace: Workspace) -> bool:
    """Tell whether somebody has to think of a row: most leave a name that is suggested."""
    kind = row.slot.kind
    if kind is SlotKind.NAMED or (kind is SlotKind.MESSAGE and row.text == new_words(row.slot)):
        return False
    if kind.form is Written.VARIABLE and kind.makes is not None:
        return False
    named: dict[SlotKind, Mapping[str, object]] = {
        SlotKind.NODE: workspace.nodes,
        SlotKind.ROBOT: workspace.robots,
        SlotKind.PACKAGE: workspace.packages,
        SlotKind.LAUNCH: workspace.launches,
        SlotKind.OWN_TYPE: workspace.types,
    }
    return kind not in named or len(named[kind]) != 1
