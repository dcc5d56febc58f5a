"""`plastron lint` as its users call it."""

from __future__ import annotations

import json
import os
import pty
import signal
import subprocess
from pathlib import Path

import pytest
from command_line import PLASTRON, Run, snapshot

TALKER = """\
import rospy
from std_msgs.msg import String
rospy.init_node('one')
pub = rospy.Publisher('a', String, queue_size=1)
rospy.spin()
"""
NO_QUEUE = "import rospy\nfrom std_msgs.msg import String\npub = rospy.Publisher('a', String)\n"


@pytest.fixture
def workspace(here: Path) -> Path:
    """A folder with a warning in its third line, and nothing else wrong."""
    (here / "src").mkdir()
    (here / "src" / "a.py").write_text(NO_QUEUE)
    (here / "plastron.yaml").write_text("lint: {select: RC407}\n")
    return here


def _break(here: Path) -> None:
    """Make two nodes that use a topic with different types, which is an error."""
    (here / "src" / "one.py").write_text(TALKER)
    text = TALKER.replace("String", "Int32").replace("one", "two").replace("queue_size=1", "print")
    (here / "src" / "two.py").write_text(text.replace("Publisher", "Subscriber"))


def test_exit_statuses(workspace: Path, run: Run) -> None:
    result = run("lint", "src")
    assert (result.returncode, result.stdout) == (0, b"")
    assert b"warning[RC407]" in result.stderr
    assert b" --> src/a.py:3:7\n" in result.stderr
    assert result.stderr.endswith(b"found 1 warning\n")
    assert run("lint", "--strict").returncode == 1
    assert run("lint", "--ignore", "RC407", "--strict").returncode == 0
    _break(workspace)
    result = run("lint", "--select", "type-conflict")
    assert result.returncode == 1
    assert b"error[RG101]" in result.stderr
    assert run("lint", "--baseline", "missing.json").returncode == 2
    assert run("lint", "missing").returncode == 2
    assert run("lint", "--select", "RX").returncode == 2
    assert run("lint", "--fix", "--watch").returncode == 2
    # As a variable of a CI that is not set.
    assert run("lint", "--against", "").returncode == 2
    # A rule that compares with a revision would find nothing.
    assert run("lint", "--select", "RK508").returncode == 2


@pytest.mark.parametrize(
    "setting",
    ["select: RC999", "ignore: RC999", "selct: RC407", "per_file_ignores: 1", "select: {"],
)
@pytest.mark.parametrize(
    "words", [(), ("--diff",), ("--fix",), ("--format", "json"), ("--write-baseline", "b.json")]
)
def test_mistake_in_the_settings(
    workspace: Path, run: Run, setting: str, words: tuple[str, ...]
) -> None:
    (workspace / "plastron.yaml").write_text(f"lint: {{{setting}}}\n")
    result = run("lint", *words)
    assert result.returncode == 2
    assert b"plastron.yaml" in result.stderr


def test_folder_without_anything_to_look_at(workspace: Path, run: Run) -> None:
    (workspace / "empty").mkdir()
    (workspace / "empty" / "a.py").write_text("x = 1\n")
    result = run("lint", "empty")
    assert result.returncode == 0
    assert result.stderr == b"there is no package, node, launch file or program\n"
    assert run("lint", "empty", "--format", "json").stderr == b""


@pytest.mark.parametrize("format_", ["json", "sarif", "github"])
def test_results_go_to_standard_output(workspace: Path, run: Run, format_: str) -> None:
    result = run("lint", "--format", format_)
    assert (result.returncode, result.stderr) == (0, b"found 1 warning\n")
    if format_ == "github":
        assert result.stdout.startswith(b"::warning title=plastron lint (RC407),file=src/a.py,")
        return
    found = json.loads(result.stdout)
    if format_ == "json":
        assert [(each["code"], each["file"]) for each in found] == [
            ("RC407", str(workspace / "src" / "a.py"))
        ]
    else:
        assert [each["ruleId"] for each in found["runs"][0]["results"]] == ["RC407"]


@pytest.mark.parametrize(
    ("repositories", "file"),
    [
        ((), "a.py"),
        ((".git/",), "src/a.py"),
        # So it is in a worktree, and in a submodule.
        ((".git",), "src/a.py"),
        ((".git/", "src/.git"), "a.py"),
    ],
)
def test_annotations_name_files_from_the_root_of_the_repository(
    workspace: Path, run: Run, repositories: tuple[str, ...], file: str
) -> None:
    for each in repositories:
        if each.endswith("/"):
            (workspace / each).mkdir()
        else:
            (workspace / each).touch()
    result = run("lint", "--format", "github", cwd=workspace / "src")
    assert f",file={file},line=3," in result.stdout.decode()


@pytest.mark.parametrize(
    ("format_", "name"),
    [("json", r"src/\\udcff.py"), ("sarif", "src/%FF.py"), ("github", r"file=src/\udcff.py")],
)
def test_file_name_that_is_no_text(workspace: Path, run: Run, format_: str, name: str) -> None:
    (workspace / "src" / "a.py").rename(workspace / "src" / os.fsdecode(b"\xff.py"))
    assert name in run("lint", "--format", format_).stdout.decode()


def test_comments_baseline_and_fixes(workspace: Path, run: Run) -> None:
    assert run("lint", "--write-baseline", "known.json").returncode == 0
    assert run("lint", "--baseline", "known.json").stderr == b""
    (workspace / "known.json").unlink()

    result = run("lint", "--add-noqa")
    assert (result.returncode, result.stderr) == (0, b"noted 1 problem in 1 file\n")
    file = workspace / "src" / "a.py"
    assert file.read_text() == NO_QUEUE.rstrip() + "  # noqa: RC407\n"
    assert run("lint").stderr == b""

    # Nothing breaks the rule there any more: the comment is taken away.
    text = NO_QUEUE.replace("String)", "String, queue_size=1)  # noqa: RC407")
    file.write_text(text)
    (workspace / "plastron.yaml").unlink()
    before = snapshot(workspace)
    result = run("lint", "--diff", "--select", "RC407,unused-noqa")
    assert result.returncode == 1
    assert b"--- a/src/a.py\n+++ b/src/a.py\n" in result.stdout
    assert snapshot(workspace) == before
    result = run("lint", "--fix", "--select", "RC407,unused-noqa")
    assert (result.returncode, result.stderr) == (0, b"mended 1 problem in 1 file\n")
    assert file.read_text() == text.replace("  # noqa: RC407", "")
    assert sorted(snapshot(workspace)) == ["src", "src/a.py"]


OLD_BASELINE = '{"version": 1, "findings": []}'
TAKEN = {
    "no_file": (None, 0),
    "nothing": ("", 0),
    "a_baseline": (OLD_BASELINE, 0),
    "a_source": (NO_QUEUE, 2),
    "other_json": ('{"version": "1"}', 2),
    "a_baseline_of_later": (OLD_BASELINE.replace("1", "2"), 2),
}


@pytest.mark.parametrize(("text", "status"), TAKEN.values(), ids=TAKEN)
def test_baseline_takes_the_place_of_no_work(
    workspace: Path, run: Run, text: str | None, status: int
) -> None:
    file = workspace / "known.json"
    if text is not None:
        file.write_text(text)
    result = run("lint", "--write-baseline", "known.json")
    assert result.returncode == status
    if status:
        assert file.read_text() == text
        assert b"`known.json` is no baseline, and would be written over" in result.stderr
    else:
        assert b"RC407" in file.read_bytes()
        assert run("lint", "--baseline", "known.json").returncode == 0


def test_baseline_goes_to_a_pipe(workspace: Path, run: Run) -> None:
    assert json.loads(run("lint", "--write-baseline", "/dev/stdout").stdout)["version"] == 1


def test_annotation_of_a_name_that_a_terminal_would_obey(workspace: Path, run: Run) -> None:
    (workspace / "src" / "a.py").rename(workspace / "src" / "d \x1b[31m:,%.py")
    said = run("lint", "--format", "github").stdout.decode()
    assert r",file=src/d \x1b[31m%3A%2C%25.py,line=" in said


def test_a_rule_is_explained_and_completed(run: Run) -> None:
    by_code, by_name = (
        run("lint", "--explain", "RC407"),
        run("lint", "--explain", "queue-size-missing"),
    )
    assert by_code.stdout.startswith(b"# RC407: queue-size-missing\n")
    assert by_code.stdout == by_name.stdout
    assert run("lint", "--explain", "unused-noqa").stdout.startswith(b"# unused-noqa\n")
    assert run("lint", "--explain", "RX1").returncode == 2
    asked = {"_PLASTRON_COMPLETE": "bash_complete", "COMP_WORDS": "plastron lint --select RC407,qu"}
    completed = run(env={**asked, "COMP_CWORD": "3"}).stdout
    assert b"RC407,queue-size-missing" in completed


def test_it_looks_again_when_a_file_changes(workspace: Path) -> None:
    command = [*PLASTRON, "lint", "--watch", "--format", "github", "-j1"]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdout=pipe, stderr=pipe, cwd=workspace) as process:
        assert process.stdout is not None and process.stderr is not None
        assert b"RC407" in process.stdout.readline()
        assert process.stderr.readline() == b"found 1 warning\n"
        assert b"watching" in process.stderr.readline()
        # As editors do it: another file takes its place.
        other = workspace / "src" / ".a.py.new"
        other.write_text("# moved\n" + NO_QUEUE)
        other.rename(workspace / "src" / "a.py")
        assert b"line=4," in process.stdout.readline()
        process.send_signal(signal.SIGINT)
        rest = process.stderr.read()
        assert process.wait(60) == 130
    assert b"Traceback" not in rest


def test_what_can_have_no_comment_is_told(workspace: Path, run: Run) -> None:
    text = NO_QUEUE.replace("pub = ", "x = '''\n''' + \\\n  ")
    (workspace / "src" / "a.py").write_text(text.rstrip() + " + \\\n  '''\n'''\n")
    result = run("lint", "--add-noqa")
    assert b"1 problem can have no comment: see `per_file_ignores`\n" in result.stderr
    assert b"warning[RC407]" in result.stderr


def test_progress_is_drawn_on_the_terminal_and_goes(workspace: Path) -> None:
    own, its = pty.openpty()
    try:
        subprocess.run([*PLASTRON, "lint", "src"], cwd=workspace, stderr=its, check=False)
        said = os.read(own, 65536)
    finally:
        os.close(own)
        os.close(its)
    # The line is taken back by the terminal's own signs, not by words for them.
    assert b"\r\x1b[K" in said
    assert b"\\x1b" not in said
