"""A folder that one created node is generated into, again and again."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import NamedTuple

from file_sets import one

from plastron_tui.diagnostics import Severity
from plastron_tui.model.source import EndpointKind
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target

LIBRARIES = ["rospy", "rclpy"]
MESSAGES = """\
create_message hello of message_type String and input "hello"
create_message bye of message_type String and input "bye"
create_message five of message_type Int32 and input 5
"""
KEEP = """\
subscribe n to 'kept' of message_type Point
n provides_service 'kept_service' of service_type Empty
"""

OWN = """
def own():
    return "mine"
"""
_CALLBACK = re.compile(r"    def ((?:on|handle)_\w+)\(self, .*\n(        .*\n)+")


def fill_in(text: str) -> tuple[str, list[str]]:
    """Write a line of code into each callback, above what it returns."""
    mine: list[str] = []

    def filled(found: re.Match[str]) -> str:
        line = f"        self.count_{found[1]} = 1  # mine"
        mine.append(line)
        *body, last = found[0].splitlines()
        return "\n".join([*body, line, last, ""])

    return _CALLBACK.sub(filled, text), mine


def read(library: str, path: Path) -> Counter[tuple[str, str, str]]:
    """Return kind, name and type of what a file holds, but for timers."""
    target = find_target(library)
    assert target is not None
    source = target.read(path, one(path.read_bytes())).source
    assert source is not None
    return Counter(
        (each.kind.value, str(each.name), str(each.type))
        for node in source.nodes
        for each in node.endpoints
        if each.kind is not EndpointKind.TIMER
    )


class Outcome(NamedTuple):
    """What a `generate` did: the state of each file, warnings, conflicts."""

    states: dict[str, str]
    warnings: list[str]
    conflicts: list[str]


class Folder:
    """An output folder, and the program `robot.plastron` beside it."""

    def __init__(self, path: Path, library: str, program: str = "robot.plastron") -> None:
        self.path, self.library, self.program = path, library, program
        self.is_managed = False

    def generate(self, *statements: str, force: bool = False) -> Outcome:
        lines = "\n".join(statements)
        managed = " managed" if self.is_managed else ""
        text = f"{MESSAGES}create_node 'robot' as n{managed}\n{lines}\ngenerate_node n\n"
        options = Options(self.library, self.path / "output", force=force)
        session = Session(text.encode(), self.path / self.program, options, environ={})
        assert session.diagnostics == ()
        plan, diagnostics = session.plan()
        assert all(found.severity is not Severity.ERROR for found in diagnostics)
        if force or not plan.conflicts:
            assert write(plan, force=force).diagnostics == ()
        return Outcome(
            {file.name: file.state.value for file in plan.files},
            [f"{found.code}: {found.message}" for found in diagnostics],
            [f"{found.code}: {found.message}" for found in plan.conflicts],
        )

    def file(self, name: str = "robot_node.py") -> Path:
        return self.path / "output" / name

    def endpoints(self, name: str = "robot_node.py") -> Counter[tuple[str, str, str]]:
        """Return kind, name and type of what a file holds, but for timers."""
        return read(self.library, self.file(name))

    def edit(self, old: str, new: str, name: str = "robot_node.py") -> None:
        text = self.file(name).read_text()
        assert text.count(old) == 1, text
        self.file(name).write_text(text.replace(old, new))

    def fill(self, name: str = "robot_node.py", own: str = OWN) -> list[str]:
        """Fill in every callback and add a function, as users do; return the user's lines."""
        filled, mine = fill_in(self.file(name).read_text())
        self.file(name).write_text(filled.replace("\ndef main(", f"{own}\n\ndef main("))
        return [*mine, *own.strip().split("\n")]


STRING, INT = "std_msgs/String", "std_msgs/Int32"
EMPTY, TRIGGER = "std_srvs/Empty", "std_srvs/Trigger"
KEPT = [("subscriptions", "kept", "geometry_msgs/Point"), ("services", "kept_service", EMPTY)]

PUBLISH = "n publish hello to 'a' of message_type String"
PUBLISH_INT = "n publish five to 'a' of message_type Int32"
SUBSCRIBE = "subscribe n to 'a' of message_type String"
SUBSCRIBE_INT = "subscribe n to 'a' of message_type Int32"
PROVIDE = "n provides_service 's' of service_type Empty"
PROVIDE_TRIGGER = "n provides_service 's' of service_type Trigger"
REQUEST = "n client_requests 's' of service_type Empty with input none"
REQUEST_TRIGGER = "n client_requests 's' of service_type Trigger with input none"


def check(folder: Folder, mine: list[str], expected: list[tuple[str, str, str]]) -> None:
    """Check what a file holds, that the user's lines are there, and that it compiles."""
    text = folder.file().read_text()
    compile(text, "robot_node.py", "exec")
    assert folder.endpoints() == Counter(expected), text
    lines = text.split("\n")
    assert [line for line in mine if line not in lines] == []


def check_again(folder: Folder, *statements: str) -> None:
    """Check that generating once more changes nothing."""
    before = {path.name: path.read_bytes() for path in folder.file().parent.iterdir()}
    again = folder.generate(*statements)
    assert set(again.states.values()) == {"identical"}
    assert before == {path.name: path.read_bytes() for path in folder.file().parent.iterdir()}
