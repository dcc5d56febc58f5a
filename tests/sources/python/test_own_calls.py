"""Calls of services in nodes that Plastron wrote: edits leave what it writes anew."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

HEARD = "subscribe n to 'heard' of message_type String"
CALL = "n client_requests 's' of service_type Empty with input none"
OTHER = "n client_requests 't' of service_type SetBool with input True"
THIRD = "n client_requests 'u' of service_type Empty with input none"
AGAIN = "n client_requests 't' of service_type SetBool with input False"
REPEATED = f"{OTHER} at 2 hz"

CHANGES = {
    "one more, then it ends": ((CALL, OTHER), THIRD, (CALL, OTHER, THIRD)),
    "one more, while it goes on": ((HEARD, CALL), THIRD, (HEARD, CALL, THIRD)),
    "once more, then it ends": ((CALL, OTHER), AGAIN, (CALL, OTHER, AGAIN)),
    "once more, while it goes on": ((HEARD, CALL, OTHER), AGAIN, (HEARD, CALL, OTHER, AGAIN)),
    "beside a repeated one": ((CALL, REPEATED), THIRD, (CALL, REPEATED, THIRD)),
    "not that one, then it ends": ((CALL, OTHER), "n stop_request 't'", (CALL,)),
    "not that one, while it goes on": ((HEARD, CALL, OTHER), "n stop_request 't'", (HEARD, CALL)),
    "not the repeated one": ((HEARD, CALL, REPEATED), "n stop_request 't'", (HEARD, CALL)),
    "none of two calls": ((HEARD, CALL, OTHER, AGAIN), "n stop_request 't'", (HEARD, CALL)),
}
"""What a program says, what is then said of its file, and the program of what is left."""

each_library = pytest.mark.parametrize("library", ["rospy", "rclpy"])


def generated(path: Path, library: str, *statements: str) -> Path:
    """Return the file that is written for a node."""
    path.mkdir()
    text = "\n".join(["create_node 'robot' as n", *statements, "generate_node n"])
    return run(path, library, text)


def run(path: Path, library: str, text: str) -> Path:
    options = Options(library, path / "output")
    session = Session(text.encode(), path / "robot.plastron", options, environ={})
    plan, diagnostics = session.plan()
    assert [str(found.code) for found in diagnostics] == []
    assert write(plan, force=False).diagnostics == ()
    (file,) = (path / "output").glob("*.py")
    return file


def changed(path: Path, library: str, before: tuple[str, ...], statement: str) -> str:
    """Return what a statement makes of the file of a program, which is loaded."""
    file = generated(path / "before", library, *before)
    (path / "node.py").write_bytes(file.read_bytes())
    text = f"load 'node.py' as n\n{statement}\ngenerate_node n"
    return run(path, library, text).read_text()


@each_library
@pytest.mark.parametrize("change", CHANGES)
def test_an_edit_leaves_what_is_written_anew(tmp_path: Path, library: str, change: str) -> None:
    before, statement, after = CHANGES[change]
    wanted = generated(tmp_path / "after", library, *after)
    assert changed(tmp_path, library, before, statement) == wanted.read_text()


@each_library
def test_a_node_that_ended_goes_on(tmp_path: Path, library: str) -> None:
    text = changed(tmp_path, library, (CALL,), HEARD)
    work, spin = {
        "rospy": ("        worker.join(0.1)\n", "    rospy.spin()\n"),
        "rclpy": (
            "        rclpy.spin_until_future_complete(node, work)\n",
            "        rclpy.spin(node)\n",
        ),
    }[library]
    assert work + spin in text


@each_library
def test_what_was_written_into_a_repeated_call_is_kept(tmp_path: Path, library: str) -> None:
    file = generated(tmp_path / "before", library, HEARD, CALL, REPEATED)
    above = 'called at its rate."""\n'
    filled = file.read_text().replace(above, f"{above}        mine()\n")
    (tmp_path / "node.py").write_text(filled)
    text = "load 'node.py' as n\nn stop_request 't'\ngenerate_node n"
    session = Session(text.encode(), tmp_path / "robot.plastron", Options(library), environ={})
    plan, diagnostics = session.plan()
    write(plan, force=False)
    kept = [each.read_text() for each in (tmp_path / "output").glob("*.py")]
    assert kept or [str(each.code) for each in diagnostics] == ["endpoint-in-use"]
    assert all("mine()" in each for each in kept)
