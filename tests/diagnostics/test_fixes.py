from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.session import Session

TALKER = "create_node 'talker' as talker\n"
GREETING = 'create_message greeting of message_type String and input "hello"\n'
TALKING = f"{TALKER}{GREETING}talker publish greeting to 'chatter' of message_type String\n"

# What has no remedy that is right whatever is meant: somebody has to choose a name or a value.
WITHOUT = {
    "keyword-as-variable", "too-deep", "variable-exists", "node-exists", "ambiguous-type",
    "function-conflict", "name-taken", "idle-node", "service-provided-twice", "file-not-found",
    "wrong-number-of-values", "unknown-field", "duplicate-field", "value-after-named",
    "value-out-of-range", "wrong-array-length", "invalid-text", "invalid-rate",
    "unsupported-target", "service-type-conflict", "action-type-conflict",
    "endless-messages", "package-exists", "unknown-item", "already-contained", "not-contained",
    "mixed-package", "bad-maintainer", "taken-package-name", "bad-package-text",
    "type-exists", "type-hidden", "circular-type", "type-in-use", "bad-field", "in-no-package",
    "launch-exists", "already-started", "not-started", "bad-launch-name",
    "invalid-qos", "not-in-ros-1", "still-needed", "unknown-parameter", "parameter-type-mismatch",
    "invalid-range", "nothing-received", "computed-type-mismatch",
    "robot-exists", "part-exists", "bad-shape", "bad-weight", "bad-unit", "bad-axis",
    "missing-limits", "incomplete-joint", "missing-weight", "bad-mimic", "bad-robot-number",
    "mesh-inertia", "no-tree", "link-name-again", "unconditional-motion",
}  # fmt: skip

MORE = [
    f"{TALKING}talkr publish greeting to 'news' of message_type String\n",
    f"{TALKING}talker publish greting to 'news' of message_type String\n",
    f"{TALKING}talker publish greeting to 'news' of message_type Strin\n",
    f"{TALKING}talker publish greeting to 'news' of message_type std_msg/String\n",
    f"{TALKING}talker publish greeting to 'news' of message_type std_msgs/srv/String\n",
    f"{TALKING}talker publish greeting to 'news' of message_type String at -5 hz\n",
    f"{TALKER}subscribe talker to 'my topic' of message_type String\n",
    f"{TALKER}subscribe talker to 'chatter of message_type String\n",
    f"{TALKER}talker provides_service 'add' of service_type AddTwoIntss\n",
    f"{TALKER}talker client_requests 'go' of service_type Trigger with input 5\n",
    f"{TALKER}talker provide_service 'add' of service_type AddTwoInts\n",
    f"{TALKER}talker provides_service 'add' of servce_type AddTwoInts\n",
    "create_node 'talker' as talker using ros2\n",
    "create_node talker as talker\n",
    "create_node 'talker' as talker;\n",
    'create_message m of message_type String and input "hello\n',
    "create_message m of message_type String and input 5\n",
    'create_message m of message_type Bool and input "on"\n',
    "create_message m of message_type Bool and input 1\n",
    "create_message m of message_type Twist and input linar.x=1\n",
    "create_message m of message_type Twist and input linear_x=1\n",
    "load listner as listener\n",
    "load 'listner.py' as listener\n",
    "load 'nodes/talkr.py' as talker\n",
    "create_launch 'a' as a\na starts 'p/x'\ngenerate_launch a\na starts 'p/y'\n",
    f"{TALKING}generate_node talker\nsubscribe talker to 'alarm' of message_type String",
]


def session(program: str, folder: Path) -> Session:
    return Session(program.encode(), folder / "program.plastron", environ={})


def mended(program: str, found: Diagnostic) -> str:
    assert found.fix is not None, found
    text = program.encode()
    for edit in sorted(found.fix.edits, key=lambda edit: edit.span, reverse=True):
        text = text[: edit.span.start] + edit.text.encode() + text[edit.span.end :]
    return text.decode()


def check_fix(program: str, folder: Path) -> None:
    """Apply the remedy of the only mistake, and see that nothing is wrong any more."""
    for name in ("listener", "nodes/talker"):
        file = (folder / name).with_suffix(".py")
        file.parent.mkdir(exist_ok=True)
        file.write_text("import rospy\nrospy.init_node('one')\n")
    [found] = session(program, folder).diagnostics
    assert list(session(mended(program, found), folder).diagnostics) == []


@pytest.mark.parametrize(
    "code", [code for code in codes.CODES.values() if code.bad], ids=lambda code: code
)
def test_a_fix_mends_the_bad_program(code: Code, tmp_path: Path) -> None:
    program = code.bad
    if code in WITHOUT:
        assert all(found.fix is None for found in session(program, tmp_path).diagnostics)
    elif session(program, tmp_path).diagnostics:
        check_fix(program, tmp_path)


@pytest.mark.parametrize("program", MORE)
def test_a_fix_mends(program: str, tmp_path: Path) -> None:
    check_fix(program, tmp_path)


@pytest.mark.parametrize(
    "late", ["create_message late of message_type Int32 and input 5\n"], ids=["its message"]
)
def test_what_needs_a_later_statement_is_not_moved_before_it(late: str, tmp_path: Path) -> None:
    publish = "talker publish late to 'numbers' of message_type Int32\n"
    program = f"{TALKING}generate_node talker\n{late}{publish}"
    [found] = session(program, tmp_path).diagnostics
    assert found.code == "changed-after-generating"
    assert found.fix is None


def test_a_message_is_not_given_the_type_of_another_one(tmp_path: Path) -> None:
    more = "create_message n of message_type Int32 and input 5\n"
    publish = "talker publish n to 'chatter' of message_type Int32\n"
    [found] = session(TALKING + more + publish, tmp_path).diagnostics
    assert found.code == "topic-type-conflict"
    assert found.fix is None
