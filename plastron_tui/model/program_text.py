"""A file's nodes, written as a program that generates equivalent ones."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType

from plastron_tui.language import DECLARATIONS, SlotKind
from plastron_tui.language.keywords import KEYWORDS
from plastron_tui.language.sentence import quoted, sentence
from plastron_tui.language.statements import CreateMessage, HasParameter, Repeats
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.names import (
    check_node_name,
    check_parameter_name,
    mended_node_name,
    parameter_name,
)
from plastron_tui.ros.parameters import ParameterType, Setting, as_setting
from plastron_tui.ros.qos import DEFAULT, Qos
from plastron_tui.ros.qos_words import WORDS, text_of

from .endpoint_details import ParameterDetails, TimerDetails
from .kinds import HIGHEST_RATE, LOWEST_RATE
from .source import EndpointKind, SourceEndpoint, SourceNode, SourceUnit
from .unique_names import numbered

_SENDING = (EndpointKind.PUBLISHER, EndpointKind.CLIENT, EndpointKind.ACTION_CLIENT)


class Variables:
    """Hands out variables for the things of a program, each only once."""

    def __init__(self) -> None:
        self._taken: set[str] = set(KEYWORDS)

    def new(self, name: str) -> str:
        """Return a variable that is made from a name and not in use."""
        base = re.sub(r"[^A-Za-z0-9_]+", "_", name).strip("_")
        if not base[:1].isalpha() or not base.isascii():
            base = f"node_{base}".rstrip("_")
        variable = next(name for name in numbered(base) if name not in self._taken)
        self._taken.add(variable)
        return variable


def program_of(source: SourceUnit, ros_version: int) -> str:
    """Return a program of the nodes of a file.

    Every endpoint of which all is known that its statement says is one; what has no statement is
    a comment. What is sent, and how often, is not read; a comment says so.
    """
    variables = Variables()
    nodes = source.nodes or ()
    blocks = [_node(source, node, variables, ros_version) for node in nodes]
    return "\n".join("\n".join(block) + "\n" for block in blocks)


def _node(
    source: SourceUnit, node: SourceNode, variables: Variables, ros_version: int
) -> Iterator[str]:
    name = node.name
    if name is None or check_node_name(name, ros_version) is not None:
        told = f": {_shown(node.expression)}" if node.expression else ""
        yield f"// the file does not say the node's name{told}"
        stem = source.path.stem
        name = stem if check_node_name(stem, ros_version) is None else mended_node_name(stem, 1)
        name = name or "node"
    variable = variables.new(name)
    managed = " managed" if node.is_managed else ""
    yield f"create_node '{name}' as {variable}{managed} using {source.library}"
    seen: set[tuple[EndpointKind, str]] = set()
    parameters = node.parameters
    for endpoint in node.endpoints:
        key = (endpoint.kind, endpoint.label or "")
        details = endpoint.details
        if isinstance(details, TimerDetails) and details.serves:
            continue
        if isinstance(details, ParameterDetails) and endpoint.name is not None:
            if key in seen:
                continue
            statement = parameter_statement(
                variable, endpoint.name, parameters[endpoint.name], ros_version
            )
        elif isinstance(details, TimerDetails):
            statement = _timer(variable, endpoint, details)
        else:
            statement = _statement(endpoint, variable, variables, ros_version)
        if statement is None:
            yield _comment(endpoint)
        elif key in seen:
            yield f"{_comment(endpoint)}, once more"
        else:
            seen.add(key)
            yield from statement
    if any(kind in _SENDING for kind, _ in seen):
        yield "// what the file sends, with which values and when, is not read: fill it in above"
    if seen:
        yield f"generate_node {variable}"


def _statement(
    endpoint: SourceEndpoint, node: str, variables: Variables, ros_version: int
) -> tuple[str, ...] | None:
    """Return the statements that make an endpoint, None when the language has none for it."""
    name, type_ = endpoint.name, endpoint.type
    if name is None or type_ is None:
        return None
    if endpoint.kind.facts.check_name(name, ros_version) is not None:
        return None
    stem = f"{name.strip('/~').replace('/', '_')}_message"
    more = {"function": _calling(endpoint), "qos": _qos(endpoint.qos, ros_version)}
    return endpoint_statements(endpoint.kind, node, name, type_, lambda: variables.new(stem), more)


def _qos(qos: Qos | None, ros_version: int) -> str:
    """Return the words for a quality of service, "" where it is the usual one, or not known."""
    if qos is None or qos.over(DEFAULT) == DEFAULT:
        return ""
    if ros_version == 2 and None in qos[:3]:
        return ""
    text = text_of(qos)
    return text if all(word.split()[0] in WORDS for word in text.split(", ")) else ""


def parameter_statement(
    node: str, name: str, details: ParameterDetails, ros_version: int
) -> tuple[str, ...] | None:
    """Return the statement that gives a node a parameter, None where not all is known of it."""
    types = {each.value: each for each in ParameterType}
    type_ = types.get(details.type or "")
    default = None if type_ is None else as_setting(type_, details.default)
    written = name.removeprefix("~/")
    is_own = not written.startswith("/") and parameter_name(written, ros_version) == name
    if type_ is None or default is None or not is_own:
        return None
    if check_parameter_name(written, ros_version) is not None:
        return None
    texts = {"node": node, "parameter": written, "type": type_.value, "default": _value(default)}
    if details.range is not None:
        low, high, step = details.range
        if step or not type_.is_number or not low <= float(str(default)) <= high:
            return None
        texts |= {"minimum": _value(low), "maximum": _value(high)}
    if details.description:
        texts["description"] = quoted(details.description)
    return (sentence(DECLARATIONS[HasParameter], texts),)


def _timer(node: str, endpoint: SourceEndpoint, details: TimerDetails) -> tuple[str, ...] | None:
    """Return the statement that repeats a function, None where not all is known of it."""
    function, period = _calling(endpoint), details.period
    if not function or endpoint.label is None or details.is_guess or not period:
        return None
    if not LOWEST_RATE <= 1 / period <= HIGHEST_RATE:
        return None
    texts = {"node": node, "function": function, "rate": f"{1 / period:.12g}"}
    return (sentence(DECLARATIONS[Repeats], texts),)


def _value(value: Setting) -> str:
    """Return a value as a program writes it."""
    if isinstance(value, tuple):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, float):
        return f"{value:.17g}" if float(f"{value:.15g}") != value else f"{value:.15g}"
    return quoted(value) if isinstance(value, str) else str(value)


def endpoint_statements(
    kind: EndpointKind,
    node: str,
    name: str,
    type_: InterfaceName,
    new_message: Callable[[], str],
    more: Mapping[str, str] = MappingProxyType({}),
) -> tuple[str, ...] | None:
    """Return the statements that give a node an endpoint, None when the language has none.

    Args:
        kind: what it is.
        node: the node's variable.
        name: its topic or service.
        type_: its type.
        new_message: makes a variable for a message, where one is needed.
        more: what other slots of the statement have; one that has "" is left out.
    """
    editing = kind.facts.editing
    if editing is None:
        return None
    texts = {**more, "node": node, editing.name_slot: name, "type": str(type_), "input": "none"}
    if any(slot.kind is SlotKind.MESSAGE for slot in editing.making.slots):
        texts["message"] = new_message()
        message = {"variable": texts["message"], "type": str(type_), "input": "none"}
        made = sentence(DECLARATIONS[CreateMessage], message)
        return (made, sentence(editing.making, texts))
    return (sentence(editing.making, texts),)


def _calling(endpoint: SourceEndpoint) -> str:
    callback = endpoint.callback
    if callback is None or not callback.isidentifier() or not callback.isascii():
        return ""
    if callback in KEYWORDS:
        return ""
    return callback


def _comment(endpoint: SourceEndpoint) -> str:
    what = f"// line {endpoint.line}: {endpoint.kind.facts.verb} {_shown(endpoint.expression)}"
    if endpoint.type is not None:
        what += f" of type {endpoint.type}"
    elif endpoint.type_expression:
        what += f" of type {_shown(endpoint.type_expression)}"
    return what


def _shown(expression: str) -> str:
    text = " ".join(expression.split())
    return text if len(text) <= 80 else f"{text[:77]}..."
