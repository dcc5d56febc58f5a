"""What the files of a new package hold."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree
from xml.sax.saxutils import unescape

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from made_packages import ADA, ROS_VERSION, nodes_of, spec_of, with_types, write
from rules import broken_rules

from plastron_tui.diagnostics import Span
from plastron_tui.ros.package_keys import find_own_license
from plastron_tui.ros.packages import Maintainer
from plastron_tui.targets.packages import (
    BuildType,
    PackagedFile,
    PackagedLaunch,
    PackageFile,
    PackageSpec,
    interfaces_of,
    render_interfaces,
    render_package,
)
from plastron_tui.targets.packages.smoke_tests import expected_of

SPAN = Span(3, 7)


@cache
def kept(library: str) -> PackageSpec:
    with TemporaryDirectory() as folder:
        return spec_of(library, Path(folder))


def shape(name: str) -> PackageSpec:
    """Return a package of a kind, by the name of the kind."""
    if name == "catkin":
        return with_types(kept("rospy"))
    if name == "interfaces":
        found = interfaces_of(with_types(kept("rclpy")))
        assert found is not None
        return found
    if name == "types and nodes":
        return replace(with_types(kept("rclpy")), builds_types=True)
    return replace(kept("rclpy"), build_type=BuildType(name))


def read(description: str) -> str:
    """Return a description's text: catkin_pkg leaves its XML as it is, which may be XHTML."""
    return unescape(description, {"&quot;": '"'})


SHAPES = (
    *("catkin", "ament_python", "ament_cmake_python", "ament_cmake", "interfaces"),
    "types and nodes",
)


def rendered(spec: PackageSpec, folder: Path) -> Path:
    is_apart = spec.ros_version == 2 and spec.definitions and not spec.builds_types
    write(render_interfaces(spec) if is_apart else render_package(spec), folder)
    return folder


@pytest.mark.parametrize("name", SHAPES)
def test_package_breaks_no_rule(name: str, tmp_path: Path) -> None:
    assert broken_rules(rendered(shape(name), tmp_path)) == []


@pytest.mark.parametrize("name", SHAPES)
def test_catkin_pkg_reads_the_manifest(name: str, tmp_path: Path) -> None:
    parse_package = pytest.importorskip("catkin_pkg.package").parse_package
    warnings: list[str] = []
    spec = shape(name)
    package = parse_package(str(rendered(spec, tmp_path)), warnings=warnings)
    assert warnings == []
    assert (package.name, read(package.description)) == (spec.name, spec.summary)
    assert [(each.name, each.email) for each in package.maintainers] == [tuple(ADA)]
    built = {"catkin": "catkin", "ament_python": "ament_python"}
    assert package.get_build_type() == built.get(name, "ament_cmake")


TEXTS = st.text(st.characters(blacklist_categories=("Cc", "Cs", "Cf", "Zl", "Zp", "Co", "Cn", "Zs"),
                              whitelist_characters=" "), min_size=1, max_size=300).filter(
    lambda text: text.strip() != ""
)  # fmt: skip


@settings(max_examples=examples(20))
@given(TEXTS, TEXTS)
def test_any_text_is_in_the_files_as_it_is(description: str, person: str) -> None:
    catkin_pkg = pytest.importorskip("catkin_pkg.package")
    spec = replace(kept("rclpy"), description=description, maintainer=Maintainer(person, ADA.mail))
    found = render_package(spec)
    assert found.files is not None, found.diagnostics
    package = catkin_pkg.parse_package_string(found.files["package.xml"].text.decode())
    assert read(package.description).split() == description.split()
    with TemporaryDirectory() as folder:
        assert broken_rules(write(found, Path(folder))) == []
    longest = max(len(line) for line in found.files["setup.py"].text.decode().splitlines())
    assert longest <= 99 or "\\" in description or '"' in description


def keys(spec: PackageSpec, tag: str) -> set[str | None]:
    found = render_package(spec)
    assert found.files is not None
    root = ElementTree.fromstring(found.files["package.xml"].text)
    return {each.text for each in root.findall(tag)}


IMPORTS = """
import json, sys
import numpy as np, cv2
import os.path
from google.protobuf import message
from PIL import Image
from tf2_ros import Buffer
from nav_msgs.msg import Path
from . import helper
from demo.talker import TalkerNode
from demo_interfaces.msg import Level

def late():
    import serial.tools
"""


def test_dependencies_are_what_the_code_imports() -> None:
    spec = kept("rclpy")
    first = spec.nodes[0]._replace(text=spec.nodes[0].text + IMPORTS.encode())
    spec = replace(spec, nodes=(first, *spec.nodes[1:]))
    assert render_package(spec).diagnostics == ()
    assert keys(spec, "exec_depend") == {
        "demo_interfaces", "nav_msgs", "python3-numpy", "python3-opencv", "python3-pil",
        "python3-protobuf", "python3-serial", "rclpy", "ros2launch", "std_msgs", "std_srvs",
        "tf2_ros_py",
    }  # fmt: skip


def test_unknown_import_is_told_and_no_key_is_invented() -> None:
    spec = kept("rclpy")
    text = spec.nodes[0].text + b"import my_robot, std_msgs.msg\n"
    spec = replace(spec, nodes=(spec.nodes[0]._replace(text=text, span=SPAN),))
    found = render_package(spec)
    assert [(each.code, each.span) for each in found.diagnostics] == [("unknown-import", SPAN)]
    assert "`my_robot`" in found.diagnostics[0].message
    assert keys(spec, "exec_depend") == {"rclpy", "ros2launch", "std_msgs"}


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"name": "Demo"}, "bad-package-name"),
        ({"name": "../demo"}, "bad-package-name"),
        ({"name": "demo\n<x>"}, "bad-package-name"),
        ({"version": "1.0"}, "bad-package-text"),
        ({"description": "two\nlines"}, "bad-package-text"),
        ({"maintainer": Maintainer("Ada", "ada")}, "bad-maintainer"),
        ({"maintainer": Maintainer("A\nda", "ada@example.com")}, "bad-maintainer"),
        ({"license": "Apache"}, "unknown-license"),
        ({"configs": (PackagedFile("../x.yaml", b"", SPAN),)}, "bad-package-file"),
        ({"configs": (PackagedFile("a.yaml", b""), PackagedFile("A.yaml", b""))},
         "bad-package-file"),
    ],
)  # fmt: skip
def test_mistake_is_told_and_nothing_is_written(change: dict[str, object], code: str) -> None:
    found = render_package(replace(kept("rclpy"), **change))  # type: ignore[arg-type]
    assert found.files is None
    assert [each.code for each in found.diagnostics] == [code]


@pytest.mark.parametrize(
    ("part", "value"),
    [
        ("executable", "a b"), ("executable", "../a"), ("executable", "listener"),
        ("module", "class"), ("module", "a-b"), ("module", "__init__"), ("module", "listener"),
    ],
)  # fmt: skip
def test_node_that_cannot_be_called_so_is_told(part: str, value: str) -> None:
    spec = kept("rclpy")
    first, *others = spec.nodes
    nodes = (first._replace(**{part: value}), *others)  # type: ignore[arg-type]
    found = render_package(replace(spec, nodes=nodes))
    assert found.files is None
    assert {each.code for each in found.diagnostics} == {"bad-package-file"}


@pytest.mark.parametrize("name", ["flake8", "pep257", "copyright", "lint_cmake", "xmllint"])
@pytest.mark.parametrize("build", ["ament_python", "ament_cmake_python"])
def test_node_may_be_called_as_a_linter_is(build: str, name: str) -> None:
    spec = shape(build)
    plain = render_package(spec).files
    nodes = (spec.nodes[0]._replace(executable=name, module=name), *spec.nodes[1:])
    found = render_package(replace(spec, nodes=nodes)).files
    assert plain is not None
    assert found is not None
    assert len(found) == len(plain)
    assert found.get(f"test/test_{name}.py") == plain.get(f"test/test_{name}.py")
    # ament_lint_auto adds a test of that name.
    build_file = found.get("CMakeLists.txt", PackageFile(b"")).text.decode()
    assert name not in [line.strip().partition(" ")[0] for line in build_file.splitlines()]


def test_what_the_program_does_not_say_is_told_and_parses() -> None:
    catkin_pkg = pytest.importorskip("catkin_pkg.package")
    spec = replace(kept("rclpy"), description="", maintainer=None, license=None)
    found = render_package(spec)
    assert [each.code for each in found.diagnostics] == ["maintainer-missing", "license-missing"]
    assert found.files is not None
    package = catkin_pkg.parse_package_string(found.files["package.xml"].text.decode())
    assert package.licenses == ["Proprietary"]
    assert "LICENSE" not in found.files


def test_license_without_a_text_is_linked() -> None:
    found = render_package(replace(kept("rclpy"), license="gpl-3.0-only"))
    assert found.files is not None
    assert "LICENSE" not in found.files
    assert b"spdx.org/licenses/GPL-3.0-only" in found.files["README.md"].text


def test_catkin_checks_launch_files() -> None:
    launches = (
        PackagedLaunch("b.launch", b"<launch/>"),
        PackagedLaunch("a.launch", b"<launch/>", is_open=True),
    )
    spec = replace(kept("rospy"), launches=launches)
    found = render_package(spec)
    assert found.files is not None
    checks = [
        line.strip()
        for line in found.files["CMakeLists.txt"].text.decode().splitlines()
        if "roslaunch" in line
    ]
    assert checks == [
        "find_package(roslaunch REQUIRED)",
        "roslaunch_add_file_check(launch/a.launch IGNORE_UNSET_ARGS)",
        "roslaunch_add_file_check(launch/b.launch)",
    ]
    assert "roslaunch" in keys(spec, "test_depend")


OWN_LICENSES = [
    ("proprietary", b"see [LICENSE](LICENSE)", "Copyright (c) Ada\n\nAll rights reserved.\n"),
    ("LicenseRef-Acme-1.0", b"`LicenseRef-Acme-1.0`. Put its text", None),
]


@pytest.mark.parametrize(("written", "told", "text"), OWN_LICENSES)
def test_a_license_of_ones_own(written: str, told: bytes, text: str | None) -> None:
    catkin_pkg = pytest.importorskip("catkin_pkg.package")
    meant = find_own_license(written)
    maintainer = Maintainer("Ada", "ada@example.com")
    found = render_package(replace(kept("rclpy"), license=meant, maintainer=maintainer))
    assert (found.files is not None, found.diagnostics) == (True, ())
    assert found.files is not None
    package = catkin_pkg.parse_package_string(found.files["package.xml"].text.decode())
    assert package.licenses == [meant]
    assert told in found.files["README.md"].text
    held = found.files.get("LICENSE")
    assert (None if held is None else held.text.decode()) == text


def test_types_of_ros_2_are_in_a_package_of_their_own() -> None:
    spec = with_types(kept("rclpy"))
    assert render_package(spec) == render_package(replace(spec, definitions=()))
    own = interfaces_of(spec)
    assert own is not None
    found = render_interfaces(own)
    assert found.files is not None
    assert {"msg/Level.msg", "msg/Levels.msg", "srv/SetLevel.srv"} < set(found.files)
    assert own.name == "demo_interfaces"


def test_same_package_is_the_same_files() -> None:
    assert render_package(kept("rospy")) == render_package(kept("rospy"))


def test_package_depends_on_what_its_launch_files_start() -> None:
    launch = kept("rclpy").launches[0]._replace(needs=frozenset({"turtlesim", "demo"}))
    spec = replace(kept("rclpy"), launches=(launch,))
    assert keys(spec, "exec_depend") == {
        "rclpy", "ros2launch", "std_msgs", "std_srvs", "turtlesim",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("library", "type_", "expected"),
    [
        (
            "rospy",
            "actionlib_tutorials/Fibonacci",
            {
                ("publisher", "/plan/feedback", ""),
                ("publisher", "/plan/result", ""),
                ("publisher", "/plan/status", ""),
                ("subscription", "/plan/cancel", ""),
                ("subscription", "/plan/goal", ""),
                ("service", "/planner/reset", ""),
            },
        ),
        (
            "rclpy",
            "example_interfaces/Fibonacci",
            {
                ("action server", "/plan", "example_interfaces/action/Fibonacci"),
                ("service", "/planner/reset", "std_srvs/srv/Trigger"),
            },
        ),
    ],
)
def test_smoke_test_expects_what_the_graph_shows(
    library: str, type_: str, expected: set[tuple[str, str, str]], tmp_path: Path
) -> None:
    program = (
        "create_node 'planner' as planner\n"
        f"planner provides_action 'plan' of action_type {type_}\n"
        "planner provides_service '~/reset' of service_type Trigger\n"
        "generate_node planner\n"
    )
    node = nodes_of(program, library, tmp_path)[0].node
    assert set(expected_of(node, ROS_VERSION[library])) == expected
