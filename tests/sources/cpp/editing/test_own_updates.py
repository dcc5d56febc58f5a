"""How little of a node that Plastron wrote changes where a statement says something else."""

from __future__ import annotations

from difflib import ndiff
from pathlib import Path

import pytest
from patches import CATALOGS, LIBRARIES

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Endpoint
from plastron_tui.model.source import Update
from plastron_tui.model.workspace import Node
from plastron_tui.session import Session
from plastron_tui.sources import find_language
from plastron_tui.sources.cpp.editing.editor import edit_cpp
from plastron_tui.targets import find_target

AT = Span(0, 0)
HEAD = """create_node 'robot' as n using {0}
create_message a of message_type String and input "a"
create_message b of message_type String and input "b"
create_message k of message_type Int32 and input 3
create_message p of message_type geometry_msgs/PointStamped and input point.x=1
create_message q of message_type geometry_msgs/PointStamped and input point.x=2, point.y=1
create_message r of message_type Int32 and input received.data + 1
create_message s of message_type Int32 and input received.data + 2
"""
SPEED = "n has_parameter 'speed' of parameter_type float with default 0.5 between 0 and 1\n"
SPEED += "create_message m of message_type Float64 and input parameter 'speed'{0}\n"
SPEED += "n publish m to 'out' of message_type Float64 at 2 hz"
HEAR = "subscribe n to 'in' of message_type Int32{0}"
PUBLISH = "n publish {0} to 'out' of message_type {1} {2}"
EACH = HEAR.format("") + "\nn publish {0} to 'out' of message_type {1} for_each 'in'{2}"
SERVE = "n provides_service 's' of service_type {0}"
ASK = "n client_requests 's' of service_type {0}"
KEEP = "n has_parameter 'x' of parameter_type {0}"
# What the statement says, what it says then, and how many lines differ in ROS 1 and in ROS 2.
CASES = {
    "a value": (PUBLISH.format("a", "String", "at 2 hz"), PUBLISH.format("b", "String", "at 2 hz"),
                1, 1),
    "a rate": (PUBLISH.format("a", "String", "at 2 hz"), PUBLISH.format("a", "String", "at 5 hz"),
               1, 1),
    "a type": (PUBLISH.format("a", "String", "at 2 hz"), PUBLISH.format("k", "Int32", "at 2 hz"),
               4, 5),
    "a quality of service": (PUBLISH.format("a", "String", "at 2 hz"),
                             PUBLISH.format("a", "String", "at 2 hz with qos depth 5"), 1, 1),
    "a message with more fields": (PUBLISH.format("p", "geometry_msgs/PointStamped", "at 2 hz"),
                                   PUBLISH.format("q", "geometry_msgs/PointStamped", "at 2 hz"),
                                   2, 2),
    "a computed value": (SPEED.format(""), SPEED.format(" * 2"), 1, 1),
    "a value that is sent once": (PUBLISH.format("a", "String", "once"),
                                  PUBLISH.format("b", "String", "once"), 1, 1),
    "a value for each": (EACH.format("a", "String", ""), EACH.format("b", "String", ""), 1, 1),
    "a computed value for each": (EACH.format("r", "Int32", ""), EACH.format("s", "Int32", ""),
                                  1, 1),
    "a condition": (EACH.format("r", "Int32", " when received.data > 3"),
                    EACH.format("r", "Int32", " when received.data > 4"), 1, 1),
    "what is heard": (HEAR.format(""), HEAR.format("").replace("Int32", "String"), 2, 4),
    "how it is heard": (HEAR.format(""), HEAR.format(" with qos depth 3"), 1, 1),
    "what hears": (HEAR.format(""), HEAR.format(" calling hear"), 2, 2),
    "an answer": (SERVE.format("SetBool answering success=True"),
                  SERVE.format("SetBool answering success=False"), 1, 1),
    "a computed answer": (SERVE.format("SetBool answering success=received.data"),
                          SERVE.format("SetBool answering success=True"), 1, 1),
    "a service": (SERVE.format("SetBool"), SERVE.format("Trigger"), 2, 5),
    "what answers": (SERVE.format("SetBool"), SERVE.format("SetBool calling go"), 2, 2),
    "a request": (ASK.format("SetBool with input data=True"),
                  ASK.format("SetBool with input data=False"), 1, 1),
    "how often it is made": (ASK.format("SetBool with input data=True at 2 hz"),
                             ASK.format("SetBool with input data=True at 4 hz"), 1, 1),
    "what is asked": (ASK.format("SetBool with input data=True"),
                      ASK.format("Trigger with input none"), 4, 5),
    "the rate of a function": ("n repeats look at 2 hz", "n repeats look at 4 hz", 1, 1),
    "a default": (KEEP.format("int with default 1"), KEEP.format("int with default 2"), 1, 1),
    "a list": (KEEP.format("int_list with default [1, 2]"),
               KEEP.format("int_list with default [1, 3]"), 1, 1),
    "a range": (KEEP.format("int with default 1 between 0 and 5"),
                KEEP.format("int with default 1 between 0 and 9"), 0, 1),
    "a description": (KEEP.format('int with default 1 described_as "a"'),
                      KEEP.format('int with default 1 described_as "b"'), 0, 1),
    "a goal": ("n sends_goal to 'f' of action_type Fibonacci with input order=5",
               "n sends_goal to 'f' of action_type Fibonacci with input order=7", 1, 1),
}  # fmt: skip


def node(statements: str, library: str) -> Node:
    """Return the node of a program."""
    session = Session(f"{HEAD.format(library)}{statements}\n".encode())
    assert [each for each in session.diagnostics if each.severity.value == "error"] == []
    return next(iter(session.workspace.nodes.values()))


def said(endpoint: Endpoint) -> object:
    """Return what is said of an endpoint, wherever."""
    return endpoint._replace(span=None) if hasattr(endpoint, "span") else endpoint


@pytest.mark.long
@pytest.mark.parametrize("library", LIBRARIES)
@pytest.mark.parametrize("name", CASES)
def test_what_a_statement_changes(name: str, library: str) -> None:
    first, then, *expected = CASES[name]
    before, after = node(first, library), node(then, library)
    target = find_target(library)
    version = LIBRARIES[library]
    assert target is not None
    target.set_layouts({"cpp": "single"})
    files = target.render(before, CATALOGS[version]).files
    assert files is not None
    source = find_language("cpp").read(Path("x.cpp"), files).source
    assert source is not None
    changes = [
        Update(kind, each, endpoint, AT)
        for kind, named in after.by_kind.items()
        for each, endpoint in named.items()
        if said(before.by_kind[kind][each]) != said(endpoint)
    ]
    rendered = edit_cpp(source, changes, CATALOGS[version])
    assert rendered.files is not None, rendered.diagnostics
    lines = [text.main.decode().splitlines() for text in (files, rendered.files)]
    found = [each[0] for each in ndiff(*lines) if each[0] in "+-"]
    assert max(found.count("-"), found.count("+")) == expected[version - 1]
