"""Parameters, timers, reactions, answers: programs change them, and so do hands."""

from __future__ import annotations

from difflib import SequenceMatcher
from pathlib import Path

import pytest
from merging_driver import KEEP, Folder, Outcome

SPEED = "n has_parameter 'speed' of parameter_type float with default 0.5 between 0 and 2"
PACE = "n has_parameter 'pace' of parameter_type float with default 2"
PUBLISH = "n publish hello to 'b' of message_type String"
MADE = (
    "create_message made of message_type Point and input x=parameter 'speed'\n"
    "n publish made to 'c' of message_type Point at 2 hz"
)
DOUBLE = MADE.replace("'speed'", "'speed' * 2")
REACT = f"{PUBLISH} for_each 'kept'"
REPEAT = "n repeats look at 2 hz"
ANSWER = "n provides_service 'add' of service_type SetBool answering True, \"a\""
QUIET = "n provides_service 'add' of service_type SetBool"
CALL = "n client_requests 'lamp' of service_type SetBool with input True"
AGAIN = f"{CALL} at 2 hz"
TWICE = f"{REPEAT}\nn repeats glance at 3 hz"

CHANGES = {
    "parameter added": ("", SPEED),
    "another parameter added": (SPEED, f"{SPEED}\n{PACE}"),
    "parameter removed": (SPEED, ""),
    "one of two parameters removed": (f"{SPEED}\n{PACE}", PACE),
    "default": (SPEED, SPEED.replace("0.5", "0.7")),
    "range": (SPEED, SPEED.replace("and 2", "and 3")),
    "type of a parameter": (PACE, PACE.replace("float", "int")),
    "parameter renamed": (SPEED, SPEED.replace("speed", "haste")),
    "parameter that the program renames": (
        f"{SPEED}\n{MADE}", f"{SPEED}\n{MADE}\nn renames parameter 'speed' to 'haste'",
    ),
    "timer added": ("", REPEAT),
    "another timer added": (REPEAT, TWICE),
    "timer removed": (REPEAT, ""),
    "one of two timers removed": (TWICE, REPEAT),
    "rate of a timer": (REPEAT, REPEAT.replace("2 hz", "4 hz")),
    "rate of a parameter": (
        f"{PACE}\n{REPEAT}", f"{PACE}\n{REPEAT.replace('2', 'parameter {pace}')}",
    ),
    "function of a timer": (REPEAT, REPEAT.replace("look", "stare")),
    "once": (f"{PUBLISH} at 2 hz", f"{PUBLISH} once"),
    "no longer once": (f"{PUBLISH} once", f"{PUBLISH} at 2 hz"),
    "once added": ("", f"{PUBLISH} once"),
    "once removed": (f"{PUBLISH} once", ""),
    "once another message": (f"{PUBLISH} once", f"{PUBLISH} once".replace("hello", "bye")),
    "reaction added": ("", REACT),
    "reaction removed": (REACT, ""),
    "reaction instead of a rate": (PUBLISH, REACT),
    "condition": (f"{REACT} when received.x < 1", f"{REACT} when received.x > 2"),
    "value of a parameter": (SPEED, f"{SPEED}\n{MADE}"),
    "calculation": (f"{SPEED}\n{MADE}", f"{SPEED}\n{DOUBLE}"),
    "answer": (ANSWER, ANSWER.replace('"a"', '"b"')),
    "answer added": (QUIET, ANSWER),
    "answer removed": (ANSWER, QUIET),
    "repeated call added": ("", AGAIN),
    "repeated call removed": (AGAIN, ""),
    "repeated instead of one call": (CALL, AGAIN),
    "one call instead of repeated": (AGAIN, CALL),
    "rate of a call": (AGAIN, AGAIN.replace("2 hz", "3 hz")),
}  # fmt: skip
"""What a program says first, and then."""


def program(statements: str) -> list[str]:
    return [KEEP, statements.replace("{pace}", "'pace'").replace("request.", "received.")]


def fresh(folder: Folder, statements: str) -> Folder:
    """Return a folder of its own that a program is generated into for the first time."""
    other = Folder(folder.path / f"fresh_{len(list(folder.path.iterdir()))}", folder.library)
    other.path.mkdir()
    other.generate(*program(statements))
    return other


each_change = pytest.mark.parametrize("change", CHANGES)


@pytest.mark.long
@each_change
def test_handwork_elsewhere(folder: Folder, change: str) -> None:
    before, after = CHANGES[change]
    folder.generate(*program(before))
    mine = folder.fill()
    outcome = folder.generate(*program(after))
    assert outcome.conflicts == []
    wanted = fresh(folder, after)
    wanted.fill()
    text = folder.file().read_text()
    assert text == wanted.file().read_text()
    assert [line for line in mine if line not in text.split("\n")] == []
    again = folder.generate(*program(after))
    assert set(again.states.values()) == {"identical"}


def changed_lines(library: str, path: Path, before: str, after: str) -> list[int]:
    """Return the lines of a file that a program changes, or that come before what it adds."""
    folder = Folder(path, library)
    texts = []
    for number, statements in enumerate((before, after)):
        other = Folder(folder.path / str(number), library)
        other.path.mkdir()
        other.generate(*program(statements))
        texts.append(other.file().read_text().splitlines())
    blocks = SequenceMatcher(None, *texts, autojunk=False).get_opcodes()
    found = [range(max(0, at - (at == end)), end) for tag, at, end, *_ in blocks if tag != "equal"]
    return [at for lines in found for at in lines if texts[0][at].strip()]


def told(outcome: Outcome) -> list[str]:
    return [each for each in outcome.warnings if "your changes are kept" not in each]


@pytest.mark.long
@each_change
def test_handwork_in_the_same_lines(folder: Folder, change: str) -> None:
    before, after = CHANGES[change]
    wanted = fresh(folder, after).file().read_text()
    folder.generate(*program(before))
    lines = folder.file().read_text().splitlines(keepends=True)
    manifest = {path: path.read_bytes() for path in folder.file().parent.iterdir()}
    for at in changed_lines(folder.library, folder.path, before, after):
        written = [*lines[:at], f"{lines[at].rstrip()}  # mine\n", *lines[at + 1 :]]
        for path, data in manifest.items():
            path.write_bytes(data)
        folder.file().write_text("".join(written))
        outcome = folder.generate(*program(after))
        text = folder.file().read_text()
        if outcome.conflicts:
            assert text == "".join(written)
        elif text.replace("  # mine", "") != wanted:
            assert told(outcome), text
        if "# mine" not in text:
            assert "was written by hand, and is not kept" in "".join(outcome.warnings)
