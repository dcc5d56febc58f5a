"""All programs of the tests and the examples as one package of C++ nodes, built once a run.

To configure a package takes longer than to compile a small node: one program is made of all of
them, in which what would have the same name gets that of its file. Each node is there as a
program of its own and as a plugin, where the client library can.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from cpp_builds import FLAGS, WARNINGS, CppLibrary
from processes import PROGRAMS, plastron
from ros_workspaces import SYSTEM, call, complete_ros2, skip_without
from roscpp_builds import locked

from plastron_tui.ros.catalog import Catalog

PACKAGE = "corpus"
JOBS = 2
# Those whose nodes are run keep their names.
_NAMED = {"sentry": ("sentry",), "count": ("counter", "asker")}
_EXAMPLES = PROGRAMS.parents[1] / "examples"
_TABLE = ("actionlib_tutorials", "beginner_tutorials", "mavros_msgs")

# What catkin and what rosconsole exports to it define (catkin/cmake/catkin_package.cmake,
# rosconsole-extras.cmake): a header that is compiled already is so with the same.
_CATKIN = (
    f'-DROS_PACKAGE_NAME="{PACKAGE}"',
    "-DROS_BUILD_SHARED_LIBS=1",
    "-DROSCONSOLE_BACKEND_LOG4CXX",
)

_WORD = re.compile(r"""'([^']*)'|"[^"]*"|(?<![\w.])[a-z]\w*(?![\w(])(?!=)""")
_NAMES = re.compile(r"^create_(?:message|node '\w+' as) (\w+)", re.MULTILINE)
_LOADED = re.compile(r"^load ", re.MULTILINE)
_USING = re.compile(r" using \w+$", re.MULTILINE)
_COMMENT = re.compile(r"^//.*\n", re.MULTILINE)

_CMAKE = """\
cmake_minimum_required(VERSION 3.10)
project({package})
find_package(catkin REQUIRED COMPONENTS actionlib_msgs message_generation std_msgs)
{files}
generate_messages(DEPENDENCIES actionlib_msgs std_msgs)
catkin_package(CATKIN_DEPENDS actionlib_msgs message_runtime std_msgs)
"""
_MANIFEST = """\
<?xml version="1.0"?>
<package format="2">
  <name>{package}</name>
  <version>0.0.0</version>
  <description>Types that the archives have not</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>actionlib_msgs</depend>
  <depend>std_msgs</depend>
  <build_depend>message_generation</build_depend>
  <build_export_depend>message_runtime</build_export_depend>
  <exec_depend>message_runtime</exec_depend>
</package>
"""


@dataclass(frozen=True)
class Built:
    """A package that is built.

    Attributes:
        package: its folder.
        prefix: what holds its programs and libraries, `lib` and `share`.
        library: what it was compiled with, with the packages of its types; none for Debian's.
    """

    package: Path
    prefix: Path
    library: CppLibrary | None = None

    def program(self, node: str) -> Path:
        """Return the program of a node."""
        # A file is called as its node is, and by one word for what the node does.
        own = re.compile(rf"{node}_[a-z0-9]+")
        folder = self.prefix / "lib" / PACKAGE
        [program] = [each for each in folder.iterdir() if own.fullmatch(each.name)]
        return program


def program_with(node: str) -> Path:
    """Return the program that has a node whose name is kept."""
    [stem] = [stem for stem, nodes in _NAMED.items() if node in nodes]
    [file] = [file for file in _files() if file.stem == stem]
    return file


def _files() -> list[Path]:
    return sorted([*PROGRAMS.glob("*.plastron"), *_EXAMPLES.glob("*.plastron")])


def corpus(libraries: Sequence[str], *, managed: bool, actions: bool, in_turn: bool = False) -> str:
    """Return a program with the nodes of all programs.

    Args:
        libraries: what each node is for; for the second one it is called `NODE_plugin`.
        managed: whether nodes that are managed are so; else they are usual ones.
        actions: whether programs that have actions are there.
        in_turn: whether a program is for one of the libraries only, the next for the next, but
            those whose nodes are run.
    """
    parts: list[str] = []
    for number, (stem, text) in enumerate(_programs(managed, actions)):
        kept = stem in _NAMED
        suffixes = ("", "plugin") if kept else (stem, f"{stem}_plugin")
        for place, (library, suffix) in enumerate(zip(libraries, suffixes, strict=False)):
            if kept or not in_turn or number % len(libraries) == place:
                parts.append(_distinct(written(text, library), suffix, are_names_kept=kept))
    return "\n".join(parts)


def _programs(managed: bool, actions: bool) -> Iterator[tuple[str, str]]:
    """Return the names and texts of those that write nodes; a package is written by itself."""
    for file in _files():
        text = _COMMENT.sub("", file.read_text(encoding="utf-8"))
        if _LOADED.search(text) or "create_package" in text:
            continue
        if "action_type" in text and not actions:
            continue
        text = _USING.sub("", text)
        yield file.stem, text if managed else text.replace(" managed", "")


def written(text: str, library: str) -> str:
    """Return a program whose nodes are for a client library."""
    return re.sub(r"^(generate_node \w+)$", rf"\1 using {library}", text, flags=re.MULTILINE)


def _distinct(text: str, suffix: str, *, are_names_kept: bool) -> str:
    """Return a program in which what is named has a suffix.

    Args:
        text: the program.
        suffix: what comes behind the names; nothing, and the program is as it was.
        are_names_kept: whether what is in quotes (topics, services, parameters) stays, but nodes.
    """
    names = set(_NAMES.findall(text))

    def rename(match: re.Match[str]) -> str:
        quoted = match[1]
        before = text[: match.start()]
        if quoted is not None and (not are_names_kept or before.endswith("create_node ")):
            return f"'{quoted}_{suffix}'"
        return f"{match[0]}_{suffix}" if match[0] in names else match[0]

    return _WORD.sub(rename, text) if suffix else text


def generate(program: str, package: Path) -> None:
    """Generate a program into a package's folder."""
    package.parent.mkdir(parents=True, exist_ok=True)
    file = package.with_suffix(".plastron")
    file.write_text(program, encoding="utf-8")
    done = plastron("generate", file, "-o", package)
    assert done.returncode == 0, done.stderr


def build_with_catkin(cache: Path) -> Built:
    """Build the corpus for roscpp and for nodelets, once for all workers."""
    skip_without("catkin_make", "g++", path=SYSTEM)
    folder = cache / "catkin_corpus"
    package = folder / "src" / PACKAGE
    with locked(folder):
        if not (folder / "made").exists():
            for name in _TABLE:
                _write_types(folder / "src" / name, name)
            program = corpus(("roscpp", "nodelet"), managed=False, actions=True, in_turn=True)
            generate(program, package)
            flags = _precompiled(folder, "ros/ros.h", _CATKIN)
            # Only C++ is asked for.
            others = {"ROS_LANG_DISABLE": "geneus:genlisp:gennodejs:genpy"}
            environ = {"PATH": SYSTEM, "CXXFLAGS": flags, **others}
            call(["catkin_make", f"-j{JOBS}"], folder, environ)
            (folder / "made").touch()
    return Built(package, folder / "devel")


def _precompiled(folder: Path, header: str, more: Sequence[str]) -> str:
    """Compile a header, and return the flags by which all nodes begin with it."""
    flags = ["-O0", "-fPIC", *WARNINGS]
    begin = folder / "begin.hpp"
    begin.write_text(f"#include <{header}>\n")
    call(["g++", *flags, *more, "-x", "c++-header", begin], folder, {"PATH": SYSTEM})
    return " ".join([*flags, "-Winvalid-pch", "-include", str(begin)])


def _write_types(folder: Path, package: str) -> None:
    definitions = Catalog("noetic").table_package(package)
    assert definitions is not None
    lines = []
    calls = {"msg": "message", "srv": "service", "action": "action"}
    for kind, texts in definitions.items():
        (folder / kind).mkdir(parents=True)
        for name, text in texts.items():
            (folder / kind / f"{name}.{kind}").write_text(text, encoding="utf-8")
        files = " ".join(f"{name}.{kind}" for name in texts)
        lines += [f"add_{calls[kind]}_files(FILES {files})"] if texts else []
    build = _CMAKE.format(package=package, files="\n".join(lines))
    (folder / "CMakeLists.txt").write_text(build, encoding="utf-8")
    (folder / "package.xml").write_text(_MANIFEST.format(package=package), encoding="utf-8")


def build_with_colcon(cache: Path, rclcpp: CppLibrary, environ: Mapping[str, str]) -> Built:
    """Build the corpus for rclcpp, and for components where they can be, once for all workers.

    Args:
        cache: a folder that the workers share.
        rclcpp: what the nodes are compiled with.
        environ: the variables of a graph, by whose libraries of types the types are found.
    """
    library = rclcpp.with_types(environ, cache)
    folder = cache / "colcon_corpus"
    package = folder / "src" / PACKAGE
    with locked(folder):
        if not (folder / "made").exists():
            libraries = ("rclcpp", "component") if rclcpp.is_real else ("rclcpp",)
            generate(corpus(libraries, managed=rclcpp.is_real, actions=rclcpp.is_real), package)
            tools = complete_ros2(folder, library)
            # What the environment's own rclcpp is built with.
            told = ("CMAKE_TOOLCHAIN_FILE", "LDFLAGS") if rclcpp.is_real else ()
            tools.update({name: os.environ[name] for name in told if name in os.environ})
            flags = " ".join([*FLAGS, *WARNINGS, *rclcpp.beginning])
            build = {**tools, "CXXFLAGS": flags, "MAKEFLAGS": f"-j{JOBS}"}
            call(["colcon", "build"], folder, build)
            (folder / "made").touch()
    return Built(package, folder / "install" / PACKAGE, library)
