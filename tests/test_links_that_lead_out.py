"""A program that is a link out of its project is written by nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from plastron_tui.cli.group import cli
from plastron_tui.studio.files import open_file, save_file
from plastron_tui.studio.recipes import Recipe, place_files
from plastron_tui.trust import TrustStore

UNTIDY = b"create_node   'a'  as a\n"
TIDY = b"create_node 'a' as a\n"

# Where a link in the repository leads, from the folder above; and whether that is in the project.
LINKS = {
    "a file outside": ("home/.profile", False),
    "a file of a repository beside it": ("other/a.plastron", False),
    "git's hooks": ("repo/.git/hooks/pre-commit", False),
    "installed packages": ("repo/env/site-packages/a.plastron", False),
    "a file below": ("repo/programs/a.plastron", True),
    "a file beside it": ("repo/b.plastron", True),
}


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    for name, _ in LINKS.values():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(UNTIDY)
    return tmp_path / "repo"


def link_to(repository: Path, name: str) -> Path:
    path = repository / "x.plastron"
    path.symlink_to(repository.parent / name)
    return path


@pytest.mark.parametrize(("name", "is_inside"), LINKS.values(), ids=LINKS)
def test_fmt_writes_through_no_link_out(repository: Path, name: str, is_inside: bool) -> None:
    path = link_to(repository, name)
    result = CliRunner().invoke(cli, ["fmt", str(path)])
    assert (path.read_bytes() == TIDY) is is_inside
    assert (result.exit_code == 0) is is_inside
    assert ("error[outside-project]" in result.output) is not is_inside
    assert path.is_symlink()


@pytest.mark.parametrize(("name", "is_inside"), LINKS.values(), ids=LINKS)
def test_the_studio_saves_through_no_link_out(repository: Path, name: str, is_inside: bool) -> None:
    path = link_to(repository, name)
    saved = save_file(path, TIDY, open_file(path).disk)
    assert (path.read_bytes() == TIDY) is is_inside
    assert ([saved.problem.code] if saved.problem else []) == ["outside-project"] * (not is_inside)


def test_what_is_named_itself_or_trusted_is_written(repository: Path) -> None:
    outside = repository.parent / "home" / ".profile"
    assert CliRunner().invoke(cli, ["fmt", str(outside)]).exit_code == 0
    assert outside.read_bytes() == TIDY
    outside.write_bytes(UNTIDY)
    path = link_to(repository, "home/.profile")
    TrustStore().add(repository)
    assert CliRunner().invoke(cli, ["fmt", str(path)]).exit_code == 0
    assert outside.read_bytes() == TIDY


def test_a_recipe_is_placed_through_no_link_out(repository: Path, tmp_path: Path) -> None:
    (tmp_path / "recipes").mkdir()
    (tmp_path / "recipes" / "old.py").write_text("import rospy\n")
    (repository / "old.py").symlink_to(tmp_path / "home" / "new.py")
    recipe = Recipe("t", "d", tmp_path / "recipes" / "a.plastron", b"", (Path("old.py"),))
    placed = place_files(recipe, repository)
    assert placed.problem is not None
    assert not (tmp_path / "home" / "new.py").exists()
