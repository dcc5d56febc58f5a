"""What somebody wrote by hand is in the merged file, or a message names it."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from merging_driver import KEEP, LIBRARIES, PUBLISH, PUBLISH_INT, SUBSCRIBE, SUBSCRIBE_INT, Folder
from test_random_merges import programs

SEND = "        self.a_publisher.publish(message)\n"
# What stands by hand around the lines that send, and what of them it replaces.
SENDING = {
    "a condition": (SEND, f"        if self.enabled:  # mine\n    {SEND}"),
    "a way out": (SEND, f"        if not self.enabled:  # mine\n            return\n{SEND}"),
    "a way out, first": (
        "        message = String",
        "        if not self.enabled:  # mine\n            return\n        message = String",
    ),
    "a change": (SEND, f"        self.stamp(message)  # mine\n{SEND}"),
    "a count": (SEND, f"{SEND}        self.count += 1  # mine\n"),
    "a period": ("1 / 2", "self.period()"),
    "a parameter": ("(1 / 2", "(self.get('~period', 0.5)"),
    "a callback by its name": ("1 / 2, self.publish_a)", "0.5, callback=self.publish_a)"),
}


@pytest.mark.parametrize("edit", SENDING)
def test_lines_that_send_keep_what_stands_around_them(folder: Folder, edit: str) -> None:
    old, new = SENDING[edit]
    if folder.library == "rospy":
        old, new = (each.replace("1 / 2, self", "1 / 2), self") for each in (old, new))
        new = new.replace("0.5, callback", "0.5), callback")
    folder.generate(KEEP, f"{PUBLISH} at 2 hz")
    folder.edit(old, new)
    before = folder.file().read_text()
    outcome = folder.generate(KEEP, f"{PUBLISH_INT} at 2 hz")
    assert outcome.conflicts == []
    assert len(outcome.warnings) == 1
    expected = before.replace('String(data="hello")', "Int32(data=5)").replace("String", "Int32")
    assert folder.file().read_text() == expected


GUARD = "        if not self.enabled:  # mine\n            return\n"
CHANGED = {
    "type and rate": (
        PUBLISH_INT + " at 4 hz",
        [('String(data="hello")', "Int32(data=5)"), ("String", "Int32"), ("1 / 2", "1 / 4")],
    ),
    "name": (f"{PUBLISH} at 2 hz".replace("'a'", "'b'"), [('"a"', '"b"')]),
    "one more message": (
        f"{PUBLISH} at 2 hz\n{PUBLISH.replace('hello', 'bye')} at 2 hz",
        [('"hello")\n', f'"hello")\n{SEND}        message = String(data="bye")\n')],
    ),
}


@pytest.mark.parametrize("change", CHANGED)
def test_nothing_is_sent_past_a_condition(folder: Folder, change: str) -> None:
    after, expected = CHANGED[change]
    folder.generate(KEEP, f"{PUBLISH} at 2 hz")
    folder.edit("        message = String", f"{GUARD}        message = String")
    text = folder.file().read_text()
    outcome = folder.generate(KEEP, after)
    assert len(outcome.warnings) == 1
    for old, new in expected:
        text = text.replace(old, new)
    assert folder.file().read_text() == text


def test_a_condition_stays_where_endpoints_are_added_too(folder: Folder) -> None:
    folder.generate(KEEP, f"{PUBLISH} at 2 hz")
    folder.edit(*SENDING["a condition"])
    outcome = folder.generate(KEEP, f"{PUBLISH_INT} at 2 hz", SUBSCRIBE_INT)
    assert (outcome.conflicts, len(outcome.warnings)) == ([], 1)
    text = folder.file().read_text()
    assert f"message = Int32(data=5)\n{SENDING['a condition'][1]}" in text
    assert text.count("create_timer(") + text.count("rospy.Timer(") == 1
    assert "self.on_a" in text


@pytest.mark.parametrize("after", ["", PUBLISH_INT.replace("'a'", "'b'") + " at 2 hz"])
def test_a_timer_that_is_kept_and_sends_no_more_is_told(folder: Folder, after: str) -> None:
    folder.generate(KEEP, f"{PUBLISH} at 2 hz")
    folder.edit("        message = String", f"{GUARD}        message = String")
    outcome = folder.generate(KEEP, after)
    told = "a timer that sent through the publisher `a` is kept, and sends no more"
    assert f"merged-by-hand: {told}" in outcome.warnings
    assert GUARD in folder.file().read_text()


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('String(data="hello")', "self.filled('hello')"),
        ('String(data="hello")', "self.filled('hello')  # mine\n        message.data = 'mine'"),
        (f'String(data="hello")\n{SEND}', f"self.fill()\n        if self.mine:\n    {SEND}"),
    ],
)
def test_the_same_lines_that_send_are_a_conflict(folder: Folder, old: str, new: str) -> None:
    folder.generate(KEEP, f"{PUBLISH} at 2 hz")
    folder.edit(old, new)
    before = folder.file().read_bytes()
    (conflict,) = folder.generate(KEEP, f"{PUBLISH_INT} at 2 hz").conflicts
    assert conflict.endswith("by hand, and so were the lines that send through the publisher `a`")
    assert folder.file().read_bytes() == before


def test_a_name_that_goes_is_not_left_in_what_is_written_by_hand(folder: Folder) -> None:
    folder.generate(KEEP, f"{PUBLISH} at 2 hz")
    folder.edit(SEND, f"        if message == String():\n            return\n{SEND}")
    outcome = folder.generate(KEEP, f"{PUBLISH_INT} at 2 hz")
    assert len(outcome.conflicts) == 1


OPTIONS = {
    "rospy": [("self.on_a)\n", "self.on_a, tcp_nodelay=True)  # fast\n")],
    "rclpy": [
        ("self.on_a, 10)", "self.on_a, qos_profile_sensor_data)"),
        ("import Node\n", "import Node\nfrom rclpy.qos import qos_profile_sensor_data\n"),
    ],
}


@pytest.mark.parametrize(
    "after",
    [
        SUBSCRIBE_INT.replace("'a'", "'c'"),
        SUBSCRIBE_INT.replace("'a'", "'b'") + "\n" + SUBSCRIBE.replace("'a'", "'c'"),
        "",
    ],
    ids=["another", "two others", "none"],
)
def test_options_of_an_endpoint_that_goes_are_told(folder: Folder, after: str) -> None:
    folder.generate(KEEP, SUBSCRIBE)
    for old, new in OPTIONS[folder.library]:
        folder.edit(old, new)
    lines = folder.file().read_text().split("\n")
    outcome = folder.generate(KEEP, after)
    (call,) = (each for each in lines if '"a"' in each)
    number = lines.index(call) + 1
    text = folder.file().read_text()
    if call.split("self.on_a, ")[1] not in text:
        told = f"line {number} of the subscription `a` was written by hand, and is not kept"
        assert f"merged-by-hand: {told}: `{call.strip()}`" in outcome.warnings
    for line in lines:
        is_import = "import qos_profile" in line
        assert not is_import or line in text or f"`{line}`" in "".join(outcome.warnings)


_STATEMENT = re.compile(r"^( {8})(?=[a-z][^\"]*\n)(?!return|raise|else|try|except|finally)", re.M)


def write_by_hand(data: st.DataObject, text: str, turn: int) -> tuple[str, list[str]]:
    """Add remarks, statements and conditions to lines of the class, each with a word of its own."""
    marks: list[str] = []
    head, main = text.split("\ndef main(", 1)
    lines = head.splitlines(keepends=True)
    for at, line in enumerate(lines):
        if not _STATEMENT.match(line) or line.count("(") != line.count(")"):
            continue
        mark = f"mine_{turn}_{at}"
        how = data.draw(st.sampled_from(["", "", "remark", "statement", "condition"]))
        match how:
            case "remark":
                lines[at] = f"{line[:-1]}  # {mark}\n"
            case "statement":
                lines[at] = f"        self.{mark} = 1\n{line}"
            case "condition" if ".publish(" in line:
                lines[at] = f"        if self.{mark}:\n    {line}"
            case _:
                continue
        marks.append(mark)
    return "".join(lines) + "\ndef main(" + main, marks


@settings(max_examples=examples(15), deadline=None)
@given(data=st.data(), library=st.sampled_from(LIBRARIES))
def test_handwork_is_kept_or_told(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject, library: str
) -> None:
    folder = Folder(tmp_path_factory.mktemp("merging"), library)
    (name,) = folder.generate(*data.draw(programs()).statements.values()).states
    marks: list[str] = []
    for turn in range(2):
        text, added = write_by_hand(data, folder.file(name).read_text(), turn)
        folder.file(name).write_text(text)
        marks += added
        outcome = folder.generate(*data.draw(programs()).statements.values())
        after = folder.file(name).read_text()
        compile(after, name, "exec")
        if outcome.conflicts:
            assert after == text
            return
        told = "\n".join(outcome.warnings)
        assert [mark for mark in marks if mark not in after and mark not in told] == []
        marks = [mark for mark in marks if mark in after]
        (name,) = outcome.states
