"""Where the user's settings and state are, also for a user without a home."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui import user_folders
from plastron_tui.private_files import write_private
from plastron_tui.user_folders import NOWHERE, cache_folder, config_folder, state_folder


@pytest.fixture
def shared(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Stand for `/tmp`, for a user who has no home."""

    def no_home() -> Path:
        raise RuntimeError("no home")

    folder = tmp_path / "tmp"
    folder.mkdir()
    monkeypatch.setattr(user_folders, "_SHARED", folder)
    monkeypatch.setattr(Path, "home", no_home)
    return folder


def test_variables_go_first_and_count_only_when_absolute(tmp_path: Path) -> None:
    environ = {"XDG_STATE_HOME": str(tmp_path), "XDG_CONFIG_HOME": "here"}
    assert state_folder(environ) == tmp_path / "plastron"
    assert config_folder(environ) == Path.home() / ".config/plastron"
    assert cache_folder(environ) == Path.home() / ".cache/plastron"


def test_a_home_that_is_no_place_is_none(shared: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Path, "home", lambda: Path("home"))
    assert state_folder({}).parent == shared / f"plastron-{os.geteuid()}"


def test_without_a_home_there_is_a_folder_that_only_the_user_enters(shared: Path) -> None:
    for _ in range(2):
        folder = state_folder({})
        assert folder == config_folder({}) == shared / f"plastron-{os.geteuid()}" / "plastron"
        write_private(folder / "a", b"")
    assert [path.stat().st_mode & 0o777 for path in (folder, folder.parent)] == [0o700] * 2


@pytest.mark.parametrize("how", ["wide", "foreign", "link", "file"])
def test_a_folder_that_others_may_have_made_is_not_used(
    how: str, shared: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = shared / f"plastron-{os.geteuid()}"
    if how == "link":
        (shared / "mine").mkdir(mode=0o700)
        folder.symlink_to("mine")
    elif how == "file":
        folder.touch(mode=0o600)
    else:
        folder.mkdir(mode=0o700)
    if how == "wide":
        folder.chmod(0o750)
    if how == "foreign":
        user = os.geteuid()
        monkeypatch.setattr(os, "geteuid", lambda: user + 1)
        folder.rename(shared / f"plastron-{user + 1}")
    assert state_folder({}).parent == NOWHERE
    with pytest.raises(OSError):
        write_private(state_folder({}) / "a", b"")
