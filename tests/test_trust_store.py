"""The folders that the user trusts: remembered, forgotten, and never taken from others."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from machine import skip_or_fail

from plastron_tui.trust import TrustStore, TrustStoreError

NOBODY = 65534


@pytest.fixture
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> TrustStore:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return TrustStore()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    path = tmp_path / "project"
    path.mkdir()
    return path


def test_a_folder_is_trusted_until_it_is_removed(store: TrustStore, folder: Path) -> None:
    assert folder not in store
    store.add(folder)
    store.add(folder)
    assert folder in TrustStore()
    assert store.folders() == [folder]
    assert store.remove(folder)
    assert folder not in store
    assert not store.remove(folder)


def test_exactly_the_folder_is_trusted(store: TrustStore, folder: Path) -> None:
    store.add(folder)
    (folder / "inner").mkdir()
    assert folder / "inner" not in store
    assert folder.parent not in store
    assert folder.with_name("project2") not in store


def test_a_folder_is_known_by_its_real_path(store: TrustStore, folder: Path) -> None:
    link = folder.with_name("link")
    link.symlink_to(folder)
    store.add(link)
    assert store.folders() == [folder]
    other = folder.with_name("other")
    other.mkdir()
    link.unlink()
    link.symlink_to(other)
    assert link not in store


@pytest.mark.parametrize("name", ["a\nb", "ä", os.fsdecode(b"\xff"), "'", " "])
def test_any_name_of_a_folder(store: TrustStore, tmp_path: Path, name: str) -> None:
    (tmp_path / name).mkdir()
    store.add(tmp_path / name)
    assert store.folders() == [tmp_path / name]
    assert tmp_path not in store


def test_the_store_is_the_users_alone(store: TrustStore, folder: Path) -> None:
    before = os.umask(0)
    try:
        store.add(folder)
    finally:
        os.umask(before)
    files = [store.folder, *store.folder.iterdir()]
    assert [file.stat().st_mode & 0o777 for file in files] == [0o700, 0o600]


def _entry(store: TrustStore) -> Path:
    (file,) = store.folder.iterdir()
    return file


def _given_away(path: Path) -> None:
    if os.geteuid() != 0:
        skip_or_fail("only root can give a file to another user")
    os.chown(path, NOBODY, NOBODY)


def _linked(path: Path) -> None:
    real = path.with_name("real")
    path.rename(real)
    path.symlink_to(real)


def _fifo(path: Path) -> None:
    path.unlink()
    os.mkfifo(path)


def _folder(path: Path) -> None:
    path.unlink()
    path.mkdir()


@pytest.mark.parametrize(
    "spoil",
    [
        pytest.param(lambda file: file.write_bytes(b""), id="empty"),
        pytest.param(lambda file: file.write_bytes(b"/"), id="another path"),
        pytest.param(lambda file: file.write_bytes(os.urandom(100_000)), id="too long"),
        pytest.param(lambda file: file.chmod(0o666), id="anyone may write"),
        pytest.param(lambda file: file.chmod(0o620), id="the group may write"),
        pytest.param(_given_away, id="another user's"),
        pytest.param(_linked, id="a link"),
        pytest.param(_fifo, id="a pipe"),
        pytest.param(_folder, id="a folder"),
    ],
)
def test_a_spoilt_entry_counts_for_nothing(
    store: TrustStore, folder: Path, tmp_path: Path, spoil: object
) -> None:
    store.add(folder)
    spoil(_entry(store))  # type: ignore[operator]
    assert folder not in store
    assert store.folders() == []
    assert store.broken()
    other = tmp_path / "other"
    other.mkdir()
    store.add(other)
    assert other in store


@pytest.mark.parametrize(
    "spoil",
    [
        pytest.param(lambda path: path.chmod(0o777), id="anyone may write"),
        pytest.param(lambda path: path.chmod(0o1777), id="anyone may write, sticky"),
        pytest.param(lambda path: path.chmod(0o770), id="the group may write"),
        pytest.param(_given_away, id="another user's"),
        pytest.param(_linked, id="a link"),
    ],
)
def test_nothing_is_trusted_where_the_store_is_spoilt(
    store: TrustStore, folder: Path, spoil: object
) -> None:
    store.add(folder)
    spoil(store.folder)  # type: ignore[operator]
    assert folder not in store
    assert store.problem() is not None
    for call in (store.folders, store.broken):
        with pytest.raises(TrustStoreError):
            call()
    for change in (store.add, store.remove):
        with pytest.raises(TrustStoreError):
            change(folder)


def test_a_store_that_is_a_file_trusts_nothing(store: TrustStore, folder: Path) -> None:
    store.folder.parent.mkdir(parents=True)
    store.folder.write_text(str(folder))
    assert folder not in store
    with pytest.raises(TrustStoreError):
        store.add(folder)


def test_an_interrupted_entry_is_in_nobodys_way(store: TrustStore, folder: Path) -> None:
    store.add(folder)
    left = _entry(store).with_name(f".{_entry(store).name}.999999999.tmp")
    left.write_text("half")
    assert store.folders() == [folder]
    assert store.broken() == []
    store.add(folder)
    assert folder in store
    assert not left.exists()
