"""Trees that nobody should have: lint comes to an end with each, and says what it did not read."""

from __future__ import annotations

import os
import random
import socket
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from machine import mostly_long

from plastron_tui.lint import Found
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.project.linting.listing import list_files
from plastron_tui.project.linting.run import LintOptions, LintRun

_DEEP = 3_000
_PACKAGE = """\
<package format="3"><name>a</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>MIT</license>{}
<export><build_type>{}</build_type></export></package>
"""
_IMPORT = "import rclpy\nfrom rclpy.node import Node\n"
_INCLUDE = "#include <rclcpp/rclcpp.hpp>\n#include <std_msgs/msg/string.hpp>\n"
_LAUGHS = "a0: &a0 [x]\n" + "".join(
    f"a{at}: &a{at} [{', '.join([f'*a{at - 1}'] * 9)}]\n" for at in range(1, 30)
)
_ENTITIES = (
    '<!DOCTYPE launch [<!ENTITY a0 "x">'
    + "".join(f'<!ENTITY a{at} "{f"&a{at - 1};" * 9}">' for at in range(1, 30))
    + "]>"
)
_TEXTS = {
    "deep.py": _IMPORT + "x = " + "(" * _DEEP + ")" * _DEEP,
    "calls.py": _IMPORT + "n = rclpy.create_node" + "(f" * _DEEP + ")" * _DEEP,
    "blocks.py": _IMPORT + "".join(" " * at + "if x:\n" for at in range(900)) + " " * 900 + "pass",
    "sum.py": _IMPORT + "TOPIC = " + " + ".join(["'a'"] * _DEEP) + "\nn.create_publisher(S, TOPIC)",
    "lines.py": _IMPORT + "x = 1\n" * 50_000,
    "bases.py": _IMPORT + "".join(f"class C{at}(C{at - 1}): pass\n" for at in range(2_000)),
    "loop.py": _IMPORT + "from loop import *\nfrom .loop import TOPIC\nn.create_client(T, TOPIC)",
    "tabs.py": _IMPORT + "\t \tif x:\n\t\0y\n",
    "deep.cpp": _INCLUDE + "int x = " + "(" * _DEEP + ")" * _DEEP + ";",
    "braces.cpp": _INCLUDE + "void f() " + "{" * _DEEP + "}" * _DEEP,
    "types.cpp": _INCLUDE + "A" + "<A" * _DEEP + ">" * _DEEP + " a;",
    "ifs.cpp": _INCLUDE + "#if A\n" * _DEEP + "int x;\n" + "#endif\n" * _DEEP,
    "self.cpp": _INCLUDE + '#include "self.cpp"\n#include "self.hpp"\n',
    "self.hpp": _INCLUDE + '#include "self.hpp"\n#include "../inner/self.hpp"\nclass A : A {};',
    "inner/self.hpp": _INCLUDE + '#include "../self.hpp"',
    "fields.cpp": _INCLUDE + "void f(std_msgs::msg::String m) { m" + ".data" * _DEEP + " = 1; }",
    "deep.launch": "<launch>" + "<group>" * _DEEP + "</group>" * _DEEP + "</launch>",
    "laughs.launch": _ENTITIES + "<launch><node name='&a29;' pkg='a' type='b'/></launch>",
    "self.launch.xml": '<launch><include file="$(dirname)/self.launch.xml"/>' * 2 + "</launch>",
    "args.launch.xml": '<launch><arg name="a" default="'
    + "$(var " * _DEEP + ")" * _DEEP + '"/></launch>',
    "laughs.launch.yaml": "launch:\n- node: {pkg: a}\n" + _LAUGHS,
    "deep.launch.yaml": "launch: " + "[" * _DEEP + "]" * _DEEP,
    "deep.launch.py": "def generate_launch_description():\n    return L("
    + "[" * _DEEP + "]" * _DEEP + ")",
    "laughs.yaml": "/**:\n  ros__parameters:\n    x: 1\n" + _LAUGHS,
    "deep.yaml": "ros__parameters: " + "{a: " * _DEEP + "}" * _DEEP,
    "merge.yaml": "a: &a\n  <<: *a\n  ros__parameters: {<<: *a}\n",
    "package.xml": _PACKAGE.format("<a>" * _DEEP + "</a>" * _DEEP, "ament_cmake"),
    "cmake/package.xml": _PACKAGE.format("", "ament_cmake"),
    "cmake/CMakeLists.txt": "foo(" * _DEEP + ")" * _DEEP + "if(A)\n" * _DEEP + "${" * _DEEP,
    "python/package.xml": _PACKAGE.format(_ENTITIES, "ament_python"),
    "python/setup.py": "setup(name=" + "[" * _DEEP + "]" * _DEEP + ")",
    "python/setup.cfg": "[" * _DEEP,
    "msg/Self.msg": "Self self\nSelf[] others\n" + "int32 a\n" * _DEEP,
    "msg/Deep.msg": "int32[" + "<=" * _DEEP + "3] a\nstring A='" + "\\'" * _DEEP,
    "a.plastron": "create_node 'a' as a\n" + "(" * _DEEP,
}  # fmt: skip
_SUFFIXES = sorted({Path(name).suffix for name in _TEXTS} | {".srv", ".action", ".h", ""})
_NAMES = ["package.xml", "CMakeLists.txt", "setup.py", "a.launch.py", "plastron.yaml"]


@pytest.fixture
def root(tmp_path: Path) -> Iterator[Path]:
    folder = tmp_path / "src"
    folder.mkdir()
    yield folder
    # What cannot be entered could not be removed.
    for place, folders, _ in os.walk(folder):
        for name in folders:
            with suppress(OSError):
                Path(place, name).chmod(0o700)


def _lint(root: Path) -> tuple[Found, ...]:
    options = LintOptions((root,), cache=FactCache(root, root.parent / "cache"), workers=1)
    run = LintRun(options)
    found = run.told
    # Something that nobody has thought of would end a whole run where it is not caught.
    assert not [each.message for each in run.diagnostics if "plastron fails" in each.message]
    return found


@pytest.mark.parametrize("name", _TEXTS)
def test_text_that_breaks_readers_is_read_or_left(name: str, root: Path) -> None:
    (root / name).parent.mkdir(parents=True, exist_ok=True)
    (root / name).write_text(_TEXTS[name])
    (root / "node.py").write_text(f"{_IMPORT}rclpy.create_node('a').create_client(B, 'c')\n")
    first = _lint(root)
    assert _lint(root) == first


def _write_bytes(path: Path, rng: random.Random) -> None:
    text = rng.choice(list(_TEXTS.values())).encode()
    start = rng.randrange(len(text))
    data = text[start : start + rng.randrange(2_000)] + rng.randbytes(rng.randrange(200))
    path.write_bytes(data)


def _write_huge(path: Path, rng: random.Random) -> None:
    with path.open("wb") as file:
        file.write(b"import rclpy\n#include <rclcpp/rclcpp.hpp>\nros__parameters:\n")
        file.truncate(rng.choice([5, 500]) * 1024**2)


def _listen(path: Path, rng: random.Random) -> None:
    del rng
    with socket.socket(socket.AF_UNIX) as made, suppress(OSError):
        made.bind(os.fsencode(path))


def _link(path: Path, rng: random.Random) -> None:
    away = [".", "..", "../..", "/", "/dev/zero", "/dev/tty", "/proc/self/mem", "\udcff"]
    path.symlink_to(rng.choice([*away, path.name, path]))


def _lock(path: Path, rng: random.Random) -> None:
    _write_bytes(path, rng)
    path.chmod(0o000)


_MAKERS: list[Callable[[Path, random.Random], object]] = [
    *[_write_bytes] * 6,
    *(_write_huge, _listen, _link, _lock),
    lambda path, rng: os.mkfifo(path),
    lambda path, rng: path.mkdir(),
]


def _make_tree(folder: Path, rng: random.Random, left: int) -> None:
    for _ in range(rng.randrange(1, 12)):
        letters = b"ab\xff\x1b\n\t '\"%\\;[]*\x7f"
        stem = os.fsdecode(bytes(rng.choices(letters, k=rng.randrange(1, 5))))
        path = folder / rng.choice([rng.choice(_NAMES), stem + rng.choice(_SUFFIXES)])
        if os.path.lexists(path):
            continue
        if left and rng.random() < 0.3:
            path.mkdir()
            _make_tree(path, rng, left - 1)
            path.chmod(rng.choice([0o700, 0o700, 0o000, 0o400]))
        else:
            rng.choice(_MAKERS)(path, rng)


@pytest.mark.parametrize("seed", mostly_long(range(60), range(8)))
def test_random_tree_is_read_as_far_as_it_can_be(seed: int, root: Path) -> None:
    rng = random.Random(seed)
    _make_tree(root, rng, 4)
    assert _lint(root) == _lint(root)


def test_deep_folders_and_loops_of_links_come_to_an_end(root: Path) -> None:
    place = root
    for _ in range(100):
        place = place / "a"
        place.mkdir()
        (place / "back").symlink_to(root)
        (place / "node.py").write_text(_IMPORT)
    listing = list_files([root])
    assert 30 < len(listing.files) < 100
    assert _lint(root) == ()


@pytest.mark.long
def test_ten_thousand_folders_are_read(root: Path) -> None:
    for at in range(10_000):
        folder = root / f"{at % 100}" / f"p{at}"
        folder.mkdir(parents=True)
        (folder / "node.py").write_text(f"{_IMPORT}node = rclpy.create_node('n{at}')\n")
        if at % 10 == 0:
            (folder / "package.xml").write_text(_PACKAGE.format("", "ament_python"))
    assert list_files([root]).is_whole
    first = _lint(root)
    assert _lint(root) == first
