"""Hundreds of changes of one file: the same text as one after the other, in a bounded time."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from edits import CATALOGS, DIALECTS, NODES, SUB, edit, provide, publish, request, subscribe
from file_sets import one

from plastron_tui.model.source import Add, Change, Remove
from plastron_tui.sources.python import edit_python, edits, read_python

_STRING, _INT = "std_msgs/String", "std_msgs/Int32"


def _alternating(n: int) -> Add:
    return subscribe(f"topic{n}", (_STRING, _INT)[n % 2])


MANY = {
    "subscriptions": [subscribe(f"topic{n}") for n in range(18)],
    "of two types": [_alternating(n) for n in range(18)],
    "of one name": [subscribe(f"{'a/' * n}topic") for n in range(18)],
    "of like names": [subscribe(name) for n in range(9) for name in (f"a/t{n}", f"a_t{n}")],
    "that name each other": [subscribe("on_" * (n % 3) + f"topic{n // 3}") for n in range(18)],
    "of one callback": [subscribe(f"topic{n}", callback="heard") for n in range(18)],
    "of a callback each": [subscribe(f"topic{n}", callback=f"heard{n}") for n in range(18)],
    "of two callbacks": [subscribe(f"topic{n}", callback=f"heard{n % 7}") for n in range(18)],
    "publishers": [publish(f"topic{n}") for n in range(18)],
    "messages": [publish(f"topic{n}", data="hello", rate=2.0) for n in range(18)],
    "of open rate": [publish(f"topic{n}", data="hello") for n in range(18)],
    "poses": [publish(f"topic{n}", "geometry_msgs/PoseStamped") for n in range(18)],
    "services": [provide(f"service{n}") for n in range(18)],
    "clients": [request(f"service{n}", "std_srvs/SetBool", data=True) for n in range(18)],
    "of all kinds": [
        *(publish(f"topic{n}", data="hello", rate=2.0) for n in range(10)),
        *(subscribe(f"topic{n}") for n in range(10)),
        *(provide(f"service{n}") for n in range(10)),
    ],
}
NODE = """\
import rospy
from std_msgs.msg import String

rospy.init_node('known')
rospy.spin()
"""


def _check(path: Path, text: bytes, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    source = read_python(path, one(text)).source
    if source is None:
        return
    target = CATALOGS[source.library], DIALECTS[source.library]
    together = edit_python(source, MANY[name], *target)
    monkeypatch.setattr(edits, "_MANY", 1_000)
    assert together == edit_python(source, MANY[name], *target)


@pytest.mark.long
@pytest.mark.parametrize("name", MANY)
def test_in_one_go_is_as_one_after_the_other(name, monkeypatch):
    _check(Path("node.py"), NODE.encode(), name, monkeypatch)


# Each node with a third of the changes, and each of these in a third of the nodes.
@pytest.mark.long
@pytest.mark.parametrize(
    ("path", "name"),
    [
        pytest.param(path, name, id=f"{path.name}-{name}")
        for row, path in enumerate(NODES[::8])
        for column, name in enumerate(MANY)
        if (row + column) % 3 == 0
    ],
)
def test_in_one_go_in_the_nodes_of_others(path, name, monkeypatch):
    _check(path, path.read_bytes(), name, monkeypatch)


def _analyses(monkeypatch, changes: Sequence[Change]) -> int:
    """Return how often a file is analyzed while changes are made in it."""
    count = 0
    analyze = edits.analyze_again

    def counted(*arguments):
        nonlocal count
        count += 1
        return analyze(*arguments)

    monkeypatch.setattr(edits, "analyze_again", counted)
    assert edit(NODE, *changes).files is not None
    return count


@pytest.mark.parametrize("add", [subscribe, provide, publish], ids=lambda add: add.__name__)
def test_alike_additions_take_one_analysis(monkeypatch, add):
    assert _analyses(monkeypatch, [add(f"name{n}") for n in range(400)]) < 10


def test_too_much_work_is_refused(monkeypatch):
    monkeypatch.setattr(edits, "_MOST_WORK", 20_000)
    topics = [f"topic{n}" for n in range(60)]
    text = "".join(f"rospy.Subscriber('{topic}', String, print)\n" for topic in topics)
    text = NODE.replace("rospy.spin()\n", f"{text}rospy.spin()\n")
    found = edit(text, *(Remove(SUB, topic) for topic in topics))
    assert [each.code for each in found.diagnostics] == ["edit-refused"]
    assert "too large" in found.diagnostics[0].message
