"""When something is sent, and how: the rate, once, for what arrives, the quality of service."""

from __future__ import annotations

import re

from plastron_tui.diagnostics import listed
from plastron_tui.language import SlotKind
from plastron_tui.model.kinds import HIGHEST_RATE, INTERFACES, LOWEST_RATE
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.field_meanings import meaning_of, rank_of
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.primitives import primitive
from plastron_tui.ros.qos_words import Said, is_sensor_type, offered_words, parse_words

from ..editor.value_completion import Part, all_received
from . import driving_conditions
from .ask import Ask, Choice
from .form import NEW, Cell, new_words
from .kind import Kind
from .obstacles import distances_heard, distances_of_trigger, way_is_free
from .trials import first_that_works

_CONDITION = re.compile(
    r"((any|all) )?received(\.[A-Za-z]\w*)+(\[\d+\])?\s*[<>=]\s*\S.*", re.ASCII | re.DOTALL
)
_TYPED = re.compile(
    r"\s*((?P<quantifier>any|all)\s+)?(received\.?)?(?P<path>[\w.]*)(?P<at>\[\d+\])?"
    r"\s*((?P<operator>[<>=]+)\s*(?P<value>.*))?",
    re.ASCII | re.DOTALL,
)
"""A condition, or what there is of it by now."""
_PARAMETER = re.compile(r"parameter\s*'([^']*)'")


class RateKind(Kind):
    """How often something is sent, or done."""

    def suggest(self, ask: Ask) -> str:
        """Return a rate, or nothing for what is usually done once: a request."""
        if ask.form.drives:
            return ""
        is_request = ask.form.slot_of(SlotKind.INPUT) is not None
        return "" if is_request and ask.slot.name in ask.form.optional else "10"

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return usual rates, and the parameters of the node that can say it."""
        parameters = ask.scene.parameters(ask.node).items()
        return [
            Choice("1", "once a second"),
            Choice("2", "twice a second"),
            Choice("10", "ten times a second"),
            Choice("30", "as often as a camera"),
            *(
                Choice(f"parameter '{name}'", "as often as that says")
                for name, each in parameters
                if each.holds is not None and each.holds.is_number
            ),
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        named = _PARAMETER.fullmatch(text)
        if named is not None:
            known = ask.scene.parameters(ask.node)
            return None if named[1] in known else f"`{ask.node}` has no parameter `{named[1]}`"
        try:
            rate = float(text) if text.isascii() and "_" not in text else 0.0
        except ValueError:
            return "it is a number of times a second, such as 10 or 0.5"
        if rate <= 0 or rate > HIGHEST_RATE:
            return "it is more than 0, and at most a million, times a second"
        if rate < LOWEST_RATE:
            return "so seldom that it would never be: it is once in thirty years at least"
        return None


class FlagKind(Kind):
    """A word that stands there or not."""


class TriggerKind(Kind):
    """The topic for each message of which something is sent."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return that there is none where the node listens to nothing."""
        is_entered = ask.form.entered.get(ask.slot.name)
        is_open = ask.scene.heard(ask.node) or is_entered or ask.form.drives
        return None if is_open else Cell("", "it listens to nothing yet")

    def suggest(self, ask: Ask) -> str:
        """Return what says how near things are, where a robot is to drive by that."""
        return next(iter(distances_heard(ask)), NEW) if ask.form.drives else ""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return what the node listens to; to drive by, what of that has distances."""
        heard = ask.scene.heard(ask.node)
        names = distances_heard(ask) if ask.form.drives else heard
        found = [Choice(name, str(heard[name] or "")) for name in names]
        if ask.form.drives:
            about = "a later screen asks for its name"
            found.append(Choice(NEW, "", about, label=new_words(ask.slot)))
        return found

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        heard = ask.scene.heard(ask.node)
        if text in heard:
            is_blind = ask.form.drives and text not in distances_heard(ask)
            return f"`{text}` does not say how far away things are" if is_blind else None
        if not heard:
            return f"`{ask.node}` listens to no topic yet"
        return f"`{ask.node}` does not listen to `{text}`, but to {listed(list(heard))}"


class ConditionKind(Kind):
    """What must hold of what arrives."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return that there is none where nothing has to arrive."""
        has_trigger = bool(ask.text(SlotKind.TRIGGER))
        return None if has_trigger else Cell("", "only with a trigger")

    def suggest(self, ask: Ask) -> str:
        """Return that the way is free, where a robot is driven for each reading of distances."""
        return way_is_free(ask)

    def meant(self, ask: Ask, text: str) -> str:
        """Return when it drives, of who says when it stops."""
        return driving_conditions.meant(ask, text) if _is_to_drive(ask) else text

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return a condition for each field of what arrives, of those that are meant by a text."""
        if _is_to_drive(ask):
            return driving_conditions.choices(ask, query)
        type_ = ask.scene.heard(ask.node).get(ask.text(SlotKind.TRIGGER))
        catalog = ask.scene.catalog(ask.version)
        found = None if type_ is None else catalog.find(type_, InterfaceKind.MESSAGE)
        parts = [] if found is None else _by_weight(found, catalog)
        typed = _TYPED.fullmatch(query)
        wanted = "" if typed is None else typed["path"].lower()
        meant = [each for each in parts if wanted in each.path.removeprefix("received.").lower()]
        offered = []
        for each in meant or parts:
            text = _condition(each, typed if meant else None, catalog.ros_version)
            note = _noted(found, each, catalog)
            offered += [Choice(text, note)] if text else []
            if text.startswith("any ") and text.endswith(" < 0.5") and not wanted:
                far = f"all {each.path} > 0.5"
                offered.append(Choice(far, note))
        return offered

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no condition."""
        if _is_to_drive(ask):
            return driving_conditions.problem(ask, text)
        if _CONDITION.fullmatch(text):
            return None
        offered = [each.text for each in self.choices(ask, text)]
        typed = _TYPED.fullmatch(text)
        if typed is not None and typed["value"] and offered and typed["path"] in offered[0]:
            return f"write `{offered[0]}`"
        example = offered[0] if offered else "received.data > 5"
        return f"it compares a field of what arrives, such as `{example}`"


def _is_to_drive(ask: Ask) -> bool:
    """Tell whether a form drives a robot by distances, as long as the condition holds."""
    return ask.form.drives and bool(distances_of_trigger(ask))


def _by_weight(interface: Interface, catalog: Catalog) -> list[Part]:
    """Return the parts of a message, those first that matter most."""
    parts = all_received(interface.fields, catalog)
    return sorted(parts, key=lambda part: rank_of(catalog, interface, part.path.split(".")[1:]))


def _noted(interface: Interface | None, part: Part, catalog: Catalog) -> str:
    """Return what a part of a message means, or else its type."""
    path = part.path.split(".")[1:]
    meaning = None if interface is None else meaning_of(catalog, interface, path)
    return str(part.field.type) if meaning is None else meaning.said


def _condition(part: Part, typed: re.Match[str] | None, ros_version: int) -> str:
    """Return a condition on a field, with what was typed of it; "" for what is not compared."""
    known = primitive(part.field.type.name, ros_version)
    if part.field.type.package is not None or known is None or known.parts:
        return ""
    operator, _, value = {bool: "= True", str: '= ""', float: "< 0.5"}.get(
        known.kind, "> 5"
    ).partition(" ")
    quantifier, at = ("any " if part.field.type.is_array else ""), ""
    if typed is not None:
        if part.field.type.is_array and typed["at"]:
            quantifier, at = "", typed["at"]
        elif part.field.type.is_array and typed["quantifier"]:
            quantifier = f"{typed['quantifier']} "
        operator, value = (typed["operator"] or operator)[0], typed["value"] or value
    return f"{quantifier}{part.path}{at} {operator} {value}"


class QosKind(Kind):
    """How messages are to arrive."""

    def suggest(self, ask: Ask) -> str:
        """Return the words for readings of sensors, where those are what is sent."""
        word = "sensor_data"
        if ask.is_trial or ask.version == 1 or not is_sensor_type(_type_of(ask)):
            return ""
        return first_that_works(ask, [word]) or ""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the words that may follow those that are written."""
        said = _words(query)
        if said and parse_words(said)[1]:
            said = said[:-1]
        before = "".join(f"{_text(each)}, " for each in said)
        found = [] if said else [Choice("", "all messages, the last 10 kept", label="the usual")]
        words = offered_words([word for word, _ in said], ask.version, _type_of(ask))
        for word in words:
            example = {"depth": " 5", "": ""}.get(word.number, " 0.5")
            found.append(Choice(f"{before}{word.word}{example}", word.summary))
        return found

    def written(self, ask: Ask, text: str) -> str:
        """Return the words without what is around them."""
        return text.strip().rstrip(",")

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell what is wrong with words."""
        problems = parse_words(_words(text))[1]
        if not problems:
            return None
        first = problems[0]
        return f"{first.message} ({first.help})" if first.help else first.message


def _type_of(ask: Ask) -> InterfaceName | None:
    found = ask.scene.resolve(ask.text(*INTERFACES), ask.interface, ask.version)
    return None if found is None else found.name


def _words(text: str) -> list[Said]:
    """Return the words that are written, with their numbers."""
    return [_said(each.split()) for each in text.split(",") if each.strip()]


def _said(parts: list[str]) -> Said:
    word, *rest = parts
    if not rest:
        return word, None
    try:
        return word, float(" ".join(rest))
    except ValueError:
        return " ".join(parts), None


def _text(said: Said) -> str:
    word, number = said
    return word if number is None else f"{word} {number:.15g}"
