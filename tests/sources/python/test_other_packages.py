"""What a node takes from other packages of its workspace, and where the workspace ends."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.source import SourceUnit
from plastron_tui.sources.python import read_python
from plastron_tui.sources.workspace_modules import modules_in, workspace_of

_FILES = {
    "src/demo/package.xml": "<package/>",
    "src/demo/demo/__init__.py": "from .names import CHATTER as SAID\n",
    "src/demo/demo/names.py": "from .words import WORD\nCHATTER = WORD + 'ter'\n",
    "src/demo/demo/words.py": "WORD = 'chat'\n",
    "src/demo/demo/bases.py": (
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n"
        "class Base(Node):\n    def __init__(self):\n        super().__init__('base')\n"
        "        self.create_publisher(String, 'of_base', 1)\n"
    ),
    "src/demo/msg/Own.msg": "int32 x\n",
    "src/group/arms/package.xml": "<package/>",
    "src/group/arms/src/arms/__init__.py": "",
    "src/group/arms/src/arms/names.py": "from demo.names import CHATTER\nARM = CHATTER + '/arm'\n",
    "src/ignored/COLCON_IGNORE": "",
    "src/ignored/gone/package.xml": "<package/>",
    "src/ignored/gone/gone/__init__.py": "NAME = 'gone'\n",
    "src/one/package.xml": "<package/>",
    "src/one/twice/__init__.py": "NAME = 'one'\n",
    "src/two/package.xml": "<package/>",
    "src/two/twice/__init__.py": "NAME = 'two'\n",
    "src/loose/loose/__init__.py": "NAME = 'loose'\n",
    "src/other/package.xml": "<package/>",
    "src/other/other/__init__.py": "",
}
_NODE = "src/other/other/node.py"


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    for name, text in _FILES.items():
        path = tmp_path / "ws" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return tmp_path / "ws"


def _read(
    workspace: Path, imports: str, name: str, node: str = _NODE, type_: str = "String"
) -> SourceUnit:
    text = "import rclpy\nfrom std_msgs.msg import String\n" + imports + "\n"
    text += f"node = rclpy.create_node('n')\nnode.create_publisher({type_}, {name}, 1)\n"
    source = read_python(workspace / node, one(text.encode())).source
    assert source is not None
    return source


def _topic(workspace: Path, imports: str, name: str, node: str = _NODE) -> str | None:
    return _read(workspace, imports, name, node).nodes[0].endpoints[0].name


@pytest.mark.parametrize(
    ("imports", "name", "topic"),
    [
        ("from demo.names import CHATTER", "CHATTER", "chatter"),
        ("import demo.names as names", "names.CHATTER", "chatter"),
        ("import demo", "demo.SAID", "chatter"),
        ("from demo import *", "SAID", "chatter"),
        ("from arms.names import ARM", "ARM", "chatter/arm"),
        # What is no package, is left out of the build, or is there twice.
        ("from loose import NAME", "NAME", None),
        ("from gone import NAME", "NAME", None),
        ("from twice import NAME", "NAME", None),
        ("from demo.names import NOTHING", "NOTHING", None),
    ],
)
def test_a_name_of_another_package_is_followed(
    workspace: Path, imports: str, name: str, topic: str | None
) -> None:
    assert _topic(workspace, imports, name) == topic


def test_a_type_of_another_package_stays_a_type(workspace: Path) -> None:
    source = _read(workspace, "from demo.msg import Own", "'own'", type_="Own")
    assert str(source.nodes[0].endpoints[0].type) == "demo/Own"


def test_a_base_class_of_another_package_makes_a_node(workspace: Path) -> None:
    text = b"from demo.bases import Base\nimport rclpy\nclass Arm(Base):\n    pass\n"
    source = read_python(workspace / _NODE, one(text)).source
    assert source is not None
    ((endpoint,),) = (node.endpoints for node in source.nodes)
    assert (endpoint.name, endpoint.file) == ("of_base", "../../demo/demo/bases.py")


@pytest.mark.parametrize(
    ("mark", "topic"),
    [
        (".git", "chatter"),
        ("plastron.yaml", "chatter"),
        # Nothing says how far the workspace reaches, or each package is a project of its own.
        ("", None),
        ("other/.git", None),
    ],
)
def test_a_workspace_ends_where_its_folder_says_so(
    workspace: Path, mark: str, topic: str | None
) -> None:
    shutil.move(workspace / "src", workspace / "packages")
    if mark:
        (workspace / "packages" / mark).write_text("")
    node = _NODE.replace("src", "packages")
    assert _topic(workspace, "from demo.names import CHATTER", "CHATTER", node) == topic


def test_the_home_folder_is_no_workspace(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for home in (workspace / "src", workspace / "src" / "group"):
        monkeypatch.setenv("HOME", os.fspath(home))
        assert _topic(workspace, "from demo.names import CHATTER", "CHATTER") is None


def test_what_comes_into_the_workspace_counts(workspace: Path) -> None:
    imports = "from late.names import NAME"
    assert _topic(workspace, imports, "NAME") is None
    late = workspace / "src" / "late"
    (late / "late").mkdir(parents=True)
    (late / "package.xml").write_text("<package/>")
    (late / "late" / "__init__.py").write_text("")
    assert _topic(workspace, imports, "NAME") is None
    (late / "late" / "names.py").write_text("NAME = 'late'\n")
    assert _topic(workspace, imports, "NAME") == "late"


def test_who_reads_a_workspace_says_what_is_in_it(workspace: Path) -> None:
    packages = [os.fspath(workspace / "src" / name) for name in ("demo", "group/arms")]
    inits = [os.fspath(each) for each in workspace.rglob("__init__.py")]
    modules = modules_in(packages, inits)
    assert modules == {
        "arms": os.fspath(workspace / "src/group/arms/src"),
        "demo": os.fspath(workspace / "src/demo"),
    }
    with workspace_of({}):
        assert _topic(workspace, "from demo.names import CHATTER", "CHATTER") is None
    with workspace_of(modules):
        assert _topic(workspace, "from demo.names import CHATTER", "CHATTER") == "chatter"
