"""Parameters that are taken out of C++ nodes: where their values are used, defaults stay."""

from __future__ import annotations

import pytest
from patches import check, refusal

from plastron_tui.model.source import EndpointKind, Remove

ROSCPP = """
 #include <ros/ros.h>
 #include <std_msgs/Float64.h>

 class Driver {{
  public:
   Driver() : nh_("~") {{
{}
     pub_ = nh_.advertise<std_msgs::Float64>("out", 1);
   }}

   void run(double given) {{ use(port_, given * speed_, count_); }}

  private:
   ros::NodeHandle nh_;
   ros::Publisher pub_;
   std::string port_ = "none";
   double speed_;
   int count_;
 }};
"""

ROS_1 = [
    (
        "read into a member with a default",
        "~/speed",
        """\
-    nh_.param("speed", speed_, 0.5);  // m/s
+    speed_ = 0.5;  // m/s""",
    ),
    (
        "read into a member with a default of a written type",
        "~/port",
        """\
-    nh_.param<std::string>("port", port_, "/dev/ttyUSB0");
+    port_ = "/dev/ttyUSB0";""",
    ),
    (
        "read in an assignment",
        "~/count",
        """\
-    count_ = nh_.param<int>("count", 3);
+    count_ = 3;""",
    ),
    (
        "read in what an expression computes",
        "~/speed",
        """\
-    speed_ = 2 * nh_.param<double>("speed", 1);
+    speed_ = 2 * 1.0;""",
    ),
    (
        "read as an argument, where a literal is of another type",
        "~/port",
        """\
-    open(nh_.param<std::string>("port", "/dev/ttyUSB0"), nh_.param("rate", 9600));
+    open(std::string("/dev/ttyUSB0"), nh_.param("rate", 9600));""",
    ),
    (
        "a default that is computed",
        "~/speed",
        """\
     double most = 4.0;
-    speed_ = 3 * nh_.param("speed", most - 1.0);
+    speed_ = 3 * (most - 1.0);""",
    ),
    (
        "its own value as the default",
        "~/port",
        """\
-    nh_.param("port", port_, port_);
     ROS_INFO("starts");""",
    ),
    (
        "read over a value that is there",
        "~/port",
        """\
-    nh_.getParam("port", port_);
     ROS_INFO("starts");""",
    ),
    (
        "set where nobody has set it",
        "~/speed",
        """\
-    if (!nh_.getParam("speed", speed_)) {
-      ROS_WARN("no speed is set");
-      speed_ = 0.5;
-    }
+    speed_ = 0.5;""",
    ),
    (
        "set where nobody has set it, without braces",
        "~/count",
        """\
-    if (!nh_.getParam("count", count_))
-      count_ = 3;
+    count_ = 3;""",
    ),
    (
        "read where it is set, over a value that is there",
        "~/port",
        """\
-    if (nh_.hasParam("port")) {
-      nh_.getParam("port", port_);
-    }
     ROS_INFO("starts");""",
    ),
]

RCLCPP = """
 #include <rclcpp/rclcpp.hpp>

 class Driver : public rclcpp::Node
 {{
 public:
   Driver() : Node("driver")
   {{
{}
   }}

   void run(double given) {{use(port_, given * speed_, count_);}}

 private:
   std::string port_;
   double speed_ = 0.0;
   int count_;
 }};
"""

ROS_2 = [
    (
        "what a declaration gives",
        "speed",
        """\
-    speed_ = this->declare_parameter("speed", 0.5);
+    speed_ = 0.5;""",
    ),
    (
        "declared, and read behind it",
        "speed",
        """\
-    declare_parameter<double>("speed", 0.5);
-    speed_ = get_parameter("speed").as_double();
+    speed_ = 0.5;""",
    ),
    (
        "declared, and read into a member",
        "port",
        """\
-    declare_parameter("port", "/dev/ttyUSB0");
-    get_parameter("port", port_);
+    port_ = "/dev/ttyUSB0";""",
    ),
    (
        "declared with a value object, and read through one",
        "count",
        """\
-    declare_parameter("count", rclcpp::ParameterValue(3));
-    auto count = get_parameter("count").get_parameter_value().get<int>();
+    auto count = int64_t{3};
     count_ = count;""",
    ),
    (
        "with a descriptor, in a list of arguments",
        "port",
        """\
-    rcl_interfaces::msg::ParameterDescriptor port;
-    port.description = "where the driver is";
-    open(declare_parameter("port", "/dev/ttyUSB0", port), 3);
+    open(std::string("/dev/ttyUSB0"), 3);""",
    ),
    (
        "cast",
        "count",
        """\
-    count_ = static_cast<int>(declare_parameter("count", 3));
+    count_ = static_cast<int>(3);""",
    ),
    (
        "with another one of no default",
        "speed",
        """\
-    get_parameter_or("speed", speed_, 0.5);
+    speed_ = 0.5;
     port_ = declare_parameter<std::string>("port");""",
    ),
    (
        "declared where it is not declared yet",
        "count",
        """\
-    if (!has_parameter("count")) {
-      declare_parameter("count", 3);
-    }
-    get_parameter("count", count_);
+    count_ = 3;""",
    ),
    (
        "a list",
        "speeds",
        """\
-    declare_parameter("speeds", std::vector<double>{0.5, 1.0});
-    auto speeds = get_parameter("speeds").as_double_array();
+    auto speeds = std::vector<double>{0.5, 1.0};
     speed_ = speeds.at(0);""",
    ),
]

REFUSED = [
    (
        ROSCPP,
        "~/speed",
        '     nh_.getParam("speed", speed_);',
        "endpoint-in-use: the parameter `speed` is used in line 11",
    ),
    (
        ROSCPP,
        "~/port",
        '     if (nh_.hasParam("port") || given()) {start();}',
        "edit-refused: line 7 does more than to create it",
    ),
    (
        ROSCPP,
        "~/speed",
        '     if (!nh_.getParam("speed", speed_)) {ROS_ERROR("no speed"); return;}',
        "edit-refused: line 7 does more than to create it",
    ),
    (
        RCLCPP,
        "port",
        '     port_ = declare_parameter<std::string>("port");',
        "endpoint-in-use: the parameter `port` is used in line 11",
    ),
    (
        RCLCPP,
        "count",
        '     declare_parameter("count", 3);\n     auto count = get_parameter("count");\n'
        "     count_ = count.as_int();",
        "endpoint-in-use: the parameter `count` is used in line 10",
    ),
]


def remove(name: str) -> Remove:
    return Remove(EndpointKind.PARAMETER, name)


@pytest.mark.parametrize(
    ("name", "lines"), [each[1:] for each in ROS_1], ids=[each[0] for each in ROS_1]
)
def test_a_default_takes_the_place_of_a_parameter_of_ros_1(name: str, lines: str) -> None:
    check(ROSCPP.format(lines), remove(name))


@pytest.mark.parametrize(
    ("name", "lines"), [each[1:] for each in ROS_2], ids=[each[0] for each in ROS_2]
)
def test_a_default_takes_the_place_of_a_parameter_of_ros_2(name: str, lines: str) -> None:
    check(RCLCPP.format(lines), remove(name))


@pytest.mark.parametrize(("node", "name", "lines", "expected"), REFUSED)
def test_what_is_used_and_has_no_default_stays(
    node: str, name: str, lines: str, expected: str
) -> None:
    assert refusal(node.format(lines), remove(name)) == expected
