"""Edits of the managed nodes that Plastron writes: what asks others begins and ends as theirs."""

from __future__ import annotations

from pathlib import Path

import pytest
from edits import AT, edited, request

from plastron_tui.model.source import EndpointKind, Remove
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target

STATEMENTS = {
    "once": "n client_requests 'once' of service_type SetBool with input True",
    "again": "n client_requests 'again' of service_type Trigger with input none at 5 hz",
    "count": "n sends_goal to 'count' of action_type Fibonacci with input order=5",
    "spell": "n provides_action 'spell' of action_type Fibonacci",
}
KINDS = {
    "once": EndpointKind.CLIENT,
    "again": EndpointKind.CLIENT,
    "count": EndpointKind.ACTION_CLIENT,
    "spell": EndpointKind.ACTION_SERVER,
}


def written(*names: str) -> str:
    """Return the file of a managed node with some of the statements."""
    lines = [STATEMENTS[each] for each in names]
    text = "\n".join(["create_node 'n' as n managed using rclpy", *lines, "generate_node n", ""])
    session = Session(text.encode(), Path("p.plastron"), Options(), environ={})
    assert not session.diagnostics
    target = find_target("rclpy")
    assert target is not None
    [generation] = session.workspace.generations
    rendered = target.render(generation.node, session.catalog(2))
    assert rendered.files is not None
    return rendered.files.main.decode()


def method(text: str, name: str) -> str:
    return text.partition(f"def {name}(")[2].partition("\n\n")[0]


@pytest.mark.parametrize("names", [["once"], ["once", "again"], [*STATEMENTS]])
def test_a_call_that_is_added_begins_and_ends_with_the_others(names: list[str]) -> None:
    before = written(*names)
    after = edited(before, request("added", "std_srvs/Trigger"))
    assert "self.added_client = self.create_client(" in method(after, "on_configure")
    assert "self.executor.create_task(self.call_added)" in method(after, "on_activate")
    assert "self.destroy_client(self.added_client)" in method(after, "destroy_endpoints")
    assert "if await self.wait_until_served(" in method(after, "call_added")
    # What the first edit of a file brings in stays the only difference.
    assert edited(after, Remove(EndpointKind.CLIENT, "added", AT)) == before


@pytest.mark.parametrize("name", STATEMENTS)
def test_what_is_taken_out_is_held_by_nothing(name: str) -> None:
    after = edited(written(*STATEMENTS), Remove(KINDS[name], name, AT))
    compile(after, "node.py", "exec")
    for held in (f"self.{name}_client", f"self.{name}_server", f"self.{name}_timer"):
        assert held not in after
    assert f"create_task(self.call_{name})" not in after


@pytest.mark.parametrize("name", ["once", "again"])
def test_a_call_goes_as_if_it_had_never_been(name: str) -> None:
    others = [each for each in STATEMENTS if each != name]
    assert edited(written(*STATEMENTS), Remove(KINDS[name], name, AT)) == written(*others)
