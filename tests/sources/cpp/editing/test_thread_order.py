"""A call of ROS 1 has a thread of its own: its timer goes before its queue, which it still asks.

roscpp's `ros::Timer` takes what is pending out of the callback queue as it is destroyed: on a queue
that has gone, the node ends with an abort.
"""

from __future__ import annotations

import re

import pytest
from additions import request
from patches import edit, shown

from plastron_tui.model.source import FileSet

MEMBER = """#include <ros/ros.h>
#include <std_msgs/Bool.h>

class Gate {
 public:
  Gate() {
    timer_ = nh_.createTimer(ros::Duration(1.0), &Gate::tick, this);
    gate_pub_ = nh_.advertise<std_msgs::Bool>("gate", 1);
  }

 private:
  void tick(const ros::TimerEvent&) { ++count_; }

  ros::NodeHandle nh_;
  ros::Timer timer_;
  ros::Publisher gate_pub_;
  int count_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "gate");
  Gate gate;
  ros::spin();
}
"""
GLOBAL = """#include <ros/ros.h>

ros::Timer timer;
int count = 0;

void tick(const ros::TimerEvent&) { ++count; }

int main(int argc, char** argv) {
  ros::init(argc, argv, "gate");
  ros::NodeHandle nh;
  timer = nh.createTimer(ros::Duration(1.0), tick);
  ros::spin();
}
"""
FUNCTION = GLOBAL.replace(
    "int main(int argc, char** argv) {\n",
    "void setup(ros::NodeHandle& nh) {\n  timer = nh.createTimer(ros::Duration(1.0), tick);\n}\n\n"
    "int main(int argc, char** argv) {\n",
).replace("  timer = nh.createTimer(ros::Duration(1.0), tick);\n  ros", "  setup(nh);\n  ros")


@pytest.mark.parametrize(
    ("before", "kept"),
    [
        pytest.param(MEMBER, "", id="members, with a timer above the others"),
        pytest.param(GLOBAL, "", id="variables of the file"),
        pytest.param(FUNCTION, "static ", id="a function that returns"),
    ],
)
def test_timer_goes_before_its_queue(before: str, kept: str) -> None:
    files, _ = edit(FileSet.single(".cpp", before.encode()), request("ask", data=True))
    after = shown(files)
    declared = re.findall(r"^  (static )?ros::(\w+) ask_?\w*(?=[ ;({])", after, re.MULTILINE)
    kinds = [kind for _, kind in declared if kind != "ServiceClient"]
    assert kinds == ["CallbackQueue", "AsyncSpinner", "NodeHandle", "Timer"]
    assert {static for static, kind in declared if kind != "ServiceClient"} == {kept}
