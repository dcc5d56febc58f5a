"""From a row of the live panel to a form, and from what was entered to an order for a monitor."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.session import Session

from ..panels.live_rows import Kind, LiveRow
from .live_form import LiveForm
from .parameter_kinds import parameter_entry
from .sent_values import Wrong, sent_setting, sent_values, shown_setting
from .values import Path, entries_of

_LONGEST = 20_000
"""Characters of a value that a field takes without keeping keys waiting."""


class LiveOrder(NamedTuple):
    """A form, and what makes an order of what was entered in it."""

    dialog: LiveForm
    order: Callable[[Mapping[Path, str]], dict[str, Any]]


def form_for(row: LiveRow, session: Session, given: Mapping[Path, str]) -> LiveOrder | str:
    """Return the form for what can be sent to a topic, a service or a parameter, or why not.

    Args:
        row: what it is for.
        session: the program, with its own types.
        given: what was entered the last time.
    """
    match row.kind:
        case Kind.TOPIC:
            return _sending(row, session, given, InterfaceKind.MESSAGE)
        case Kind.SERVICE | Kind.ANSWER:
            return _sending(row, session, given, InterfaceKind.SERVICE)
        case Kind.PARAMETER:
            return _setting(row)
        case _:
            return "there is nothing to send to that"


def _sending(
    row: LiveRow, session: Session, given: Mapping[Path, str], kind: InterfaceKind
) -> LiveOrder | str:
    package, _, name = row.type.partition("/")
    catalog = session.catalog(row.ros_version)
    interface = catalog.find(InterfaceName(package, name), kind)
    if interface is None:
        return f"the fields of {row.type or 'its type'} are not known here"
    form = entries_of(interface, catalog)

    def check(entered: Mapping[Path, str]) -> dict[str, Any] | Wrong:
        return sent_values(interface, catalog, form, entered)

    is_topic = kind is InterfaceKind.MESSAGE
    title = f"{'send to' if is_topic else 'call'} {row.owner}"
    verb = "Send" if is_topic else "Call"
    about = f"{interface.name}: {interface.comment}" if interface.comment else str(interface.name)
    dialog = LiveForm(title, verb, form, check, given, about)
    order = {"do": "publish" if is_topic else "call", "name": row.owner, "type": row.type}
    return LiveOrder(dialog, lambda entered: {**order, "values": check(entered)})


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


def _is_within(value: Any, limits: tuple[float, float] | None) -> bool:
    """Tell whether a parameter's value is within its range; only a number can be outside."""
    if limits is None or isinstance(value, bool) or not isinstance(value, (int, float)):
        return True
    return limits[0] <= value <= limits[1]
