"""Statements of C++ that create several endpoints, and places that several functions make."""

from __future__ import annotations

import pytest
from additions import parameter, publish, subscribe
from patches import check, edit, refusal, sides

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Message, Publication, Publisher
from plastron_tui.model.source import Add, EndpointKind, Remove
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName

K = EndpointKind

CAMERA = """
 #include <image_transport/image_transport.hpp>
 #include <rclcpp/rclcpp.hpp>

 class Camera : public rclcpp::Node
 {
 public:
   Camera() : Node("camera")
   {
-    camera_ = image_transport::create_camera_publisher(this, "image_raw");
     start();
   }

 private:
-  image_transport::CameraPublisher camera_;
   int frames_;
 };
"""

SAMPLER = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 class Sampler : public rclcpp::Node
 {
 public:
   Sampler() : Node("sampler")
   {
     declare_parameter("depth", 10);
-    pub_ = create_publisher<std_msgs::msg::String>("out", get_parameter("depth").as_int());
     sub_ = create_subscription<std_msgs::msg::String>(
       "in", get_parameter("depth").as_int(), [](const std_msgs::msg::String &) {});
   }

 private:
-  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
 };
"""

LAYER = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

 class Layer : public costmap_2d::VoxelLayer
 {
 public:
   virtual void onInitialize();

 private:
   ros::Publisher pub_;
 };

 void Layer::onInitialize()
 {
   VoxelLayer::onInitialize();
   ros::NodeHandle nh("~/");
   pub_ = nh.advertise<std_msgs::String>("out", 1);
 }
"""

COMPONENT = """

 #include "camera.hpp"

 namespace camera
 {
 Camera::Camera(const rclcpp::NodeOptions & options) : Node("camera", options)
 {
   pub_ = create_publisher<std_msgs::msg::String>("out", 10);
 }
 }  // namespace camera

 #include "rclcpp_components/register_node_macro.hpp"
 RCLCPP_COMPONENTS_REGISTER_NODE(camera::Camera)
"""

RATES = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 class Sender : public rclcpp::Node
 {
 public:
   Sender() : Node("sender")
   {
     declare();
     pub_ = create_publisher<std_msgs::msg::String>("out", 10);
   }

 private:
   void declare()
   {
     declare_parameter("rate", 2.5);
   }

   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };
"""


def removal(kind: EndpointKind, name: str) -> Remove:
    return Remove(kind, name)


def test_what_one_call_creates_goes_together() -> None:
    both = [removal(K.PUBLISHER, "image_raw"), removal(K.PUBLISHER, "camera_info")]
    check(CAMERA, *both)
    check(CAMERA, *reversed(both))


def test_a_part_of_what_one_call_creates_is_refused_with_the_other_part() -> None:
    assert refusal(CAMERA, removal(K.PUBLISHER, "image_raw")) == (
        "edit-refused: line 9 creates the publisher `image_raw` with the publisher `camera_info`"
    )


def test_a_parameter_that_a_statement_only_reads_stays() -> None:
    check(SAMPLER, removal(K.PUBLISHER, "out"))


def test_a_parameter_that_only_a_statement_declares_is_told() -> None:
    text = SAMPLER.replace('get_parameter("depth").as_int());', 'declare_parameter("size", 3));')
    assert refusal(text, removal(K.PUBLISHER, "out")) == (
        "edit-refused: line 10 creates the publisher `out` with the parameter `size`"
    )


def test_a_function_that_calls_its_base_is_called_once() -> None:
    files, told = edit(sides(LAYER)[0], publish("more"))
    assert files is not None, told
    assert files.main.count(b"advertise<") == 2


def test_an_include_goes_before_what_needs_it() -> None:
    files, told = edit(sides(COMPONENT)[0], subscribe("imu"))
    assert files is not None, told
    assert files.main.index(b"sensor_msgs/msg/imu.hpp") < files.main.index(b"namespace")


def test_a_rate_follows_the_function_that_declares_its_parameter() -> None:
    string = InterfaceName("std_msgs", "String")
    message = Message("m", MessageValue(string, {"data": "hi"}), Span(0, 0))
    sent = Publication(message, 0.0, Span(0, 0), parameter="rate")
    files, told = edit(sides(RATES)[0], Add(Publisher("word", string, (sent,), Span(0, 0))))
    assert files is not None, told
    text = files.main
    declared = text.index(b'declare_parameter("rate"')
    assert (
        declared < text.index(b'get_parameter("rate").as_double()') < text.index(b"  }\n", declared)
    )


def test_a_parameter_is_declared_beside_the_others() -> None:
    files, told = edit(sides(RATES)[0], parameter("gain", "float", 0.5))
    assert files is not None, told
    assert files.main.index(b'"rate"') < files.main.index(b'"gain"')


LISTENED = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

 class Mapper {
  public:
   Mapper() {
-    pub_ = nh_.advertise<std_msgs::String>("out", 1);
     other_ = nh_.advertise<std_msgs::String>("other", 1);
   }

-  void send(const Cloud& cloud) {
+  void send(const Cloud& /*cloud*/) {
-    // for those who look
-    if (CONDITION) {
-      std_msgs::String text;
-      convert(cloud, text);
-      for (int at = 0; at < limit_; at++) text.data += words(at);
-      pub_.publish(text);
-    }
-
     std_msgs::String more;
     other_.publish(more);
   }

  private:
   ros::NodeHandle nh_;
-  ros::Publisher pub_;
   ros::Publisher other_;
   int limit_;
 };
"""


@pytest.mark.parametrize(
    "condition",
    ["pub_.getNumSubscribers()", "pub_.getNumSubscribers() > 0", "0 < pub_.getNumSubscribers()",
     "pub_.getNumSubscribers() != 0u", "this->pub_.getNumSubscribers() >= 1"],
)  # fmt: skip
def test_what_is_done_for_listeners_goes_with_their_topic(condition: str) -> None:
    check(LISTENED.replace("CONDITION", condition), removal(K.PUBLISHER, "out"))


@pytest.mark.parametrize(
    ("condition", "more"),
    [("pub_.getNumSubscribers() == 0", ""), ("pub_.getNumSubscribers() > 0 || more()", ""),
     ("pub_.getNumSubscribers() > 0", "other_.publish(text);")],
)  # fmt: skip
def test_what_is_not_only_for_listeners_is_in_use(condition: str, more: str) -> None:
    text = LISTENED.replace("CONDITION", condition)
    text = text.replace("pub_.publish(text);\n", f"pub_.publish(text); {more}\n")
    assert refusal(text, removal(K.PUBLISHER, "out")) == (
        "endpoint-in-use: the publisher `out` is used in line 13"
    )
