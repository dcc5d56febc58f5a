"""Strings that are written into files that are not in UTF-8: what ROS sends is."""

from __future__ import annotations

from patches import edit, sides

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Message, Publication, Publisher
from plastron_tui.model.source import Add, FileSet
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName

AT = Span(0, 0)
TYPE = InterfaceName("std_msgs", "String")
TEXT = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 // é
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
   ros::Publisher a = nh.advertise<std_msgs::String>("a", 1);
   ros::spin();
 }
"""


def written(encoding: str, said: str) -> bytes:
    """Return a file of an encoding with a publisher that sends a text."""
    (name, text), *_ = sides(TEXT)[0].texts
    files = FileSet(((name, text.decode().encode(encoding)),))
    value = MessageValue(TYPE, {"data": said})
    sent = Publication(Message("m", value, AT), 10.0, AT)
    changed, told = edit(files, Add(Publisher("b", TYPE, (sent,), AT)))
    assert changed is not None, told
    return changed.texts[0][1]


def test_new_strings_are_utf_8_in_any_file() -> None:
    assert b'data = "caf\\303\\251 \\342\\202\\254";' in written("latin-1", "café €")
    assert 'data = "café €";'.encode() in written("utf-8", "café €")
