from __future__ import annotations

import os
import stat
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from plastron_tui.output.manifest import load_manifest
from plastron_tui.output.plan import FilePlan, OutputFile, make_plan

Snapshot = dict[str, tuple[int, bytes | str | None]]


@pytest.fixture
def snapshot() -> Callable[[Path], Snapshot]:
    """Everything below a folder: names, modes, contents, link targets."""

    def take(root: Path) -> Snapshot:
        found: Snapshot = {}
        for path in sorted(root.rglob("*")):
            mode = path.lstat().st_mode
            content: bytes | str | None = None
            if stat.S_ISLNK(mode):
                content = os.readlink(path)
            elif stat.S_ISREG(mode):
                content = path.read_bytes()
            found[path.relative_to(root).as_posix()] = (stat.S_IMODE(mode), content)
        return found

    return take


@pytest.fixture
def plan() -> Callable[[Path, Sequence[OutputFile]], FilePlan]:
    """A plan against the folder's own manifest, which must raise no objection."""

    def make(folder: Path, files: Sequence[OutputFile]) -> FilePlan:
        manifest, _ = load_manifest(folder)
        made, diagnostics = make_plan(folder, files, manifest)
        assert diagnostics == ()
        return made

    return make


@pytest.fixture(autouse=True)
def _usual_umask():
    before = os.umask(0o022)
    yield
    os.umask(before)
