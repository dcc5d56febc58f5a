"""The attacker that the tests of this folder share."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from limited import Attacker, make_project

_SERVER = Path(__file__).with_name("attacked.py")


@pytest.fixture(scope="session")
def attacker(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Attacker]:
    """Return what attacks; all the tests share the process that forks."""
    home = tmp_path_factory.mktemp("home")
    command = [sys.executable, str(_SERVER)]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, text=True, stdin=pipe, stdout=pipe) as server:
        attacker = Attacker(server, home)
        make_project(home / "project")
        for command in ("generate", "generate", "check"):
            attacker.warm_up(home / "project", command, "p.plastron")
        yield attacker


@pytest.fixture(scope="session")
def made(attacker: Attacker, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a project whose program has generated its files."""
    folder = tmp_path_factory.mktemp("made") / "project"
    make_project(folder)
    attacker.run(folder, "generate", "p.plastron").check(0)
    return folder
