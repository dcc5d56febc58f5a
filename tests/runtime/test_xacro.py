"""Files with macros are expanded as xacro expands them, and can do nothing else."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from plastron_tui.boundary import Boundary
from plastron_tui.runtime import xacro
from plastron_tui.runtime.xacro import Expanded, expand, find_xacro, remedy
from plastron_tui.sources.urdf.reach import find_reach
from plastron_tui.sources.urdf.reader import read_urdf

ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
DOUBLING = (
    "".join(
        f'<xacro:macro name="m{i}" params=""><xacro:m{i + 1}/><xacro:m{i + 1}/></xacro:macro>'
        for i in range(40)
    )
    + '<xacro:macro name="m40" params="">a</xacro:macro>'
)
# An expression that breaks out of xacro's list of forbidden names, and has the module `os`.
OS = (
    "(lambda: [c for c in ().__class__.__base__.__subclasses__() "
    "if c.__name__ == '_wrap_close'][0].__init__.__globals__)()"
)
WITHOUT_END = "macros, files or expressions are within each other without end"
OUTSIDE = "which is neither in the project nor in an installed package"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    # However busy the machine is.
    monkeypatch.setattr(xacro, "_LIMITS", xacro._LIMITS._replace(wait=600))
    folder = tmp_path / "project"
    folder.mkdir()
    for path, text in {
        "../secret.xacro": ROBOT.format('<link name="secret"/>'),
        "../secret.yaml": "secret: 1",
        "leaf.xacro": ROBOT.format('<link name="leaf"/>'),
        "circle.xacro": ROBOT.format('<xacro:include filename="circle.xacro"/>'),
        "broken.xacro": "<robot><link></robot>",
        "bomb.xacro": '<!DOCTYPE r [<!ENTITY a "aa"><!ENTITY b "&a;&a;">]><robot>&b;</robot>',
        "sizes.yaml": "wheel: {radius: 0.2}",
    }.items():
        (folder / path).write_text(text)
    (folder / "out.xacro").symlink_to(tmp_path / "secret.xacro")
    with (folder / "large.xacro").open("wb") as file:
        os.truncate(file.fileno(), 2**40)
    return folder


def expanded(folder: Path, text: str) -> Expanded:
    path = folder / "robot.xacro"
    modules = find_xacro({})
    assert modules is not None
    reach = find_reach(Boundary(folder.resolve()), path, {})
    return expand(path, ROBOT.format(text).encode(), reach, modules)


@pytest.mark.long
def test_what_a_robot_needs_is_there(folder: Path) -> None:
    named = {
        '<link name="l${1 + 1}"/>': "l2",
        '<xacro:include filename="*f.xacro"/>': "leaf",
        '<xacro:include filename="none.xacro" optional="true"/><link name="a"/>': "a",
        "<link name=\"${xacro.load_yaml('sizes.yaml')['wheel']['radius']}\"/>": "0.2",
        '<xacro:arg name="x" default="y"/><link name="$(arg x)"/>': "y",
        '<link name="$(optenv HOME none)"/>': "none",
    }
    found = expanded(folder, "".join(named))
    assert found.text is not None, found.reason
    description = read_urdf(found.text).description
    assert description is not None
    assert list(description.links) == list(named.values())


@pytest.mark.long
@pytest.mark.parametrize(
    ("text", "reason"),
    [
        # Where files lead.
        ('<xacro:include filename="../secret.xacro"/>', OUTSIDE),
        ('<xacro:include filename="../secret.xacro" optional="true"/>', OUTSIDE),
        ('<xacro:include filename="out.xacro"/>', OUTSIDE),
        ('<xacro:include filename="/etc/*.xml"/>', OUTSIDE),
        ("<link name=\"${xacro.load_yaml('../secret.yaml')}\"/>", OUTSIDE),
        ('<xacro:include filename="/proc/self/environ"/>', OUTSIDE),
        ('<xacro:property name="x" value=".."/><xacro:include filename="${x}/secret.xacro"/>',
         OUTSIDE),
        ('<link name="$(find nothing)"/>', "the package `nothing` is neither in the project"),
        ('<link name="$(env HOME)"/>', "they ask for the environment variable `HOME`"),
        # What never ends, or grows.
        ('<xacro:macro name="m" params=""><xacro:m/></xacro:macro><xacro:m/>', WITHOUT_END),
        ('<xacro:include filename="circle.xacro"/>', WITHOUT_END),
        (f"{DOUBLING}<xacro:m0/>", "more than 1 s"),
        ("<link name=\"${'a' * 10**10}\"/>", "more than 512 MB of memory"),
        ("<link name=\"${'a' * 10**7}\"/>", "they make more than 4 MB"),
        ('<link name="${len(list(map(str, range(10**12))))}"/>', "more than"),
        ('<xacro:include filename="bomb.xacro"/>', "declares entities"),
        ('<xacro:include filename="large.xacro"/>', "larger than 4 MB"),
        # Mistakes.
        ('<link name="${x}"/>', "name 'x' is not defined when evaluating expression 'x'"),
        ('<link name="$(arg x)"/>', "the argument `x` has no value"),
        ('<xacro:macro name="m" params=""/><xacro:m x="1"/>', 'parameter "x" (in the macro `m`)'),
        ('<xacro:include filename="broken.xacro"/>', "(in `broken.xacro`)"),
        ('<xacro:include filename="none.xacro"/>', "none.xacro"),
        # What breaks out of the expressions.
        (f"<link name=\"${{{OS}['system']('touch out')}}\"/>", "they ask for `os.system`"),
        (f"<link name=\"${{{OS}['fork']()}}\"/>", "they ask for `os.fork`"),
        (f"<link name=\"${{{OS}['open']('out', 577)}}\"/>", "they write to `out`"),
        (f"<link name=\"${{{OS}['listdir']('/')}}\"/>", OUTSIDE),
        (f"<link name=\"${{{OS}['__builtins__']['__import__']('socket')}}\"/>",
         "they ask for the module `socket`"),
        (f"<link name=\"${{{OS}['_exit'](0)}}\"/>", "expanding them fails"),
        (f"<link name=\"${{{OS}['kill'](0, 0)}}\"/>", "they ask for `os.kill`"),
    ],
)  # fmt: skip
def test_what_no_robot_needs_is_refused(
    folder: Path, monkeypatch: pytest.MonkeyPatch, text: str, reason: str
) -> None:
    monkeypatch.setattr(xacro, "_LIMITS", xacro._LIMITS._replace(work=1))
    found = expanded(folder, text)
    assert found.text is None
    assert reason in found.reason
    assert not (folder / "out").exists()


@pytest.mark.long
def test_a_robot_is_expanded_as_xacro_does_it(folder: Path) -> None:
    text = ROBOT.format(
        '<xacro:property name="w" value="0.3"/>'
        '<xacro:macro name="wheel" params="side y:=${w / 2} *place">'
        '<link name="${side}_wheel"><visual><xacro:insert_block name="place"/>'
        '<geometry><cylinder radius="${w / 3}" length="0.05"/></geometry></visual></link>'
        '<joint name="${side}" type="continuous"><parent link="base"/>'
        '<child link="${side}_wheel"/><origin xyz="0 ${y} 0"/><axis xyz="0 1 0"/></joint>'
        '</xacro:macro><link name="base"/>'
        '<xacro:wheel side="left"><origin xyz="${sqrt(2)} 0 0"/></xacro:wheel>'
        '<xacro:wheel side="right" y="-${w}"><origin rpy="${pi / 2} 0 0"/></xacro:wheel>'
        '<xacro:unless value="${w > 1}"><xacro:include filename="leaf.xacro"/></xacro:unless>'
    )
    path = folder / "robot.xacro"
    path.write_text(text)
    command = [sys.executable, "-c", "import xacro; xacro.main()", str(path)]
    by_hand = subprocess.run(command, capture_output=True, check=True, cwd=folder).stdout
    found = expanded(folder, text.removeprefix(ROBOT.split("{")[0]).removesuffix("</robot>"))
    assert found.text is not None, found.reason
    description = read_urdf(found.text).description
    assert description == read_urdf(by_hand).description
    assert description is not None
    assert len(description.links) == 4
    assert found.files == (folder / "leaf.xacro",)


@pytest.mark.long
def test_what_only_an_installed_package_has_is_found_there(folder: Path) -> None:
    share = folder.parent / "ros" / "share" / "parts"
    share.mkdir(parents=True)
    for each in (share, folder / "parts"):
        each.mkdir(exist_ok=True)
        (each / "package.xml").write_text("<package><name>parts</name></package>")
    (folder / "parts" / "both.xacro").write_text(ROBOT.format('<link name="source"/>'))
    for name in ("both", "only"):
        (share / f"{name}.xacro").write_text(ROBOT.format(f'<link name="{name}"/>'))
    (share / "sizes.yaml").write_text("a: b")
    path = folder / "robot.xacro"
    environ = {"AMENT_PREFIX_PATH": str(folder.parent / "ros")}
    reach = find_reach(Boundary(folder.resolve()), path, environ)
    text = ROBOT.format(
        '<xacro:include filename="$(find parts)/both.xacro"/>'
        '<xacro:include filename="$(find parts)/only.xacro"/>'
        "<link name=\"${xacro.load_yaml('$(find parts)/sizes.yaml')['a']}\"/>"
    )
    modules = find_xacro({})
    assert modules is not None
    found = expand(path, text.encode(), reach, modules)
    assert found.text is not None, found.reason
    description = read_urdf(found.text).description
    assert description is not None
    assert list(description.links) == ["source", "only", "b"]


def test_where_the_package_comes_from(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", ["", "."])
    monkeypatch.setattr(xacro, "_DEBIAN_MODULES", tmp_path / "dist-packages")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "xacro").mkdir()
    (tmp_path / "xacro" / "__init__.py").touch()
    # Not from the folder that one happens to be in.
    assert find_xacro({}) is None
    modules = tmp_path / "ros" / "lib" / "python3.12" / "site-packages"
    (modules / "xacro").mkdir(parents=True)
    (modules / "xacro" / "__init__.py").touch()
    assert find_xacro({"AMENT_PREFIX_PATH": f":{tmp_path / 'ros'}"}) == modules
    assert remedy({}) == "install it with `pip install 'plastron-tui[xacro]'`"
    assert remedy({"ROS_DISTRO": "jazzy"}) == "install it with `sudo apt install ros-jazzy-xacro`"
