"""Packages of the nodes that programs generate."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.packages import Maintainer
from plastron_tui.session import Options, Session
from plastron_tui.sources import find_language
from plastron_tui.sources.python.ament_style import ament_style
from plastron_tui.targets.packages import (
    BuildType,
    PackagedDefinition,
    PackagedFile,
    PackagedLaunch,
    PackagedNode,
    PackageSpec,
    RenderedPackage,
)

ROS_VERSION = {"rospy": 1, "rclpy": 2}
ADA = Maintainer("Ada Lovelace", "ada@example.com")
TALKER = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
generate_node talker
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
listener provides_service '~/reset' of service_type Trigger
generate_node listener
"""


def nodes_of(program: str, library: str, folder: Path) -> tuple[PackagedNode, ...]:
    """Return the nodes that a program generates, each with the text that it has in a package."""
    options = Options(library, folder / "out")
    session = Session(program.encode(), folder / "a.plastron", options, environ={})
    python = find_language("python")
    nodes = []
    for each in session.generated():
        assert each.files is not None, each.diagnostics
        node = each.generation.node
        text = each.files.files.main
        assert text is not None
        if library == "rclpy":
            text = ament_style(text)
        nodes.append(PackagedNode(node.name, node.name, text, node, python, library))
    return tuple(nodes)


def packages_of(library: str) -> frozenset[str]:
    """Return the packages with types that the catalog knows."""
    catalog = Catalog({"rospy": "noetic", "rclpy": "kilted"}[library])
    return frozenset(each for kind in InterfaceKind for each in catalog.packages(kind))


def spec_of(
    library: str,
    folder: Path,
    program: str = TALKER,
    build_type: BuildType | None = None,
    name: str = "demo",
) -> PackageSpec:
    """Return a package with two nodes, a launch file, a parameter file and a robot."""
    return PackageSpec(
        name,
        ROS_VERSION[library],
        "Says hello & <listens>, as Ada's robots do",
        ADA,
        "Apache-2.0",
        "0.1.0",
        nodes=nodes_of(program, library, folder),
        launches=(PackagedLaunch("demo.launch", LAUNCH[library], frozenset({name})),),
        configs=(PackagedFile("demo.yaml", b"talker:\n  rate: 1\n"),),
        robots=(
            PackagedFile("rover.urdf", b'<robot name="rover">\n  <link name="a"/>\n</robot>\n'),
        ),
        packages=packages_of(library),
        build_type=build_type,
    )


def with_types(spec: PackageSpec) -> PackageSpec:
    """Return a package with a message and a service of its own besides."""
    definitions = (
        PackagedDefinition(InterfaceKind.MESSAGE, "Level", b"uint8 LOW = 0\nfloat64 value\n"),
        PackagedDefinition(
            InterfaceKind.MESSAGE, "Levels", b"std_msgs/Header header\nLevel[] levels\n",
            frozenset({"std_msgs"}),
        ),
        PackagedDefinition(InterfaceKind.SERVICE, "SetLevel", b"Level level\n---\nbool success\n"),
    )  # fmt: skip
    return replace(spec, definitions=definitions)


def write(rendered: RenderedPackage, folder: Path) -> Path:
    """Write the files of a package."""
    assert rendered.files is not None, rendered.diagnostics
    for path, file in rendered.files.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(file.text)
        target.chmod(0o755 if file.is_executable else 0o644)
    return folder


LAUNCH = {
    "rospy": b"""\
<launch>
  <node pkg="demo" type="talker.py" name="talker" />
</launch>
""",
    "rclpy": b"""\
<launch>
  <node pkg="demo" exec="talker" />
</launch>
""",
}
