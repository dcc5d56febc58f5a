"""Scripts whose names have no suffix, and links to scripts: ROS starts them as any other."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, told, write_tree
from packages import CATKIN, ROS1_NODE

_NO_QUEUE = ROS1_NODE.replace(", queue_size=1", "")


@pytest.mark.parametrize(
    ("text", "mode", "count"),
    [
        (_NO_QUEUE, 0o755, 1),
        # Nothing can start it.
        (_NO_QUEUE, 0o644, 0),
        # It is in another language, as far as the first line says.
        (_NO_QUEUE.replace("python", "ruby"), 0o755, 0),
        (_NO_QUEUE.partition("\n")[2], 0o755, 0),
        (_NO_QUEUE.replace("Twist)", "Twist)  # noqa: RC407"), 0o755, 0),
    ],
)
def test_script_without_a_suffix_is_read(tmp_path: Path, text: str, mode: int, count: int) -> None:
    root = write_tree(tmp_path, CATKIN | {"old/scripts/talker": text})
    (root / "old/scripts/talker").chmod(mode)
    assert len(told(run_over(root, "RC407"))) == count
    # What was read is kept, and tells the same.
    assert len(told(run_over(root, "RC407"))) == count


def test_script_that_may_be_run_later_is_read_then(tmp_path: Path) -> None:
    root = write_tree(tmp_path, CATKIN | {"old/scripts/talker": _NO_QUEUE})
    assert told(run_over(root, "RC407")) == []
    (root / "old/scripts/talker").chmod(0o755)
    assert told(run_over(root, "RC407")) == [("RC407", 7)]


_LAUNCH = '<launch>\n  <node pkg="old" type="{}" name="mover"/>\n</launch>\n'


def test_link_to_a_program_is_one(tmp_path: Path) -> None:
    root = write_tree(tmp_path, CATKIN | {"old/launch/old.launch": _LAUNCH.format("mover")})
    (root / "old/scripts/mover.py").chmod(0o755)
    assert [code for code, _ in told(run_over(root, "RK506"))] == ["RK506"]
    (root / "old/scripts/mover").symlink_to("mover.py")
    assert told(run_over(root, "RK506")) == []
    (root / "old/scripts/mover.py").chmod(0o644)
    (root / "old/scripts/mover").unlink()
    (root / "old/scripts/mover").symlink_to("nowhere.py")
    assert [code for code, _ in told(run_over(root, "RK506"))] == ["RK506"]
