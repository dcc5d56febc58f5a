"""Packages that exist: what programs put into them, and take out again."""

from __future__ import annotations

import difflib
import os
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some
from loaded_packages import (
    AMENT_CMAKE,
    AMENT_PYTHON,
    CATKIN,
    IN,
    KINDS,
    OUT,
    TALKER,
    lay,
    run,
    texts,
)
from machine import examples

ADDED = {
    "ament_python": {
        "package.xml": ["  <exec_depend>std_msgs</exec_depend>"],
        "setup.py": ["            'talker = demo.talker:main',"],
    },
    "ament_cmake": {
        "package.xml": ["  <exec_depend>std_msgs</exec_depend>"],
        "CMakeLists.txt": ["  nodes/talker.py"],
    },
    "catkin": {
        "package.xml": ["  <exec_depend>std_msgs</exec_depend>"],
        "CMakeLists.txt": ["catkin_install_python(PROGRAMS scripts/listener.py scripts/talker.py"],
    },
}
NODE_FILE = {
    "ament_python": "demo/talker.py",
    "ament_cmake": "nodes/talker.py",
    "catkin": "scripts/talker.py",
}


def added(before: bytes, after: bytes) -> list[str]:
    lines = difflib.ndiff(before.decode().splitlines(), after.decode().splitlines())
    return [line[2:] for line in lines if line.startswith("+ ")]


@pytest.mark.parametrize("kind", KINDS)
def test_output_gets_the_package_with_what_is_new(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, files)
    before = texts(package)
    assert run(IN, tmp_path, library) == ()
    assert texts(package) == before
    made = texts(tmp_path / "output" / "demo")
    assert set(made) == {NODE_FILE[kind], *before}
    changed = {name for name in before if made[name] != before[name]}
    assert {name: added(before[name], made[name]) for name in changed} == ADDED[kind]


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_put_in_place_is_taken_out_to_the_byte(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, files)
    before = texts(package)
    assert run(IN, tmp_path, library, in_place=True) == ()
    after = texts(package)
    assert set(after) == {*before, NODE_FILE[kind]}
    assert os.access(package / NODE_FILE[kind], os.X_OK)
    assert run(IN, tmp_path, library, in_place=True) == ()
    assert texts(package) == after
    told = run(OUT, tmp_path, library, in_place=True)
    assert [each.code for each in told] == ["file-stays"]
    assert texts(package) == {**before, NODE_FILE[kind]: after[NODE_FILE[kind]]}


def test_a_dependency_that_was_there_before_stays(tmp_path: Path) -> None:
    manifest = AMENT_PYTHON["package.xml"].replace(
        "  <export>", "  <exec_depend>std_msgs</exec_depend>\n  <export>"
    )
    package = lay(tmp_path, {**AMENT_PYTHON, "package.xml": manifest})
    before = texts(package)
    assert run(IN, tmp_path, "rclpy", in_place=True) == ()
    assert texts(package)["package.xml"] == before["package.xml"]
    run(OUT, tmp_path, "rclpy", in_place=True)
    assert texts(package)["package.xml"] == before["package.xml"]


@pytest.mark.parametrize(
    ("path", "text", "stays"),
    [
        ("demo/other.py", "import std_msgs.msg\n", True),
        ("launch/a.launch.xml", '<launch><node pkg="std_msgs"/></launch>', True),
        ("src/a.cpp", "#include <std_msgs/msg/string.hpp>\n", True),
        ("demo/other.py", "import os\n", False),
    ],
)
def test_a_dependency_stays_that_something_else_names_by_now(
    path: str, text: str, stays: bool, tmp_path: Path
) -> None:
    package = lay(tmp_path, AMENT_PYTHON)
    run(IN, tmp_path, "rclpy", in_place=True)
    lay(tmp_path, {path: text})
    run(OUT, tmp_path, "rclpy", in_place=True)
    assert (b"std_msgs" in texts(package)["package.xml"]) is stays


def test_a_dependency_goes_that_the_package_named_and_did_not_declare(tmp_path: Path) -> None:
    package = lay(tmp_path, {**AMENT_PYTHON, "demo/other.py": "import std_msgs.msg\n"})
    before = texts(package)
    run(IN, tmp_path, "rclpy", in_place=True)
    run(OUT, tmp_path, "rclpy", in_place=True)
    assert texts(package)["package.xml"] == before["package.xml"]


def test_output_is_as_the_package_is_once_nothing_is_contained(tmp_path: Path) -> None:
    package = lay(tmp_path, AMENT_PYTHON)
    run(IN, tmp_path, "rclpy")
    run(f"{TALKER}generate_package demo\n", tmp_path, "rclpy")
    made = texts(tmp_path / "output" / "demo")
    assert made["setup.py"] == texts(package)["setup.py"]
    assert made["package.xml"] == texts(package)["package.xml"]


def test_handwork_in_a_build_file_is_kept_between_runs(tmp_path: Path) -> None:
    package = lay(tmp_path, AMENT_PYTHON)
    run(IN, tmp_path, "rclpy", in_place=True)
    setup = package / "setup.py"
    setup.write_text(setup.read_text() + "# by hand\n")
    by_hand = texts(package)
    assert run(IN, tmp_path, "rclpy", in_place=True) == ()
    assert texts(package) == by_hand
    run(OUT, tmp_path, "rclpy", in_place=True)
    assert setup.read_text() == AMENT_PYTHON["setup.py"] + "# by hand\n"


def test_a_node_that_was_changed_by_hand_is_not_written_over(tmp_path: Path) -> None:
    package = lay(tmp_path, AMENT_PYTHON)
    run(IN, tmp_path, "rclpy", in_place=True)
    node = package / "demo/talker.py"
    node.write_text(node.read_text() + "# by hand\n")
    there = texts(package)
    [told] = run(IN.replace("2 hz", "3 hz"), tmp_path, "rclpy", in_place=True)
    assert told.code == "file-conflict"
    assert texts(package) == there


_COMPUTED = AMENT_PYTHON["setup.py"].replace(
    "            'listener = demo.listener:main',  # hears it\n", "            *found(),\n"
)
_BROKEN_CMAKE = AMENT_CMAKE["CMakeLists.txt"].replace("project(demo)", "project(demo")
_LOOP = CATKIN["CMakeLists.txt"].replace("scripts/listener.py", "${SCRIPTS}")

_BARE_SETUP = AMENT_PYTHON["setup.py"].partition("    entry_points")[0] + ")\n"
BARE = {**AMENT_PYTHON, "setup.py": _BARE_SETUP}

REFUSED = [
    ({"a.txt": ""}, IN, "file-not-found", "no `package.xml`"),
    ({**AMENT_PYTHON, "package.xml": "<package><name>demo</package>"}, IN, "broken-xml", ""),
    ({**AMENT_PYTHON, "package.xml": "<robot/>"}, IN, "broken-package", "not `<package>`"),
    ({**AMENT_PYTHON, "package.xml": "\0"}, IN, None, ""),
    ({**AMENT_CMAKE, "CMakeLists.txt": _BROKEN_CMAKE}, IN, "broken-build-file", "syntax error"),
    ({**AMENT_PYTHON, "setup.py": "setup(\n"}, IN, "broken-build-file", ""),
    ({**AMENT_PYTHON, "setup.py": "print(1)\n"}, IN, "broken-build-file", ""),
    (
        {"package.xml": AMENT_PYTHON["package.xml"], "demo/__init__.py": ""},
        *(IN, "broken-build-file", "no `setup.py`"),
    ),
    (
        {**AMENT_PYTHON, "pyproject.toml": '# it\n[project]\nname = "demo"\n'},
        *(IN, "computed-build-file", "line 2 of `pyproject.toml`"),
    ),
    (
        {**BARE, "setup.cfg": "[options]\nentry_points = file: points.cfg\n"},
        *(IN, "computed-build-file", "line 2 of `setup.cfg`"),
    ),
    ({**BARE, "setup.cfg": "[options\n"}, *(IN, "broken-build-file", "`setup.cfg`")),
    (
        {**AMENT_PYTHON, "demo/talker.py": "import os\n"},
        IN,
        "already-contained",
        "`demo/talker.py`",
    ),
    (AMENT_PYTHON, IN.replace("'demo'", "'dmo'"), "file-not-found", "no folder `dmo`"),
    (AMENT_PYTHON, IN.replace("'demo'", "'../demo'"), "outside-project", "outside"),
    (AMENT_PYTHON, IN.replace("'demo'", "'demo/setup.py'"), "file-not-found", "not a folder"),
    (
        AMENT_PYTHON,
        IN.replace("generate", "load_package 'demo' as again\ngenerate"),
        *("package-exists", "`demo`"),
    ),
    (
        AMENT_PYTHON,
        IN.replace("contains talker", "contains talker as 'listener'"),
        *("already-contained", "line 12 of `setup.py`"),
    ),
    ({**CATKIN, "scripts/talker.py": "import os\n"}, IN, "other-ros", "is for ROS 1"),
]


@pytest.mark.parametrize(
    ("files", "program", "code", "said"),
    REFUSED,
    ids=[str(number) for number in range(len(REFUSED))],
)
@pytest.mark.parametrize("in_place", [False, True])
def test_what_is_refused_is_told_and_nothing_is_written(
    files: dict[str, str], program: str, code: str | None, said: str, in_place: bool, tmp_path: Path
) -> None:
    (tmp_path / ".git").mkdir()
    lay(tmp_path, files)
    before = texts(tmp_path)
    told = run(program, tmp_path, "rclpy", in_place=in_place)
    errors = [each for each in told if each.severity.value == "error"]
    assert len(errors) == 1, told
    assert code in (None, errors[0].code)
    assert said in errors[0].message
    assert texts(tmp_path) == before


@pytest.mark.parametrize("name", ["package.xml", "setup.py"])
def test_a_link_that_leads_out_is_not_followed(name: str, tmp_path: Path) -> None:
    project = tmp_path / "project"
    (project / ".git").mkdir(parents=True)
    package = lay(project, AMENT_PYTHON)
    (package / name).rename(tmp_path / name)
    (package / name).symlink_to(tmp_path / name)
    [told] = run(IN, project, "rclpy", in_place=True)
    assert (told.code, told.span is not None) == ("outside-project", True)
    assert (tmp_path / name).read_text() == AMENT_PYTHON[name]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("style", ["crlf", "bom", "tabs", "no-end"])
def test_the_style_of_a_file_is_kept(kind: str, style: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, {name: _styled(text, style) for name, text in files.items()})
    before = texts(package)
    assert run(IN, tmp_path, library, in_place=True) == ()
    after = texts(package)
    if style == "crlf":
        assert all(after[name].count(b"\n") == after[name].count(b"\r\n") for name in ADDED[kind])
    run(OUT, tmp_path, library, in_place=True)
    now = texts(package)
    assert {name: now[name] for name in before} == before


def _styled(text: str, style: str) -> bytes:
    if style == "crlf":
        text = text.replace("\n", "\r\n")
    if style == "tabs":
        text = text.replace("  ", "\t")
    if style == "no-end":
        text = text.rstrip("\n")
    return (b"\xef\xbb\xbf" if style == "bom" else b"") + text.encode()


@settings(max_examples=examples(25), deadline=None)
@given(
    kind=some.sampled_from(sorted(KINDS)),
    depends=some.lists(some.sampled_from(["std_msgs", "nav_msgs", "tf2", "yaml"]), unique=True),
    others=some.lists(some.sampled_from(["alpha", "beta", "zeta"]), unique=True),
    comment=some.text(some.sampled_from("ab #"), max_size=6),
    is_crlf=some.booleans(),
)
def test_any_package_is_as_it_was(
    kind: str,
    depends: list[str],
    others: list[str],
    comment: str,
    is_crlf: bool,
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    folder = tmp_path_factory.mktemp("any")
    library, files = KINDS[kind]
    listed = "".join(f"  <exec_depend>{each}</exec_depend> <!--{comment}-->\n" for each in depends)
    line = {
        "ament_python": "            '{0} = demo.listener:main',\n",
        "ament_cmake": "  nodes/{0}.py\n",
        "catkin": "  scripts/{0}.py\n",
    }[kind]
    more = "".join(line.format(each) for each in others)
    ends = {
        "package.xml": "</package>",
        "setup.py": "        ],\n    },",
        "CMakeLists.txt": "  DESTI",
    }
    extra = {"package.xml": listed, "setup.py": more, "CMakeLists.txt": more}
    changed = {
        name: text.replace(ends[name], extra[name] + ends[name], 1) if name in ends else text
        for name, text in files.items()
    }
    package = lay(
        folder,
        {name: _styled(text, "crlf" if is_crlf else "") for name, text in changed.items()},
    )
    before = texts(package)
    assert run(IN, folder, library, in_place=True) == ()
    run(OUT, folder, library, in_place=True)
    now = texts(package)
    assert {name: now[name] for name in before} == before
