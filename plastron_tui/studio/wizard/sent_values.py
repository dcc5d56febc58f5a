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
from plastron_tui.ros.parameters import ParameterType, Setting, as_setting

from .values import Entry, Heading, Path, input_text, is_computed, pieces, problem_of, written


class Wrong(NamedTuple):
    """What is wrong with what was entered, and the field that it is about, if it is about one."""

    message: str
    path: Path | None = None


_NOT_FINITE = re.compile(r"(?<![\w.])(inf|nan)(?![\w.])", re.ASCII | re.IGNORECASE)
_OF_LISTS = frozenset(',"\\[]')
"""What means something else in a list than itself."""
_COMPUTED = "a value that is sent now is written as it is, not computed"


def sent_values(
    interface: Interface,
    catalog: Catalog,
    form: Sequence[Entry | Heading],
    given: Mapping[Path, str],
) -> dict[str, Any] | Wrong:
    """Return the values of a message or a request, by field, or what is wrong with them.

    They are checked as those of a program are; other than there a number may be `inf` or `nan`,
    as an open room is in a laser's scan. JSON has them as Python does: `Infinity`, `NaN`.

    Args:
        interface: the type of the topic, or of the service.
        catalog: the types of its generation of ROS.
        form: the fields, as `entries_of` has them.
        given: what was entered.
    """
    finite, boundless = _split_finite(form, given, catalog.ros_version)
    wrong = _first_problem(form, finite, catalog.ros_version)
    if wrong is not None:
        return wrong
    text, used = input_text(list(form), finite)
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
    sent = {name: _plain(each) for name, each in value.fields.items()}
    for path, number in boundless.items():
        _set(sent, path, number)
    return sent


def _split_finite(
    form: Sequence[Entry | Heading], given: Mapping[Path, str], ros_version: int
) -> tuple[dict[Path, str], dict[Path, Any]]:
    """Return what was entered with 0.0 for each `inf` and `nan`, and the values that have those."""
    finite, boundless = dict(given), dict[Path, Any]()
    for entry in form:
        if isinstance(entry, Heading) or entry.python is not float or entry.is_time:
            continue
        text = given.get(entry.path, "")
        changed = _NOT_FINITE.sub("0.0", text)
        if changed == text or _has_computed(entry, text):
            continue
        finite[entry.path] = changed
        if problem_of(entry, changed, ros_version) is None:
            type_ = ParameterType.FLOAT_LIST if entry.type.is_array else ParameterType.FLOAT
            boundless[entry.path] = _value_of(type_, text)
    return finite, boundless


def _set(values: dict[str, Any], path: Path, value: Any) -> None:
    for name in path[:-1]:
        values = values[name]
    values[path[-1]] = value


def shown_setting(value: Setting) -> str:
    """Return the value of a parameter as it stands in its field; `sent_setting` takes it back.

    A text stands there as it is, where it can be seen and means nothing else; else in double
    quotes, escaped as in a program.
    """
    if isinstance(value, tuple):
        return ", ".join(
            quoted(each) if isinstance(each, str) and not _is_plain_item(each) else str(each)
            for each in value
        )
    if isinstance(value, str) and not _is_plain(value):
        return quoted(value)
    return str(value)


def sent_setting(entry: Entry, type_: ParameterType, text: str, ros_version: int) -> Any | Wrong:
    """Return the value that a parameter is to get, or what is wrong with it.

    Other than in a program a number may be `inf` or `nan`: a node may have such a value already.
    """
    if _has_computed(entry, text):
        return Wrong(_COMPUTED, entry.path)
    checked = _NOT_FINITE.sub("0.0", text) if type_.element is ParameterType.FLOAT else text
    if type_ is ParameterType.STRING:
        checked = _unquoted(text)
    problem = problem_of(entry, checked, ros_version)
    if problem is not None:
        return Wrong(problem, entry.path)
    if as_setting(type_, _value_of(type_, checked)) is None:
        return Wrong("it is too large for the parameter", entry.path)
    return _value_of(type_, text)


def written_setting(entry: Entry, type_: ParameterType, text: str) -> str | None:
    """Return the value of a parameter as a program writes it; None for one that none can have."""
    plain = _unquoted(text) if type_ is ParameterType.STRING else text
    # A node may be told `inf`.
    return None if problem_of(entry, plain, 2) is not None else written(entry, plain)


def _value_of(type_: ParameterType, text: str) -> Any:
    if not type_.is_list:
        return _scalar(type_, text)
    return [_scalar(type_.element, each) for each in _items(text)]


def _items(text: str) -> list[str]:
    return pieces(text.strip().removeprefix("[").removesuffix("]"))


def _has_computed(entry: Entry, text: str) -> bool:
    """Tell whether a value, or one of a list, is computed; in a list of texts it is a text."""
    if not entry.type.is_array or entry.python in (str, None):
        return is_computed(text)
    return any(map(is_computed, _items(text)))


def _is_plain(text: str) -> bool:
    """Tell whether a text is taken for itself, and can be seen, in a field of its own."""
    is_seen = text.isprintable() and text == text.strip()
    return is_seen and not (_is_quoted(text) or is_computed(text))


def _is_plain_item(text: str) -> bool:
    """Tell the same of a text in a list."""
    return bool(text) and _is_plain(text) and not _OF_LISTS & set(text)


def _is_quoted(text: str) -> bool:
    return len(text) > 1 and text[0] == text[-1] == '"'


def _first_problem(
    form: Sequence[Entry | Heading], given: Mapping[Path, str], ros_version: int
) -> Wrong | None:
    for entry in form:
        text = given.get(entry.path, "")
        if isinstance(entry, Heading) or not text:
            continue
        if _has_computed(entry, text):
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
    """Return the text that stands in double quotes; one without them is itself."""
    if not _is_quoted(text):
        return text
    try:
        # The escapes of programs are those of JSON.
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
            return _unquoted(text)
