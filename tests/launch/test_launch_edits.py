"""Launch files in XML that are changed in place."""

from __future__ import annotations

import pytest

from plastron_tui.ros.launch import Argument, Include, Item, Remapping, StartedNode
from plastron_tui.ros.launch_text import package_file, text
from plastron_tui.sources.launch.edits import add, remove
from plastron_tui.sources.xml.document import XmlDocument, read_xml

TALKER = StartedNode(
    text("demo"),
    text("talker"),
    text("talker"),
    remaps=(Remapping(text("chatter"), text("hello")),),
)
ITEMS: list[tuple[Item, str]] = [
    (TALKER, "talker"),
    (Argument("speed", text("0.5")), "speed"),
    (Include(package_file("demo", "launch/more.launch")), "demo/more.launch"),
]
ROS1 = """<?xml version="1.0"?>
<launch>
    <!-- what starts the robot -->
    <arg name='front' default='true' />

    <node pkg='rover' type='driver' name='driver' output='screen' /> <!-- wheels -->
    <group ns='front'>
        <node pkg='rover' type='laser' name='laser' />
    </group>
</launch>
"""
ROS2 = (
    '<launch>\r\n\t<let name="a" value="1"/>\r\n'
    '\t<node pkg="rover" exec="driver"/>\r\n</launch>\r\n'
)
EMPTY = "<launch>\n</launch>\n"


def _document(source: str) -> XmlDocument:
    found = read_xml(source.encode()).document
    assert found is not None
    return found


@pytest.mark.parametrize("item, name", ITEMS, ids=[name for _, name in ITEMS])
@pytest.mark.parametrize("source, ros_version", [(ROS1, 1), (ROS2, 2), (EMPTY, 1), (EMPTY, 2)])
def test_what_is_added_and_taken_out_leaves_no_trace(
    source: str, ros_version: int, item: Item, name: str
) -> None:
    added = add(_document(source), item, ros_version)
    assert added.document is not None, added.diagnostics
    removed = remove(added.document, type(item), name, ros_version)
    assert removed.document is not None, removed.diagnostics
    assert removed.document.text == source.encode()


def test_a_node_is_written_as_the_file_writes_them() -> None:
    added = add(_document(ROS1), TALKER, 1)
    assert added.document is not None
    expected = ROS1.replace(
        "<!-- wheels -->\n",
        "<!-- wheels -->\n    <node pkg='demo' type='talker' name='talker'>\n"
        "        <remap from='chatter' to='hello' />\n    </node>\n",
    )
    assert added.document.text.decode() == expected


ROSPARAM = '<rosparam subst_value="true">rate: $(arg rate)</rosparam>'


@pytest.mark.parametrize(
    ("ros_version", "words", "used"),
    [
        (2, '<node pkg="p" exec="$(var rate)"/>', "$(var rate)"),
        (2, '<node pkg="p" exec="a" args="$(var  rate)"/>', "$(var  rate)"),
        (2, """<node pkg="p" exec="$(var 'rate')"/>""", "$(var 'rate')"),
        (2, """<node pkg="p" exec="$(env E $(var rate))"/>""", "$(env E $(var rate))"),
        (2, """<node pkg="p" exec="$(eval '$(var rate) + 1')"/>""", "$(eval '$(var rate) + 1')"),
        (2, '<let name="b" value="$(var $(var rate))"/>', "$(var $(var rate))"),
        (2, '<node pkg="p" exec="$(var rates)"/>', None),
        (2, '<node pkg="p" exec="a" args="rate $(eval 1)"/>', None),
        (2, """<node pkg="p" exec="$(eval 'rates')"/>""", None),
        (1, '<node pkg="p" type="$(arg rate)" name="n"/>', "$(arg rate)"),
        (1, """<param name="a" value="$(eval arg('rate'))"/>""", "$(eval arg('rate'))"),
        (1, '<param name="a" value="$(eval rate + 1)"/>', "$(eval rate + 1)"),
        (1, ROSPARAM, "rate: $(arg rate)"),
        (1, '<group><node pkg="a" type="b" name="c" if="$(arg rate)"/></group>', "$(arg rate)"),
        (1, "<rosparam>rate: 1</rosparam><!-- $(arg rate) -->", None),
    ],
)
def test_an_argument_that_is_used_stays(ros_version: int, words: str, used: str | None) -> None:
    source = f'<launch><arg name="rate" default="$(env A)"/>{words}</launch>'
    removed = remove(_document(source), Argument, "rate", ros_version)
    if used is None:
        assert removed.document is not None, removed.diagnostics
        return
    assert removed.document is None
    (refused,) = removed.diagnostics
    assert refused.message == "`rate` is still used here, and cannot be taken out"
    assert refused.span is not None
    assert source[refused.span.start : refused.span.end] == used


@pytest.mark.parametrize(
    "before, after",
    [
        ("<launch>\n  {}\n</launch>\n", "<launch>\n</launch>\n"),
        ("<launch>\r\n  {}\r\n</launch>\r\n", "<launch>\r\n</launch>\r\n"),
        ("<launch>{}</launch>\n", "<launch></launch>\n"),
        ("<launch>\n  <!-- eyes -->\n  {}\n</launch>", "<launch>\n  <!-- eyes -->\n</launch>"),
    ],
)
def test_a_file_is_open_when_its_only_node_is_gone(before: str, after: str) -> None:
    full = before.format('<node pkg="demo" exec="ear" name="ear"/>')
    removed = remove(_document(full), StartedNode, "ear", 2)
    assert removed.document is not None
    assert removed.document.text.decode() == after
    ear = StartedNode(text("demo"), text("ear"), text("ear"))
    again = add(removed.document, ear, 2)
    assert again.document is not None
    assert again.document.text.decode() == full
