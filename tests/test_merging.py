"""Generating again over files that were changed by hand: a merge of three sides."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import NamedTuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plastron_tui.diagnostics import Severity
from plastron_tui.model.source import EndpointKind
from plastron_tui.output.manifest import NAME
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
    source = target.read(path, path.read_bytes()).source
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

    def generate(self, *statements: str, force: bool = False) -> Outcome:
        lines = "\n".join(statements)
        text = f"{MESSAGES}create_node 'robot' as n\n{lines}\ngenerate_node n\n"
        options = Options(self.library, self.path / "output", force=force)
        session = Session(text.encode(), self.path / self.program, options, environ={})
        assert session.diagnostics == ()
        plan, diagnostics = session.plan()
        assert all(found.severity is Severity.WARNING for found in diagnostics)
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


@pytest.fixture(params=LIBRARIES)
def folder(request: pytest.FixtureRequest, tmp_path: Path) -> Folder:
    return Folder(tmp_path, request.param)


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

# For each kind: what the program has, what it has with another type, and what a file shows of both.
KINDS = {
    "publisher": (PUBLISH, PUBLISH_INT, ("publishers", "a", STRING), ("publishers", "a", INT)),
    "subscription": (
        SUBSCRIBE, SUBSCRIBE_INT, ("subscriptions", "a", STRING), ("subscriptions", "a", INT),
    ),
    "service": (PROVIDE, PROVIDE_TRIGGER, ("services", "s", EMPTY), ("services", "s", TRIGGER)),
    "client": (REQUEST, REQUEST_TRIGGER, ("clients", "s", EMPTY), ("clients", "s", TRIGGER)),
}  # fmt: skip
each_kind = pytest.mark.parametrize("kind", KINDS)


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


@each_kind
def test_added(folder: Folder, kind: str) -> None:
    statement, _, shown, _ = KINDS[kind]
    folder.generate(KEEP)
    mine = folder.fill()
    outcome = folder.generate(KEEP, statement)
    assert outcome.states == {"robot_node.py": "changed"}
    check(folder, mine, [*KEPT, shown])
    check_again(folder, KEEP, statement)


@each_kind
def test_removed(folder: Folder, kind: str) -> None:
    statement, _, _, _ = KINDS[kind]
    folder.generate(KEEP, statement)
    mine = folder.fill()
    outcome = folder.generate(KEEP)
    assert outcome.conflicts == []
    check(folder, mine, KEPT)
    orphan = {"subscription": "on_a", "service": "handle_s"}.get(kind)
    told = f"merged-by-hand: `{orphan}` is kept, but no longer called"
    assert (told in outcome.warnings) == (orphan is not None)
    check_again(folder, KEEP)


@each_kind
def test_type_changed(folder: Folder, kind: str) -> None:
    statement, other, _, shown = KINDS[kind]
    folder.generate(KEEP, statement)
    mine = folder.fill()
    outcome = folder.generate(KEEP, other)
    assert outcome.conflicts == []
    check(folder, mine, [*KEPT, shown])
    name = {"subscription": "on_a", "service": "handle_s"}.get(kind)
    if name is not None:
        text = folder.file().read_text()
        assert text.count(f"def {name}(") == 1
        assert f"self.{name})" in text or f"self.{name}, 10)" in text
        assert f"`{name}` was written for" in "".join(outcome.warnings)
    check_again(folder, KEEP, other)


@each_kind
def test_added_and_removed_at_once(folder: Folder, kind: str) -> None:
    statement, other, _, shown = KINDS[kind]
    folder.generate(KEEP, statement)
    mine = folder.fill()
    renamed = other.replace("'a'", "'b'").replace("'s'", "'t'")
    outcome = folder.generate(KEEP, renamed)
    assert outcome.conflicts == []
    expected = (shown[0], {"a": "b", "s": "t"}[shown[1]], shown[2])
    check(folder, mine, [*KEPT, expected])


@each_kind
def test_only_endpoint_changes_its_type(folder: Folder, kind: str) -> None:
    statement, other, _, shown = KINDS[kind]
    (name,) = folder.generate(statement).states
    folder.fill(name)
    outcome = folder.generate(other)
    assert (outcome.states, outcome.conflicts) == ({name: "changed"}, [])
    assert folder.endpoints(name) == Counter([shown])
    text = folder.file(name).read_text()
    compile(text, name, "exec")
    assert "plastron_holds" not in text
    assert len(re.findall(r"def (?:on|handle)_", text)) == (kind in ("subscription", "service"))
    assert "def own" in text


@each_kind
def test_taken_out_by_hand_stays_out(folder: Folder, kind: str) -> None:
    statement, other, _, _ = KINDS[kind]
    folder.generate(KEEP, statement)
    without = Folder(folder.path / "other", folder.library)
    without.generate(KEEP)
    folder.file().write_bytes(without.file().read_bytes())
    mine = folder.fill()
    for again in (statement, other):
        outcome = folder.generate(KEEP, again)
        assert any(" was taken out by hand, and stays out" in each for each in outcome.warnings)
        check(folder, mine, KEPT)


@each_kind
def test_added_by_hand_stays(folder: Folder, kind: str) -> None:
    statement, other, shown, _ = KINDS[kind]
    folder.generate(KEEP)
    base = (folder.path / "output" / NAME).read_bytes()
    folder.generate(KEEP, statement)
    mine = folder.fill()
    # To the manifest, the file is one that the user has added an endpoint to.
    (folder.path / "output" / NAME).write_bytes(base)
    before = folder.file().read_bytes()
    for program in ([KEEP], [KEEP, statement]):
        assert folder.generate(*program).states == {"robot_node.py": "identical"}
        check(folder, mine, [*KEPT, shown])
    assert folder.file().read_bytes() == before
    (folder.path / "output" / NAME).write_bytes(base)
    (conflict,) = folder.generate(KEEP, other).conflicts
    assert f"is of type `{shown[2]}` in line " in conflict
    assert folder.file().read_bytes() == before


@pytest.mark.parametrize(
    ("before", "after", "gone", "new"),
    [
        (PUBLISH, PUBLISH.replace("hello", "bye"), "hello", "bye"),
        (f"{PUBLISH} at 2 hz", f"{PUBLISH} at 4 hz", "1 / 2", "0.25"),
        (PUBLISH, f"{PUBLISH}\n{PUBLISH.replace('hello', 'bye')}", None, "bye"),
        (
            "n client_requests 's' of service_type SetBool with input True",
            "n client_requests 's' of service_type SetBool with input False",
            "data=True",
            "data=False",
        ),
    ],
    ids=["message", "rate", "one more", "request"],
)
def test_what_is_sent_is_renewed_where_it_is_untouched(
    folder: Folder, before: str, after: str, gone: str | None, new: str
) -> None:
    folder.generate(KEEP, before)
    mine = folder.fill()
    shown = folder.endpoints()
    for program, old, now in ((after, gone, new), (before, new, gone or "hello")):
        outcome = folder.generate(KEEP, program)
        assert outcome.states == {"robot_node.py": "changed"}
        assert len(outcome.warnings) == 1
        check(folder, mine, list(shown.elements()))
        text = folder.file().read_text()
        assert now in text or (now == "1 / 2" and "0.5" in text)
        assert old is None or old not in text
        check_again(folder, KEEP, program)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("message = String(", "message = self.filled(  # mine\n            "),
        ("publisher.publish(message)", "publisher.publish(message)  # mine"),
        ("def own():", "def own(node):\n    node.a_publisher.publish(None)"),
        ("1 / 10", "1 / 20"),
    ],
)
def test_what_was_changed_by_hand_is_sent_as_it_is(folder: Folder, old: str, new: str) -> None:
    folder.generate(KEEP, PUBLISH)
    folder.fill()
    folder.edit(old, new)
    before = folder.file().read_bytes()
    outcome = folder.generate(KEEP, PUBLISH.replace("hello", "bye"))
    assert outcome.states == {"robot_node.py": "identical"}
    told = "merged-by-hand: the messages of the publisher `a` are changed in the program only"
    assert told in outcome.warnings
    assert folder.file().read_bytes() == before


def test_used_publisher_is_a_conflict_that_names_the_line(folder: Folder) -> None:
    folder.generate(KEEP, PUBLISH)
    folder.fill()
    folder.edit("def own():", "def own(node):\n    node.a_publisher.anything()")
    before = folder.file().read_bytes()
    number = before[: before.index(b"anything")].count(b"\n") + 1
    manifest = (folder.path / "output" / NAME).read_bytes()
    (conflict,) = folder.generate(KEEP, "n publish bye to 'b' of message_type String").conflicts
    assert conflict.startswith("file-conflict: `robot_node.py` was changed by hand, and ")
    assert conflict.endswith(f"the publisher `a` is used in line {number}")
    assert folder.file().read_bytes() == before
    assert (folder.path / "output" / NAME).read_bytes() == manifest
    folder.generate(KEEP, force=True)
    assert folder.endpoints() == Counter(KEPT)
    assert folder.file("robot_node.py.bak").read_bytes() == before


def test_type_changed_by_hand_stays(folder: Folder) -> None:
    folder.generate(KEEP, SUBSCRIBE)
    folder.fill()
    text = folder.file().read_text()
    text = text.replace("import String", "import Int32").replace("String", "Int32")
    folder.file().write_text(text)
    (_, told) = folder.generate(KEEP, SUBSCRIBE).warnings
    assert f"the subscription `a` is of type `{INT}` by hand, not `{STRING}`" in told
    assert folder.file().read_text() == text
    for other in (SUBSCRIBE.replace("String", "Bool"), ""):
        (conflict,) = folder.generate(KEEP, other).conflicts
        assert f"is of type `{INT}` in line " in conflict
    assert folder.generate(KEEP, SUBSCRIBE_INT).states == {"robot_node.py": "identical"}
    assert folder.generate(KEEP).conflicts == []
    assert folder.endpoints() == Counter(KEPT)


def test_callback_that_the_program_names(folder: Folder) -> None:
    folder.generate(KEEP, SUBSCRIBE)
    mine = folder.fill()
    outcome = folder.generate(KEEP, f"{SUBSCRIBE} calling hear")
    check(folder, mine, [*KEPT, ("subscriptions", "a", STRING)])
    assert "self.hear" in folder.file().read_text()
    assert "merged-by-hand: `on_a` is kept, but no longer called" in outcome.warnings
    outcome = folder.generate(KEEP, f"{SUBSCRIBE} calling on_a")
    text = folder.file().read_text()
    assert "self.on_a" in text
    assert "hear" not in text  # a stub that nobody has touched


def test_topic_from_a_parameter_is_the_same_topic(folder: Folder) -> None:
    folder.generate(KEEP, SUBSCRIBE)
    folder.fill()
    expression = "rospy.get_param('~topic', 'a')"
    if folder.library == "rclpy":
        expression = "self.declare_parameter('topic', 'a').value"
    folder.edit('"a", ', f"{expression}, ")
    assert folder.generate(KEEP, SUBSCRIBE).states == {"robot_node.py": "identical"}


def test_other_library_is_a_conflict(tmp_path: Path) -> None:
    Folder(tmp_path, "rospy").generate(KEEP)
    Folder(tmp_path, "rospy").fill()
    (conflict,) = Folder(tmp_path, "rclpy").generate(KEEP).conflicts
    assert conflict.endswith("was changed by hand, and it is a node of `rospy`")


def test_file_that_is_no_node_any_more_is_a_conflict(folder: Folder) -> None:
    folder.generate(KEEP)
    folder.file().write_text("mine = 1\n")
    (conflict,) = folder.generate(KEEP, PUBLISH).conflicts
    assert conflict.endswith("was changed by hand, and it holds no node that can be read")
    assert folder.file().read_text() == "mine = 1\n"


def test_reverted_handwork_is_ours_again(folder: Folder) -> None:
    folder.generate(KEEP)
    ours = folder.file().read_bytes()
    folder.fill()
    folder.generate(KEEP, PUBLISH)
    folder.file().write_bytes(ours)
    assert folder.generate(KEEP, SUBSCRIBE).warnings == []
    fresh = Folder(folder.path / "other", folder.library)
    fresh.generate(KEEP, SUBSCRIBE)
    assert folder.file().read_bytes() == fresh.file().read_bytes()


def test_manifest_of_an_older_version(folder: Folder) -> None:
    """Without a base, endpoints are added only: what the file has besides may be the user's."""
    folder.generate(KEEP, SUBSCRIBE)
    manifest = folder.path / "output" / NAME
    digest = re.search(r"sha256:\w+", manifest.read_text())
    assert digest is not None
    old = f'{{"generator": "plastron", "version": 1, "files": {{"robot_node.py": "{digest[0]}"}}}}'
    manifest.write_text(old)
    mine = folder.fill()
    (conflict,) = folder.generate(KEEP).conflicts
    assert conflict.endswith("it has the subscription `a`, which the program does not have")
    assert manifest.read_text() == old
    assert folder.generate(KEEP, SUBSCRIBE, PROVIDE).conflicts == []
    assert folder.generate(KEEP, PROVIDE).conflicts == []
    check(folder, mine, [*KEPT, ("services", "s", EMPTY)])


def test_twice_created_endpoint_is_not_taken_out(folder: Folder) -> None:
    folder.generate(KEEP, PUBLISH)
    (line,) = [each for each in folder.file().read_text().split("\n") if "a_publisher = " in each]
    folder.edit(line, f"{line}\n{line.replace('a_publisher', 'mine')}")
    before = folder.file().read_bytes()
    for other in ("", PUBLISH_INT):
        (conflict,) = folder.generate(KEEP, other).conflicts
        assert re.search(r"the publisher `a` is created in lines \d+ and \d+$", conflict)
    assert folder.file().read_bytes() == before


def test_handwork_goes_along_to_another_file_name(folder: Folder) -> None:
    assert folder.generate(SUBSCRIBE).states == {"robot_sub1.py": "create"}
    mine = folder.fill("robot_sub1.py")
    old = folder.file("robot_sub1.py").read_bytes()
    outcome = folder.generate(SUBSCRIBE, PROVIDE)
    assert outcome.states == {"robot_node.py": "create"}
    left = "left-behind: the node of `robot_sub1.py` is in `robot_node.py` now"
    assert outcome.warnings[0].startswith(left)
    assert outcome.warnings[1].startswith("merged-by-hand: `robot_sub1.py` was changed by hand")
    check(folder, mine, [("subscriptions", "a", STRING), ("services", "s", EMPTY)])
    assert folder.file().stat().st_mode & 0o100
    assert folder.file("robot_sub1.py").read_bytes() == old
    # What went along counts as handwork in the new file, too.
    folder.generate(SUBSCRIBE, PROVIDE, PUBLISH)
    three = [("subscriptions", "a", STRING), ("services", "s", EMPTY), ("publishers", "a", STRING)]
    check(folder, mine, three)
    again = folder.generate(SUBSCRIBE, PROVIDE, PUBLISH)
    assert again.states == {"robot_node.py": "identical"}
    assert again.warnings[0].startswith(left)
    folder.file("robot_sub1.py").unlink()
    assert len(folder.generate(SUBSCRIBE, PROVIDE, PUBLISH).warnings) == 1


def test_going_back_to_a_file_name_does_not_lose_the_newer_handwork(folder: Folder) -> None:
    folder.generate(SUBSCRIBE)
    folder.fill("robot_sub1.py")
    old = folder.file("robot_sub1.py").read_bytes()
    folder.generate(SUBSCRIBE, PROVIDE)
    newer = folder.fill("robot_node.py", own=OWN.replace("own", "newer"))
    (conflict,) = folder.generate(SUBSCRIBE).conflicts
    assert "later the node went on in `robot_node.py`" in conflict
    assert folder.file("robot_sub1.py").read_bytes() == old
    folder.file("robot_sub1.py").unlink()
    assert folder.generate(SUBSCRIBE).states == {"robot_sub1.py": "create"}
    text = folder.file("robot_sub1.py").read_text()
    assert all(line in text.split("\n") for line in newer)
    assert folder.endpoints("robot_sub1.py") == Counter([("subscriptions", "a", STRING)])


def test_untouched_file_of_another_name_is_told_and_left(folder: Folder) -> None:
    folder.generate(SUBSCRIBE)
    old = folder.file("robot_sub1.py").read_bytes()
    (told,) = folder.generate(SUBSCRIBE, PROVIDE).warnings
    assert told.startswith("left-behind: ")
    assert folder.file("robot_sub1.py").read_bytes() == old
    fresh = Folder(folder.path / "other", folder.library)
    fresh.generate(SUBSCRIBE, PROVIDE)
    assert folder.file().read_bytes() == fresh.file().read_bytes()
    (told,) = folder.generate(SUBSCRIBE).warnings
    assert told.startswith("left-behind: the node of `robot_node.py` is in `robot_sub1.py`")


def test_refused_merge_into_another_file_name_writes_nothing(folder: Folder) -> None:
    folder.generate(PUBLISH)
    folder.fill("robot_pub.py")
    folder.edit("def own():", "def own(node):\n    node.a_publisher.anything()", "robot_pub.py")
    outcome = folder.generate(SUBSCRIBE)
    assert outcome.states == {"robot_sub1.py": "conflict"}
    assert "`robot_pub.py` was changed by hand, and the publisher `a`" in outcome.conflicts[0]
    assert not folder.file("robot_sub1.py").exists()
    folder.generate(SUBSCRIBE, force=True)
    assert folder.endpoints("robot_sub1.py") == Counter([("subscriptions", "a", STRING)])


def test_node_of_the_same_name_in_another_program_is_another(folder: Folder) -> None:
    folder.generate(SUBSCRIBE)
    folder.fill("robot_sub1.py")
    other = Folder(folder.path, folder.library, "other.plastron")
    assert other.generate(PUBLISH) == ({"robot_pub.py": "create"}, [], [])
    assert len(folder.generate(SUBSCRIBE).warnings) == 1


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


@settings(max_examples=25, deadline=None)
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


def test_callback_is_not_made_a_second_time_elsewhere(tmp_path: Path) -> None:
    """The file's other subscription is in `main`, from where the method cannot be called."""
    folder = Folder(tmp_path, "rospy")
    folder.generate(SUBSCRIBE)
    folder.fill("robot_sub1.py")
    mine = '    rospy.Subscriber("mine", rospy.AnyMsg, print)\n    rospy.spin()'
    folder.edit("    rospy.spin()", mine, "robot_sub1.py")
    before = folder.file("robot_sub1.py").read_bytes()
    (conflict,) = folder.generate(SUBSCRIBE_INT).conflicts
    assert conflict.endswith("`on_a` cannot be called from where endpoints are added")
    assert folder.file("robot_sub1.py").read_bytes() == before
