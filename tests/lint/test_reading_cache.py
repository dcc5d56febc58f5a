"""What is taken from the cache is what would be read."""

from __future__ import annotations

import os
import random
import shutil
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from machine import mostly_long

from plastron_tui.lint.selection import Selection
from plastron_tui.lint.tree import SourceTree
from plastron_tui.project.linting import cache, read_tree, reading, run
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.project.linting.run import LintOptions, LintRun

_PYTHON = """\
<package format="3"><name>eye</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>MIT</license>
<export><build_type>ament_python</build_type></export></package>
"""
_CMAKE = _PYTHON.replace("ament_python", "ament_cmake").replace("eye", "arm")
_NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from {module} import TOPIC, Base


class Eye(Base):
    def __init__(self):
        super().__init__('{name}')
        self.pub = self.create_publisher(String, TOPIC, 1)
"""
_BASE = """\
from rclpy.node import Node
from std_msgs.msg import String
TOPIC = '{name}'


class Base(Node):
    def __init__(self, name):
        super().__init__(name)
        self.sub = self.create_subscription(String, '{name}_in', self.on, 1)
"""
_HEADER = """\
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
{include}
constexpr char TOPIC[] = "{name}";
class Arm : public rclcpp::Node {{
 public:
  Arm();
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
}};
"""
_SOURCE = """\
#include "arm.hpp"
Arm::Arm() : rclcpp::Node("{name}") {{
  pub_ = create_publisher<std_msgs::msg::String>(TOPIC, 1);
}}
"""
_LAUNCH = """\
<launch><arg name="name" default="{name}"/>
<node pkg="eye" exec="eye" name="$(var name)"><remap from="{name}" to="other"/></node>
<include file="$(dirname)/inner.launch.xml"/></launch>
"""
_SETUP = """\
from setuptools import setup
setup(name='eye', packages=['eye'], entry_points={{'console_scripts': ['{name} = eye.eye:main']}})
"""
_CMAKE_LISTS = """\
project(arm)
include_directories({folder})
add_executable({name} src/arm.cpp)
add_library(rest src/made.cpp src/a.cpp src/b.cpp)
install(TARGETS {name} DESTINATION lib/${{PROJECT_NAME}})
"""
_OWN = """\
import rclpy
from arm.msg import Own
from std_msgs.msg import Bool


def main():
    node = rclpy.create_node('own')
    pub = node.create_publisher(Bool, 'front', 1)  # noqa: RG101
    other = node.create_publisher(Own, 'own', 1)
    msg = Own()
    msg.b.a = 1
    msg.rear = 2
    other.publish(msg)
    rclpy.spin(node)
"""
_MAIN = """\
#include <rclcpp/rclcpp.hpp>
#include "arm.hpp"
int main() {{ rclcpp::spin(std::make_shared<Arm>()); }}
"""
_TEXTS = {
    "eye/package.xml": (_PYTHON, _PYTHON.replace("eye", "eyes"), "<package"),
    "eye/setup.py": (_SETUP, "import os"),
    "eye/eye/__init__.py": ("", "from .base import *"),
    "eye/eye/eye.py": (_NODE, "import rospy\npub = rospy.Publisher('{name}', String)\n", "x = 1"),
    "eye/eye/base.py": (_BASE, "TOPIC = '{name}'"),
    "eye/base.py": (_BASE,),
    "eye/launch/a.launch.xml": (_LAUNCH, "<launch/>"),
    "eye/launch/inner.launch.xml": (_LAUNCH.replace("<include", "<!--").replace("xml", "x"),),
    "arm/package.xml": (_CMAKE, ""),
    "arm/CMakeLists.txt": (_CMAKE_LISTS, "project(arm)"),
    "arm/src/arm.cpp": (_SOURCE, "int main() {{}}"),
    "arm/src/arm.hpp": (_HEADER,),
    "arm/inner/arm.hpp": (_HEADER,),
    "arm/arm/__init__.py": ("", "TOPIC = '{name}'"),
    "arm/arm/base.py": (_BASE, "from eye.base import *"),
    "arm/include/arm.hpp": (_HEADER, "#include <rclcpp/rclcpp.hpp>"),
    "arm/src/made.cpp": (_MAIN,),
    "loose/node.py": (_NODE,),
    "loose/base.py": (_BASE,),
    "base.py": (_BASE,),
    "arm/msg/Own.msg": ("int32 a\nOwn2 b", "int32 {name}"),
    "arm/msg/Own2.msg": ("int32 a",),
    "eye/eye/own.py": (_OWN, _OWN.replace("front", "rear"), _OWN.replace("b.a", "b.c")),
}  # fmt: skip


@pytest.fixture
def root(tmp_path: Path) -> Path:
    folder = tmp_path / "src"
    folder.mkdir()
    return folder


def _shown(tree: SourceTree) -> tuple[object, ...]:
    return tree.units, tree.launches, dict(tree.packages), dict(tree.parameter_files)


def _found(root: Path, kept: Path) -> list[tuple[str, object]]:
    linted = LintRun(LintOptions((root,), cache=FactCache(root, kept), workers=1))
    return [(each.rule.code, tuple(each.diagnostic)) for each in linted.found]


def _edit(root: Path, rng: random.Random) -> None:
    file = root / rng.choice(list(_TEXTS))
    match rng.randrange(10):
        case 0:
            file.unlink(missing_ok=True)
        case 1 if file.exists():
            other = root / rng.choice(list(_TEXTS))
            other.parent.mkdir(parents=True, exist_ok=True)
            file.rename(other)
        case 2 if file.exists():
            inner = file.parent / "COLCON_IGNORE"
            inner.unlink() if inner.exists() else inner.touch()
        case 3:
            file.unlink(missing_ok=True)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.symlink_to(root / rng.choice(list(_TEXTS)))
        case 4 if file.exists():
            file.chmod(rng.choice([0o644, 0o755]))
        case _:
            text = rng.choice(_TEXTS[file.relative_to(root).as_posix()])
            words = {
                "name": rng.choice(["front", "rear"]),
                "module": rng.choice(["eye.base", ".base", "base", "arm", "arm.base"]),
                "include": rng.choice(["", '#include "../inner/arm.hpp"']),
                "folder": rng.choice(["inner", "include"]),
            }
            file.parent.mkdir(parents=True, exist_ok=True)
            with suppress(OSError):  # a link that leads to nothing, or to itself
                file.write_text(text.format(**words))


@pytest.mark.parametrize("seed", mostly_long(range(24), range(4)))
def test_warm_result_is_the_cold_one_whatever_was_edited(seed: int, root: Path) -> None:
    rng = random.Random(seed)
    kept = root.parent / "cache"
    for _ in range(12):
        _edit(root, rng)
    for step in range(6):
        for _ in range(rng.randint(0, 2)):
            _edit(root, rng)
        none = root.parent / f"none{step}"
        assert _found(root, kept) == _found(root, none)
        warm = read_tree([root], FactCache(root, kept), workers=1)
        shutil.rmtree(none)
        assert _shown(warm) == _shown(read_tree([root], FactCache(root, none), workers=1))


def _write_all(root: Path) -> None:
    words = {"name": "front", "module": "eye.base", "include": "", "folder": "inner"}
    for name, texts in _TEXTS.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(texts[0].format(**words))


def _fail(path: str) -> Any:
    raise AssertionError(f"{path} is read")


def _left(kept: Path) -> Path:
    (file,) = (kept / "lint").iterdir()
    return file


def test_nothing_is_read_twice(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    _write_all(root)
    kept = root.parent / "cache"
    cold = read_tree([root], FactCache(root, kept), workers=1)
    assert {each.path.name for each in cold.units} >= {"eye.py", "arm.cpp", "made.cpp", "node.py"}
    before = _left(kept).stat()
    for name in ("read_unit", "read_package", "read_launch_file"):
        monkeypatch.setattr(reading, name, lambda *given: _fail(str(given[0])))
    assert _shown(read_tree([root], FactCache(root, kept), workers=1)) == _shown(cold)
    # Nor is anything written: another run may be reading it.
    assert _left(kept).stat().st_ino == before.st_ino


def test_what_one_file_asks_of_the_disk_counts_for_all_that_ask_it(root: Path) -> None:
    words = {"name": "front", "include": "", "folder": "inner"}
    for name, text in {
        "arm/package.xml": _CMAKE,
        "arm/CMakeLists.txt": _CMAKE_LISTS,
        "arm/inner/arm.hpp": _HEADER,
        "arm/other/arm.hpp": _HEADER.replace('"{name}"', '"other"'),
        "arm/src/a.cpp": _SOURCE,
        "arm/src/b.cpp": _SOURCE,
    }.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text.format(**words))
    kept = root.parent / "cache"

    def topics() -> list[str | None]:
        tree = read_tree([root], FactCache(root, kept), workers=1)
        return [each.name for unit in tree.units for node in unit.nodes for each in node.endpoints]

    assert topics() == ["front", "front"]
    lists = root / "arm/CMakeLists.txt"
    lists.write_text(lists.read_text().replace("inner", "other"))
    assert topics() == ["other", "other"]


def test_text_that_is_remembered_hangs_on_the_modules_that_it_asked_for(root: Path) -> None:
    words = {"name": "front", "module": "base"}
    for name, text in {"a.py": _NODE, "base.py": _BASE}.items():
        (root / name).write_text(text.format(**words))
    kept = root.parent / "cache"

    def topics() -> set[str | None]:
        tree = read_tree([root], FactCache(root, kept), workers=1)
        nodes = [node for unit in tree.units for node in unit.nodes if unit.path.name == "a.py"]
        return {each.name for node in nodes for each in node.endpoints}

    assert "front" in topics()
    # One more file: it is read again, in the process that remembers it.
    (root / "other.py").touch()
    assert "front" in topics()
    (root / "base.py").write_text(_BASE.format(name="rear"))
    assert "front" not in topics()
    assert "rear" in topics()


def test_what_was_found_is_told_again_without_a_look(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _write_all(root)
    kept = root.parent / "cache"
    cold = _found(root, kept)
    assert cold
    before = {each.name: each.stat().st_ino for each in (kept / "lint").iterdir()}
    monkeypatch.setattr(run, "read_tree", lambda *given: _fail(str(given[0])))
    assert _found(root, kept) == cold
    assert {each.name: each.stat().st_ino for each in (kept / "lint").iterdir()} == before
    # Yet it is used: others are forgotten first.
    for each in (kept / "lint").iterdir():
        os.utime(each, (0, 0))
    assert _found(root, kept) == cold
    assert all(each.stat().st_mtime > 0 for each in (kept / "lint").iterdir())
    monkeypatch.undo()
    # Other rules are looked for anew.
    options = LintOptions((root,), Selection(("RM201",)), cache=FactCache(root, kept), workers=1)
    assert {each.rule.code for each in LintRun(options).found} <= {"RM201"}


def _cut(file: Path) -> None:
    file.write_bytes(file.read_bytes()[:-9])


def _change_a_byte(file: Path) -> None:
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 1
    file.write_bytes(data)


def _lead_away(file: Path) -> None:
    file.rename(file.with_name("other"))
    file.symlink_to(file.with_name("other"))


@pytest.mark.parametrize(
    "harm",
    [
        _cut,
        _change_a_byte,
        _lead_away,
        lambda file: file.write_bytes(b""),
        lambda file: file.write_bytes(cache.packed(_TEXTS)),
        lambda file: (file.unlink(), os.mkfifo(file)),
        lambda file: (file.unlink(), file.mkdir()),
        lambda file: file.chmod(0o000),
        lambda file: (file.unlink(), file.parent.rmdir(), file.parent.write_text("")),
    ],
)
def test_cache_that_is_damaged_or_cannot_be_written_is_none(
    harm: Callable[[Path], object], root: Path
) -> None:
    _write_all(root)
    kept = root.parent / "cache"
    cold = read_tree([root], FactCache(root, kept), workers=1)
    harm(_left(kept))
    assert _shown(read_tree([root], FactCache(root, kept), workers=1)) == _shown(cold)


def _known(root: Path, kept: Path) -> Mapping[str, cache.Entry]:
    opened = FactCache(root, kept)
    opened.begin()
    return opened._old


def test_another_plastron_reads_all_again(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    _write_all(root)
    kept = root.parent / "cache"
    read_tree([root], FactCache(root, kept), workers=1)
    assert _known(root, kept)
    monkeypatch.setattr(cache, "_program_stamp", lambda: b"another")
    assert not _known(root, kept)


def test_old_workspaces_are_forgotten(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    _write_all(root)
    monkeypatch.setattr(cache, "_MOST_FILES", 3)
    kept = root.parent / "cache"
    (kept / "lint").mkdir(parents=True)
    for at in range(5):
        old = kept / "lint" / f"{at:032x}"
        old.write_bytes(b"old")
        os.utime(old, (at, at))
    abandoned = kept / "lint" / ".00.999999999-0123abcd.tmp"
    abandoned.touch()
    read_tree([root], FactCache(root, kept), workers=1)
    names = sorted(each.name for each in (kept / "lint").iterdir())
    assert len(names) == 3
    assert names[:1] != [abandoned.name]
    assert {f"{at:032x}" for at in (3, 4)} < set(names)


# What tells a file from what it was.
