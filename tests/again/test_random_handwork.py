"""Random programs over a node that was loaded, with handwork of all kinds between them."""

from __future__ import annotations

import re
from collections import Counter
from itertools import takewhile
from pathlib import Path

import pytest
from again_driver import LIBRARIES, WAYS, Bench, shown
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from test_generate_again import programs

NOT_KEPT = re.compile(r"line \d+.* was written by hand, and is not kept: `(.*)`")

LISTENING = {
    "rospy": ('    rospy.Service("reset"', '    rospy.Subscriber("{}", String, print)'),
    "rclpy": (
        '        self.create_service(Empty, "reset"',
        '        self.create_subscription(String, "{}", print, 10)',
    ),
}


class Writer:
    """Somebody who writes into a file by hand, and what was written."""

    def __init__(self, library: str) -> None:
        self.library = library
        self.lines: Counter[str] = Counter()
        self.topics: list[str] = []

    def write(self, data: st.DataObject, text: str) -> str:
        """Add a comment, a line to a callback, a function or a subscription."""
        lines = text.split("\n")
        number = sum(self.lines.values())
        starts, listening = LISTENING[self.library]
        what = data.draw(st.sampled_from(["comment", "callback", "function", "subscription"]))
        at = {
            "comment": range(3, len(lines) - 1),
            "callback": [i for i, each in enumerate(lines, 1) if "def on_" in each],
            "function": [i for i, each in enumerate(lines) if each.startswith("def main")],
            "subscription": [i for i, each in enumerate(lines) if each.startswith(starts)],
        }[what]
        if not at:
            return text
        row = data.draw(st.sampled_from(list(at)))
        indent = lines[row][: len(lines[row]) - len(lines[row].lstrip())]
        if what == "subscription":
            self.topics.append(f"mine_{number}")
        new = {
            "comment": [f"{indent}# mine {number}"],
            "callback": [f"{indent}mine_{number} = 1"],
            "function": [f"def mine_{number}():", "    return 1", "", ""],
            "subscription": [listening.format(f"mine_{number}")],
        }[what]
        self.lines[new[0]] += 1
        return "\n".join([*lines[:row], *new, *lines[row:]])


def comments_in(text: str, function: str) -> set[str]:
    """Return the comments in a function of a file."""
    _, _, behind = text.partition(f"def {function}(")
    body = takewhile(lambda line: not line.lstrip().startswith("def "), behind.split("\n")[1:])
    return {line.strip() for line in body if line.lstrip().startswith("#")}


@settings(max_examples=examples(25))
@given(data=st.data(), library=st.sampled_from(LIBRARIES), way=st.sampled_from(sorted(WAYS)))
def test_random_programs_over_handwork(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject, library: str, way: str
) -> None:
    load, origin, written, in_place = WAYS[way]
    bench = Bench(tmp_path_factory.mktemp("random"), library)
    bench.put(origin)
    file, writer = bench.path / written, Writer(library)
    for _ in range(4):
        text = f"{load}\n{data.draw(programs())}"
        fresh = Bench(tmp_path_factory.mktemp("fresh"), library)
        fresh.put(origin)
        if fresh.generate(text, in_place=in_place).errors:
            continue
        before = bench.files()
        commented = comments_in(file.read_text(), "tick") if file.exists() else set()
        outcome = bench.generate(text, in_place=in_place)
        assert outcome.errors == []
        if outcome.conflicts:
            assert bench.files() == before
            continue
        now = file.read_text()
        compile(now, written, "exec")
        # A comment goes with the function that it is in: that of a function which the program
        # wrote is told, that of one which only sends through what the program takes away is not.
        lost = writer.lines - Counter(now.split("\n"))
        told = {each[1] for each in map(NOT_KEPT.search, outcome.warnings) if each}
        gone = set() if "def tick" in now else commented
        comments = {each for each in told if each.startswith("#")}
        assert {line.strip() for line in lost} <= comments | gone
        writer.lines -= lost
        expected = shown(fresh.path / written)
        expected.update(("subscriptions", topic) for topic in writer.topics)
        assert shown(file) == expected, now
        before = bench.files()
        assert bench.generate(text, in_place=in_place).states == ["identical"]
        assert bench.files() == before
        for _ in range(data.draw(st.integers(0, 2))):
            file.write_text(writer.write(data, file.read_text()))


def test_handwork_of_each_kind_is_written(tmp_path: Path) -> None:
    """What the random test writes is handwork indeed."""
    assert len(LISTENING) == len(LIBRARIES)
    for library in LIBRARIES:
        bench = Bench(tmp_path, library)
        text = bench.put("robot.py").read_text()
        assert LISTENING[library][0] in text
        assert "def on_" in text
        assert "\ndef main" in text
