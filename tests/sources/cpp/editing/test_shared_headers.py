"""Headers that other sources of a package include too."""

from __future__ import annotations

from pathlib import Path

from patches import CATALOGS

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import Change, EndpointKind, FileSet, Remove, Update
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources import find_language
from plastron_tui.sources.cpp.editing.editor import edit_cpp

K = EndpointKind

HEADER = b"""\
#pragma once
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

class Driver {
 public:
  Driver();
  void step();
  ros::NodeHandle nh_;
  ros::Publisher out_ = nh_.advertise<std_msgs::String>("out", 1);
};
"""
MAIN = b"""\
#include "driver.h"

void heard(const std_msgs::Bool& msg) { ROS_INFO_STREAM(msg); }

int main(int argc, char** argv) {
  ros::init(argc, argv, "driver");
  Driver driver;
  ros::Subscriber sub = driver.nh_.subscribe("in", 1, heard);
  ros::spin();
}
"""
OTHER = b"""\
#include "driver.h"

Driver::Driver() {}

void Driver::step() {
  std_msgs::String text;
  out_.publish(text);
}
"""


def edit(
    folder: Path, change: Change, header: bytes = HEADER, other: bytes = OTHER
) -> tuple[FileSet | None, tuple[Diagnostic, ...]]:
    for name, text in {"main.cpp": MAIN, "driver.h": header, "step.cpp": other}.items():
        (folder / name).write_bytes(text)
    path, language = folder / "main.cpp", find_language("cpp")
    others = language.others(path, MAIN)
    files = FileSet.gather(
        path, MAIN, others, lambda each: each.read_bytes() if each.is_file() else None
    )
    source = language.read(path, files).source
    assert source is not None
    rendered = edit_cpp(source, [change], CATALOGS[1])
    return rendered.files, rendered.diagnostics


def test_what_another_source_uses_stays(tmp_path: Path) -> None:
    files, told = edit(tmp_path, Remove(K.PUBLISHER, "out"))
    assert files is None
    assert told[0].message == "the publisher `out` is used in line 7 of `step.cpp`"


def test_what_a_source_of_another_folder_uses_stays(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package/>\n")
    (tmp_path / "src").mkdir()
    (tmp_path / "tools").mkdir()
    text = b'#include "driver.h"\n\nvoid stop(Driver& driver) { driver.out_.shutdown(); }\n'
    (tmp_path / "tools" / "stop.cpp").write_bytes(text)
    header = HEADER.replace(b"  void step();\n", b"").replace(b"Driver();", b"Driver() = default;")
    files, told = edit(tmp_path / "src", Remove(K.PUBLISHER, "out"), header, b"")
    assert files is None
    assert told[0].message == "`out_` of `driver.h` is used in line 3 of `stop.cpp`"


def test_what_a_header_includes_for_others_stays(tmp_path: Path) -> None:
    files, told = edit(tmp_path, Remove(K.SUBSCRIPTION, "in"))
    assert files is not None, told
    assert files.get("driver.h") == HEADER and b"heard" not in files.main


def test_what_a_header_includes_for_others_stays_beside_another_type(tmp_path: Path) -> None:
    string = InterfaceName("std_msgs", "Int32")
    change = Update(K.SUBSCRIPTION, "in", Subscription("in", string, None, Span(0, 0)))
    files, told = edit(tmp_path, change)
    assert files is not None, told
    assert files.get("driver.h") == HEADER and b"#include <std_msgs/Int32.h>" in files.main
