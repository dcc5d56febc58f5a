"""What the studio looks at by itself, where something else than a file lies in its place."""

from __future__ import annotations

from pathlib import Path

import pytest
from limited import Attacker
from machine import mostly_long
from test_special_files import SPECIAL

_LOOKS = """
import sys
from pathlib import Path
from plastron_tui.project.program_file import read_program
from plastron_tui.studio.config import load_remembered
from plastron_tui.studio.config_reader import load_config
from plastron_tui.studio.files import open_file, read_again, save_file
from plastron_tui.studio.journal import kept_texts
from plastron_tui.studio.recipes import recipes
from plastron_tui.studio.screens.choose_file import _names
from plastron_tui.studio.screens.welcome import Welcome
from plastron_tui.studio.wizard.node_files import _node_files

here = Path.cwd()
opened = open_file(here / "x.plastron")
assert opened.disk is None and opened.problem is not None
assert save_file(here / "x.plastron", b"text", None).problem is not None
load_config(here / "studio.yaml", (), ())
assert load_remembered(here).recent == []
assert kept_texts(here) == []
assert recipes(here) == ()
assert list(_node_files(here)) == []
_names(here)
Welcome([str(here / "x.plastron")])
"""


@pytest.mark.parametrize("kind", mostly_long(SPECIAL, {"fifo", "device"}))
def test_the_studio_looks_at_no_special_file(attacker: Attacker, tmp_path: Path, kind: str) -> None:
    folder = tmp_path / "here"
    folder.mkdir()
    for name in ("x.plastron", "studio.yaml", "studio.json", "x.journal", "x.py"):
        SPECIAL[kind](folder / name)
    before = sorted(folder.iterdir())
    attacker.python(folder, _LOOKS).check(0)
    assert sorted(folder.iterdir()) == before
