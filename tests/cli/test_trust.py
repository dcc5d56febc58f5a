"""`plastron trust`, and what each command does in a folder that is not trusted."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path

import pytest
from command_line import TALKER, Run, snapshot

WAITING = b"untrusted-templates"


@pytest.fixture
def go(run: Run, here: Path) -> Run:
    """Run plastron in a repository, with a state and a home of the test's own."""
    env = {"XDG_STATE_HOME": str(here / "state"), "HOME": str(here / "home")}
    (here / "home").mkdir()
    (here / "work" / ".git").mkdir(parents=True)
    return partial(run, env=env, cwd=here / "work")


@pytest.fixture
def foreign(here: Path) -> Path:
    """A program in a project that has templates of its own."""
    folder = here / "work"
    (folder / "mine" / "rospy").mkdir(parents=True)
    (folder / "mine" / "rospy" / "node.py.j2").write_text("# foreign\n")
    (folder / "plastron.yaml").write_text("templates: mine\n")
    (folder / "a.plastron").write_text(TALKER)
    return folder


def test_trust_list_and_remove(go: Run, here: Path) -> None:
    folder = here / "work"
    (folder / "inner").mkdir()
    none = go("trust", "--list")
    assert (none.returncode, none.stdout, none.stderr) == (0, b"", b"you trust no folder yet\n")
    assert go("trust", "inner").stdout.decode() == f"trusted  {folder}\n"
    assert go("trust", "--list").stdout.decode() == f"{folder}\n"
    assert go("trust", "--remove").stdout.decode() == f"no longer trusted  {folder}\n"
    again = go("trust", "--remove", folder)
    assert (again.returncode, again.stdout) == (1, b"")
    assert snapshot(folder) == {".git": None, "inner": None}


def test_a_trusted_folder_that_is_gone_can_be_removed(go: Run, here: Path) -> None:
    (here / "gone" / ".git").mkdir(parents=True)
    assert go("trust", here / "gone").returncode == 0
    (here / "gone" / ".git").rmdir()
    (here / "gone").rmdir()
    assert go("trust", "--remove", here / "gone").returncode == 0
    assert go("trust", "--list").stdout == b""


@pytest.mark.parametrize(
    "arguments", [("nowhere",), ("--list", "--remove"), ("--list", "."), ("plastron.yaml",)]
)
def test_wrong_usage(go: Run, foreign: Path, arguments: tuple[str, ...]) -> None:
    assert go("trust", *arguments).returncode == 2


def test_the_home_folder_is_trusted_by_its_name_only(go: Run, here: Path) -> None:
    assert go("trust", cwd=here / "home").returncode == 2
    assert go("trust", "--list").stdout == b""
    assert go("trust", ".", cwd=here / "home").returncode == 0


def test_a_store_that_others_may_write_is_said(go: Run, foreign: Path, here: Path) -> None:
    assert go("trust").returncode == 0
    (here / "state" / "plastron" / "trusted").chmod(0o777)
    for arguments in ((), ("--list",), ("--remove",)):
        result = go("trust", *arguments)
        assert (result.returncode, result.stdout) == (2, b"")
        assert b"error[unsafe-trust-store]: others may write to" in result.stderr
        assert b"remove it, and trust your folders again" in result.stderr
    result = go("generate", "a.plastron")
    assert result.returncode == 1
    assert b"nothing counts as trusted, because others may write to" in result.stderr


def test_a_store_that_cannot_be_written_is_not_to_be_removed(go: Run, here: Path) -> None:
    env = {"XDG_STATE_HOME": "/proc", "HOME": str(here / "home")}
    result = go("trust", env=env)
    assert result.returncode == 2
    assert b"error[unsafe-trust-store]" in result.stderr
    assert b"remove it" not in result.stderr


@pytest.mark.parametrize(
    ("arguments", "status"),
    [
        (("check", "a.plastron"), 0),
        (("graph", "a.plastron"), 0),
        (("types", "Twist"), 0),
        (("generate", "a.plastron"), 1),
        (("generate", "--dry-run", "a.plastron"), 1),
        (("generate", "--diff", "a.plastron"), 1),
        (("run", "a.plastron"), 1),
        (("shell",), 1),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else str(value),
)
def test_each_command_says_once_that_templates_wait(
    go: Run, foreign: Path, arguments: tuple[str, ...], status: int
) -> None:
    before = snapshot(foreign)
    result = go(*arguments, stdin=TALKER.encode())
    assert (result.returncode, result.stderr.count(WAITING)) == (status, 1)
    assert (b"warning[" if status == 0 else b"error[") + WAITING in result.stderr
    assert f"plastron trust {foreign}".encode() in result.stderr
    assert b"# foreign" not in result.stdout
    assert snapshot(foreign) == before


def test_two_programs_of_a_project_say_it_once(go: Run, foreign: Path) -> None:
    (foreign / "b.plastron").write_text(TALKER.replace("'talker'", "'other'"))
    result = go("check", "a.plastron", "b.plastron")
    assert result.stderr.count(WAITING) == 1


def test_check_as_json_says_it_too(go: Run, foreign: Path) -> None:
    (found,) = json.loads(go("check", "-f", "json", "a.plastron").stdout)
    assert (found["code"], found["severity"]) == ("untrusted-templates", "warning")


def test_commands_that_need_no_project_say_nothing(go: Run, foreign: Path) -> None:
    (foreign / "node.py").write_text("import rospy\nrospy.init_node('a')\n")
    for arguments in (("inspect", "node.py"), ("fmt", "--check", "a.plastron")):
        result = go(*arguments)
        assert (result.returncode, result.stderr) == (0, b"")


def test_what_a_load_leads_to_is_refused_at_its_place(go: Run, here: Path) -> None:
    (here / "home" / "driver.py").write_text("import rospy\nrospy.init_node('a')\n")
    program = "load '../home/driver.py' as n\ngenerate_node n\n"
    result = go("generate", "-", "--in-place", stdin=program.encode())
    assert result.returncode == 1
    assert b":1:6\n" in result.stderr
    assert b"error[outside-project]: `../home/driver.py` is outside of the project" in result.stderr
