"""Whatever a file's name or text holds, no command lets it reach a terminal as it is."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from command_line import PLASTRON, TALKER
from hostile import NAME, ODD_NAME, PAYLOAD, PROGRAM, obeyed, on_terminal

from plastron_tui.output.graphs import FORMATS

NODE = f"""\
#!/usr/bin/env python3
# {PAYLOAD}
import rospy
from std_msgs.msg import String
rospy.init_node("n{PAYLOAD}")
rospy.Publisher("a{PAYLOAD}", String)
rospy.Publisher("chatter", String)  # {PAYLOAD}
"""

COMMANDS: list[tuple[str, ...]] = [
    ("check", f"{NAME}.plastron"),
    ("check", f"{NAME}.plastron", "--format", "json"),
    ("check", "missing" + NAME),
    ("check", ODD_NAME),
    ("check", f"{NAME}.yaml.d/a.plastron"),
    ("generate", f"good{NAME}.plastron", "--diff"),
    ("generate", f"good{NAME}.plastron", "-o", f"out{NAME}"),
    ("generate", f"{NAME}.plastron"),
    ("generate", f"good{NAME}.plastron", "-o", f"{NAME}.plastron"),
    ("generate", f"good{NAME}.plastron", "--target", NAME),
    ("fmt", "-"),
    ("fmt", "--check", f"good{NAME}.plastron"),
    ("graph", f"good{NAME}.plastron"),
    ("graph", f"{NAME}.plastron"),
    *(("graph", f"{NAME}.py", "--format", name) for name in FORMATS),
    ("inspect", f"{NAME}.py"),
    ("inspect", f"{NAME}.py", "--format", "json"),
    ("inspect", f"{NAME}.py", "--format", "program"),
    ("inspect", f"missing{NAME}"),
    ("types", NAME),
    ("types", f"{NAME}/A"),
    ("run", f"{NAME}.plastron"),
    ("run", f"good{NAME}.plastron", NAME),
    ("shell",),
    ("wizard", f"{NAME}.plastron"),
    (f"good{NAME}.plastron",),
    (NAME,),
    (f"--{NAME}",),
    ("check", f"--{NAME}"),
    ("graph", "x", "--format", NAME),
    ("run", "x", "--for", NAME),
    ("serve", f"{NAME}.yaml.d"),
    ("trust", f"{NAME}.yaml.d"),
    ("trust", f"missing{NAME}"),
    ("check", f"{NAME}.yaml.d/a.plastron"),
]  # fmt: skip


@pytest.fixture
def hostile(here: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(here / "state"))
    here.joinpath(f"{NAME}.plastron").write_text(PROGRAM)
    here.joinpath(f"good{NAME}.plastron").write_text(TALKER.replace("\n", f" // {NAME[:-2]}\n", 1))
    here.joinpath(f"{NAME}.py").write_text(NODE)
    folder = here / f"{NAME}.yaml.d"
    folder.mkdir()
    folder.joinpath("a.plastron").write_text(TALKER)
    folder.joinpath("plastron.yaml").write_text('output: "a\\u001b]0;OWNED\\a"\n"\\u009b2J": 1\n')
    return here


@pytest.mark.long
def test_no_command_writes_what_a_terminal_obeys(hostile: Path) -> None:
    found = {}
    for command in COMMANDS:
        stdin = f"{PROGRAM}help {NAME}\n".encode()
        said = on_terminal([*PLASTRON, *command], hostile, stdin=stdin)
        assert said or "--check" in command, command
        if bad := obeyed(said):
            found[command] = bad, said
    assert not found


def test_an_error_of_python_is_no_way_out(hostile: Path) -> None:
    code = "from plastron_tui.cli import entry, main\n"
    code += f"def fail(): raise RuntimeError({PAYLOAD!r})\n"
    code += "entry._run_command = fail\nmain()"
    said = on_terminal([sys.executable, "-c", code, "check", "x"], hostile)
    assert "RuntimeError" in said
    assert not obeyed(said.replace("\x1b[35;5m", ""))


def test_data_for_a_pipe_stays_as_it_is(hostile: Path) -> None:
    import subprocess

    done = subprocess.run(
        [*PLASTRON, "fmt", "-"], input=PROGRAM.encode(), capture_output=True, cwd=hostile
    )
    assert PAYLOAD.replace("\r", "").encode() in done.stdout
