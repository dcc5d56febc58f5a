"""Nodes that an earlier version of Plastron wrote, whose templates were others."""

from __future__ import annotations

from pathlib import Path

import pytest
from command_line import Run

LISTENER = """\
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
generate_node listener
"""
TEMPLATES = Path(__file__).parents[2] / "templates"

# What the shipped template says, and what an earlier one said at that place.
EARLIER = {
    "rospy": {
        "    signal.signal(signal.SIGINT, interrupt)\n": "    watch_signals()\n",
        "    signal.signal(signal.SIGTERM, interrupt)\n": "",
        "def interrupt(number, frame):": "def watch_signals(number, frame):",
    },
    "rclpy": {
        "    rclpy.init(args=args)\n": "    rclpy.init()\n",
        "    except (KeyboardInterrupt, ExternalShutdownException):": "    except BaseException:",
    },
}


def written_earlier(here: Path, run: Run, library: str) -> tuple[Path, bytes]:
    """Write a node by an earlier template; return it, and what the shipped template makes."""
    template = (TEMPLATES / library / "node.py.j2").read_text()
    for now, before in EARLIER[library].items():
        assert template.count(now) == 1
        template = template.replace(now, before)
    (here / "mine" / library).mkdir(parents=True)
    (here / "mine" / library / "node.py.j2").write_text(template)
    (here / "a.plastron").write_text(LISTENER)
    assert run("generate", "a.plastron", "-t", library, "-o", "fresh").returncode == 0
    (here / "plastron.yaml").write_text("templates: mine\n")
    env = {"XDG_STATE_HOME": str(here / "state")}
    assert run("trust", env=env).returncode == 0
    assert run("generate", "a.plastron", "-t", library, env=env).returncode == 0
    (here / "plastron.yaml").unlink()
    fresh = (here / "fresh" / "listener_sub1.py").read_bytes()
    file = here / "output" / "listener_sub1.py"
    assert file.read_bytes() != fresh
    return file, fresh


@pytest.mark.parametrize("library", EARLIER)
def test_a_node_that_nobody_edited_gets_the_new_text(run: Run, here: Path, library: str) -> None:
    file, fresh = written_earlier(here, run, library)
    result = run("generate", "a.plastron", "-t", library)
    assert (result.returncode, result.stderr) == (0, b"")
    assert file.read_bytes() == fresh


@pytest.mark.parametrize("library", EARLIER)
def test_an_edited_node_keeps_its_text_and_gets_what_the_program_says(
    run: Run, here: Path, library: str
) -> None:
    file, _ = written_earlier(here, run, library)
    line, edited = '"""Handle a message from chatter."""', '"""Hear what is said."""'
    text = file.read_text()
    assert line in text
    file.write_text(text.replace(line, edited))
    more = "subscribe listener to 'more' of message_type String\ngenerate_node"
    (here / "a.plastron").write_text(LISTENER.replace("generate_node", more))
    result = run("generate", "a.plastron", "-t", library)
    assert (result.returncode, b": your changes are kept" in result.stderr) == (0, True)
    merged = file.read_text()
    assert set(text.replace(line, edited).splitlines()) <= set(merged.splitlines())
    assert "def on_more(self, message):" in merged
