"""`generate` of nodes that a program loads."""

from __future__ import annotations

import json
import stat
from pathlib import Path

import pytest
from command_line import LISTENER, Run, endpoints, fill_in, snapshot, write

CHANGE = """\
load listener_sub1 as node
subscribe node to 'other' of message_type Int32
generate_node node
"""


def test_load_and_change_after_handwork(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "listener_sub1.py"
    text = fill_in(file)
    write(here, CHANGE, "b.plastron")
    result = run("generate", "b.plastron")
    assert result.returncode == 0, result.stderr.decode()
    assert endpoints(run, file) == {"subscriptions": ["chatter", "other"]}
    changed = file.read_text()
    lost = set(text.split("\n")) - set(changed.split("\n"))
    assert lost == {"from std_msgs.msg import String"}
    assert "from std_msgs.msg import Int32, String\n" in changed
    compile(changed, str(file), "exec")


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
@pytest.mark.parametrize("flags", [[], ["--in-place"]])
def test_load_without_a_change_is_identical(
    run: Run, here: Path, flags: list[str], ending: str
) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "listener_sub1.py"
    text = fill_in(file).replace("\n", ending)
    file.write_bytes(text.encode())
    write(here, "load listener_sub1 as n\ngenerate_node n\n", "b.plastron")
    result = run("generate", *flags, "b.plastron")
    assert (result.returncode, result.stdout) == (0, b"identical  output/listener_sub1.py\n")
    assert file.read_bytes() == text.encode()


def test_unsubscribe_takes_the_topic_out(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    change = CHANGE.replace("generate", "unsubscribe node from 'chatter'\ngenerate")
    write(here, change, "b.plastron")
    result = run("generate", "b.plastron")
    assert result.returncode == 0, result.stderr.decode()
    file = here / "output" / "listener_sub1.py"
    assert endpoints(run, file) == {"subscriptions": ["other"]}


def test_loaded_from_the_program_folder_goes_to_the_output(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron", "-o", ".").returncode == 0
    original = (here / "listener_sub1.py").read_bytes()
    write(here, CHANGE, "b.plastron")
    assert run("generate", "b.plastron").stdout == b"   create  output/listener_sub1.py\n"
    assert (here / "listener_sub1.py").read_bytes() == original
    assert endpoints(run, here / "output" / "listener_sub1.py") == {
        "subscriptions": ["chatter", "other"]
    }


def test_in_place_writes_over_the_file_and_keeps_its_mode(run: Run, here: Path) -> None:
    (here / "scripts").mkdir()
    write(here, LISTENER)
    assert run("generate", "a.plastron", "-o", "scripts").returncode == 0
    file = here / "scripts" / "listener_sub1.py"
    file.chmod(0o750)
    write(here, CHANGE.replace("listener_sub1", "'scripts/listener_sub1.py'"), "b.plastron")
    result = run("generate", "--in-place", "b.plastron")
    assert (result.returncode, result.stdout) == (0, b"  changed  scripts/listener_sub1.py\n")
    assert endpoints(run, file) == {"subscriptions": ["chatter", "other"]}
    assert stat.S_IMODE(file.stat().st_mode) == 0o750
    assert not (here / "output").exists()


@pytest.mark.parametrize("flags", [[], ["--in-place"]])
def test_load_of_what_the_program_generates(run: Run, here: Path, flags: list[str]) -> None:
    write(here, LISTENER + CHANGE)
    file = here / "output" / "listener_sub1.py"
    for _ in range(2):
        result = run("generate", *flags, "a.plastron")
        assert result.returncode == 0, result.stderr.decode()
        assert endpoints(run, file) == {"subscriptions": ["chatter", "other"]}
    assert b"identical" in result.stdout
    file.write_text(file.read_text() + "# mine\n")
    result = run("generate", *flags, "a.plastron")
    assert result.returncode == 0
    assert b": your changes are kept" in result.stderr
    assert file.read_text().endswith("# mine\n")
    assert endpoints(run, file) == {"subscriptions": ["chatter", "other"]}


def test_folders_are_searched_in_order(run: Run, here: Path) -> None:
    (here / ".git").mkdir()
    for folder in ("work", "program", "program/output"):
        (here / folder).mkdir()
        topic = folder.replace("/", "_")
        write(here, LISTENER.replace("chatter", topic))
        assert run("generate", "a.plastron", "-o", folder, "--force").returncode == 0
    write(here, "load listener_sub1 as n\ngenerate_node n\n", "program/p.plastron")
    found = []
    for folder in ("program/output", "program", "work"):
        result = run("graph", "--format", "json", "../program/p.plastron", cwd=here / "work")
        found.append(json.loads(result.stdout)["topics"][0]["name"])
        (here / folder / "listener_sub1.py").unlink()
    assert found == ["/program_output", "/program", "/work"]


@pytest.mark.parametrize(
    ("source", "code", "remedy"),
    [
        ("listner_sub1", "file-not-found", "did you mean `listener_sub1`?"),
        ("'output/listener_sub.py'", "file-not-found", "did you mean `output/listener_sub1.py`?"),
        ("'output'", "unreadable-file", None),
        ("'/dev/null'", "outside-project", None),
        (f"'{'x/' * 3000}'", "file-not-found", None),
        ("x" * 400, "file-not-found", None),
        ("'~nobody-at-all/x.py'", "file-not-found", None),
    ],
)
def test_load_that_fails(run: Run, here: Path, source: str, code: str, remedy: str | None) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    (here / "node.cpp").write_text("int main() {}\n")
    write(here, f"load {source} as n\ngenerate_node n\n", "b.plastron")
    before = snapshot(here)
    result = run("generate", "b.plastron")
    assert result.returncode == 1
    assert f"error[{code}]".encode() in result.stderr
    assert b"b.plastron:1:6" in result.stderr
    assert remedy is None or f"= help: {remedy}".encode() in result.stderr
    assert b"found 1 error\n" in result.stderr
    assert snapshot(here) == before
