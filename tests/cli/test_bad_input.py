"""Files that are no programs: each gives a diagnostic and a status, and nothing changes."""

from __future__ import annotations

import os
import random
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path

import pytest
from command_line import BROKEN, LISTENER, TALKER, Run, snapshot
from machine import examples, mostly_long, skip_or_fail

COMMANDS = [("check",), ("generate",), ("graph",), ("fmt",), ("inspect",)]

Make = Callable[[Path], object]

UNREADABLE: dict[str, tuple[Make, str]] = {
    "missing": (lambda path: None, "no such file or directory"),
    "folder": (lambda path: path.mkdir(), "is a directory"),
    "huge": (lambda path: os.truncate(make_file(path), 10**12), "is larger than"),
    "loop": (lambda path: path.symlink_to(path), "too many levels of symbolic links"),
    "dangling link": (lambda path: path.symlink_to("nowhere"), "no such file or directory"),
    "device": (lambda path: path.symlink_to("/dev/zero"), "is not a regular file"),
    "fifo": (os.mkfifo, "is not a regular file"),
}

NO_TEXT = {
    "binary": (bytes(range(256)) * 20, "NUL bytes"),
    "nul": (TALKER.encode() + b"\0", "NUL bytes"),
    "latin-1": (TALKER.replace("hello", "grüße").encode("latin-1"), "not UTF-8 (line 2)"),
    "utf-16": (TALKER.encode("utf-16"), "NUL bytes"),
    "cut utf-8": (TALKER.encode() + "ü".encode()[:1], "not UTF-8 (line 5)"),
    "surrogate": (b'create_message m of message_type String and input "\xed\xa0\x80"', "not UTF-8"),
    "50 MB line": (b"x" * (50 * 1024 * 1024), "larger than"),
    "1 MB line": (b"x" * 1024 * 1024, "longer than"),
}


def make_file(path: Path) -> Path:
    path.touch()
    return path


@pytest.mark.parametrize("command", mostly_long(COMMANDS, [("check",), ("fmt",)]))
@pytest.mark.parametrize("what", UNREADABLE)
def test_file_that_cannot_be_read_is_2(
    run: Run, here: Path, command: tuple[str, ...], what: str
) -> None:
    make, reason = UNREADABLE[what]
    make(here / "a.plastron")
    before = sorted(here.rglob("*"))
    result = run(*command, "a.plastron")
    assert result.returncode == 2
    assert result.stderr.startswith(b"error[unreadable-file]: ")
    assert reason in result.stderr.decode()
    assert b"a.plastron" in result.stderr
    assert result.stderr.endswith(b"found 1 error\n")
    assert result.stdout == b""
    assert sorted(here.rglob("*")) == before


@pytest.mark.parametrize(
    "command",
    mostly_long([("check",), ("generate",), ("graph",), ("fmt",)], [("check",), ("fmt",)]),
)
@pytest.mark.parametrize("what", NO_TEXT)
def test_file_that_is_no_text_is_2(
    run: Run, here: Path, command: tuple[str, ...], what: str
) -> None:
    text, reason = NO_TEXT[what]
    (here / "a.plastron").write_bytes(text)
    before = snapshot(here)
    result = run(*command, "a.plastron")
    assert result.returncode == 2
    assert result.stderr.startswith(b"error[unreadable-file]: ")
    assert reason in result.stderr.decode()
    assert result.stdout == b""
    assert snapshot(here) == before
    assert len(result.stderr) < 2_000
    assert run(*command, "-", stdin=text).returncode == 2


@pytest.mark.parametrize("what", NO_TEXT)
def test_inspect_of_what_is_no_source(run: Run, here: Path, what: str) -> None:
    text, _ = NO_TEXT[what]
    (here / "a.py").write_bytes(text)
    result = run("inspect", "a.py")
    assert result.returncode in (1, 2)
    assert result.stderr.startswith(b"error[")
    assert result.stdout == b""
    assert len(result.stderr) < 2_000


def test_one_unreadable_file_does_not_hide_the_others(run: Run, here: Path) -> None:
    (here / "broken.plastron").write_text(BROKEN)
    (here / "good.plastron").write_text(TALKER)
    result = run("check", "missing.plastron", "broken.plastron", "good.plastron")
    assert result.returncode == 2
    assert b"missing.plastron" in result.stderr
    assert b"unknown-node" in result.stderr
    assert b"found 2 errors" in result.stderr
    assert run("generate", "missing.plastron", "good.plastron").returncode == 2
    assert not (here / "output").exists()


@pytest.mark.parametrize("text", [TALKER.rstrip("\n"), TALKER.replace("\n", "\r\n"),
                                  "\ufeff" + TALKER, TALKER + "\n\n // end"])  # fmt: skip
def test_line_endings_and_marks_are_no_mistake(run: Run, here: Path, text: str) -> None:
    (here / "a.plastron").write_text(TALKER)
    assert run("generate", "a.plastron", "-o", "plain").returncode == 0
    (here / "a.plastron").write_bytes(text.encode())
    assert run("check", "a.plastron").stderr == b""
    assert run("generate", "a.plastron", "-o", "other").returncode == 0
    assert snapshot(here / "plain") == snapshot(here / "other")


@pytest.mark.parametrize("text", ["", "\n", "\r\n", "// nothing\n", "/* nothing", "\t \n"])
def test_empty_programs(run: Run, here: Path, text: str) -> None:
    (here / "a.plastron").write_bytes(text.encode())
    is_right = text != "/* nothing"
    assert run("check", "a.plastron").returncode == (0 if is_right else 1)
    result = run("generate", "a.plastron")
    assert result.returncode == (0 if is_right else 1)
    assert (b"warning[nothing-to-generate]" in result.stderr) == is_right
    assert not (here / "output").exists()


@pytest.mark.parametrize(
    "name",
    ["../../x", "__import__('os')", "/etc/passwd", "a/b", "..", "a b", "a;b", "ünïcode", "a.py",
     "{{7*7}}", "", "1a", "~a", "x" * 300, "a\\nb", "-rf"],
)  # fmt: skip
def test_names_that_lead_astray(run: Run, here: Path, name: str) -> None:
    (here / "a.plastron").write_text(LISTENER.replace("'listener'", f"'{name}'"))
    before = snapshot(here)
    result = run("generate", "a.plastron")
    assert result.returncode == 1
    assert result.stderr.startswith(b"error[")
    assert snapshot(here) == before


@pytest.mark.parametrize("name", ["class", "None", "rospy", "main", "import_", "self", "a__b"])
def test_names_that_mean_something_to_python(run: Run, here: Path, name: str) -> None:
    (here / "a.plastron").write_text(LISTENER.replace("'listener'", f"'{name}'"))
    assert run("generate", "a.plastron").returncode == 0
    text = (here / "output" / f"{name}_sub1.py").read_text()
    compile(text, name, "exec")


@pytest.fixture
def full(here: Path) -> Iterator[Path]:
    """A file system with room for next to nothing."""
    yield from mounted(here / "full", "-o", "size=16k")


@pytest.fixture
def read_only(here: Path) -> Iterator[Path]:
    """A file system that nobody may write to, root included."""
    folder = here / "locked"
    folder.mkdir()
    yield from mounted(folder, "-o", "ro")


def mounted(folder: Path, *options: str) -> Iterator[Path]:
    folder.mkdir(exist_ok=True)
    mount = subprocess.run(
        ["mount", "-t", "tmpfs", *options, "tmpfs", folder], capture_output=True, check=False
    )
    if mount.returncode:
        skip_or_fail("mounting a file system needs to be root: run the tests in a container")
    yield folder
    subprocess.run(["umount", folder], check=True)


def test_read_only_output_is_2(run: Run, here: Path, read_only: Path) -> None:
    (here / "a.plastron").write_text(TALKER)
    for folder in ("locked", "locked/new"):
        result = run("generate", "a.plastron", "-o", folder)
        assert result.returncode == 2
        assert result.stderr.startswith(b"error[cannot-write]: cannot write ")
        assert b"read-only file system" in result.stderr
    assert list(read_only.iterdir()) == []
    assert run("generate", "a.plastron", "-o", "locked", "--dry-run").returncode == 0


def test_full_disk_is_2_and_leaves_nothing(run: Run, here: Path, full: Path) -> None:
    programs = [TALKER.replace("talker", f"talker{number}") for number in range(20)]
    (here / "a.plastron").write_text("".join(programs).replace("greeting", "g"))
    text = "".join(program.replace("greeting", f"g{i}") for i, program in enumerate(programs))
    (here / "a.plastron").write_text(text)
    result = run("generate", "a.plastron", "-o", "full")
    assert result.returncode == 2
    assert b"no space left on device" in result.stderr
    assert b"free some space" in result.stderr
    assert list(full.iterdir()) == []


def test_full_disk_leaves_a_formatted_program_alone(run: Run, full: Path) -> None:
    program = full / "a.plastron"
    program.write_text("create_node  'a'  as a\n" * 478)
    before = program.read_bytes()
    result = run("fmt", program)
    assert result.returncode == 2
    assert b"no space left on device" in result.stderr
    assert program.read_bytes() == before
    assert list(full.iterdir()) == [program]


def test_links_that_lead_out_are_2(run: Run, here: Path) -> None:
    (here / "home").mkdir()
    (here / "home" / "a.plastron").write_text(TALKER)
    outside = here / "outside"
    outside.mkdir()
    (outside / "precious").write_text("precious")
    output = here / "home" / "output"
    output.symlink_to(outside)
    result = run("generate", "home/a.plastron")
    assert (result.returncode, b"error[outside-output]" in result.stderr) == (2, True)
    output.unlink()
    output.mkdir()
    (output / "talker_pub.py").symlink_to(outside / "precious")
    for force in ([], ["--force"]):
        result = run("generate", "home/a.plastron", *force)
        assert (result.returncode, b"error[outside-output]" in result.stderr) == (2, True)
    assert snapshot(outside) == {"precious": b"precious"}


@pytest.mark.parametrize("what", ["file", "folder in the way"])
def test_output_that_is_no_folder_is_2(run: Run, here: Path, what: str) -> None:
    (here / "a.plastron").write_text(TALKER)
    if what == "file":
        (here / "output").write_text("mine")
    else:
        (here / "output" / "talker_pub.py").mkdir(parents=True)
    before = snapshot(here)
    result = run("generate", "a.plastron")
    assert (result.returncode, b"error[cannot-write]" in result.stderr) == (2, True)
    assert snapshot(here) == before


def noise(seed: int) -> bytes:
    chance = random.Random(seed)
    if seed % 2:
        return chance.randbytes(chance.randrange(400))
    text = bytearray((TALKER + LISTENER + BROKEN).encode())
    for _ in range(chance.randrange(1, 12)):
        at = chance.randrange(len(text) + 1)
        text[at : at + chance.randrange(6)] = bytes(
            chance.choice(b"'\"\\ \n\t/*(),[]=.-ab19\x7f\xc3\xa9")
            for _ in range(chance.randrange(6))
        )
    return bytes(text)


def test_noise_through_the_process(run: Run, here: Path) -> None:
    """Many files a process: what counts is that none crashes or hangs it."""
    names = []
    for seed in range(300):
        name = f"{seed}.plastron"
        (here / name).write_bytes(noise(seed))
        names.append(name)
    for command in ("check", "graph", "fmt"):
        result = run(command, *names)
        assert result.returncode == 2
    for seed in range(examples(40)):
        assert run("check", "-", stdin=noise(seed)).returncode in (0, 1, 2)


STATUS = {"check": 0, "generate": 0, "graph": 0, "inspect": 1, "--help": 0, "shell": 0}
CLOSED = (">&-", "2>&-", ">&- 2>&- <&-")


# Each command with all of them closed, and one of them with each.
@pytest.mark.parametrize(
    "case",
    mostly_long(
        product(STATUS, CLOSED),
        [*product(STATUS, CLOSED[2:]), *product(["generate"], CLOSED[:2])],
    ),
)
def test_closed_streams(here: Path, case: tuple[str, str]) -> None:
    command, closed = case
    here.joinpath("talker.plastron").write_text(TALKER)
    file = "talker.plastron" if command[0].islower() and command != "shell" else ""
    code = "from plastron_tui.cli import main; main()"
    done = subprocess.run(
        f"'{sys.executable}' -c '{code}' {command} {file} {closed}",
        shell=True,
        cwd=here,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert "Traceback" not in done.stderr
    assert done.returncode == STATUS[command]


def test_files_of_the_other_kind(run: Run, here: Path) -> None:
    here.joinpath("talker.plastron").write_text(TALKER)
    here.joinpath("node.py").write_text("import rospy\n")
    for command in ("check", "generate", "graph", "fmt"):
        result = run(command, "node.py")
        assert result.returncode == 2
        assert b"`node.py` is Python, not a program" in result.stderr
        assert b"found 1 error" in result.stderr
    result = run("inspect", "talker.plastron")
    assert result.returncode == 1
    assert b"`plastron check` and `plastron graph` read programs" in result.stderr


LAUNCH = b"`plastron graph` shows what it starts"
OTHERS = {
    "a.launch": (b"is a launch file, not ", LAUNCH),
    "a.launch.xml": (b"is a launch file, not ", LAUNCH),
    "a.launch.yaml": (b"is a launch file, not ", LAUNCH),
    "a_launch.py": (b"is a launch file, not ", LAUNCH),
    "package.xml": (b"is the manifest of a package, not ", b"`load_package`"),
    "A.msg": (b"is the definition of a type, not ", b"`load_type`"),
    "A.srv": (b"is the definition of a type, not ", b"`load_type`"),
    "a.urdf.xacro": (b"is the description of a robot, not ", b"`load_robot`"),
    "A.action": (b"is the definition of a type, not ", b"`load_type`"),
}


@pytest.mark.parametrize("name", OTHERS)
def test_files_that_are_neither_a_program_nor_a_node(run: Run, here: Path, name: str) -> None:
    here.joinpath(name).write_text("<launch>\n  <node/>\n</launch>\n")
    said, remedy = OTHERS[name]
    commands = [("check", b"a program"), ("fmt", b"a program"), ("inspect", b"a node")]
    # That one reads robots too.
    for command, wanted in commands[: 2 if b"robot" in said else 3]:
        result = run(command, name)
        assert result.returncode == (1 if command == "inspect" else 2)
        assert said + wanted in result.stderr and remedy in result.stderr
        assert b"found 1 error" in result.stderr


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("genrate", b"no command 'genrate'; did you mean 'generate'?"),
        ("talker.plstron", b"and no program: that is a file, or a name that ends in '.plastron'"),
    ],
)
def test_a_word_that_is_no_command(run: Run, name: str, said: bytes) -> None:
    result = run(name)
    assert result.returncode == 2
    assert said in result.stderr


def test_a_port_that_is_in_use(run: Run) -> None:
    pytest.importorskip("aiohttp", reason="the extra [web] is not installed")
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        result = run("serve", "--port", str(port))
    assert result.returncode == 2
    assert result.stderr.decode() == (
        f"error: port {port} of 127.0.0.1 is in use; choose another with --port\n"
    )


def test_a_host_that_is_no_name_is_2(run: Run) -> None:
    result = run("serve", "--host", "a..b")
    assert (result.returncode, result.stdout) == (2, b"")
    assert result.stderr == b"error: a..b is no name of a machine\n"


def test_a_name_without_its_suffix(run: Run, here: Path) -> None:
    here.joinpath("talker.plastron").write_text(TALKER)
    assert b"did you mean `talker.plastron`?" in run("check", "talker").stderr
    assert b"did you mean" not in run("check", "other").stderr
