"""What reviewers found wrong in edits of packages: a table of patches, and of refusals."""

from __future__ import annotations

import pytest
from additions import parameter, publish, repeat, subscribe
from patches import check

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Publisher, Rate, Subscription, Timer, kind_of
from plastron_tui.model.source import Change, EndpointKind, Remove, Update
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.qos import Qos

K = EndpointKind
AT = Span(0, 0)
IMAGE = InterfaceName("sensor_msgs", "Image")
NUMBER = InterfaceName("std_msgs", "Int32")
BEST = Qos(depth=7, reliability="best_effort")


def repeats(name: str, hertz: float) -> Update:
    return Update(kind_of(Timer), name, Timer(name, None, Rate(hertz), AT), AT)


PATCHES = [
    pytest.param(
        Update(K.SUBSCRIPTION, "image", Subscription("image", IMAGE, None, AT, BEST), AT),
        """
 #include <rclcpp/rclcpp.hpp>
 #include <message_filters/subscriber.h>
 #include <sensor_msgs/msg/image.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a"),
-    images_(this, "image", rclcpp::QoS(1).get_rmw_qos_profile()) {
+    images_(this, "image", rclcpp::QoS(7).best_effort().get_rmw_qos_profile()) {
   }
   message_filters::Subscriber<sensor_msgs::msg::Image> images_;
 };
""",
        id="a profile of rmw stays one",
    ),
    pytest.param(
        Update(K.PUBLISHER, "image", Publisher("image", IMAGE, (), AT, BEST), AT),
        """
 #include <rclcpp/rclcpp.hpp>
 #include <image_transport/image_transport.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     rmw_qos_profile_t qos = rmw_qos_profile_default;
-    pub_ = image_transport::create_publisher(this, "image", qos);
+    pub_ = image_transport::create_publisher(
+      this, "image", rclcpp::QoS(7).best_effort().get_rmw_qos_profile());
   }
   image_transport::Publisher pub_;
 };
""".replace(
            "\n+    pub_ = image_transport::create_publisher(\n+      this",
            "\n+    pub_ = image_transport::create_publisher(this",
        ),
        id="a profile of rmw in a variable stays one",
    ),
    pytest.param(
        publish("image", "sensor_msgs/Image", once=True, height=1),
        """
+#include <chrono>
+#include <functional>
+
 #include <rclcpp/rclcpp.hpp>
 #include <sensor_msgs/msg/image.hpp>
 #include <image_transport/image_transport.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     _pub = image_transport::create_publisher(
       this, "image", rclcpp::QoS(1).transient_local().get_rmw_qos_profile());
+    _image_timer = create_wall_timer(
+      std::chrono::milliseconds(200), std::bind(&A::publish_image, this));
   }

  private:
+  void publish_image() {
+    const bool was_heard = _image_is_heard;
+    _image_is_heard = _pub.getNumSubscribers() > 0;
+    if (was_heard && _image_is_heard) {
+      // A subscription that is there for so long knows this publisher too.
+      _image_timer->cancel();
+      sensor_msgs::msg::Image message;
+      message.height = 1;
+      message.header.stamp = now();
+      _pub.publish(message);
+    }
+  }
+
   image_transport::Publisher _pub;
+  rclcpp::TimerBase::SharedPtr _image_timer;
+  bool _image_is_heard = false;
 };
""",
        id="who listens is counted as image_transport does",
    ),
    pytest.param(
        repeat("tick", 4.0),
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 ros::Publisher pub;
+
+void tick(const ros::TimerEvent&)
+{
+  ROS_INFO("tick ticks");
+}
+
 int main(int argc, char** argv)
 {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
   bool is_first = true;
+  ros::Timer tick_timer = nh.createTimer(ros::Duration(0.25), tick);
   // Try again and again.
   while (ros::ok())
   {
     ros::ServiceServer server = nh.advertiseService("reset", reset);
     while (ros::ok()) ros::spinOnce();
   }
 }
""",
        id="what stands behind a loop that ends with the node is never done",
    ),
    pytest.param(
        repeats("tick", 3.0),
        """
 #include <ros/ros.h>
 class A {
  public:
   A() {
     if (rate_ > 0)
     {
-      timer_ = nh_.createTimer(ros::Duration(1.0 / rate_), &A::tick, this);
+      timer_ = nh_.createTimer(ros::Duration(1.0 / 3.0), &A::tick, this);
     }
   }
   void tick(const ros::TimerEvent&) { count_++; }
   ros::NodeHandle nh_;
   ros::Timer timer_;
   double rate_;
   int count_;
 };
""",
        id="a period is changed where it is computed, under its condition",
    ),
    pytest.param(
        repeats("tick", 4.0),
        """
 #include <ros/ros.h>
 class A {
  public:
   A() {
-    timer_ = nh_.createTimer(ros::Duration(1.0), &A::tick, this);
+    timer_ = nh_.createTimer(ros::Duration(0.25), &A::tick, this);
   }
   void faster(double rate) {
     timer_ = nh_.createTimer(ros::Duration(1.0 / rate), &A::tick, this);
   }
   void tick(const ros::TimerEvent&) { count_++; }
   ros::NodeHandle nh_;
   ros::Timer timer_;
   int count_;
 };
""",
        id="a timer that is created again at a computed rate keeps that",
    ),
    pytest.param(
        parameter("count", "int", 2),
        """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class Sender {
  public:
   Sender(rclcpp::Node & node, const std::string & topic)
   {
     pub_ = node.create_publisher<std_msgs::msg::String>(topic, 1);
+    if (!node.has_parameter("count")) {
+      node.declare_parameter<int64_t>("count", 2);
+    }
   }
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };
""",
        id="objects that share a node declare a parameter once",
    ),
    pytest.param(
        Update(K.SUBSCRIPTION, "in", Subscription("in", NUMBER, None, AT), AT),
        """
 #include <ros/ros.h>
 #include <std_msgs/Bool.h>
+#include <std_msgs/Int32.h>
 void heard(const std_msgs::Bool& msg) { ROS_INFO_STREAM(msg); }
+void inCallback(const std_msgs::Int32& msg) {
+  ROS_INFO_STREAM("in: " << msg);
+}
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
   ros::Subscriber sub;
-  if (argc > 1) { sub = nh.subscribe("in", 1, heard); }
-  else { sub = nh.subscribe("in", 2, heard); }
+  if (argc > 1) { sub = nh.subscribe("in", 1, inCallback); }
+  else { sub = nh.subscribe("in", 2, inCallback); }
   ros::spin();
 }
""",
        id="what two calls have in common is written once",
    ),
    pytest.param(
        Remove(K.PARAMETER, "~/rate"),
        """
 #include <ros/ros.h>
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh("~");
-  double rate;
-  nh.param("rate", rate, 10.0);
+  double rate = 10.0;
   ros::Rate pause(rate);
   while (ros::ok()) pause.sleep();
 }
""",
        id="a default is the first value of what is declared just above",
    ),
    pytest.param(
        publish("odom", "nav_msgs/Odometry"),
        """
 #include "rclcpp/rclcpp.hpp"

+#include "nav_msgs/msg/odometry.hpp"
 #include "nav_msgs/msg/path.hpp"

 #include "std_srvs/srv/trigger.hpp"
 int main(int argc, char** argv) {
   rclcpp::init(argc, argv);
   auto node = rclcpp::Node::make_shared("a");
+  auto odom_pub = node->create_publisher<nav_msgs::msg::Odometry>("odom", 10);
 }
""",
        id="types of one package are included together",
    ),
    pytest.param(
        publish("out", data="hi"),
        """
+#include <chrono>
+
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 using namespace std::chrono_literals;

 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     if (declare_parameter("debug", false)) {
       pub_ = create_publisher<std_msgs::msg::String>("out", 1);
+      out_timer_ = create_wall_timer(100ms, std::bind(&A::publish_out, this));
     }
     timer_ = create_wall_timer(1s, std::bind(&A::tick, this));
   }

  private:
   void tick() {
     count_++;
   }

+  void publish_out() {
+    std_msgs::msg::String message;
+    message.data = "hi";
+    pub_->publish(message);
+  }
+
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
   rclcpp::TimerBase::SharedPtr timer_;
+  rclcpp::TimerBase::SharedPtr out_timer_;
   int count_;
 };
""",
        id="what is sent stands under the condition of what sends it",
    ),
    pytest.param(
        subscribe("imu"),
        """
+#include <functional>
+
 #include <rclcpp/rclcpp.hpp>
+#include <sensor_msgs/msg/imu.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     pub_ = create_publisher<std_msgs::msg::String>("out", 1);
+    imu_sub_ = create_subscription<sensor_msgs::msg::Imu>(
+      "imu", 10, std::bind(&A::on_imu, this, std::placeholders::_1));
     frame_ = declare_parameter("frame", "map");
   }

  private:
+  void on_imu(const sensor_msgs::msg::Imu::SharedPtr msg) {
+    RCLCPP_INFO(get_logger(), "imu: %s", to_yaml(*msg).c_str());
+  }
+
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
+  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_sub_;

   std::string frame_;
   std::string other_frame_;
 };
""",
        id="an endpoint stands with the endpoints, and not with the parameters",
    ),
]


@pytest.mark.parametrize(("change", "patch"), PATCHES)
def test_an_edit_is_as_a_maintainer_writes_it(change: Change, patch: str) -> None:
    check(patch, change)
