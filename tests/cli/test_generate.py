"""`generate`: what it writes, and what it never loses."""

from __future__ import annotations

import stat
from pathlib import Path

import pytest
from command_line import BROKEN, LISTENER, TALKER, Run, endpoints, fill_in, snapshot, write

TWICE = LISTENER.replace("generate", "subscribe listener to 'b' of message_type Int32\ngenerate")
THRICE = TWICE.replace("generate", "subscribe listener to 'c' of message_type Int32\ngenerate")


def test_created_then_identical(run: Run, here: Path) -> None:
    write(here, TALKER)
    first = run("generate", "a.plastron")
    assert (first.returncode, first.stdout) == (0, b"   create  output/talker_pub.py\n")
    file = here / "output" / "talker_pub.py"
    assert file.stat().st_mode & stat.S_IXUSR
    before = snapshot(here)
    again = run("generate", "a.plastron")
    assert (again.returncode, again.stdout) == (0, b"identical  output/talker_pub.py\n")
    assert snapshot(here) == before


def test_output_folder_is_beside_the_program(run: Run, here: Path) -> None:
    (here / "deep").mkdir()
    write(here, TALKER, "deep/a.plastron")
    assert run("generate", "deep/a.plastron").stdout == b"   create  deep/output/talker_pub.py\n"
    assert run("generate", "deep/a.plastron", "-o", "x/y").returncode == 0
    assert (here / "x" / "y" / "talker_pub.py").exists()


def test_standard_input_writes_beside_the_working_folder(run: Run, here: Path) -> None:
    assert run("generate", "-", stdin=TALKER.encode()).returncode == 0
    assert (here / "output" / "talker_pub.py").exists()


@pytest.mark.parametrize("flag", ["--dry-run", "--diff"])
def test_dry_runs_write_nothing(run: Run, here: Path, flag: str) -> None:
    write(here, TALKER)
    before = snapshot(here)
    result = run("generate", flag, "a.plastron")
    assert (result.returncode, bool(result.stdout)) == (0, True)
    assert snapshot(here) == before
    assert run("generate", "a.plastron").returncode == 0
    write(here, TALKER.replace('"hello"', '"bye"'))
    before = snapshot(here)
    result = run("generate", flag, "a.plastron")
    changed = b"  changed  output/talker_pub.py\n" if flag == "--dry-run" else b'"bye"'
    assert changed in result.stdout
    assert snapshot(here) == before


def test_diff_is_a_patch(run: Run, here: Path) -> None:
    write(here, TALKER)
    assert run("generate", "a.plastron").returncode == 0
    write(here, TALKER.replace('"hello"', '"bye"'))
    patch = run("generate", "--diff", "a.plastron").stdout.decode().split("\n")
    assert [line for line in patch if line.startswith(("-", "+")) and "String(" in line]
    assert "--- a/talker_pub.py" in patch


@pytest.mark.parametrize("programs", [(BROKEN,), (TALKER, BROKEN), (BROKEN, TALKER)])
def test_an_error_generates_nothing(run: Run, here: Path, programs: tuple[str, ...]) -> None:
    names = []
    for number, text in enumerate(programs):
        write(here, text, f"{number}.plastron")
        names.append(f"{number}.plastron")
    result = run("generate", *names)
    assert (result.returncode, result.stdout) == (1, b"")
    assert b"did you mean `node1`?" in result.stderr
    assert not (here / "output").exists()


def test_program_that_generates_nothing_is_told_so(run: Run, here: Path) -> None:
    write(here, "create_node 'a' as a\n")
    result = run("generate", "a.plastron")
    assert (result.returncode, result.stdout) == (0, b"")
    assert b"warning[nothing-to-generate]" in result.stderr


def test_a_type_alone_is_something_to_generate(run: Run, here: Path) -> None:
    (here / "W.msg").write_text("int8 a\n")
    program = "load_type 'W.msg' as W\nW has_field \"int8 b\"\ngenerate_type W\n"
    write(here, program)
    for states in (b"changed", b""):
        result = run("generate", "--in-place", "a.plastron")
        assert (result.returncode, result.stderr) == (0, b"")
        assert states in result.stdout
    assert run("check", "a.plastron").stderr == b""


def test_two_programs_do_not_overwrite_each_other(run: Run, here: Path) -> None:
    write(here, TALKER, "a.plastron")
    write(here, TALKER.replace("hello", "bye"), "b.plastron")
    result = run("generate", "a.plastron", "b.plastron")
    assert (result.returncode, b"error[same-file]" in result.stderr) == (1, True)
    assert not (here / "output").exists()
    assert run("generate", "a.plastron", "a.plastron").returncode == 0


def test_file_of_somebody_else_is_a_conflict(run: Run, here: Path) -> None:
    write(here, TALKER + LISTENER)
    (here / "output").mkdir()
    mine = here / "output" / "talker_pub.py"
    mine.write_text("mine\n")
    before = snapshot(here)
    result = run("generate", "a.plastron")
    assert (result.returncode, b"error[file-conflict]" in result.stderr) == (1, True)
    assert b"or use `generate --force` to overwrite it" in result.stderr
    assert b" conflict  output/talker_pub.py\n" in result.stdout
    assert snapshot(here) == before
    forced = run("generate", "--force", "a.plastron")
    assert forced.returncode == 0
    assert b" replaced  output/talker_pub.py\n" in forced.stdout
    assert b"   backup  output/talker_pub.py.bak\n" in forced.stdout
    assert (here / "output" / "talker_pub.py.bak").read_text() == "mine\n"
    assert b"rospy" in mine.read_bytes()


def test_regenerating_keeps_handwork_and_adds_what_is_new(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "listener_sub1.py"
    text = fill_in(file)
    same = run("generate", "a.plastron")
    # Nothing is wrong, and nothing is to be done.
    assert (same.returncode, same.stderr) == (
        0, b"note: `listener_sub1.py`: your changes are kept\n\n"
    )  # fmt: skip
    assert file.read_text() == text
    service = "listener provides_service 'reset' of service_type Empty\n"
    # The node keeps its file, whatever it does.
    write(here, LISTENER.replace("generate", service + "generate"))
    changed = run("generate", "a.plastron")
    assert (changed.returncode, changed.stdout) == (0, b"  changed  output/listener_sub1.py\n")
    assert endpoints(run, file) == {"subscriptions": ["chatter"], "services": ["reset"]}
    assert "self.heard = message.data  # mine" in file.read_text()


@pytest.mark.parametrize("is_still_written", [False, True])
def test_a_node_keeps_its_file_for_another_library(
    run: Run, here: Path, is_still_written: bool
) -> None:
    write(here, LISTENER.replace("generate_node listener", "generate_node listener using rospy"))
    assert run("generate", "a.plastron").returncode == 0
    ported = "generate_node listener using rclpy"
    before = "generate_node listener using rospy\n" if is_still_written else ""
    more = "subscribe listener to 'b' of message_type Int32\n"
    write(here, LISTENER.replace("generate_node listener", before + more + ported))
    expected = "listener_sub2.py" if is_still_written else "listener_sub1.py"
    found = run("generate", "a.plastron")
    assert (found.returncode, found.stderr) == (0, b"")
    assert b"import rclpy" in (here / "output" / expected).read_bytes()
    names = {path.name for path in (here / "output").glob("*.py")}
    assert names == {"listener_sub1.py", expected}


def test_plain_names_are_for_files_that_are_new(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    (here / "plastron.yaml").write_text("file_names: plain\n")
    assert run("generate", "a.plastron").stdout == b"identical  output/listener_sub1.py\n"
    (here / "output" / "listener_sub1.py").unlink()
    assert run("generate", "a.plastron").stdout == b"   create  output/listener.py\n"
    (here / "plastron.yaml").write_text("file_names: ending\n")
    assert run("generate", "a.plastron").stdout == b"identical  output/listener.py\n"


@pytest.mark.parametrize("name", ["listener_sub1", "listener_sub2"])
def test_a_file_is_loaded_by_its_name_or_by_that_of_a_new_one(
    run: Run, here: Path, name: str
) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    second = "subscribe listener to 'x' of message_type String\n"
    write(here, LISTENER.replace("generate", second + "generate") + f"load {name} as again\n")
    found = run("check", "a.plastron")
    assert (found.returncode, found.stderr) == (0, b"")


def test_a_mistake_in_a_node_is_none_of_the_load_of_its_file(run: Run, here: Path) -> None:
    second = "subscribe listener to 'x' of message_type Strin\n"
    load = "load listener_sub2 as again\n"
    write(here, LISTENER.replace("generate", second + "generate") + load)
    found = run("check", "a.plastron")
    assert (found.returncode, found.stderr.count(b"error[")) == (1, 1)


def test_regenerating_merges_into_the_same_file(run: Run, here: Path) -> None:
    write(here, TWICE)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "listener_sub2.py"
    head, tail = file.read_text().split("\n\n\ndef main", 1)
    file.write_text(f"{head}\n\n    def own(self):\n        return 'mine'\n\n\ndef main{tail}")
    write(here, THRICE)
    result = run("generate", "a.plastron")
    assert result.returncode == 0, result.stderr.decode()
    assert b"  changed  output/listener_sub2.py" in result.stdout
    assert endpoints(run, file) == {"subscriptions": ["chatter", "b", "c"]}
    assert "return 'mine'" in file.read_text()


def test_what_was_added_by_hand_is_never_taken_out(run: Run, here: Path) -> None:
    write(here, THRICE)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "listener_sub2.py"
    mine = "        rospy.Subscriber('mine', Int32, self.on_b)  # mine\n"
    at = "\n    def on_chatter("
    file.write_text(file.read_text().replace(at, mine + at, 1))
    write(here, TWICE)
    result = run("generate", "a.plastron")
    assert result.returncode == 0, result.stderr.decode()
    assert endpoints(run, file) == {"subscriptions": ["chatter", "b", "mine"]}
    assert mine in file.read_text()


def test_type_that_changes_keeps_what_is_written_in_the_callback(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "listener_sub1.py"
    fill_in(file)
    write(here, LISTENER.replace("String", "Int32"))
    result = run("generate", "a.plastron")
    assert result.returncode == 0, result.stderr.decode()
    assert b"`on_chatter` was written for `std_msgs/String`" in result.stderr
    text = file.read_text()
    assert "rospy.Subscriber('chatter', Int32, self.on_chatter)" in text.replace('"', "'")
    assert "self.heard = message.data  # mine" in text


def test_what_cannot_be_merged_is_a_conflict_that_says_why(run: Run, here: Path) -> None:
    write(here, TALKER + LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "talker_pub.py"
    text = file.read_text()
    text += "\n\ndef own(node):\n    return node.chatter_publisher.get_num_connections()\n"
    file.write_text(text)
    line = text.count("\n")
    other = TALKER.replace("chatter", "other").replace("String", "Int32").replace('"hello"', "1")
    write(here, other)
    before = snapshot(here)
    result = run("generate", "a.plastron")
    assert (result.returncode, b"error[file-conflict]" in result.stderr) == (1, True)
    assert f"the publisher `chatter` is used in line {line}" in result.stderr.decode()
    assert b"`generate --force` to write it anew" in result.stderr
    assert snapshot(here) == before
    assert run("generate", "--force", "a.plastron").returncode == 0
    assert file.with_name("talker_pub.py.bak").read_text() == text
    assert endpoints(run, file) == {"publishers": ["other"]}


def test_force_writes_anew_and_keeps_a_backup(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "listener_sub1.py"
    fresh = file.read_text()
    text = fill_in(file)
    assert run("generate", "--force", "--dry-run", "a.plastron").returncode == 0
    assert file.read_text() == text
    assert run("generate", "--force", "a.plastron").returncode == 0
    assert file.read_text() == fresh
    assert file.with_name("listener_sub1.py.bak").read_text() == text


def test_broken_manifest_is_told_and_nothing_is_overwritten(run: Run, here: Path) -> None:
    write(here, TALKER)
    assert run("generate", "a.plastron").returncode == 0
    (here / "output" / ".plastron.json").write_text("{")
    write(here, TALKER.replace("hello", "bye"))
    result = run("generate", "a.plastron")
    assert result.returncode == 1
    assert b"warning[bad-manifest]" in result.stderr
    assert b"error[file-conflict]" in result.stderr
