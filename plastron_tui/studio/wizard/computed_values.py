"""What the values of a form can be computed of when they are sent: offered, and mended."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from plastron_tui.language import SlotKind
from plastron_tui.language.corrections import corrected
from plastron_tui.model.kinds import INTERFACES, Parameter
from plastron_tui.model.kinds.computed import fits
from plastron_tui.model.kinds.received import What, what_of
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, InterfaceKind

from ..editor.value_completion import fields_of, fitting
from .ask import Ask, Choice
from .values import NUMBER, Entry, is_computed, problem_of

_QUOTES = "['\"`]?"
_NAME = re.compile(
    rf"(?<![\w.])(?:parameter\s*{_QUOTES}(?P<parameter>[\w.]+){_QUOTES}|[A-Za-z]\w*(?:\.\w+)*)",
    re.ASCII,
)
_BRACKETS = re.compile("[()]")
_SUMMED = range(2, 5)
"""Of how many numbers the sum is offered."""

_NUMBERS = frozenset({What(int, is_list=False), What(float, is_list=False)})
_NO_BRACKETS = (
    "a calculation has no brackets; for one that needs them leave this empty: after Finish, Alt-C "
    "opens the code"
)


@dataclass(frozen=True, slots=True)
class Sources:
    """What values can be computed of.

    Attributes:
        parameters: the parameters, by the names that programs write.
        heard: the fields of what is received then.
        catalog: the types.
        is_asked: whether what is received is the request of a service, which is answered.
    """

    parameters: Mapping[str, Parameter]
    heard: tuple[Field, ...]
    catalog: Catalog
    is_asked: bool
    _known: dict[FieldType, list[Choice]] = field(default_factory=dict)

    def choices(self, entry: Entry) -> list[Choice]:
        """Return what a field can take as it is."""
        if entry.type not in self._known:
            self._known[entry.type] = [
                Choice(each.text, each.detail)
                for each in fitting(entry.type, self.parameters, self.heard, self.catalog)
            ]
        offered, total = self._known[entry.type], self._sum(entry)
        if total is None:
            return offered
        return [total, *offered] if entry.path[-1] == "sum" else [*offered, total]

    def _sum(self, entry: Entry) -> Choice | None:
        """Return the sum of all numbers that are asked for, None where no answer can be it."""
        version = self.catalog.ros_version
        if not self.is_asked or len(self.heard) not in _SUMMED or entry.type.is_array:
            return None
        kinds = {what_of(each.type, version) for each in self.heard}
        is_sum = kinds <= _NUMBERS and all(
            fits(entry.type, each.type, version) for each in self.heard
        )
        written = " + ".join(f"received.{each.name}" for each in self.heard)
        return Choice(written, "the sum") if is_sum else None

    def example(self, entry: Entry) -> str:
        """Return an example of each kind that a field can take, "" where there is none."""
        offered = [each.text for each in self.choices(entry)]
        of_parameter = [each for each in offered if each.startswith("parameter")]
        of_received = [each for each in offered if not each.startswith("parameter")]
        is_float = entry.python is float and not (entry.type.is_array or entry.is_time)
        step = " * 0.5" if is_float else ""
        shown = [*of_parameter[:1], *(each + step for each in of_received[:1])]
        return " or ".join(f"`{each}`" for each in shown)

    def problem(self, entry: Entry, text: str) -> str | None:
        """Tell why a value does not fit its field, and what was meant, as far as is known."""
        version = self.catalog.ros_version
        problem = problem_of(entry, text, version, self.example(entry))
        if problem is None or NUMBER.fullmatch(text.strip()):
            return problem
        meant = self.mended(text)
        if meant is not None:
            return f"write `{meant}`"
        is_calculated = "(" in text and self.mended(_BRACKETS.sub("", text)) is not None
        return _NO_BRACKETS if is_calculated else problem

    def mended(self, text: str) -> str | None:
        """Return what somebody means who does not write it as a program does, None for nothing."""
        meant = corrected(_NAME.sub(self._known_as, text.strip()))
        return meant if meant is not None and is_computed(meant) else None

    def _known_as(self, name: re.Match[str]) -> str:
        """Return a parameter, or a part of what is received, as a program names it."""
        path, names = name[0], {each.name for each in self.heard}
        if name["parameter"] is not None:
            return f"parameter '{name['parameter']}'"
        for part in (path, path.partition(".")[2]):
            if part.partition(".")[0] in names:
                return f"received.{part}"
        return f"parameter '{path}'" if path in self.parameters else path


def sources_of(ask: Ask) -> Sources:
    """Return what the values of a slot can be computed of.

    A message that is not sent yet may be made of what any node has, as in the editor.
    """
    names_node = ask.form.slot_of(SlotKind.NODE) is not None or ask.form.parent is not None
    parameters = ask.scene.parameters(ask.node if names_node else None)
    catalog = ask.scene.catalog(ask.version)
    is_asked = ask.slot.kind is SlotKind.ANSWER
    return Sources(parameters, tuple(fields_of(_heard(ask))), catalog, is_asked)


def _heard(ask: Ask) -> Iterable[object]:
    """Yield the types of what is received when the values are sent."""
    if ask.slot.kind is SlotKind.ANSWER:
        yield ask.scene.resolve(ask.text(*INTERFACES), ask.interface, ask.version)
        return
    if ask.form.parent is not None:
        types = [ask.scene.heard(ask.node).get(ask.parent_text(SlotKind.TRIGGER))]
    elif ask.form.made is not None:
        types = list(ask.scene.vocabulary.heard_with(ask.text(SlotKind.NEW_MESSAGE)))
    else:
        types = []
    catalog = ask.scene.catalog(ask.version)
    yield from (catalog.find(each, InterfaceKind.MESSAGE) for each in types if each is not None)


def is_about(message: str, text: str) -> bool:
    """Tell whether a message names what a value is computed of."""
    names = (
        each["parameter"] or each[0].removeprefix("received.") for each in _NAME.finditer(text)
    )
    return any(re.search(rf"[`.']{re.escape(name)}\b", message) for name in names)
