"""What a port says of the other files of a node's package."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one
from ported_nodes import CATALOGS, MARK, OTHER

from plastron_tui.sources.python import read_python
from plastron_tui.targets import find_target

INIT = {
    "rospy": "import rospy\n{}rospy.init_node('n')\n",
    "rclpy": "import rclpy\n{}rclpy.init()\nnode = rclpy.create_node('n')\n",
}


def ported_in(folder: Path, text: str, library: str) -> tuple[str, list[str | None]]:
    """Bring a file of a package to the other library; return it, and the helps."""
    path = folder / "main.py"
    path.write_text(text)
    read = read_python(path, one(text.encode()), library).source
    target = find_target(OTHER[library])
    assert read is not None
    assert target is not None
    result = target.port(None, read, CATALOGS[OTHER[library]])  # type: ignore[arg-type]
    assert result.files is not None
    return result.files.main.decode(), [each.help for each in result.diagnostics]


IMPORTS = [
    ("from .helper import Base", ".helper", "from rospy import *\n", "from rclpy import *\n"),
    ("from helper import Base", "helper", "    import rospy\n", "    import rclpy\n"),
    ("import helper as h", "helper", "import rospy, sys\n", "import rclpy, sys\n"),
    ("from . import helper", ".helper", "import rospy\n", "import rclpy\n"),
    ("from .helper import Base", "", "import rospybag\n", "# import rclpy\n"),
    ("from .other import Base", "", "import rospy\n", "import rclpy\n"),
]


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize(("line", "what", "of_1", "of_2"), IMPORTS)
def test_a_module_beside_that_uses_the_old_ros_is_marked(
    line: str, what: str, of_1: str, of_2: str, library: str, tmp_path: Path
) -> None:
    (tmp_path / "helper.py").write_text(of_1 if library == "rospy" else of_2)
    text, helps = ported_in(tmp_path, INIT[library].format(f"{line}\n"), library)
    assert (f"{MARK}{what}\n{line}\n" if what else f"\n{line}\n") in text
    wanted = f"it uses {library}, and has to be ported too"
    assert helps == ([wanted] if what else [])


MAIN = "def go():\n    rospy.loginfo('a')\nif __name__ == '__main__':\n    rospy.init_node('n')\n"
OTHERS = [
    (MAIN, "from .main import go\n", True),
    (MAIN, "from pack.main import go\n", True),
    (MAIN, "from .domain import go\n", False),
    (MAIN.replace("rospy.loginfo", "print"), "from .main import go\n", False),
    ("rospy.init_node('n')\n", "from .main import go\n", False),
]


@pytest.mark.parametrize(("text", "other", "is_marked"), OTHERS)
def test_a_node_of_the_program_that_another_file_needs_is_marked(
    text: str, other: str, is_marked: bool, tmp_path: Path
) -> None:
    (tmp_path / "other.py").write_text(other)
    made, helps = ported_in(tmp_path, f"import rospy\n{text}", "rospy")
    assert (f"    {MARK}the node\n    rclpy.init()\n" in made) == is_marked
    help_ = "`other.py` imports the file, and has to set its `node` first"
    assert helps == ([help_] if is_marked else [])
