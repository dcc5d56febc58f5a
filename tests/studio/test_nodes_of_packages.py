"""Nodes that have to be built, in the studio: all their files, and what is read of those."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from studio_driver import studio
from test_packages_panel import analysis_of

from plastron_tui.studio.panels.nodes import make as _nodes
from plastron_tui.studio.panels.preview import previews_of
from plastron_tui.studio.panels.source_lines import coloured
from plastron_tui.studio.wizard.node_files import _node_files

NODES = Path(__file__).parents[1] / "nodes"
PROGRAM = """\
create_node 'talker' as talker using {}
create_message hello of message_type String and input "hello"
talker publish hello to 'chatter' of message_type String at 2 hz
generate_node talker
create_node 'script' as script using {}
subscribe script to 'chatter' of message_type String
generate_node script
create_launch 'all' as all
all starts 'turtlesim/turtlesim_node'
generate_launch all
"""
BUILD = ["CMakeLists.txt", "package.xml"]


@pytest.mark.parametrize(
    ("library", "script", "files"),
    [
        ("roscpp", "rospy", ["src/talker_pub.cpp", *BUILD]),
        ("nodelet", "rospy", ["src/talker_pub.cpp", "nodelet_plugins.xml", *BUILD]),
        ("rclcpp", "rclpy", ["src/talker_pub.cpp", *BUILD]),
        ("component", "rclpy", ["src/talker_pub.cpp", "include/robot/talker_pub.hpp", *BUILD]),
    ],
)
def test_the_preview_has_all_files_of_a_node(
    library: str, script: str, files: list[str], tmp_path: Path
) -> None:
    analysis = analysis_of(PROGRAM.format(library, script), tmp_path / "robot.plastron")
    assert analysis.diagnostics == ()
    found = previews_of(analysis, "talker")
    assert sorted(each.name for each in found) == sorted(files)
    assert [each.name for each in found if each.is_main] == ["src/talker_pub.cpp"]
    assert found[0].is_main
    # The script is in the same package.
    names = {each.name for each in previews_of(analysis, "script")}
    beside = {name for name in files if "/" not in name}
    assert names == {"scripts/script_sub1.py", *beside}


def test_a_node_that_nothing_builds_has_its_file_alone(tmp_path: Path) -> None:
    analysis = analysis_of(PROGRAM.format("rclpy", "rclpy"), tmp_path / "robot.plastron")
    assert [each.name for each in previews_of(analysis, "talker")] == ["talker_pub.py"]


def test_what_a_preprocessor_reads_is_no_comment() -> None:
    include, comment, code = coloured('#include "a.hpp"\n// b\nint c;\n', Path("a.cpp"))
    assert {piece.tone for piece in include if piece.text.strip()} == {"keyword", "string"}
    assert {piece.tone for piece in comment} == {"quiet"}
    assert code[0].tone == "keyword"


LOADED = [
    # A node, what the panel has of it, a statement, and the files that it changes.
    (
        "roscpp/sonar_driver/src/sonar_driver.cpp",
        {"range", "enable", "ping"},
        "it renames topic 'range' to 'distance'",
        {"sonar_driver.cpp"},
    ),
    (
        "nodelet/lights_nodelet/src/lights_nodelet.cpp",
        {"colour", "lights_on"},
        "it renames service 'lights_on' to 'lamps_on'",
        {"lights_nodelet.hpp"},
    ),
    (
        "rclcpp/battery_header/src/main.cpp",
        {"battery_state", "Tick"},
        "it renames topic 'battery_state' to 'battery'",
        {"battery.hpp"},
    ),
    (
        "component/health/src/cpu_health.cpp",
        {"cpu/load", "sample", "limit"},
        "subscribe it to 'extra' of message_type String",
        {"cpu_health.cpp", "cpu_health.hpp"},
    ),
]


@pytest.mark.parametrize(
    ("file", "shown", "statement", "changed"),
    LOADED,
    ids=[each[0].partition("/")[0] for each in LOADED],
)
def test_a_node_that_somebody_wrote_is_shown_with_its_changes(
    file: str, shown: set[str], statement: str, changed: set[str], tmp_path: Path
) -> None:
    library, folder, inner = file.split("/", 2)
    shutil.copytree(NODES / library / folder, tmp_path / folder)
    text = f"load '{folder}/{inner}' as it\n{{}}generate_node it\n"
    path = tmp_path / "robot.plastron"
    entries = _nodes(analysis_of(text.format(""), path), None).all
    assert {each.text for each in entries[1:]} == shown
    previews = previews_of(analysis_of(text.format(f"{statement}\n"), path), "it")
    assert {Path(each.name).name for each in previews if each.diff} == changed


def test_a_header_that_belongs_to_a_node_is_not_offered(tmp_path: Path) -> None:
    for each in ("nodelet/lights_nodelet", "roscpp/sonar_driver", "roscpp/talker.cpp"):
        copy = shutil.copy if each.endswith(".cpp") else shutil.copytree
        copy(NODES / each, tmp_path / Path(each).name)
    found = {path.name: library for path, library in _node_files(tmp_path)}
    assert found == {
        "talker.cpp": "roscpp",
        "lights_nodelet.cpp": "nodelet",
        "sonar_driver.cpp": "roscpp",
    }


async def test_the_preview_begins_with_the_source_of_each_node(tmp_path: Path) -> None:
    path = tmp_path / "robot.plastron"
    text = PROGRAM.format("component", "rclpy")
    path.write_text(text)
    async with studio(path) as driver:
        await driver.show("preview")
        panel = driver.main.panels["preview"]
        await driver.until(lambda: panel.current is not None)
        assert panel.current.name == "src/talker_pub.cpp"
        await driver.pilot.press("n", "n")
        assert panel.current.name == "CMakeLists.txt"
        driver.main.editor.go_to(text.index("generate_node script"))
        await driver.until(lambda: panel.current.name == "scripts/script_sub1.py")
        assert "rclpy" in panel.text
