"""What reviewers found wrong in edits of packages, and is refused or told."""

from __future__ import annotations

import pytest
from additions import publish, subscribe
from patches import edit, read, refusal, sides

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Rate, Timer, kind_of
from plastron_tui.model.source import EndpointKind, Remove, Update

K = EndpointKind
AT = Span(0, 0)


def test_a_period_that_other_code_gives_anew_is_not_changed() -> None:
    text = """
 #include <ros/ros.h>
 class A {
  public:
   A() {
     timer_ = nh_.createTimer(ros::Duration(1.0), &A::tick, this, false, false);
     nh_.param("rate", rate_, 10.0);
     timer_.setPeriod(ros::Duration(1.0 / rate_), false);
     timer_.start();
   }
   void tick(const ros::TimerEvent&) { count_++; }
   ros::NodeHandle nh_;
   ros::Timer timer_;
   double rate_;
   int count_;
 };
"""
    assert "used in line 7" in refusal(
        text, Update(kind_of(Timer), "tick", Timer("tick", None, Rate(3.0), AT), AT)
    )


def test_what_several_functions_create_is_not_sent_in_one_of_them() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class A {
  public:
   void startLive() { pub_ = nh_.advertise<std_msgs::String>("map", 1, true); }
   void startReplay() { pub_ = nh_.advertise<std_msgs::String>("map", 1, true); }
   ros::NodeHandle nh_;
   ros::Publisher pub_;
 };
"""
    said = refusal(text, publish("map", rate=3.0, data="x"))
    assert "lines 5, 6 create `map` in functions of which any may run" in said


SPINNING = [
    pytest.param("ros::spin();", True, id="it spins"),
    pytest.param("while (ros::ok()) { ros::spinOnce(); }", True, id="it spins in a loop"),
    pytest.param("ros::AsyncSpinner hands(2); hands.start();", True, id="others spin"),
    pytest.param("Robot robot; robot.run();", True, id="what runs may spin"),
    pytest.param("write(nh);", False, id="it ends"),
]


@pytest.mark.parametrize(("line", "is_called"), SPINNING)
def test_what_nothing_would_call_is_not_added(line: str, is_called: bool) -> None:
    text = f"""
 #include <ros/ros.h>
 int main(int argc, char** argv)
 {{
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
   {line}
   return 0;
 }}
"""
    files, told = edit(sides(text)[0], subscribe("imu"))
    assert (files is not None) is is_called
    said = ["`main` in line 2 does not spin, so that `imuCallback` would not be called"]
    assert [each.message for each in told] == ([] if is_called else said)


def test_a_lambda_that_nothing_calls_any_more_is_told() -> None:
    text = """
 #include <rclcpp/rclcpp.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     auto tick = [this]() { count_++; };
     timer_ = create_wall_timer(std::chrono::seconds(1), tick);
   }
   rclcpp::TimerBase::SharedPtr timer_;
   int count_;
 };
"""
    (timer,) = (each for each in read(sides(text)[0]).endpoints if each.kind is K.TIMER)
    files, told = edit(sides(text)[0], Remove(K.TIMER, timer.callback or ""))
    assert files is not None, told
    assert [each.message for each in told] == ["nothing in the file calls `tick` (line 5) any more"]
