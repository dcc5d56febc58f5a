"""How far a robot's file may lead: into the project, and into packages that are installed."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.boundary import find_boundary
from plastron_tui.sources.urdf import includes
from plastron_tui.sources.urdf.includes import check_includes
from plastron_tui.sources.urdf.reach import Reach, find_reach
from plastron_tui.sources.xml.document import read_xml

XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'


def package(folder: Path, name: str) -> Path:
    (folder / "urdf").mkdir(parents=True)
    (folder / "package.xml").write_text(f"<package format='3'><name>{name}</name></package>")
    return folder


@pytest.fixture(scope="module")
def above(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with packages, packages that are installed beside it, and what is neither."""
    above = tmp_path_factory.mktemp("reach")
    root = above / "project"
    rover = package(root / "rover_description", "rover_description")
    (rover / "urdf" / "rover.xacro").write_text(XACRO.format(""))
    (rover / "urdf" / "wheel.stl").write_text("solid")
    (root / ".git").mkdir()
    (root / ".git" / "config.xacro").touch()
    parts = package(above / "ros" / "share" / "parts", "parts")
    (parts / "urdf" / "arm.xacro").write_text(XACRO.format(""))
    built = package(above / "ros" / "share" / "rover_description", "rover_description")
    (built / "config").mkdir()
    (built / "config" / "joints.xacro").touch()
    (above / "ros" / "share" / "no_package").mkdir()
    (above / "ros" / "share" / "no_package" / "x.xacro").touch()
    (above / "ros" / "share" / "loose.xacro").touch()
    (above / "secret.xacro").touch()
    (rover / "urdf" / "out.xacro").symlink_to(above / "secret.xacro")
    (rover / "out").symlink_to(above)
    (parts / "urdf" / "out.xacro").symlink_to(above / "secret.xacro")
    os.mkfifo(rover / "urdf" / "fifo.xacro")
    return above


@pytest.fixture(scope="module")
def reach(above: Path) -> Reach:
    root = above / "project"
    environ = {"AMENT_PREFIX_PATH": str(above / "ros")}
    return find_reach(
        find_boundary(root), root / "rover_description" / "urdf" / "rover.xacro", environ
    )


OUTSIDE = "is neither in the project nor in an installed package"
NO_PACKAGE = "is of the package `{}`, which is neither in the project nor installed"


@pytest.mark.parametrize(
    ("name", "problem"),
    [
        ("rover.xacro", ""),
        ("$(dirname)/rover.xacro", ""),
        ("../urdf/wheel.stl", ""),
        ("package://rover_description/urdf/wheel.stl", ""),
        ("$(find rover_description)/urdf/wheel.stl", ""),
        ("file://$(find rover_description)/urdf/wheel.stl", ""),
        ("file://{root}/rover_description/urdf/wheel.stl", ""),
        ("{root}/rover_description/urdf/wheel.stl", ""),
        ("package://parts/urdf/arm.xacro", ""),
        # The sources of an installed package have it elsewhere.
        ("package://rover_description/config/joints.xacro", ""),
        ("$(find rover_description)/config/../../../../secret.xacro", OUTSIDE),
        ("{above}/ros/share/parts/urdf/arm.xacro", ""),
        ("none.xacro", "is not there"),
        ("", "is not there"),
        ("fifo.xacro", "is not there"),
        ("package://parts", "is not there"),
        ("package://parts/" + "x/" * 5000 + "y", "is not there"),
        ("package://pats/urdf/arm.xacro", NO_PACKAGE.format("pats")),
        ("$(find no_package)/x.xacro", NO_PACKAGE.format("no_package")),
        ("package://../secret.xacro", NO_PACKAGE.format("..")),
        ("package://./parts/urdf/arm.xacro", NO_PACKAGE.format(".")),
        ("package://parts/../../../secret.xacro", OUTSIDE),
        ("package://parts/../no_package/x.xacro", OUTSIDE),
        ("package://parts/../loose.xacro", OUTSIDE),
        ("package://parts/urdf/out.xacro", OUTSIDE),
        ("package://parts//{above}/secret.xacro", OUTSIDE),
        ("$(find rover_description)/../../secret.xacro", OUTSIDE),
        ("../../.git/config.xacro", OUTSIDE),
        ("../../../secret.xacro", OUTSIDE),
        ("../out/secret.xacro", OUTSIDE),
        ("out.xacro", OUTSIDE),
        ("{above}/secret.xacro", OUTSIDE),
        ("file://{above}/secret.xacro", OUTSIDE),
        ("/dev/stdin", OUTSIDE),
        ("/proc/self/environ", OUTSIDE),
        ("~/secret.xacro", "is not there"),
        ("x\0.xacro", "has a NUL character in it"),
        ("https://example.com/x.xacro", "is of a kind of URI that is not looked for"),
        ("model://rover/x.stl", "is of a kind of URI that is not looked for"),
        ("${prefix}.xacro", "is computed"),
        ("$(find $(arg package))/x.xacro", "is computed"),
        ("$(env HOME)/x.xacro", "is computed"),
    ],
)
def test_where_a_name_leads(above: Path, reach: Reach, name: str, problem: str) -> None:
    root = above / "project"
    written = name.replace("{root}", str(root)).replace("{above}", str(above))
    place = reach.find(written, root / "rover_description" / "urdf")
    assert place.problem == problem
    assert (place.path is not None) == (not problem)


def test_packages_of_a_sourced_ros_1_are_found_where_they_are_developed(tmp_path: Path) -> None:
    sources = tmp_path / "workspace" / "src"
    parts = package(sources / "group" / "parts", "parts")
    (parts / "urdf" / "arm.xacro").touch()
    (sources / "secret.xacro").touch()
    root = tmp_path / "project"
    root.mkdir()
    environ = {"ROS_PACKAGE_PATH": str(sources)}
    reach = find_reach(find_boundary(root), root / "rover.xacro", environ)
    assert reach.find("package://parts/urdf/arm.xacro", root).path is not None
    assert reach.find("$(find parts)/../../secret.xacro", root).problem == OUTSIDE


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('<xacro:include filename="rover.xacro"/>', []),
        ('<xacro:include filename="inner.xacro"/>', ["`../../../secret.xacro` " + OUTSIDE]),
        ('<xacro:include filename="circle.xacro"/>', []),
        ('<xacro:include filename="broken.xacro"/>', ["`<link>` is not closed"]),
        ('<xacro:include filename="bomb.xacro"/>',
         ["the document type has declarations of its own, which are not read"]),
        ('<xacro:include filename="none.xacro"/>', ["`none.xacro` is not there"]),
        ('<xacro:include filename="none.xacro" optional="true"/>', []),
        ('<xacro:include filename="out.xacro" optional="true"/>', [f"`out.xacro` {OUTSIDE}"]),
        # What may never be reached, or is computed, is known when it is expanded.
        ('<xacro:if value="0"><xacro:include filename="out.xacro"/></xacro:if>', []),
        ('<xacro:macro name="m"><xacro:include filename="out.xacro"/></xacro:macro>', []),
        ('<xacro:include filename="${x}.xacro"/>', []),
        ('<xacro:include filename="../../../*.xacro"/>', []),
    ],
)  # fmt: skip
def test_includes_are_looked_at_before_anything_is_expanded(
    above: Path, reach: Reach, text: str, told: list[str]
) -> None:
    folder = above / "project" / "rover_description" / "urdf"
    others = {
        "inner": XACRO.format('\n<xacro:include filename="../../../secret.xacro"/>'),
        "circle": XACRO.format('<xacro:include filename="circle.xacro"/>'),
        "broken": "<robot><link></robot>",
        "bomb": '<!DOCTYPE r [<!ENTITY a "aa"><!ENTITY b "&a;&a;">]><robot>&b;</robot>',
    }
    for name, other in others.items():
        (folder / f"{name}.xacro").write_text(other)
    document = read_xml(XACRO.format(text).encode()).document
    assert document is not None
    found = check_includes(document, folder / "main.xacro", reach).diagnostics
    messages = [each.message.removeprefix("the macros are not expanded: ") for each in found]
    assert len(messages) == len(told)
    assert all(each in message for each, message in zip(told, messages, strict=True)), messages
    # Each is told in the file that it is in.
    assert all(each.file is not None and each.span is not None for each in found)


def test_a_file_that_includes_itself_is_looked_at_once(
    above: Path, reach: Reach, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = above / "project" / "rover_description" / "urdf"
    text = XACRO.format('<xacro:include filename="self.xacro"/>').encode()
    (folder / "self.xacro").write_bytes(text)
    read: list[Path] = []

    def read_regular(path: Path, _: int) -> bytes:
        read.append(path)
        return text

    monkeypatch.setattr(includes, "read_regular", read_regular)
    document = read_xml(text).document
    assert document is not None
    assert check_includes(document, folder / "main.xacro", reach).diagnostics == ()
    assert read == [folder / "self.xacro"]
