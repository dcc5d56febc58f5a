"""In which form what is wrong can be mended, where it is not the one that it was found in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plastron_tui.language import SlotKind

from .computed_values import is_about
from .filling import Filled, filled_of
from .program_trial import Finding
from .values import Path, is_computed


def where_mended(finding: Finding, filled: Sequence[Filled]) -> Finding:
    """Return what is wrong in the form where it can be mended."""
    form = finding.form
    known = None if form is None else filled_of(form, filled)
    cell = None if known is None else known.cells.get(finding.slot)
    if known is None or cell is None:
        return finding
    if cell.is_new:
        return _in_maker(finding, known)
    if cell.reason:
        return _in_parent(finding)
    named = _named(finding, known)
    return replace(finding, path=named[0]) if finding.path is not None and named else finding


def _in_parent(finding: Finding) -> Finding:
    """Return it where what a form takes over from the one around it is chosen."""
    form = finding.form
    if form is None or form.parent is None:
        return finding
    parent = form.parent[0]
    slot = next(each for each in form.declaration.slots if each.name == finding.slot)
    there = parent.slot_of(slot.kind)
    return finding if there is None else replace(finding, form=parent, slot=there.name)


def _in_maker(finding: Finding, known: Filled) -> Finding:
    """Return it at the value that is computed when what another form makes is sent."""
    maker = known.form.makers.get(finding.slot)
    made = None if maker is None else filled_of(maker, known.makers)
    slot = None if maker is None else maker.slot_of(SlotKind.INPUT)
    found = [] if made is None else _named(finding, made) or _computed(made)
    if slot is None or not found:
        return finding
    return replace(finding, form=maker, slot=slot.name, path=found[0])


def _computed(filled: Filled) -> list[Path]:
    return [each.path for each in filled.used if is_computed(filled.given[each.path])]


def _named(finding: Finding, filled: Filled) -> list[Path]:
    """Return the fields whose values are computed of what is named in the words."""
    return [path for path in _computed(filled) if is_about(finding.message, filled.given[path])]
