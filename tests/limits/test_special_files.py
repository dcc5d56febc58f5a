"""A FIFO, a device, a folder or a far too large file under every name that Plastron looks for."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from limited import Attacker, make_project
from machine import mostly_long


def _sparse(path: Path) -> None:
    with path.open("wb") as stream:
        stream.truncate(3 * 1024**3)


SPECIAL: dict[str, Callable[[Path], object]] = {
    "fifo": os.mkfifo,
    "device": lambda path: path.symlink_to("/dev/zero"),
    "folder": Path.mkdir,
    "huge": _sparse,
    "loop": lambda path: path.symlink_to(path.name),
    "endless": lambda path: path.symlink_to("/proc/self/mem"),
}

PLACES = {
    "p.plastron": ("check", "generate", "graph", "fmt"),
    "plastron.yaml": ("check", "generate", "types Odd"),
    "package.xml": ("check", "generate", "types"),
    "msg/Odd.msg": ("check", "generate", "types pkg/Odd"),
    "srv/Ask.srv": ("types Ask", "types"),
    "action/Go.action": ("types Go",),
    "known.py": ("check", "generate", "inspect known.py"),
    "output/.plastron.json": ("check", "generate", "generate --force"),
    "output/talker_pub.py": ("check", "generate", "generate --force", "graph"),
    "output/known.py": ("check", "generate", "generate --diff"),
    "templates/rospy/node.py.j2": ("trust .", "generate --dry-run"),
}
"""The names that are looked for, and the commands that do."""

_OF_PROGRAMS = {"check", "generate", "graph", "fmt"}


_QUICK = {"fifo"}


def _attacks() -> list[object]:
    return [
        pytest.param(place, kind, marks=() if kind in _QUICK else pytest.mark.long)
        for place in PLACES
        for kind in SPECIAL
    ]


def test_the_project_is_right_without_an_attack(attacker: Attacker, tmp_path: Path) -> None:
    make_project(tmp_path / "project")
    for command in ("check p.plastron", "generate p.plastron", "types pkg/Odd", "types Ask"):
        outcome = attacker.run(tmp_path / "project", *command.split()).check(0)
        assert "error" not in outcome.err


@pytest.mark.parametrize(("place", "kind"), _attacks())
def test_a_special_file_ends_with_a_diagnostic(
    attacker: Attacker, made: Path, tmp_path: Path, place: str, kind: str
) -> None:
    folder = shutil.copytree(made, tmp_path / "project")
    if place.startswith("templates/"):
        (folder / "plastron.yaml").write_text("templates: templates\n")
    path = folder / place
    # A name that nobody looks for would prove nothing.
    assert path.is_file() or place.startswith("templates/")
    path.unlink(missing_ok=True)
    SPECIAL[kind](path)
    for command in PLACES[place]:
        name, *rest = command.split()
        given = ["p.plastron"] if name in _OF_PROGRAMS else []
        attacker.run(folder, name, *rest, *given).check()


@pytest.mark.parametrize("kind", mostly_long(SPECIAL, _QUICK))
def test_a_special_file_is_no_trust(attacker: Attacker, tmp_path: Path, kind: str) -> None:
    folder = tmp_path / "project"
    make_project(folder)
    (folder / "plastron.yaml").write_text("templates: templates\n")
    known = set(attacker.trusted.glob("*"))
    attacker.run(folder, "trust", ".").check(0)
    (entry,) = set(attacker.trusted.glob("*")) - known
    attacker.run(folder, "generate", "--dry-run", "p.plastron").check(0)
    entry.unlink()
    SPECIAL[kind](entry)
    outcome = attacker.run(folder, "generate", "--dry-run", "p.plastron").check(1)
    assert "untrusted-templates" in outcome.err
    attacker.run(folder, "trust", "--list").check()
    entry.rmdir() if kind == "folder" else entry.unlink()
