"""What the README and the tutorial show: programs that are right, and output that is real."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import Copies

ROOT = Path(__file__).parents[1]
Plastron = Callable[..., subprocess.CompletedProcess[str]]
README = (ROOT / "README.md").read_text(encoding="utf-8")
TUTORIAL = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")


def blocks(page: str, language: str = "") -> list[str]:
    """Return the fenced blocks of a page, in a language."""
    found = re.findall(r"^```(\w*)\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    return [text for tag, text in found if tag == language]


def only(page: str, start: str) -> str:
    """Return the one block that starts with a text."""
    (found,) = (text for text in blocks(page) if text.startswith(start))
    return found


@pytest.fixture
def here(tmp_path: Path) -> Path:
    """The tutorial's folder: its project file, and its first program."""
    (tmp_path / "plastron.yaml").write_text(blocks(TUTORIAL, "yaml")[0])
    (tmp_path / "robot.plastron").write_text(only(TUTORIAL, "create_node 'talker'"))
    return tmp_path


@pytest.fixture
def plastron(copied: Copies, monkeypatch: pytest.MonkeyPatch) -> Plastron:
    """Run plastron as a process, in a folder and with no ROS around it."""
    for name in [name for name in os.environ if name.startswith("ROS_")]:
        monkeypatch.delenv(name)

    def plastron(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
        done = copied.run(arguments, folder, b"", {"NO_COLOR": "1"}, is_debian=False)
        out, err = done.stdout.decode(), done.stderr.decode()
        return subprocess.CompletedProcess(done.args, done.returncode, out, err)

    return plastron


def change(here: Path, old: str, new: str, file: str = "robot.plastron") -> None:
    path = here / file
    text = path.read_text()
    assert text.count(old) == 1
    path.write_text(text.replace(old, new))


def written(here: Path) -> set[str]:
    return {path.name for path in (here / "output").glob("*.py")}


def test_the_readme_begins_with_a_program_that_is_right(tmp_path: Path, plastron: Plastron) -> None:
    (tmp_path / "a.plastron").write_text(only(README, "create_node"))
    done = plastron(tmp_path, "generate", "a.plastron")
    assert (done.returncode, done.stderr) == (0, "")
    assert written(tmp_path) == {"talker_pub.py"}


def test_the_first_program_makes_the_files_that_are_named(here: Path, plastron: Plastron) -> None:
    done = plastron(here, "generate", "robot.plastron")
    assert (done.returncode, done.stderr) == (0, "")
    named = set(re.findall(r"`output/(\w+\.py)`", TUTORIAL))
    assert written(here) == named == {"talker_pub.py", "listener_sub1.py"}
    assert "import rclpy" in (here / "output" / "talker_pub.py").read_text()


def test_the_mistake_that_is_shown_is_what_is_printed(here: Path, plastron: Plastron) -> None:
    listener = "subscribe listener to 'chatter' of message_type "
    change(here, f"{listener}String", f"{listener}Int32")
    said = plastron(here, "check", "robot.plastron").stderr
    command, shown = only(TUTORIAL, "$ plastron").split("\n", 1)
    assert command == "$ plastron check robot.plastron"
    assert shown == said
    assert said.startswith(only(README, "error["))


def test_the_values_are_right(here: Path, plastron: Plastron) -> None:
    with (here / "robot.plastron").open("a") as program:
        program.write(only(TUTORIAL, "create_message"))
    done = plastron(here, "check", "robot.plastron")
    assert (done.returncode, done.stderr) == (0, "")


def test_the_program_grows_and_the_code_that_was_written_by_hand_stays(
    here: Path, plastron: Plastron
) -> None:
    with (here / "robot.plastron").open("a") as program:
        program.write(only(TUTORIAL, "create_node 'motor'"))
    assert plastron(here, "generate", "robot.plastron").stderr == ""
    handler = (here / "output" / "motor_server.py").read_text()
    assert "SetBool" in handler
    change(here, "def on_chatter", "# useful\n    def on_chatter", "output/listener_sub1.py")
    line = only(TUTORIAL, "subscribe listener")
    change(here, "generate_node listener\n", f"{line}generate_node listener\n")
    done = plastron(here, "generate", "robot.plastron")
    assert done.returncode == 0
    made = (here / "output" / "listener_sub1.py").read_text()
    assert "# useful" in made
    assert "def on_alarm" in made


def test_the_same_in_cpp_makes_the_files_that_are_named(here: Path, plastron: Plastron) -> None:
    (command,) = re.findall(r"^plastron (generate .*--output cpp .*)$", TUTORIAL, re.MULTILINE)
    done = plastron(here, *command.split())
    assert (done.returncode, done.stderr) == (0, "")
    named = set(re.findall(r"`(cpp/[\w/.]+)`", TUTORIAL))
    folder = here / "cpp"
    made = {
        path.relative_to(here).as_posix()
        for path in folder.rglob("*")
        if path.is_file() and not path.name.startswith(".")
    }
    assert made == named


def test_the_line_comes_before_the_node_is_generated(here: Path, plastron: Plastron) -> None:
    with (here / "robot.plastron").open("a") as program:
        program.write(only(TUTORIAL, "subscribe listener"))
    assert "warning[changed-after-generating]" in plastron(here, "check", "robot.plastron").stderr


def test_the_node_of_somebody_else(tmp_path: Path, plastron: Plastron) -> None:
    shutil.copytree(ROOT / "examples", tmp_path / "examples", ignore=lambda *_: ["output"])
    program = (tmp_path / "examples" / "change_node.plastron").read_text()
    statements = [line for line in program.splitlines() if line and not line.startswith("//")]
    assert statements == only(TUTORIAL, "load").splitlines()
    shown = plastron(tmp_path, "inspect", "examples/nodes/sonar.py")
    assert (shown.returncode, shown.stderr) == (0, "")
    patch = plastron(tmp_path, "generate", "--diff", "examples/change_node.plastron")
    assert (patch.returncode, patch.stderr) == (0, "")
    assert "+++ " in patch.stdout


@pytest.mark.parametrize("page", [README, TUTORIAL], ids=["README", "tutorial"])
def test_every_command_that_is_shown_is_one(page: str, plastron: Plastron) -> None:
    lines = [line for text in blocks(page, "sh") for line in text.splitlines()]
    shown = [line.partition("#")[0].split() for line in lines]
    commands = {words[1] for words in shown if words[:1] == ["plastron"] and len(words) > 1}
    done = plastron(ROOT, "--help")
    assert commands <= set(re.findall(r"^  (\w+)", done.stdout, re.MULTILINE))
