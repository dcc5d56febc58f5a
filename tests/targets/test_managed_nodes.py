"""Managed nodes: what has to hold of every one that is written, and what none can have."""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from file_sets import one
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from machine import examples
from made_nodes import SPAN, catalog, nodes

from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import EndpointKind
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target

RUFF = Path(sys.executable).with_name("ruff")
STRING = InterfaceName("std_msgs", "String")
MADE = re.compile(r"self\.(\w+)=(?:self\.create_(\w+)|Action(?:Client|Server))\(")
# What each transition has to end (design.ros2.org, node_lifecycle).
ENDS = {
    "on_deactivate": {"timers", "tasks"},
    "on_cleanup": {"endpoints"},
    "on_shutdown": {"timers", "tasks", "endpoints"},
    "on_error": {"timers", "tasks", "endpoints"},
}

thorough = settings(
    max_examples=examples(20),
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)


@st.composite
def managed(draw: st.DrawFn) -> Node:
    node = draw(nodes("rclpy"))
    node.is_managed = True
    return node


def render(node: Node, templates: Path | None = None) -> str:
    target = find_target("rclpy", templates)
    assert target is not None
    rendered = target.render(node, catalog("rclpy"))
    assert rendered.files is not None, rendered.diagnostics
    return rendered.files.main.decode()


def methods(text: str) -> dict[str, str]:
    """Return the methods of a file's class, with what is in them, however it is broken."""
    inside = text.partition("\ndef main(")[0]
    parts = re.split(r"^    def (\w+)\(.*$", inside, flags=re.MULTILINE)
    return {
        name: re.sub(r"\s+", "", body) for name, body in zip(parts[1::2], parts[2::2], strict=True)
    }


@thorough
@given(managed())
def test_what_one_transition_makes_another_destroys(node: Node) -> None:
    found = methods(render(node))
    destroying = {"endpoints": "on_configure", "timers": "on_activate"}
    there = {"tasks"} if "end_tasks" in found else set()
    for what, making in destroying.items():
        made = MADE.findall(found.get(making, ""))
        ended = found.get(f"destroy_{what}", "")
        for attribute, noun in made:
            assert f"self.{attribute}=None" in found["__init__"]
            way = (
                f"self.destroy_{noun}(self.{attribute})" if noun else f"self.{attribute}.destroy()"
            )
            assert ended.count(way) == 1
        there |= {what} if made else set()
        assert bool(made) == (f"destroy_{what}" in found)
        is_begun = what == "timers" and "tasks" in there
        assert (bool(made) or is_begun) == (making in found)
        assert making not in found or found[making].endswith(f"returnsuper().{making}(state)")
    for transition, ends in ENDS.items():
        assert (transition in found) == bool(ends & there)
        if transition in found:
            called = re.findall(r"self\.(?:destroy|end)_(\w+)\(\)", found[transition])
            assert called == [
                each for each in ("timers", "tasks", "endpoints") if each in ends & there
            ]
            assert found[transition].endswith(f"returnsuper().{transition}(state)")
    assert "create_" not in found["__init__"]


@thorough
@given(managed())
def test_it_reads_as_what_it_is(node: Node) -> None:
    target = find_target("rclpy")
    assert target is not None
    source = target.read(Path("node.py"), one(render(node).encode())).source
    assert source is not None
    [read] = source.nodes
    assert (read.name, read.is_managed) == (node.name, True)
    # Parameters are there before any transition, timers are made by a later one.
    others = (EndpointKind.TIMER, EndpointKind.PARAMETER)
    made = [each for each in read.endpoints if each.kind not in others]
    assert sorted((each.kind.value, each.name or "") for each in made) == sorted(
        (kind.value, name) for kind, name in node.endpoints if kind not in others
    )
    assert {each.transition for each in made} <= {"on_configure"}
    assert {*read.parameters} == {*node.by_kind[EndpointKind.PARAMETER]}
    timers = read.of_kind(EndpointKind.TIMER)
    assert all(each.transition == "on_activate" for each in timers)


@settings(thorough, max_examples=examples(10))
@given(st.lists(managed(), min_size=1, max_size=8))
def test_ruff_has_nothing_to_say(made: list[Node]) -> None:
    with tempfile.TemporaryDirectory() as folder:
        for number, node in enumerate(made):
            file = Path(folder, f"file{number}.py")
            file.write_text(render(node), encoding="utf-8")
            file.chmod(0o755)
        # A name can be too long for any line; what the formatter can break is broken.
        length = "lint.pycodestyle.max-line-length = 110"
        check = ["check", "--extend-select", "E,F,I,W", "--config", length]
        for command in (["format", "--diff"], check):
            done = subprocess.run(
                [RUFF, *command, "--isolated", "--no-cache", folder],
                capture_output=True,
                text=True,
                check=False,
            )
            assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("topic", ["configure", "activate", "cleanup", "error"])
def test_a_callback_takes_no_transitions_place(topic: str) -> None:
    node = Node("lamp", "lamp", SPAN, is_managed=True)
    node.put(Subscription(topic, STRING, None, SPAN))
    assert f'String, "{topic}", self.on_{topic}_2, 10' in " ".join(render(node).split())


PROGRAM = "create_node 'lamp' as lamp managed using rclpy\n{}\ngenerate_node lamp\n"
REFUSED = {
    "what ends its work": (
        "lamp repeats end_tasks at 1 hz",
        "invalid-function: `end_tasks` is a method that every managed rclpy node has",
    ),
    "a transition": (
        "lamp repeats on_activate at 1 hz",
        "invalid-function: `on_activate` is a method that every managed rclpy node has",
    ),
    "its own method": (
        "lamp repeats destroy_timers at 1 hz",
        "invalid-function: `destroy_timers` is a method that every managed rclpy node has",
    ),
}


def generated(folder: Path, text: str) -> list[str]:
    session = Session(text.encode(), folder / "p.plastron", Options(), environ={})
    _, diagnostics = session.plan()
    return [f"{found.code}: {found.message}" for found in (*session.diagnostics, *diagnostics)]


@pytest.mark.parametrize(("statement", "expected"), REFUSED.values(), ids=REFUSED)
def test_what_a_managed_node_cannot_have_is_said(
    tmp_path: Path, statement: str, expected: str
) -> None:
    assert generated(tmp_path, PROGRAM.format(statement)) == [expected]
    without = PROGRAM.replace(" managed", "").format(statement)
    assert generated(tmp_path, without) == []


def test_templates_of_the_users_are_for_one_class_each(tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "node.py.j2").write_text("plain {{ node.label }}\n")
    plain, managed = (Node("lamp", "lamp", SPAN, is_managed=each) for each in (False, True))
    assert render(plain, tmp_path) == "plain lamp\n"
    assert "class LampNode(LifecycleNode):" in render(managed, tmp_path)
    (tmp_path / "rclpy" / "managed.py.j2").write_text("managed {{ node.label }}\n")
    assert render(managed, tmp_path) == "managed lamp\n"
