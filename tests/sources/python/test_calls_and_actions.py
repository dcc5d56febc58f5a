"""What a loaded node asks of others, and does for them: it is written, read back, and taken out."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_nodes import FILES, loaded

from plastron_tui.model.source import EndpointKind
from plastron_tui.session import Session

CALM = "driver client_requests 'calm' of service_type Trigger with input none"
HELLO, HI = (
    f"create_message {name} of message_type Twist and input none\n"
    f"driver publish {name} to 'out' of message_type Twist"
    for name in ("hello", "hi")
)
STOP_CALM = "driver stop_request 'calm'"
CLASSES = [file for file in FILES if file.endswith("class")]


def after(folder: Path, text: str, statements: str) -> str:
    """Return a node's file after statements that nothing is said against."""
    (folder / "driver.py").write_text(text)
    program = f"load driver as driver\n{statements}\ngenerate_node driver\n"
    session = Session(program.encode(), folder / "program.plastron")
    plan, found = session.plan()
    assert not [str(each.message) for each in (*session.diagnostics, *found)]
    return plan.files[0].text.decode() if plan.files else text


# What is added, what takes it out again, and what a reader finds in between.
ROWS = {
    "a call at a rate": (f"{CALM} at 2 hz", STOP_CALM, EndpointKind.CLIENT, "calm"),
    "messages at two rates": (
        f"{HELLO} at 2 hz\n{HI} at 3 hz",
        "driver stop_publishing to 'out'",
        EndpointKind.PUBLISHER,
        "out",
    ),
    "a call once and at two rates": (
        f"{CALM}\n{CALM} at 2 hz\n{CALM} at 3 hz",
        STOP_CALM,
        EndpointKind.CLIENT,
        "calm",
    ),
}
CASES = [
    pytest.param(file, *row, id=f"{what} | {file}") for what, row in ROWS.items() for file in FILES
]


@pytest.mark.parametrize(("file", "add", "stop", "kind", "name"), CASES)
def test_what_is_added_is_read_back_and_taken_out(
    tmp_path: Path, file: str, add: str, stop: str, kind: EndpointKind, name: str
) -> None:
    before = FILES[file]
    text = after(tmp_path, before, add)
    compile(text, "driver.py", "exec")
    found, had = loaded(tmp_path, text), loaded(tmp_path, before)
    assert name in found.names(kind)
    # The timers that serve it are no functions that the node repeats.
    assert [*found.names(EndpointKind.TIMER)] == [*had.names(EndpointKind.TIMER)]
    assert after(tmp_path, text, stop) == before


@pytest.mark.parametrize("file", FILES)
def test_another_rate_is_one_line(tmp_path: Path, file: str) -> None:
    text = after(tmp_path, FILES[file], f"{CALM} at 2 hz")
    faster = after(tmp_path, text, f"{STOP_CALM}\n{CALM} at 5 hz")
    lines = zip(text.splitlines(), faster.splitlines(), strict=True)
    [(old, new)] = [(one, other) for one, other in lines if one != other]
    assert old.replace("0.5", "0.2") == new


@pytest.mark.parametrize("file", FILES)
def test_a_call_at_a_rate_becomes_one_that_is_made_once(tmp_path: Path, file: str) -> None:
    again, once = f"{CALM} at 2 hz", CALM
    text = after(tmp_path, FILES[file], again)
    assert after(tmp_path, text, f"{STOP_CALM}\n{once}") == after(tmp_path, FILES[file], once)
