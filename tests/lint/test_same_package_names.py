"""Two packages of one name, which the build tools refuse, are told at both places."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, write_tree
from packages import CATKIN, PYTHON

_ROS1 = {file[4:]: text for file, text in CATKIN.items()}
_ROS2 = {file[7:]: text for file, text in PYTHON.items()}


@pytest.mark.parametrize(
    ("folders", "told"),
    [
        (("a", "b"), ["b"]),
        (("a", "b", "c"), ["b", "c"]),
        (("ws/src/a", "ws/src/b"), ["ws/src/b"]),
        # `colcon` finds what is beside `src`, which `catkin` does not look at.
        (("src/a", "extra/a"), ["src/a"]),
        (("1:src/a", "1:extra/a"), []),
        (("1:src/a", "1:src/b"), ["src/b"]),
        (("1:a", "1:b"), ["b"]),
        # Two workspaces, or two generations of ROS.
        (("one/src/a", "two/src/a"), []),
        (("one/src/a", "two/src/a", "two/src/b"), ["two/src/b"]),
        (("one/src/a", "two/src/a", "three/a"), []),
        (("a", "1:b"), []),
        # One that is not built: it is ignored, or in a package.
        (("a", "b/COLCON_IGNORE/"), []),
        (("a", "a/b"), []),
        (("a/CATKIN_IGNORE/", "b/AMENT_IGNORE/"), []),
    ],
)
def test_packages_of_one_name(tmp_path: Path, folders: tuple[str, ...], told: list[str]) -> None:
    files = {}
    for each in folders:
        own = _ROS1 if each.startswith("1:") else _ROS2
        folder = each.removeprefix("1:").rstrip("/")
        marker = folder.rpartition("/")[2] if "IGNORE" in each else ""
        folder = folder.removesuffix(f"/{marker}")
        name = "<name>rover</name>"
        for file, text in own.items():
            text = text.replace("<name>wheels</name>", name).replace("<name>old</name>", name)
            files[f"{folder}/{file}"] = text
        if marker:
            files[f"{folder}/{marker}"] = ""
    root = write_tree(tmp_path, files).rename(tmp_path / "held")
    for _ in ("read", "as it was read before"):
        found = [each.diagnostic for each in run_over(root, "package-exists").told]
        paths = [str(each.file.parent.relative_to(root)) for each in found if each.file is not None]
        assert paths == told
    for each in found:
        (label,) = each.labels
        assert label.file not in (None, each.file)
        assert each.message == "two packages of this workspace are called `rover`"


def test_ignoring_one_of_them_is_enough(tmp_path: Path) -> None:
    files = {f"{each}/{file}": text for each in "ab" for file, text in _ROS2.items()}
    root = write_tree(tmp_path, files)
    (found,) = run_over(root, "package-exists").told
    assert found.diagnostic.help == (
        "rename one, or put a file `COLCON_IGNORE` into the folder that is not to be built"
    )
    (root / "b/COLCON_IGNORE").touch()
    assert run_over(root, "package-exists").told == ()
