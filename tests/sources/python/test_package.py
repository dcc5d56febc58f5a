"""What a node takes from other files of its package: names, types, classes; nothing outside."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from edits import PUB, edit_python
from file_sets import one

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import Remove, Rename
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.python import package, read_python
from plastron_tui.targets.python.porting.port import port_python
from plastron_tui.targets.python.rospy import DIALECT

TOPICS = """\
import os
from enum import Enum
from std_msgs.msg import Int32 as Count
PREFIX = '/robot'
SCAN = PREFIX + '/scan'
NAMES = {'odom': 'odom_raw'}
SEEN = SCAN if os.environ else 'x'
class Topics:
    CMD = 'cmd_vel'
class Config:
    def __init__(self, arm='left'):
        self.joy = 'joy'
        self.arm = arm
config = Config()
Type = Count
"""
FILES = {
    "package.xml": "<package/>",
    "src/demo/__init__.py": "",
    "src/demo/topics.py": TOPICS,
    "src/demo/again.py": "from .topics import *\nfrom . import topics as t\nMINE = t.SCAN + "
    "'/mine'\n",
    "src/demo/types.py": "from std_msgs.msg import *\nfrom geometry_msgs.msg import *\n",
    "src/demo/hands.py": "from .base import Base\n",
    "src/demo/stars.py": "from .base import *\n",
    "src/demo/round_a.py": "from .round_b import NAME\nfrom .round_b import *\n",
    "src/demo/round_b.py": "from .round_a import NAME\nfrom .round_a import *\n",
    "scripts/near.py": "BESIDE = 'beside'\n",
    "scripts/deeper/__init__.py": "from ..far import FAR\n",
}


@pytest.fixture
def demo(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return tmp_path


def read(demo: Path, text: str, name: str = "scripts/node.py"):
    path = demo / name
    path.parent.mkdir(parents=True, exist_ok=True)
    result = read_python(path, one(text.encode()), "rospy" if "rospy" in text else "rclpy")
    assert result.source is not None
    return result


def endpoint(demo: Path, imports: str, name: str, type_: str = "String"):
    text = f"import rospy\n{imports}\nrospy.Publisher({name}, {type_}, queue_size=1)\n"
    (found,) = read(demo, text).source.endpoints
    return found


NAMES = {
    "a constant": ("from demo.topics import SCAN", "SCAN", "/robot/scan"),
    "a constant of another name": ("from demo.topics import SCAN as S", "S", "/robot/scan"),
    "of a module": ("import demo.topics", "demo.topics.SCAN", "/robot/scan"),
    "of a module of another name": ("import demo.topics as t", "t.SCAN", "/robot/scan"),
    "of a module of a package": ("from demo import topics", "topics.PREFIX + '/x'", "/robot/x"),
    "of a module imported whole": ("from demo.topics import *", "SCAN", "/robot/scan"),
    "of a class": ("from demo.topics import Topics", "Topics.CMD", "cmd_vel"),
    "of an object": ("from demo.topics import config", "config.joy", "joy"),
    "of an object made here": ("from demo.topics import Config\nc = Config()", "c.joy", "joy"),
    "in a text": ("from demo.topics import SCAN", "f'{SCAN}/front'", "/robot/scan/front"),
    "beside the file": ("from near import BESIDE", "BESIDE", "beside"),
    "handed on": ("from demo.again import SCAN", "SCAN", "/robot/scan"),
    "made of another file's": ("from demo.again import MINE", "MINE", "/robot/scan/mine"),
    "one of two imports": (
        "try:\n    from demo.topics import SCAN\n"
        "except ImportError:\n    from demo.again import SCAN",
        "SCAN",
        "/robot/scan",
    ),
    "what the environment decides": ("from demo.topics import SEEN", "SEEN", None),
    "what a parameter decides": ("from demo.topics import config", "config.arm", None),
    "what is not there": ("from demo.topics import NOTHING", "NOTHING", None),
    "a module that is not there": ("from demo.nothing import SCAN", "SCAN", None),
    "a circle": ("from demo.round_a import NAME", "NAME", None),
    "a circle of modules imported whole": ("from demo.round_a import *", "X", None),
    "above the package": ("from ...topics import SCAN", "SCAN", None),
    "a number": ("from demo.topics import Topics", "Topics", None),
}  # fmt: skip


@pytest.mark.parametrize(("imports", "name", "expected"), NAMES.values(), ids=NAMES)
def test_a_name_is_what_another_file_of_the_package_says(demo, imports, name, expected):
    assert endpoint(demo, imports, name).name == expected


TYPES = {
    "handed on": ("from demo.topics import Count", "Count", "std_msgs/Int32", False),
    "of another name": ("from demo.topics import Type", "Type", "std_msgs/Int32", False),
    "through modules": ("from demo import topics", "topics.Count", "std_msgs/Int32", False),
    "imported whole twice": ("from demo.types import *", "Twist", "geometry_msgs/Twist", False),
    "imported whole in turn": ("from demo.again import *", "Count", "std_msgs/Int32", False),
    "of no file": ("from demo.types import Nothing", "Nothing", None, False),
}


@pytest.mark.parametrize(("imports", "type_", "expected", "is_guess"), TYPES.values(), ids=TYPES)
def test_a_type_is_what_another_file_of_the_package_imports(
    demo, imports, type_, expected, is_guess
):
    found = endpoint(demo, imports, "'x'", type_)
    assert (found.type and str(found.type), found.is_guess) == (expected, is_guess)


BASE = """\
import rospy
from std_msgs.msg import Bool
from .topics import SCAN
class Root:
    def listen(self):
        rospy.Subscriber('low', Bool, print)
class Base(Root):
    def __init__(self, name='b', extra='x'):
        rospy.init_node(name)
        rospy.Publisher('alive', Bool, queue_size=1)
        rospy.Publisher(extra, Bool, queue_size=1)
    def more(self):
        rospy.Subscriber(SCAN, Bool, self.on)
class Other:
    def __init__(self):
        rospy.Publisher('other', Bool, queue_size=1)
"""
OWN = "import rospy\nfrom demo.base import Base\nclass Node(Base):\n    "
BASES = {
    "nothing of its own": (f"{OWN}pass\n", ["low", "alive", None, "/robot/scan"]),
    "a constructor that calls the other": (
        f"{OWN}def __init__(self):\n        super().__init__('n')\n",
        ["low", "alive", None, "/robot/scan"],
    ),
    "as Python 2 calls it": (
        f"{OWN}def __init__(self):\n        Base.__init__(self, 'n')\n",
        ["low", "alive", None, "/robot/scan"],
    ),
    "a constructor of its own": (
        f"{OWN}def __init__(self):\n        pass\n", ["low", "/robot/scan"]
    ),
    "a method of its own": (f"{OWN}def more(self):\n        pass\n", ["low", "alive", None]),
    "a method of its own that calls the other": (
        f"{OWN}def more(self):\n        super(Node, self).more()\n",
        ["low", "alive", None, "/robot/scan"],
    ),
    "a class between": (
        f"{OWN}pass\nclass Last(Node):\n    def listen(self):\n        pass\n",
        ["alive", None, "/robot/scan"],
    ),
    "of a class that another file hands on": (
        OWN.replace("demo.base", "demo.hands") + "pass\n", ["low", "alive", None, "/robot/scan"]
    ),
    "of a class of a module imported whole": (
        OWN.replace("import Base", "import *") + "pass\n", ["low", "alive", None, "/robot/scan"]
    ),
    "of a class of a module imported whole in turn": (
        OWN.replace("demo.base import Base", "demo.stars import *") + "pass\n",
        ["low", "alive", None, "/robot/scan"],
    ),
    "of no class": (OWN.replace("Base", "SCAN") + "pass\n", []),
    "of a class that is only used": (
        "import rospy\nfrom demo.base import Base\nrospy.init_node('n')\nBase()\n", []
    ),
}  # fmt: skip


@pytest.mark.parametrize(("text", "expected"), BASES.values(), ids=BASES)
def test_a_node_has_what_its_base_class_in_another_file_creates(demo, text, expected):
    (demo / "src/demo/base.py").write_text(BASE)
    found = list(read(demo, text).source.endpoints)
    assert [each.name for each in found] == expected
    assert {each.file for each in found} <= {"../src/demo/base.py"}


def test_a_base_class_may_have_one_in_another_folder(demo):
    (demo / "src/demo/low").mkdir()
    (demo / "src/demo/low/__init__.py").write_text("")
    (demo / "src/demo/low/root.py").write_text(BASE.replace(".topics", "..topics"))
    middle = "from .root import Base as Low\nclass Base(Low):\n    pass\n"
    (demo / "src/demo/low/middle.py").write_text(middle)
    found = read(demo, OWN.replace("demo.base", "demo.low.middle") + "pass\n").source.endpoints
    assert [each.name for each in found] == ["low", "alive", None, "/robot/scan"]


def test_classes_that_all_derive_from_each_other_are_asked_once(demo):
    for number in range(30):
        others = [each for each in range(30) if each != number]
        imports = "".join(f"from m{each} import K as K{each}\n" for each in others)
        bases = ", ".join(f"K{each}" for each in others)
        method = f"    def f{number}(self):\n        rospy.Publisher('p{number}', Bool)\n"
        text = f"import rospy\nfrom std_msgs.msg import Bool\n{imports}class K({bases}):\n{method}"
        (demo / f"scripts/m{number}.py").write_text(text)
    found = read(demo, OWN.replace("demo.base import Base", "m0 import K as Base") + "pass\n")
    assert {each.name for each in found.source.endpoints} == {f"p{each}" for each in range(30)}


def test_a_class_that_another_file_derives_from_a_node_is_a_node(demo):
    base = "from rclpy.node import Node\nclass Base(Node):\n    pass\n"
    (demo / "demo").mkdir()
    (demo / "demo/base.py").write_text(base)
    text = (
        "import rclpy\nfrom demo.base import Base\nclass Talker(Base):\n"
        "    def __init__(self):\n        super().__init__('talker')\n"
    )
    (node,) = read(demo, text, "demo/talker.py").source.nodes
    assert (node.name, node.class_name) == ("talker", "Talker")


def change(demo: Path, text: str, *changes):
    source = read(demo, text).source
    return edit_python(source, changes, Catalog("noetic"), DIALECT)


TALKER = """\
import rospy
from demo.topics import SCAN
from std_msgs.msg import String

rospy.init_node('talker')
pub = rospy.Publisher(SCAN, String, queue_size=1)
rospy.spin()
"""


def test_a_rename_says_the_name_where_another_file_says_it_for_others_too(demo):
    rendered = change(demo, TALKER, Rename(PUB, "/robot/scan", "/front"))
    assert rendered.files is not None
    assert b"rospy.Publisher('/front', String" in rendered.files.main


def test_a_removal_finds_what_another_file_names(demo):
    rendered = change(demo, TALKER, Remove(PUB, "/robot/scan"))
    assert rendered.files is not None
    assert b"Publisher" not in rendered.files.main


@pytest.mark.parametrize(
    "asked", [Remove(PUB, "alive", Span(0, 0)), Rename(PUB, "alive", "living", Span(0, 0))]
)
def test_what_a_base_class_creates_is_changed_in_its_own_file(demo, asked):
    (demo / "src/demo/base.py").write_text(BASE)
    rendered = change(demo, f"{OWN}pass\n", asked)
    assert rendered.files is None
    (told,) = rendered.diagnostics
    assert told.message == (
        "the publisher `alive` is of a base class, in `../src/demo/base.py`, line 10"
    )


def test_no_link_leads_out_of_the_package(demo, tmp_path_factory):
    outside = tmp_path_factory.mktemp("outside") / "secret.py"
    outside.write_text("KEY = 'secret'\n")
    (demo / "scripts/link.py").symlink_to(outside)
    assert endpoint(demo, "from link import KEY", "KEY").name is None


def test_a_folder_without_a_package_is_left_by_no_import(tmp_path):
    (tmp_path / "far.py").write_text("FAR = 'far'\n")
    (tmp_path / "scripts").mkdir()
    assert endpoint(tmp_path, "from ..far import FAR", "FAR").name is None
    assert endpoint(tmp_path, "from far import FAR", "FAR").name is None


@pytest.mark.parametrize(
    "text", [b"KEY = 'k'\n" + b"#" * (300 * 1024), b"KEY = 'k'\x00\n"], ids=["large", "data"]
)
def test_what_is_no_module_is_not_read(demo, text):
    (demo / "scripts/odd.py").write_bytes(text)
    assert endpoint(demo, "from odd import KEY", "KEY").name is None


def test_a_pipe_is_not_waited_for(demo):
    os.mkfifo(demo / "scripts/pipe.py")
    assert endpoint(demo, "from pipe import KEY", "KEY").name is None


def test_only_so_many_modules_are_read(demo):
    count = 3 * package.MOST_MODULES
    for number in range(count):
        (demo / f"scripts/m{number}.py").write_text(f"N = 'n{number}'\n")
    imports = "".join(f"from m{n} import N as N{n}\n" for n in range(count))
    calls = "".join(f"rospy.Publisher(N{n}, String, queue_size=1)\n" for n in range(count))
    result = read(demo, f"import rospy\n{imports}{calls}")
    known = [each.name for each in result.source.endpoints if each.name is not None]
    assert len(known) == package.MOST_MODULES == len(result.beside)


def test_a_chain_of_files_ends(demo):
    for number in range(40):
        text = f"from m{number + 1} import N\nimport rospy\nrospy.Publisher(N, N)\n"
        (demo / f"scripts/m{number}.py").write_text(text)
    (demo / "scripts/m40.py").write_text("N = 'n'\n")
    assert endpoint(demo, "from m0 import N", "N").name is None
    assert endpoint(demo, "from m38 import N", "N").name == "n"


def test_what_was_read_beside_a_file_is_told(demo):
    result = read(demo, TALKER)
    assert result.beside == (demo / "src/demo/topics.py",)


def test_a_port_knows_the_names_that_another_file_says(demo):
    text = TALKER.replace("demo.topics", "demo.names")
    (demo / "src/demo/names.py").write_text("SCAN = 'scan'\n")
    rendered = port_python(read(demo, text).source, Catalog("jazzy"), "rclpy")
    assert rendered.files is not None
    assert b"create_publisher(String, SCAN, 1)" in rendered.files.main
    assert rendered.diagnostics == ()


def test_a_port_marks_a_private_name_that_another_file_says(demo):
    (demo / "src/demo/names.py").write_text("SCAN = '~scan'\n")
    text = TALKER.replace("demo.topics", "demo.names")
    rendered = port_python(read(demo, text).source, Catalog("jazzy"), "rclpy")
    assert any("a private name" in each.message for each in rendered.diagnostics)
