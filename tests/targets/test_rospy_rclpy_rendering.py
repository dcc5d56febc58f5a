"""What every generated Python file has to be, whatever the node."""

from __future__ import annotations

import ast
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

import pytest
from file_sets import one
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from machine import examples
from made_nodes import EVIL, SPAN, catalog, nodes

from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Message,
    Parameter,
    Publication,
    Publisher,
    Service,
    Subscription,
)
from plastron_tui.model.source import EndpointKind
from plastron_tui.model.values import MessageValue, Value
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.sources.python.naming import words
from plastron_tui.targets import find_target

LIBRARIES = ["rospy", "rclpy"]
RUFF = Path(sys.executable).with_name("ruff")

thorough = settings(
    max_examples=examples(20),
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)


def render(node: Node, library: str) -> str:
    target = find_target(library)
    assert target is not None
    rendered = target.render(node, catalog(library))
    assert rendered.files is not None, rendered.diagnostics
    return rendered.files.main.decode()


def write(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8")
    path.chmod(0o755)


def ruff(folder: str, *arguments: str) -> str:
    """Run ruff with its defaults, whatever configuration lies around."""
    done = subprocess.run(
        [RUFF, *arguments, "--isolated", "--no-cache", folder],
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stdout if done.returncode else ""


@pytest.mark.parametrize("library", LIBRARIES)
@thorough
@given(data=st.data())
def test_ruff_has_nothing_to_say(library: str, data: st.DataObject) -> None:
    made = data.draw(st.lists(nodes(library), min_size=1, max_size=8))
    with tempfile.TemporaryDirectory() as folder:
        for number, node in enumerate(made):
            text = render(node, library)
            compile(text, "node.py", "exec", dont_inherit=True)
            write(Path(folder, f"file{number}.py"), text)
        assert ruff(folder, "format", "--diff") == ""
        assert ruff(folder, "check", "--extend-select", "E,F,I,W") == ""


def shape(text: str) -> tuple[str, list[str]]:
    """Return the syntax tree without its strings, and the strings."""
    tree = ast.parse(text)
    strings = []
    for each in ast.walk(tree):
        if isinstance(each, ast.Constant) and isinstance(each.value, str):
            strings.append(each.value)
            each.value = ""
    return ast.dump(tree), strings


def tamed(value: Value) -> Value:
    """Replace the strings of a value by harmless ones."""
    match value:
        case str():
            return "x"
        case tuple():
            return tuple(map(tamed, value))
        case MessageValue():
            return MessageValue(value.type, {k: tamed(v) for k, v in value.fields.items()})
        case _:
            return value


def strings_of(value: Value) -> list[str]:
    match value:
        case str():
            return [value]
        case tuple():
            return [text for each in value for text in strings_of(each)]
        case MessageValue():
            return [text for each in value.fields.values() for text in strings_of(each)]
        case _:
            return []


def tame(node: Node) -> Node:
    """Return the node with harmless names and strings that make the same Python names."""
    tame_node = Node(words(node.name), "node", SPAN)
    for publisher in node.of(Publisher).values():
        sent = tuple(
            Publication(each.message._replace(value=tamed(each.message.value)), each.rate)
            for each in publisher.publications
        )
        topic = words(publisher.name)
        tame_node.put(publisher._replace(name=topic, publications=sent))
    for subscription in node.of(Subscription).values():
        topic = words(subscription.name)
        tame_node.put(subscription._replace(name=topic))
    for service in node.of(Service).values():
        tame_node.put(service._replace(name=words(service.name)))
    for client in node.of(Client).values():
        requests = tuple(each._replace(value=tame_value(each.value)) for each in client.requests)
        name = words(client.name)
        tame_node.put(client._replace(name=name, requests=requests))
    for parameter in node.of(Parameter).values():
        tame_node.put(parameter)
    for server in node.of(ActionServer).values():
        tame_node.put(server._replace(name=words(server.name)))
    for sender in node.of(ActionClient).values():
        goals = tuple(map(tame_value, sender.goals))
        tame_node.put(sender._replace(name=words(sender.name), goals=goals))
    return tame_node


def tame_value(value: MessageValue) -> MessageValue:
    tame = tamed(value)
    assert isinstance(tame, MessageValue)
    return tame


def is_separable(node: Node) -> bool:
    """Tell whether no two names of a kind make the same Python name."""
    kinds: list[Mapping[str, object]] = [node.of(Publisher), node.of(Subscription)]
    kinds += [node.of(Service), node.of(ActionServer)]
    kinds.append({**node.of(Client), **node.of(ActionClient)})
    return all(len({words(name) for name in kind}) == len(kind) for kind in kinds)


@pytest.mark.parametrize("library", LIBRARIES)
@settings(thorough, max_examples=examples(60))
@given(data=st.data())
def test_no_string_becomes_code(library: str, data: st.DataObject) -> None:
    node = data.draw(nodes(library, EVIL, words))
    assume(is_separable(node))
    tree, strings = shape(render(node, library))
    assert tree == shape(render(tame(node), library))[0]
    expected = [node.name]
    for publisher in node.of(Publisher).values():
        expected.append(publisher.name)
        for sent in publisher.publications:
            expected += strings_of(sent.message.value)
    expected += [*node.of(Subscription), *node.of(Service), *node.of(Client)]
    for client in node.of(Client).values():
        for request in client.requests:
            expected += strings_of(request.value)
    expected += [*node.of(ActionServer), *node.of(ActionClient)]
    for sender in node.of(ActionClient).values():
        for goal in sender.goals:
            expected += strings_of(goal)
    for text in expected:
        strings.remove(text)


@pytest.mark.parametrize("library", LIBRARIES)
@settings(thorough, max_examples=examples(40))
@given(text=st.text() | EVIL | st.text("ab \"'\\é\n", min_size=50, max_size=400))
def test_a_string_is_exactly_what_was_written(library: str, text: str) -> None:
    type_ = InterfaceName("std_msgs", "String")
    node = Node("talker", "node", SPAN)
    sent = Publication(Message("m", MessageValue(type_, {"data": text}), SPAN), 10.0)
    node.put(Publisher("chatter", type_, (sent,), SPAN))
    tree = ast.parse(render(node, library))
    found = [
        each for each in ast.walk(tree) if isinstance(each, ast.keyword) and each.arg == "data"
    ]
    assert [ast.literal_eval(each.value) for each in found] == [text]


@pytest.mark.parametrize("library", LIBRARIES)
@settings(thorough, max_examples=examples(40))
@given(data=st.data())
def test_what_is_written_reads_as_the_same_node(library: str, data: st.DataObject) -> None:
    node = data.draw(nodes(library))
    target = find_target(library)
    assert target is not None
    source = target.read(Path("node.py"), one(render(node, library).encode())).source
    assert source is not None
    (read,) = source.nodes
    assert read.name == node.name
    expected = {
        EndpointKind.PUBLISHER: [(each.name, each.type) for each in node.of(Publisher).values()],
        EndpointKind.SUBSCRIPTION: [
            (each.name, each.type) for each in node.of(Subscription).values()
        ],
        EndpointKind.SERVICE: [(each.name, each.type) for each in node.of(Service).values()],
        EndpointKind.CLIENT: [(each.name, each.type) for each in node.of(Client).values()],
        EndpointKind.ACTION_SERVER: [
            (each.name, each.type) for each in node.of(ActionServer).values()
        ],
        EndpointKind.ACTION_CLIENT: [
            (each.name, each.type) for each in node.of(ActionClient).values()
        ],
    }
    # A file of ROS 1 sets and gets a parameter.
    assert {each.name for each in read.of_kind(EndpointKind.PARAMETER)} == set(node.of(Parameter))
    timers = {each.callback for each in read.of_kind(EndpointKind.TIMER)}
    assert None not in timers, "what waits is no timer of the node"
    for kind, endpoints in expected.items():
        assert [(each.name, each.type) for each in read.of_kind(kind)] == endpoints


@pytest.mark.parametrize("library", LIBRARIES)
def test_every_type_of_the_catalog_can_be_written(library: str) -> None:
    node = Node("all_types", "node", SPAN)
    for name in catalog(library).names(InterfaceKind.MESSAGE):
        sent = Publication(Message("m", MessageValue(name, {}), SPAN), 10.0)
        topic = f"{name.package}/{name.name}"
        node.put(Publisher(topic, name, (sent,), SPAN))
    with tempfile.TemporaryDirectory() as folder:
        write(Path(folder, "file.py"), render(node, library))
        assert ruff(folder, "format", "--diff") == ""
        assert ruff(folder, "check", "--extend-select", "E,F,I,W") == ""
