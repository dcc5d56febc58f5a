"""What a robot's description names comes with it into a package that the program creates."""

from __future__ import annotations

import os
from pathlib import Path
from xml.etree import ElementTree

import pytest
from loaded_packages import KINDS, lay, run

from plastron_tui.diagnostics import Diagnostic, has_errors
from plastron_tui.project import package_copy, robot_companions
from plastron_tui.runtime import meshes, xacro
from plastron_tui.runtime.meshes import Bounds
from plastron_tui.runtime.xacro import Expanded
from plastron_tui.trust import TrustStore

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
MESH = '<visual><geometry><mesh filename="{}"/></geometry></visual>'
ARM = f"""\
<robot name="arm" {XACRO}>
  <xacro:include filename="parts/wheel.xacro"/>
  <xacro:include filename="$(find other)/more.xacro"/>
  <link name="base">{MESH.format("package://demo/meshes/base.stl")}</link>
  <xacro:wheel/>
</robot>
"""
WHEEL = f"""\
<robot {XACRO}>
  <xacro:include filename="rim.xacro"/>
  <xacro:macro name="wheel">
    <link name="wheel">{MESH.format("package://demo/meshes/fine/wheel.dae")}</link>
  </xacro:macro>
</robot>
"""
EXPANDED = f"""\
<robot name="arm">
  <link name="base">{MESH.format("package://demo/meshes/base.stl")}</link>
  <link name="wheel">{MESH.format("package://demo/meshes/fine/wheel.dae")}</link>
  <joint name="j" type="fixed"><parent link="base"/><child link="wheel"/></joint>
</robot>
"""
BINARY = bytes(range(256))
PROJECT = {
    "models/arm.urdf.xacro": ARM.encode(),
    "models/parts/wheel.xacro": WHEEL.encode(),
    "models/parts/rim.xacro": f"<robot {XACRO}/>".encode(),
    "config/sizes.yaml": b"wheel: 1\n",
    "meshes/base.stl": BINARY,
    "meshes/fine/wheel.dae": BINARY,
}
PACKAGE = (
    'create_package \'demo\' as demo maintained_by "Ada <a@b.cc>" licensed_under "MIT"\n'
    "demo contains {}\ngenerate_package demo\n"
)
NODE = "create_node 'n' as n\nsubscribe n to 'x' of message_type String\n"
ARM_THERE = {
    "urdf/parts/wheel.xacro",
    "urdf/parts/rim.xacro",
    "meshes/base.stl",
    "meshes/fine/wheel.dae",
}
DATA = {
    "rospy": "DIRECTORY launch urdf meshes",
    "rclpy": "'/urdf/parts', glob('urdf/parts/*.*')",
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    folder = tmp_path / "project"
    for path, text in {**PROJECT, "../beyond/a.stl": BINARY}.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(text)
    (folder / "plastron.yaml").write_text("")
    (folder / "out.stl").symlink_to(tmp_path / "beyond/a.stl")
    (folder / "meshes/posing.stl").symlink_to(folder / "config/sizes.yaml")
    for path in ("meshes/skin.png", ".git/config.stl"):
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_bytes(BINARY)
    return folder


def loaded(folder: Path, library: str = "rospy") -> tuple[Path, list[Diagnostic]]:
    program = f"load_robot 'models/arm.urdf.xacro' as arm\n{NODE}{PACKAGE.format('arm')}"
    program = program.replace("generate_package", "demo contains n\ngenerate_package")
    told = list(run(program, folder, library))
    assert not has_errors(told), told
    return folder / "output/demo", told


def created(folder: Path, uri: str) -> tuple[Path, list[Diagnostic]]:
    program = f"create_robot 'rover' as rover\nrover has_link 'base' shaped mesh \"{uri}\"\n"
    told = list(run(program + PACKAGE.format("rover"), folder, "rospy"))
    assert not has_errors(told), told
    return folder / "output/demo", [each for each in told if each.code == "not-copied"]


def copied(package: Path, folder: Path) -> set[str]:
    """Return what is in a package, and in the project byte by byte."""
    known = set(PROJECT.values())
    files = (each for each in package.rglob("*") if each.is_file())
    return {
        str(each.relative_to(package))
        for each in files
        if each.read_bytes() in known and each.suffix != ".py" and "arm." not in each.name
    }


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_what_is_named_is_copied_and_installed(folder: Path, library: str) -> None:
    package, told = loaded(folder, library)
    assert copied(package, folder) == ARM_THERE
    assert (package / "urdf/arm.urdf.xacro").read_text() == ARM
    build = "CMakeLists.txt" if library == "rospy" else "setup.py"
    assert DATA[library] in (package / build).read_text()
    needed = ElementTree.fromstring((package / "package.xml").read_bytes())
    assert "other" in {each.text for each in needed.findall("exec_depend")}
    assert [each.code for each in told if each.code == "not-copied"] == []
    before = {each: each.stat().st_mtime_ns for each in package.rglob("*") if each.is_file()}
    loaded(folder, library)
    assert {each: each.stat().st_mtime_ns for each in before} == before


def test_what_macros_open_is_copied_where_they_are_expanded(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "models/arm.urdf.xacro").write_text(ARM.replace("$(find other)/more", "${name}"))
    opened = (
        folder / "config/sizes.yaml",
        folder / "models/parts/wheel.xacro",
        folder / "models/none.xacro",
        Path("/usr/share/other/x.xacro"),
    )
    monkeypatch.setattr(xacro, "expand", lambda *_: Expanded(EXPANDED.encode(), "", opened))
    TrustStore().add(folder)
    package, told = loaded(folder)
    assert copied(package, folder) == {*ARM_THERE, "config/sizes.yaml"}
    assert told == []


@pytest.mark.parametrize(
    ("uri", "path", "reason"),
    [
        ("package://demo/meshes/base.stl", "meshes/base.stl", None),
        ("package://other/meshes/base.stl", None, None),
        ("meshes/base.stl", "urdf/meshes/base.stl", None),
        ("package://demo/meshes/bse.stl", None, "it is not there"),
        ("../../base.stl", None, "it would be in no folder of it"),
        ("package://demo/../base.stl", None, "it would be in no folder of it"),
        ("package://demo/base.stl", None, "it would be in no folder of it"),
        ("meshes/none.stl", None, "it is not there"),
        ("out.stl", None, "it is outside of the project"),
        ("../beyond/a.stl", None, "it is outside of the project"),
        ("file:///etc/passwd", None, "it is a place on this machine"),
        ("/etc/passwd", None, "it is a place on this machine"),
        ("file://$(find demo)/meshes/base.stl", "meshes/base.stl", None),
        ("https://example.org/a.stl", None, None),
        ("package://demo/meshes/" + "x" * 300 + ".stl", None, "it is not there"),
        ("package://demo/config/sizes.yaml", None, "it ends as no mesh does"),
        ("package://demo/meshes/skin.png", None, "it ends as no mesh does"),
        ("meshes/posing.stl", None, "it ends as no mesh does"),
        (".git/config.stl", None, "it is outside of the project"),
    ],
)
def test_a_mesh_is_copied_or_told(
    folder: Path, uri: str, path: str | None, reason: str | None
) -> None:
    package, told = created(folder, uri)
    assert copied(package, folder) == (set() if path is None else {path})
    assert not any(each.is_symlink() for each in package.rglob("*"))
    if reason is None:
        assert told == []
    else:
        [left] = told
        told_all = f"`rover.urdf` names `{uri}`, which the package does not get: {reason}"
        assert left.message == told_all
        assert left.span is not None
        assert left.help


def test_materials_and_images_of_meshes_come_along(folder: Path) -> None:
    around = {
        "meshes/fine/arm.dae": b"<init_from>../skin%20s/a.png</init_from>"
        b"<init_from>a-png</init_from><init_from>../../config/sizes.yaml</init_from>",
        "meshes/c.gltf": b'{"buffers": [{"uri": "c.bin"}, {"uri": "../plastron.yaml"}]}',
        "meshes/c.bin": BINARY,
        "meshes/skin s/a.png": BINARY,
        "meshes/b.obj": b"# obj\nmtllib b.mtl\nv 0 0 0\n",
        "meshes/b.mtl": b"newmtl x\nmap_Kd -s 1 1 1 b.png\r\n  map_Bump ../../../beyond/a.stl\n",
        "meshes/b.png": BINARY,
    }
    for path, text in around.items():
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_bytes(text)
    program = """\
create_robot 'r' as r
r has_link 'l' shaped mesh "package://demo/meshes/fine/arm.dae"
r has_link 'm' shaped mesh "package://demo/meshes/b.obj"
r has_link 'n' shaped mesh "package://demo/meshes/c.gltf"
r has_joint 'j' of joint_type fixed from 'l' to 'm'
r has_joint 'k' of joint_type fixed from 'l' to 'n'
"""
    told = run(program + PACKAGE.format("r"), folder, "rospy")
    assert [each for each in told if each.code == "not-copied"] == []
    made = folder / "output/demo"
    there = {str(each.relative_to(made)) for each in made.glob("**/*") if each.is_file()}
    assert {x for x in there if not x.startswith(("urdf/", "launch/")) and "/" in x} == set(around)


def test_a_package_is_the_same_the_next_time(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a mesh weighs follows from its size, wherever it is found."""
    box = Bounds((0.0, 0.0, 0.0), (1.0, 2.0, 3.0))
    monkeypatch.setattr(meshes, "measure", lambda paths, _: (box,) * len(paths))
    uri = 'package://demo/meshes/base.stl" weighing 2 painted "#ffffff'
    package, _ = created(folder, uri)
    before = (package / "urdf/rover.urdf").read_text()
    assert "<inertia " in before
    created(folder, uri)
    assert (package / "urdf/rover.urdf").read_text() == before


def test_what_is_included_is_xml(folder: Path) -> None:
    text = ARM.replace("parts/wheel.xacro", "../config/sizes.yaml")
    (folder / "models/arm.urdf.xacro").write_text(text)
    package, told = loaded(folder)
    assert "config/sizes.yaml" not in copied(package, folder)
    assert ["it is no XML" in each.message for each in told if each.code == "not-copied"] == [True]


def test_a_mesh_includes_nothing(folder: Path) -> None:
    mesh = MESH.format("../meshes/fine/wheel.dae")
    (folder / "models/arm.urdf.xacro").write_text(ARM.replace("  <xacro:wheel/>", mesh))
    (folder / "meshes/fine/wheel.dae").write_text(ARM.replace("parts/wheel", "more"))
    (folder / "meshes/fine/more.xacro").write_text(WHEEL)
    package, _ = loaded(folder)
    assert (package / "meshes/fine/wheel.dae").is_file()
    assert not (package / "meshes/fine/more.xacro").exists()


@pytest.mark.parametrize("count", [5, 6, 7, 30])
def test_of_many_that_are_left_the_number_is_told(folder: Path, count: int) -> None:
    links = "".join(f"r has_link 'l{i}' shaped mesh \"meshes/{i}.stl\"\n" for i in range(count))
    joints = "".join(
        f"r has_joint 'j{i}' of joint_type fixed from 'l0' to 'l{i}'\n" for i in range(1, count)
    )
    program = f"create_robot 'r' as r\n{links}{joints}{PACKAGE.format('r')}"
    told = [each for each in run(program, folder, "rospy") if each.code == "not-copied"]
    if count <= 6:
        assert len(told) == count
    else:
        assert len(told) == 6
        assert f"names {count - 5} more files" in told[-1].message


def test_what_somebody_put_into_the_package_stays_and_is_installed(folder: Path) -> None:
    mesh = folder / "output/demo/shapes/hand.stl"
    mesh.parent.mkdir(parents=True)
    mesh.write_bytes(b"by hand")
    package, told = created(folder, "package://demo/shapes/hand.stl")
    assert told == []
    assert mesh.read_bytes() == b"by hand"
    assert "DIRECTORY launch urdf shapes" in (package / "CMakeLists.txt").read_text()


def test_a_copy_that_was_changed_by_hand_stays(folder: Path) -> None:
    package, _ = created(folder, "package://demo/meshes/base.stl")
    (package / "meshes/base.stl").write_bytes(b"by hand")
    created(folder, "package://demo/meshes/base.stl")
    assert (package / "meshes/base.stl").read_bytes() == b"by hand"


def test_what_is_copied_is_bounded(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(package_copy, "MOST_BYTES", len(BINARY) + 200)
    package, told = loaded(folder)
    assert len(copied(package, folder)) == 2
    assert any("cannot be read: it is larger than" in each.message for each in told)
    monkeypatch.undo()
    monkeypatch.setattr(robot_companions, "_MOST_FILES", 1)
    program = """\
create_robot 'r' as r
r has_link 'l' shaped mesh "meshes/base.stl"
r has_link 'm' shaped mesh "meshes/fine/wheel.dae"
r has_joint 'j' of joint_type fixed from 'l' to 'm'
"""
    told = [x for x in run(program + PACKAGE.format("r"), folder, "rospy") if "files" in x.message]
    assert [each.code for each in told] == ["not-copied"]


def test_two_files_for_one_place_are_told(folder: Path) -> None:
    (folder / "urdf/meshes").mkdir(parents=True)
    (folder / "urdf/meshes/base.stl").write_bytes(b"another")
    program = """\
create_robot 'r' as r
r has_link 'l' shaped mesh "meshes/base.stl"
r has_link 'm' shaped mesh "package://demo/urdf/meshes/base.stl"
r has_joint 'j' of joint_type fixed from 'l' to 'm'
"""
    told = run(program + PACKAGE.format("r"), folder, "rospy")
    [left] = [each for each in told if each.code == "not-copied"]
    assert "it has another `urdf/meshes/base.stl`" in left.message
    assert (folder / "output/demo/urdf/meshes/base.stl").read_bytes() == BINARY


def test_a_loaded_package_is_told_what_it_lacks(tmp_path: Path) -> None:
    library, files = KINDS["ament_cmake"]
    lay(tmp_path, files)
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes/base.stl").write_bytes(BINARY)
    program = "create_robot 'rover' as rover\n"
    program += "rover has_link 'base' shaped mesh \"package://demo/meshes/base.stl\"\n"
    program += "load_package 'demo' as demo\ndemo contains rover\ngenerate_package demo\n"
    told = [x for x in run(program, tmp_path, library) if x.code == "not-copied"]
    assert [x.message for x in told] == [
        "the package `demo` has no `meshes/base.stl`, which the robot needs"
    ]


@pytest.mark.parametrize("in_place", [False, True])
def test_a_copy_without_what_it_names_is_told(folder: Path, in_place: bool) -> None:
    program = "load_robot 'models/arm.urdf.xacro' as arm\ngenerate_robot arm\n"
    told = [x for x in run(program, folder, "rospy", in_place=in_place) if x.code == "not-copied"]
    assert len(told) == (not in_place)
    for each in told:
        assert "names `parts/wheel.xacro`, which is not beside the copy" in each.message
    assert os.path.isfile(folder / "output/arm.urdf.xacro") == (not in_place)  # noqa: PTH113


def test_a_copy_finds_what_packages_have(folder: Path) -> None:
    text = ARM.replace('  <xacro:include filename="parts/wheel.xacro"/>\n', "")
    (folder / "models/arm.urdf.xacro").write_text(text)
    program = "load_robot 'models/arm.urdf.xacro' as arm\ngenerate_robot arm\n"
    assert [x for x in run(program, folder, "rospy") if x.code == "not-copied"] == []
