"""Files that lint would read, and cannot: what ROS refuses is an error, anything else a warning."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, write_tree

from plastron_tui.lint.rules.package_examples import NODE_PACKAGE

NODE = """\
import rclpy
from rclpy.node import Node
class Eye(Node):
    def __init__(self):
        super().__init__('eye')
        self.word = '{}'
"""
OLD_NODE = "import rospy\nrospy.init_node('{}')\n"
SCRIPT = "#!/usr/bin/env python3\n" + NODE
CPP = "#include <rclcpp/rclcpp.hpp>\nint main() { rclcpp::init(); }  // {}\n"
LAUNCH_PY = """\
def generate_launch_description():
    return LaunchDescription([Node(package='demo', executable='{}')])
"""
LAUNCH_YAML = "launch:\n- arg: {name: 'x'}  # {}\n"
LAUNCH_XML = "<launch>\n  <arg name='x' default='{}'/>\n</launch>\n"
VALUES = "eye:\n  ros__parameters:\n    words: 'x'  # {}\n"
SETUP = NODE_PACKAGE["demo/setup.py"] + "# end\nx = '{}'\n"
_SETUP_LINES = SETUP.count("\n")
LATIN = "# -*- coding: latin-1 -*-\n"

_LATIN_1 = [
    ("eye.py", NODE, "error unreadable-file 6"),
    ("old.py", OLD_NODE, "error unreadable-file 2"),
    ("eye.py", LATIN + NODE, ""),
    # Python imports it, whatever stands in comments.
    ("eye.py", NODE.replace("'{}'", "'' # {}"), ""),
    ("a.launch.py", LAUNCH_PY.replace("{}", "") + "# {}\n", ""),
    ("demo/setup.py", SETUP.replace("'{}'", "'' # {}"), f"warning unreadable-file {_SETUP_LINES}"),
    ("eye.cpp", CPP, ""),
    ("other.py", "x = 1  # {}\n", ""),
    ("a.launch.py", LAUNCH_PY, "error unreadable-file 2"),
    ("a.launch.py", LATIN + LAUNCH_PY, ""),
    ("a.launch.py", f"{LATIN}x{{}} = 1\n{LAUNCH_PY}", "warning unreadable-file 2"),
    ("a.launch.yaml", LAUNCH_YAML, "error unreadable-file 2"),
    ("a.launch.xml", LAUNCH_XML, "error unsupported-xml 0"),
    ("a.launch.xml", f"<?xml version='1.0' encoding='latin-1'?>{LAUNCH_XML}",
     "warning unsupported-xml 1"),
    ("eye.yaml", VALUES, "error unreadable-file 3"),
    ("other.yaml", "words: {}\n", ""),
    ("demo/setup.py", SETUP, f"error unreadable-file {_SETUP_LINES}"),
    ("demo/setup.py", LATIN + SETUP, f"warning unreadable-file {_SETUP_LINES + 1}"),
]  # fmt: skip
_UTF_16 = [
    ("eye.py", NODE, "error unreadable-file 0"),
    ("eye.cpp", CPP, "warning unreadable-file 0"),
    ("other.cpp", "int x;  // {}\n", ""),
    ("a.launch.py", LAUNCH_PY, "error unreadable-file 0"),
    ("a.launch.yaml", LAUNCH_YAML, "warning unreadable-file 0"),
    ("a.launch.xml", LAUNCH_XML, "warning unsupported-xml 0"),
    ("eye.yaml", VALUES, "warning unreadable-file 0"),
    ("demo/setup.py", SETUP, "error unreadable-file 0"),
]
_NUL = [
    ("eye.py", NODE, "error unreadable-file 6"),
    ("eye", SCRIPT, "error unreadable-file 7"),
    ("eye.cpp", CPP, "warning unreadable-file 2"),
    # A program of a machine has such a name by mistake, and no lines.
    ("eye.cpp", "{}\udcff" + CPP, ""),
    ("a.launch.py", LAUNCH_PY, "error unreadable-file 2"),
    ("a.launch.yaml", LAUNCH_YAML, "error unreadable-file 2"),
    ("a.launch.xml", LAUNCH_XML, "error broken-xml 2"),
    ("eye.yaml", VALUES, "error unreadable-file 3"),
    ("demo/setup.py", SETUP, f"error unreadable-file {_SETUP_LINES}"),
]
_BROKEN = [
    ("eye.py", NODE + "x = (1\ny = 2\n", "error broken-python 7"),
    ("eye.py", NODE.replace("Eye(Node):", "Eye(Node)"), "error broken-python 3"),
    ("eye.py", NODE + "<<<<<<< HEAD\n", "error broken-python 7"),
    ("eye", SCRIPT + "x = (1\ny = 2\n", "error broken-python 8"),
    # It may be for Python 2, whatever is wrong with it.
    ("old.py", OLD_NODE + "print 'x'\nx = (1\n", ""),
    # The Python that runs this may be too old for it.
    ("eye.py", NODE + "x = f'{f'{1}'}'\n", ""),
    ("eye.py", NODE + "type X = int\n", ""),
    ("eye.py", NODE + "x = 1\fy = 2\n", "error broken-python 7"),
    ("other.py", "x = (1\n", ""),
    ("eye.cpp", CPP + "int x = (;\n", ""),
    ("a.launch.py", LAUNCH_PY + "x = (1\n", "error broken-python 3"),
    ("a.launch.py", "x = 1\n", ""),
    ("templates/a.launch.py", LAUNCH_PY + "{{ more }} {{ x }}\n", ""),
    ("a.launch.yaml", LAUNCH_YAML + "}\n", "error broken-launch 3"),
    ("a.launch.yaml", "launch: nothing\n", ""),
    ("eye.yaml", VALUES + "  - x\n", "error bad-parameters 4"),
    ("eye.yaml", VALUES + "  {% if x %}: x\n", ""),
    ("eye.yaml", "eye:\n  ros__parameters: &a {x: 1}\nother: *a\n", ""),
    ("other.yaml", "a:\n  - x\n b\n", ""),
    ("demo/setup.py", SETUP + "x = (1\n", f"error broken-python {_SETUP_LINES + 1}"),
    ("demo/setup.py", SETUP.replace("setup(", "other("), ""),
    ("demo/setup.py", SETUP + "x = f'{f'{1}'}'\n", ""),
]
_CASES = [
    *((name, text.replace("{}", "\xe9").encode("latin-1"), told) for name, text, told in _LATIN_1),
    *((name, text.encode("utf-16"), told) for name, text, told in _UTF_16),
    *((name, text.replace("{}", "\0").encode("utf-8", "surrogateescape"), told)
      for name, text, told in _NUL),
    *((name, text.encode(), told) for name, text, told in _BROKEN),
]  # fmt: skip


def _told(root: Path, select: str = "") -> list[str]:
    run = run_over(root, *([select] if select else []))
    found = []
    for each in run.told:
        lines, span = run.lines(each.diagnostic.file), each.diagnostic.span
        line = 0 if lines is None or span is None else lines.line_at(span.start)
        found.append(f"{each.diagnostic.severity.value} {each.diagnostic.code} {line}")
    assert run.diagnostics == []
    return found


@pytest.mark.parametrize(("name", "text", "told"), _CASES)
def test_file_that_is_not_read_is_told_once(
    tmp_path: Path, name: str, text: bytes, told: str
) -> None:
    root = write_tree(tmp_path, {**NODE_PACKAGE, name: text})
    if "." not in name:
        # Only a script of a package that may be run is one.
        (root / name).rename(root / "demo" / name)
        (root / "demo" / name).chmod(0o755)
    for _ in ("read", "as it was read before"):
        assert [each for each in _told(root) if " R" not in each] == ([told] if told else [])
    assert [each for each in _told(root, "RK") if " R" not in each] == []


@pytest.mark.parametrize(
    ("name", "text", "more"),
    [
        ("eye.py", NODE, "# more\n" * 30_000),
        ("eye.cpp", CPP, "std::vector<" * 10_000),
    ],
)
def test_what_is_too_large_is_told(tmp_path: Path, name: str, text: str, more: str) -> None:
    root = write_tree(tmp_path, {name: text + more, f"other{Path(name).suffix}": more})
    assert _told(root) == ["warning file-too-large 0"]


def test_cmake_lists_that_cmake_refuses_are_told(tmp_path: Path) -> None:
    package = NODE_PACKAGE["demo/package.xml"].replace("ament_python", "ament_cmake")
    lists = "find_package(ament_cmake)\nproject(demo)\nif(x\n"
    files = {"demo/package.xml": package, "demo/CMakeLists.txt": lists}
    root = write_tree(tmp_path, files)
    assert _told(root) == ["warning broken-build-file 3"]
    (root / "demo/CMakeLists.txt").write_text("project(demo)\n")
    assert _told(root) == []
