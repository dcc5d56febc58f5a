"""How far a project reaches."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.boundary import PROJECT_FILE, Boundary, find_boundary


def made(folder: Path, *names: str) -> None:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if name.endswith("/"):
            path.mkdir(exist_ok=True)
        else:
            path.touch()


@pytest.mark.parametrize(
    ("there", "folder", "root", "project_file"),
    [
        ([], "a/b", "a/b", None),
        (["a/plastron.yaml"], "a/b", "a", "a/plastron.yaml"),
        (["a/plastron.yaml", "a/b/plastron.yaml"], "a/b", "a/b", "a/b/plastron.yaml"),
        (["a/.git/"], "a/b", "a", None),
        (["a/.git"], "a/b", "a", None),  # a worktree, or a submodule
        (["a/.git/", "a/plastron.yaml"], "a/b", "a", "a/plastron.yaml"),
        (["a/.git/", "a/b/plastron.yaml"], "a/b/c", "a", "a/b/plastron.yaml"),
        # The search ends at the repository's root.
        (["a/.git/", "plastron.yaml"], "a/b", "a", None),
        (["a/b/.git/", "a/plastron.yaml"], "a/b", "a/b", None),
        # What is in the home folder, or above it, counts for no folder below.
        (["home/plastron.yaml"], "home/a", "home/a", None),
        (["home/.git/"], "home/a", "home/a", None),
        (["plastron.yaml"], "home/a", "home/a", None),
        # For the home folder itself it does, as for any other.
        (["home/plastron.yaml"], "home", "home", "home/plastron.yaml"),
        (["plastron.yaml", ".git/"], "home", "home", None),
    ],
)
def test_root_and_project_file(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    there: list[str],
    folder: str,
    root: str,
    project_file: str | None,
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    made(tmp_path, "home/", f"{folder}/", *there)
    found = find_boundary(tmp_path / folder)
    expected = None if project_file is None else tmp_path / project_file
    assert (found.root, found.project_file) == (tmp_path / root, expected)
    assert found.is_home_or_above == (root == "home")


def test_a_link_to_a_folder_is_in_the_folders_project(tmp_path: Path) -> None:
    made(tmp_path, "mine/.git/", "theirs/a/", "theirs/plastron.yaml")
    (tmp_path / "mine" / "link").symlink_to(tmp_path / "theirs" / "a")
    assert find_boundary(tmp_path / "mine" / "link").root == tmp_path / "theirs"


@pytest.mark.parametrize("home", ["", "relative"])
def test_a_home_folder_that_is_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, home: str
) -> None:
    monkeypatch.setenv("HOME", home)
    made(tmp_path, "a/", PROJECT_FILE)
    assert find_boundary(tmp_path / "a").project_file == tmp_path / PROJECT_FILE


def test_the_root_of_the_file_system_is_no_project_by_accident() -> None:
    assert find_boundary(Path("/")).is_home_or_above


INSIDE = ["a.py", "a/b.py", ".", "not/there.py", "a/../b.py", "site/x.py"]
OUTSIDE = ["..", "../b.py", "a/../../b.py", "/etc/passwd", "link", "link/x.py", "../project2/x.py"]
APART = [".git/hooks", ".git", "a/.venv/x.py", ".bashrc", "lib/site-packages", "hooks/pre-commit"]


@pytest.mark.parametrize(("path", "is_inside"), [
    *((path, True) for path in INSIDE), *((path, False) for path in [*OUTSIDE, *APART]),
])  # fmt: skip
def test_what_is_in_a_project(tmp_path: Path, path: str, is_inside: bool) -> None:
    root = tmp_path / "project"
    made(root, "a/", ".git/hooks/")
    (root / "link").symlink_to(tmp_path)
    (root / "hooks").symlink_to(".git/hooks")
    for trusted in (False, True):
        boundary = Boundary(root, trusts=lambda _, trusted=trusted: trusted)
        assert boundary.contains(root / path) == is_inside
        assert boundary.allows(root / path) == (is_inside or trusted)


def test_of_the_home_folder_little_is_a_project(tmp_path: Path) -> None:
    boundary = Boundary(tmp_path, is_home_or_above=True)
    for inside in ("a.py", "output", "output/a.py", "."):
        assert boundary.contains(tmp_path / inside)
    for outside in (".bashrc", ".local/lib/a.py", "ws/src/a.py", "bin/a.py", "output/.x"):
        assert not boundary.contains(tmp_path / outside)


def test_what_the_command_line_names_is_allowed(tmp_path: Path) -> None:
    boundary = Boundary(tmp_path / "a", named=(tmp_path / "b",), trusts=lambda _: False)
    assert boundary.allows(tmp_path / "b" / "x.py")
    assert not boundary.allows(tmp_path / "bb" / "x.py")
