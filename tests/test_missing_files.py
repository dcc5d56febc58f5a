"""What is said of files that are not there, and which files a package has."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.project.missing_files import missing
from plastron_tui.sources.packages.files import DEEPEST, package_files


@pytest.mark.parametrize(
    ("source", "name"),
    [
        ("config/rover.yml", "config/rover.yaml"),
        ("config/rovr.yaml", "config/rover.yaml"),
        ("rovers.yaml", None),
        ("config/rover2.txt", "config/rover.yaml"),
        ("config/quite_another.yaml", None),
        ("nowhere/rover.yaml", None),
        ("config\0/rover.yaml", None),
    ],
)
def test_what_may_be_meant_by_a_path(tmp_path: Path, source: str, name: str | None) -> None:
    (tmp_path / "config").mkdir()
    for each in ("rover.yaml", "rover2.launch", "rovers.txt"):
        (tmp_path / "config" / each).touch()
    path = tmp_path / source
    found = missing(source, path, lambda each: each.suffix == ".yaml")
    assert found.name == name
    assert found.remedy == (f"did you mean `{name}`?" if name else f"it is looked for as `{path}`")


def test_a_path_that_leads_to_no_file_is_not_told_as_its_own_remedy(tmp_path: Path) -> None:
    path = tmp_path / "pipe.yaml"
    os.mkfifo(path)
    found = missing("pipe.yaml", path, lambda each: each.suffix == ".yaml")
    assert found == (None, f"it is looked for as `{path}`")


def test_files_of_a_package_are_none_of_others_or_of_builds(tmp_path: Path) -> None:
    deep = "/".join("d" * (DEEPEST + 2))
    for each in (
        "package.xml", "scripts/a.py", "inner/package.xml", "inner/b.py", "inner/in/b.py",
        "build/c.py", "scripts/__pycache__/a.pyc", ".git/config", ".hidden",
        f"{deep}/e.py", "a/z.py",
    ):  # fmt: skip
        (tmp_path / each).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / each).touch()
    assert list(package_files(tmp_path)) == ["package.xml", "a/z.py", "scripts/a.py"]
