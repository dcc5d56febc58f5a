"""Generating again over files that were changed by hand: a merge of three sides."""

from __future__ import annotations

import re
from collections import Counter

import pytest
from merging_driver import (
    EMPTY,
    INT,
    KEEP,
    KEPT,
    OWN,
    PROVIDE,
    PROVIDE_TRIGGER,
    PUBLISH,
    PUBLISH_INT,
    REQUEST,
    REQUEST_TRIGGER,
    STRING,
    SUBSCRIBE,
    SUBSCRIBE_INT,
    TRIGGER,
    Folder,
    check,
    check_again,
)

from plastron_tui.output.manifest import NAME

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


@pytest.mark.parametrize("kind", ["subscription", "service"])
def test_callback_in_which_nothing_was_written_goes_with_its_type(
    folder: Folder, kind: str
) -> None:
    statement, other, _, shown = KINDS[kind]
    folder.generate(KEEP, statement)
    folder.edit("\ndef main(", f"{OWN}\n\ndef main(")
    (told,) = folder.generate(KEEP, other).warnings
    assert told.startswith("merged-by-hand: `robot_node.py`: your changes are kept")
    check(folder, OWN.strip().split("\n"), [*KEPT, shown])


@each_kind
def test_renamed(folder: Folder, kind: str) -> None:
    statement, _, _, _ = KINDS[kind]
    folder.generate(KEEP, statement)
    mine = folder.fill()
    before = folder.file().read_text().splitlines()
    outcome = folder.generate(KEEP, statement.replace("'a'", "'b'").replace("'s'", "'t'"))
    assert outcome.conflicts == []
    after = folder.file().read_text().splitlines()
    # Not a line but that of the name is another one, and what was written in a callback is called.
    (changed,) = [(old, new) for old, new in zip(before, after, strict=True) if old != new]
    old, new = changed
    assert new == old.replace('"a"', '"b"').replace('"s"', '"t"')
    assert all(line in after for line in mine)
    assert not any("no longer called" in warning for warning in outcome.warnings)


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
        (f"{PUBLISH} at 2 hz", f"{PUBLISH} at 4 hz", "1 / 2", "1 / 4"),
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
        assert now in text
        assert old is None or old not in text
        check_again(folder, KEEP, program)


def test_comment_beside_what_is_sent_stays(folder: Folder) -> None:
    folder.generate(KEEP, PUBLISH)
    mine = folder.fill()
    folder.edit("publisher.publish(message)", "publisher.publish(message)  # mine")
    assert len(folder.generate(KEEP, PUBLISH.replace("hello", "bye")).warnings) == 1
    check(folder, mine, [*KEPT, ("publishers", "a", STRING)])
    text = folder.file().read_text()
    assert 'message = String(data="bye")\n' in text
    assert "publisher.publish(message)  # mine\n" in text


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("def own():", "def own(node):\n    node.a_publisher.publish(None)"),
        ("1 / 10", "1 / 20"),
    ],
)
def test_what_is_sent_is_renewed_beside_handwork(folder: Folder, old: str, new: str) -> None:
    folder.generate(KEEP, PUBLISH)
    folder.fill()
    folder.edit(old, new)
    text = folder.file().read_text()
    assert len(folder.generate(KEEP, PUBLISH.replace("hello", "bye")).warnings) == 1
    assert folder.file().read_text() == text.replace("hello", "bye")


def test_what_was_changed_by_hand_is_sent_as_it_is(folder: Folder) -> None:
    folder.generate(KEEP, PUBLISH)
    folder.fill()
    folder.edit("message = String(", "message = self.filled(  # mine\n            ")
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


OPTIONS = {
    "rospy": {
        "publisher": ("String, queue_size=10", "{0}, latch=True, queue_size=1, tcp_nodelay=True"),
        "subscription": ("String, self.on_a", "{0}, self.{1}, queue_size=1, tcp_nodelay=True"),
    },
    "rclpy": {
        "publisher": ('String, "a", 10', '{0}, "{2}", qos_profile_sensor_data'),
        "subscription": ('String, "a", self.on_a, 10', '{0}, "{2}", self.{1}, QoSProfile(depth=1)'),
    },
}


@pytest.mark.parametrize(
    ("kind", "change"),
    [
        *(("publisher", change) for change in ("type", "message", "rate", "name")),
        *(("subscription", change) for change in ("type", "callback", "name")),
    ],
)
def test_options_that_were_written_by_hand_stay(folder: Folder, kind: str, change: str) -> None:
    statement = KINDS[kind][0]
    programs = {
        "type": KINDS[kind][1],
        "callback": f"{statement} calling stop",
        "message": statement.replace("hello", "bye"),
        "rate": f"{statement} at 3 hz",
        "name": statement.replace("'a'", "'b'"),
    }
    old, options = OPTIONS[folder.library][kind]
    folder.generate(KEEP, statement)
    folder.fill()
    folder.edit(old, options.format("String", "on_a", "a"))
    folder.edit("import String", "import String  # mine")
    outcome = folder.generate(KEEP, programs[change])
    type_ = "Int32" if change == "type" else "String"
    callback = "stop" if change == "callback" else "on_a"
    name = "b" if change == "name" else "a"
    assert options.format(type_, callback, name) in folder.file().read_text()
    assert outcome.conflicts == []


def test_two_that_the_program_renames(folder: Folder) -> None:
    other = SUBSCRIBE.replace("'a'", "'b'")
    folder.generate(KEEP, SUBSCRIBE, other)
    mine = folder.fill()
    text = folder.file().read_text()
    renames = "n renames topic 'a' to 'c'\nn renames topic 'b' to 'd'"
    assert folder.generate(KEEP, SUBSCRIBE, other, renames).conflicts == []
    assert folder.file().read_text() == text.replace('"a"', '"c"').replace('"b"', '"d"')
    check(folder, mine, [*KEPT, ("subscriptions", "c", STRING), ("subscriptions", "d", STRING)])
