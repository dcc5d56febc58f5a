"""Random nodes, as a program could make them, and some that none could."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from hypothesis import strategies as st

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Message,
    Parameter,
    Publication,
    Publisher,
    Rate,
    Request,
    Service,
    Subscription,
    callback_of,
)
from plastron_tui.model.values import MessageValue, Value
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, InterfaceKind, InterfaceName
from plastron_tui.ros.names import parameter_name
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.ros.primitives import primitive

SPAN = Span(0, 0)
DISTRIBUTION = {"rospy": "noetic", "rclpy": "jazzy"}

WORDS = st.from_regex(r"[a-zA-Z][a-zA-Z0-9_]{0,12}", fullmatch=True)
TEXT = st.one_of(
    st.text(max_size=30),
    st.lists(st.text("abc\"'\\{}%é中 \t\n\u202e", max_size=9), max_size=30).map(" ".join),
    st.text("abcdef", min_size=60, max_size=200),
)
NAMES = st.one_of(
    WORDS,
    st.from_regex(r"/?[a-z][a-z0-9_]{0,9}(/[a-z][a-z0-9_]{0,9}){0,6}", fullmatch=True),
    st.from_regex(r"~/[a-z][a-z0-9_]{0,100}", fullmatch=True),
)
EVIL = st.one_of(
    st.text(max_size=20),
    st.sampled_from(
        [
            '"); __import__("os").system("true") #',
            "{{ 7 * 7 }} {% raw %}",
            '"""',
            "'''\\",
            "{message.__class__}",
            "%s %(x)s",
            "\n    import os\n",
            "\\",
            "\u202e\u2066 gnirts \x00 \x1b[31m \ud800 \u2028",
            "class",
            "None",
        ]
    ),
    st.text('"\\{}%\n\r#', max_size=12),
)


@cache
def catalog(library: str) -> Catalog:
    return Catalog(DISTRIBUTION[library])


def value(library: str, type_: FieldType, depth: int) -> st.SearchStrategy[Value]:
    """Values of a field, such as the model makes them."""
    if type_.is_array:
        element = value(library, type_._replace(is_array=False, length=None), depth)
        size = min(type_.length or 5, 12)
        return st.lists(element, min_size=(type_.length and size) or 0, max_size=size).map(tuple)
    if type_.message is not None:
        return message(library, type_.message, InterfaceKind.MESSAGE, depth - 1)
    known = primitive(type_.name, catalog(library).ros_version)
    assert known is not None
    if known.parts:
        return st.tuples(st.integers(0, 2**31 - 1), st.integers(0, 10**9 - 1))
    if known.kind is bool:
        return st.booleans()
    if known.kind is int:
        return st.integers(known.low, known.high)
    if known.kind is float:
        return st.floats(allow_nan=False, allow_infinity=False)
    return TEXT


@st.composite
def message(
    draw: st.DrawFn, library: str, name: InterfaceName, kind: InterfaceKind, depth: int = 3
) -> MessageValue:
    found = catalog(library).find(name, kind)
    assert found is not None
    fields: list[Field] = [
        field
        for field in found.fields
        if (field.type.message is None or depth > 0) and draw(st.booleans())
    ]
    return MessageValue(
        found.name, {each.name: draw(value(library, each.type, depth)) for each in fields}
    )


@st.composite
def nodes(
    draw: st.DrawFn,
    library: str,
    names: st.SearchStrategy[str] = NAMES,
    told_apart_by: Callable[[str], str] = str,
) -> Node:
    messages = st.sampled_from(catalog(library).names(InterfaceKind.MESSAGE))
    services = st.sampled_from(catalog(library).names(InterfaceKind.SERVICE))
    actions = st.sampled_from(catalog(library).names(InterfaceKind.ACTION))
    functions = st.none() | WORDS.map(lambda word: f"on_my_{word}")
    node = Node(draw(names), "node", SPAN)
    some = st.lists(names, max_size=3, unique_by=told_apart_by)
    for topic in draw(some):
        type_ = draw(messages)
        values = draw(
            st.lists(message(library, type_, InterfaceKind.MESSAGE), min_size=1, max_size=2)
        )
        sent = tuple(
            Publication(Message("m", each, SPAN), draw(st.sampled_from([10.0, 0.5, 1 / 3, 100.0])))
            for each in values
        )
        node.put(Publisher(topic, type_, sent, SPAN))
    for topic in draw(some):
        node.put(Subscription(topic, draw(messages), draw(functions), SPAN))
    for service in draw(some):
        node.put(Service(service, draw(services), None, SPAN))
    often = parameter_name("often", catalog(library).ros_version)
    follows = Rate(5.0, often)
    rates = st.sampled_from([None, Rate(10.0), Rate(0.5), Rate(1 / 3), follows])
    for service in draw(some):
        type_ = draw(services)
        request = st.builds(Request, message(library, type_, InterfaceKind.SERVICE), rates)
        requests = draw(st.lists(request, max_size=2))
        node.put(Client(service, type_, tuple(requests), SPAN))
    if any(r.rate == follows for each in node.of(Client).values() for r in each.requests):
        node.put(Parameter(often, None, ParameterType.FLOAT, 5.0, 0.5, 10.0, span=SPAN))
    for action in draw(some):
        executor = draw(st.none() | WORDS.map(lambda word: f"work_on_{word}"))
        if executor is None or executor not in map(callback_of, node.endpoints.values()):
            node.put(ActionServer(action, draw(actions), executor, SPAN))
    for action in draw(some):
        type_ = draw(actions)
        goals = draw(st.lists(message(library, type_, InterfaceKind.ACTION), max_size=2))
        node.put(ActionClient(action, type_, tuple(goals), SPAN))
    return node
