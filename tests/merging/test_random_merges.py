"""Random programs, one after the other, over handwork of all kinds."""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from merging_driver import LIBRARIES, STRING, SUBSCRIBE, Folder, fill_in

Shown = tuple[str, str, str]


class Program(NamedTuple):
    """A random program: what it says of each endpoint, by what a file shows of it."""

    statements: dict[Shown, str]

    @property
    def types(self) -> dict[tuple[str, str], str]:
        return {(kind, name): type_ for kind, name, type_ in self.statements}


@st.composite
def programs(draw: st.DrawFn) -> Program:
    said: dict[Shown, str] = {}
    for topic in "ab":
        name, message = draw(
            st.sampled_from([("String", "hello"), ("String", "bye"), ("Int32", "five")])
        )
        ending = f"to '{topic}' of message_type {name}"
        if draw(st.booleans()):
            rate = draw(st.sampled_from(["", " at 2 hz"]))
            said["publishers", topic, f"std_msgs/{name}"] = f"n publish {message} {ending}{rate}"
        if draw(st.booleans()):
            calling = draw(st.sampled_from(["", "", " calling hear"]))
            said["subscriptions", topic, f"std_msgs/{name}"] = f"subscribe n {ending}{calling}"
    for service in "st":
        name = draw(st.sampled_from(["Empty", "Trigger"]))
        ending = f"'{service}' of service_type {name}"
        if draw(st.booleans()):
            said["services", service, f"std_srvs/{name}"] = f"n provides_service {ending}"
        if draw(st.booleans()):
            said["clients", service, f"std_srvs/{name}"] = (
                f"n client_requests {ending} with input none"
            )
    if not said:
        said["subscriptions", "a", STRING] = SUBSCRIBE
    return Program(said)


def merged(base: Program, program: Program, present: set[Shown]) -> set[Shown]:
    """Return what a file shall show: what the program changed since the base, and the rest."""
    result = {each for each in present if each[:2] not in base.types}
    for (kind, name), type_ in program.types.items():
        is_new = (kind, name) not in base.types
        if is_new or any(each[:2] == (kind, name) for each in present):
            result.add((kind, name, type_))
    return result


def add_by_hand(text: str, library: str, topic: str) -> tuple[str, str]:
    """Subscribe to a topic of the user's own, at the end of `__init__`."""
    call = {
        "rospy": f"rospy.Subscriber('{topic}', rospy.AnyMsg, print)",
        "rclpy": f"self.create_subscription(AnyMsg, '{topic}', print, 10)",
    }[library]
    line = f"        {call}  # mine"
    head, found, tail = text.partition('"""Join the ROS graph."""\n')
    assert found
    if library == "rclpy":
        first, tail = tail.split("\n", 1)
        found += first + "\n"
    return f"{head}{found}{line}\n{tail}", line


@pytest.mark.long
@settings(max_examples=examples(25), deadline=None)
@given(data=st.data(), library=st.sampled_from(LIBRARIES))
def test_random_programs_and_handwork(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject, library: str
) -> None:
    folder = Folder(tmp_path_factory.mktemp("merging"), library)
    base = data.draw(programs())
    (name,) = folder.generate(*base.statements.values()).states
    present = set(folder.endpoints(name))
    assert present == base.statements.keys()
    mine: Counter[str] = Counter()
    for turn in range(3):
        filled, lines = fill_in(folder.file(name).read_text())
        mine += Counter(lines)
        if data.draw(st.booleans()):
            filled, line = add_by_hand(filled, library, f"mine_{turn}")
            mine[line] += 1
            present.add(("subscriptions", f"mine_{turn}", "None"))
        own = f"def own_{turn}(node):\n    return node.count\n\n\n"
        mine += Counter(own.split("\n"))
        folder.file(name).write_text(filled.replace("def main(", f"{own}def main("))
        program = data.draw(programs())
        for path in folder.file().parent.glob("robot*"):
            if path.name != name:
                path.unlink()
        outcome = folder.generate(*program.statements.values())
        assert outcome.conflicts == []
        (name,) = outcome.states
        present = merged(base, program, present)
        text = folder.file(name).read_text()
        compile(text, name, "exec")
        assert Counter(folder.endpoints(name)) == Counter(present), text
        assert mine - Counter(text.split("\n")) == Counter(), text
        assert folder.generate(*program.statements.values()).states == {name: "identical"}
        base = program
