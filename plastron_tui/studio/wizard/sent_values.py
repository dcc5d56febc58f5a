"""What was entered in a form, checked, as the values that a running node is sent."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from plastron_tui.language import Document, lower
from plastron_tui.language.sentence import quoted
from plastron_tui.language.statements import CreateMessage
from plastron_tui.model.value_check import Fitter
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface
from plastron_tui.ros.parameters import ParameterType, as_setting

from .values import Entry, Heading, Path, input_text, is_computed, pieces, problem_of


class Wrong(NamedTuple):
    """What is wrong with what was entered, and the field that it is about, if it is about one."""

    message: str
    path: Path | None = None


_PLAIN_ITEM = re.compile(r"\w[\w./-]*", re.ASCII)
_COMPUTED = "a value that is sent now is written as it is, not computed"


def sent_values(
    interface: Interface,
    catalog: Catalog,
    form: Sequence[Entry | Heading],
    given: Mapping[Path, str],
) -> dict[str, Any] | Wrong:
    """Return the values of a message or a request, by field, or what is wrong with them.

    They are checked as those of a program are.

    Args:
        interface: the type of the topic, or of the service.
        catalog: the types of its generation of ROS.
        form: the fields, as `entries_of` has them.
        given: what was entered.
    """
    wrong = _first_problem(form, given, catalog.ros_version)
    if wrong is not None:
        return wrong
    text, used = input_text(list(form), given)
    if not used:
        return {}
    line = f"create_message sent of message_type {interface.name} and input {text}"
    program = lower(Document(line.encode("utf-8", "surrogatepass")))
    statement = next(iter(program.statements), None)
    if not isinstance(statement, CreateMessage):
        first = next(iter(program.diagnostics), None)
        return Wrong("this cannot be sent" if first is None else first.message)
    value = Fitter(catalog).fit(interface, interface.fields, statement, "input")
    if isinstance(value, tuple):
        return Wrong(value[0].message)
    return {name: _plain(each) for name, each in value.fields.items()}


def sent_setting(entry: Entry, type_: ParameterType, text: str, ros_version: int) -> Any | Wrong:
    """Return the value that a parameter is to get, or what is wrong with it."""
    if is_computed(text):
        return Wrong(_COMPUTED, entry.path)
    problem = problem_of(entry, text, ros_version)
    if problem is not None:
        return Wrong(problem, entry.path)
    element = type_.element
    if not type_.is_list:
        value: Any = _scalar(element, text)
    else:
        inner = text.strip().removeprefix("[").removesuffix("]")
        value = [_scalar(element, _unquoted(each)) for each in pieces(inner)]
    if as_setting(type_, value) is None:
        return Wrong("it is too large for the parameter", entry.path)
    return value


def setting_text(value: object) -> str:
    """Return the value of a parameter as `sent_setting` reads it."""
    if isinstance(value, (list, tuple)):
        return ", ".join(map(_item_text, value))
    return str(value)


def _item_text(value: object) -> str:
    text = str(value)
    return quoted(text) if isinstance(value, str) and not _PLAIN_ITEM.fullmatch(text) else text


def _first_problem(
    form: Sequence[Entry | Heading], given: Mapping[Path, str], ros_version: int
) -> Wrong | None:
    for entry in form:
        text = given.get(entry.path, "")
        if isinstance(entry, Heading) or not text:
            continue
        if is_computed(text):
            return Wrong(_COMPUTED, entry.path)
        problem = problem_of(entry, text, ros_version)
        if problem is not None:
            return Wrong(problem, entry.path)
    return None


def _plain(value: Any) -> Any:
    """Return a value as JSON has it."""
    match value:
        case MessageValue(fields=fields):
            return {name: _plain(each) for name, each in fields.items()}
        case tuple():
            return [_plain(each) for each in value]
        case _:
            return value


def _unquoted(text: str) -> str:
    if len(text) < 2 or not text[0] == text[-1] == '"':
        return text
    try:
        # The escapes of the language are among those of JSON.
        return str(json.loads(text, strict=False))
    except ValueError:
        return text[1:-1]


def _scalar(type_: ParameterType, text: str) -> Any:
    plain = text.strip()
    match type_:
        case ParameterType.BOOL:
            return plain.lower() in ("true", "yes", "on", "1")
        case ParameterType.INT:
            return int(plain)
        case ParameterType.FLOAT:
            return float(plain)
        case _:
            return text
