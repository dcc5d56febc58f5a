"""From a row of the live panel to a form, and from what was entered to an order for a monitor."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.runtime.live_graph import LiveField
from plastron_tui.runtime.live_parts import LiveParameter
from plastron_tui.session import Session

from ..panels.live_row import Kind, LiveRow
from .live_form import LiveForm
from .live_rates import RATE, rate_of
from .live_start import conditioned_fields, first_values, start_of
from .parameter_kinds import parameter_entry
from .sent_values import Wrong, sent_setting, sent_values, shown_setting, written_setting
from .values import Path, entries_of

_LONGEST = 20_000
"""Characters of a value that a field takes without keeping keys waiting."""


class LiveOrder(NamedTuple):
    """A form, and what makes an order of what was entered in it."""

    dialog: LiveForm
    order: Callable[[Mapping[Path, str]], dict[str, Any]]


class _Sent(NamedTuple):
    """What is sent to an endpoint of a kind, and how a form and an order say so."""

    kind: InterfaceKind
    order: str
    title: str
    verb: str
    has_rate: bool = False


_MESSAGE = _Sent(InterfaceKind.MESSAGE, "publish", "send to", "Send", has_rate=True)
_REQUEST = _Sent(InterfaceKind.SERVICE, "call", "call", "Call")
_GOAL = _Sent(InterfaceKind.ACTION, "goal", "send a goal to", "Send")


def form_for(
    row: LiveRow,
    session: Session,
    given: Mapping[Path, str],
    seen: Iterable[LiveField] = (),
    at: Path = (),
    edited: Path = (),
) -> LiveOrder | str:
    """Return the form for what can be sent to a topic, a service, an action or a parameter.

    Where nothing can be sent, why that is so.

    Args:
        row: what it is for.
        session: the program, with its own types.
        given: what was entered the last time.
        seen: the fields of the last message that came, which a form begins with that was never
            filled in.
        at: the field that the cursor is on in the panel, which the form begins at; else at one
            that a condition of the program reads.
        edited: the field that was written in last, at which it begins else.
    """
    match row.kind:
        case Kind.TOPIC:
            read = conditioned_fields(session.workspace, row.owner, row.type)
            return _sending(row, session, given, _MESSAGE, seen, (at, *read, edited))
        case Kind.SERVICE:
            return _sending(row, session, given, _REQUEST, wanted=(edited,))
        case Kind.ACTION:
            return _sending(row, session, given, _GOAL, wanted=(edited,))
        case Kind.PARAMETER:
            return _setting(row)
        case _:
            return "there is nothing to send to that"


def _sending(
    row: LiveRow,
    session: Session,
    given: Mapping[Path, str],
    sent: _Sent,
    seen: Iterable[LiveField] = (),
    wanted: Iterable[Path] = (),
) -> LiveOrder | str:
    package, _, name = row.type.partition("/")
    catalog = session.catalog(row.ros_version)
    interface = catalog.find(InterfaceName(package, name), sent.kind)
    if interface is None:
        return f"the fields of {row.type or 'its type'} are not known here"
    form = entries_of(interface, catalog)

    def check(entered: Mapping[Path, str]) -> dict[str, Any] | Wrong:
        rate = rate_of(entered) if sent.has_rate else 0.0
        return rate if isinstance(rate, Wrong) else sent_values(interface, catalog, form, entered)

    about = f"{interface.name}: {interface.comment}" if interface.comment else str(interface.name)
    if not given:
        given = first_values(form, seen) if sent is _MESSAGE else {}
        given = {} if isinstance(check(given), Wrong) else given
    last = RATE if sent.has_rate else None
    title = f"{sent.title} {row.owner}"
    dialog = LiveForm(title, sent.verb, form, check, given, about, last,
                      start_of(form, wanted))  # fmt: skip
    order = {"do": sent.order, "name": row.owner, "type": row.type}

    def ordered(entered: Mapping[Path, str]) -> dict[str, Any]:
        rate = {"rate": rate_of(entered)} if sent.has_rate else {}
        return {**order, **rate, "values": check(entered)}

    return LiveOrder(dialog, ordered)


def _setting(row: LiveRow) -> LiveOrder | str:
    parameter = row.parameter
    if parameter is None or parameter.is_read_only:
        return "this parameter cannot be set while its node runs"
    try:
        type_ = ParameterType(parameter.type)
    except ValueError:
        return "a parameter without a type cannot be set here"
    entry = parameter_entry(parameter.name, type_)

    value = parameter.value
    shown = "" if value is None else shown_setting(value)
    if len(shown) > _LONGEST:
        return f"its value is too long to be changed here: {len(shown):,} characters"
    given = {entry.path: shown}

    limits = "" if parameter.range is None else "from {:g} to {:g}".format(*parameter.range)

    def check(entered: Mapping[Path, str]) -> Any:
        found = sent_setting(entry, type_, entered.get(entry.path, ""), row.ros_version)
        if isinstance(found, Wrong) or _is_within(found, parameter.range):
            return found
        return Wrong(f"{parameter.name} takes a number {limits}", entry.path)

    about = ". ".join(filter(None, (parameter.about, limits)))
    dialog = LiveForm(f"set {parameter.name} of {row.owner}", "Set", [entry], check,
                      given, about)  # fmt: skip
    order = {"do": "set", "node": row.owner, "name": parameter.name, "type": type_.value}
    return LiveOrder(dialog, lambda entered: {**order, "value": check(entered)})


def default_text(parameter: LiveParameter, given: Mapping[Path, str]) -> str | None:
    """Return what was entered for a parameter as a program writes it; None where none can."""
    type_ = ParameterType(parameter.type)
    entry = parameter_entry(parameter.name, type_)
    return written_setting(entry, type_, given.get(entry.path, ""))


def _is_within(value: Any, limits: tuple[float, float] | None) -> bool:
    """Tell whether a parameter's value is within its range; only a number can be outside."""
    if limits is None or isinstance(value, bool) or not isinstance(value, (int, float)):
        return True
    return limits[0] <= value <= limits[1]
