"""Messages that are sent without a stamp, or without the name of their frame."""

from __future__ import annotations

import pytest
from message_programs import marked, node, tick, told

HEADERS = {
    "a message whose header nobody touches": (
        "RM205 RM206",
        tick("""
            msg = LaserScan()
            msg.ranges = [1.0]
            self.scans.publish(msg)  # wrong
        """),
    ),
    "a message that is made where it is sent": (
        "RM205 RM206",
        tick("self.scans.publish(LaserScan(ranges=[1.0]))  # wrong"),
    ),
    "a header without a stamp": (
        "RM205",
        tick("""
            msg = LaserScan(header=Header(frame_id='laser'))
            self.scans.publish(msg)  # wrong
            other = LaserScan()
            other.header.frame_id = 'laser'
            self.get_logger().info(f'{other}')
            self.scans.publish(other)  # wrong
        """),
    ),
    "a stamp that a function of the file only looks at": (
        "RM205",
        node("""
            def tick(self):
                msg = LaserScan()
                msg.header.frame_id = 'laser'
                self.age(msg.header.stamp)
                self.scans.publish(msg)  # wrong

            def age(self, stamp):
                seconds = float(stamp.sec)
                return 1.0 - seconds
        """),
    ),
    "one message that is sent at two places": (
        "RM205",
        tick("""
            msg = LaserScan()
            msg.header.frame_id = 'laser'
            self.scans.publish(msg)  # wrong
            self.scans.publish(msg)
        """),
    ),
    "a header without a frame": (
        "RM206",
        tick("""
            msg = LaserScan()
            msg.header.stamp = self.get_clock().now().to_msg()
            self.scans.publish(msg)  # wrong
        """),
    ),
    "an attribute": (
        "RM205",
        node("""
            def tick(self):
                self.scan = LaserScan()
                self.scan.header.frame_id = 'laser'
                self.fill()

            def fill(self):
                self.scan.ranges = [1.0]
                self.scans.publish(self.scan)  # wrong
        """),
    ),
    "a message whose name has another one before and behind": (
        "RM205",
        tick("""
            msg = Point()
            self.points.publish(msg)
            msg = LaserScan()
            msg.header.frame_id = 'laser'
            self.scans.publish(msg)  # wrong
            msg = LaserScan()
            msg.header.stamp, msg.header.frame_id = Time(), 'laser'
            self.scans.publish(msg)
        """),
    ),
    "a stamp that is only looked at, and set too late": (
        "RM205",
        tick("""
            while rclpy.ok():
                msg = LaserScan()
                msg.header.frame_id = 'laser'
                self.get_logger().info(msg.header.stamp)
                self.scans.publish(msg)  # wrong
                msg.header.stamp = Time()
                self.last = msg
        """),
    ),
    "a header that is made for it": (
        "RM205",
        tick("""
            msg = LaserScan()
            msg.header = Header()
            msg.header.frame_id = 'laser'
            self.last = msg
            self.scans.publish(msg)  # wrong
            header = Header()
            header.frame_id = 'laser'
            other = LaserScan()
            other.header = header
            self.scans.publish(other)  # wrong
        """),
    ),
    "a message that a function makes": (
        "RM205",
        node("""
            def scan(self):
                if not self.ready:
                    return None
                scan = LaserScan()
                scan.header.frame_id = 'laser'
                return scan

            def tick(self):
                scan = self.scan()
                if scan is not None:
                    self.scans.publish(scan)  # wrong
                self.scans.publish(self.scan())  # wrong
        """),
    ),
    "an image that cv_bridge makes": (
        "RM205",
        tick("""
            image = self.bridge.cv2_to_imgmsg(self.frame, 'bgr8')
            image.header.frame_id = 'camera'
            self.images.publish(image)  # wrong
        """),
    ),
    "a marker": (
        "RM206",
        tick("""
            gone = Marker(id=3, action=Marker.DELETE)
            self.markers.publish(gone)
            gone = Marker()
            gone.action = Marker.DELETEALL
            self.markers.publish(gone)
            gone = Marker()
            gone.action = 2
            self.markers.publish(gone)
            shown = Marker()
            shown.action = Marker.ADD
            self.markers.publish(shown)  # wrong
            self.markers.publish(Marker(action=0))  # wrong
        """),
    ),
    "a transform": (
        "RM205",
        tick("""
            transform = TransformStamped()
            transform.header.frame_id = 'map'
            self.broadcaster.sendTransform(transform)  # wrong
        """),
    ),
}


@pytest.mark.parametrize(("codes", "text"), HEADERS.values(), ids=HEADERS)
def test_named_is_what_a_header_lacks(codes: str, text: str) -> None:
    for code in ("RM205", "RM206"):
        assert told(text, code) == (marked(text) if code in codes else [])


TOUCHED = {
    "as a whole": """
        msg = LaserScan()
        msg.header = self.header()
        self.scans.publish(msg)
        header = Header(stamp=Time())
        header.frame_id = 'laser'
        other = LaserScan()
        other.header = header
        self.scans.publish(other)
        self.fill(header)
        msg = LaserScan(header=header)
        self.scans.publish(msg)
    """,
    "where it is kept": """
        msg = LaserScan()
        self.last = msg
        self.fill()
        self.scans.publish(msg)
    """,
    "by another name": """
        msg = LaserScan()
        header = msg.header
        header.frame_id, header.stamp = 'a', Time()
        self.scans.publish(msg)
    """,
    "by a function that gets the stamp": """
        msg = LaserScan()
        msg.header.frame_id = 'laser'
        copy_stamp(self.last.header.stamp, msg.header.stamp)
        self.scans.publish(msg)
    """,
    "by a method that gets the stamp": """
        msg = LaserScan()
        msg.header.frame_id = 'laser'
        self.fill(msg.header.stamp)
        self.scans.publish(msg)
    """,
    "by a function that gets the header": """
        msg = LaserScan()
        fill(msg.header)
        self.scans.publish(msg)
    """,
    "where nothing runs": """
        if self.is_off:
            return
            self.scans.publish(LaserScan(ranges=[1.0]))
    """,
    "by a function that gets the message": """
        msg = LaserScan()
        self.stamp(msg)
        self.scans.publish(msg)
    """,
    "by a function that gets it in a list": """
        msg = LaserScan()
        for each in [msg]:
            self.stamp(each)
        self.scans.publish(msg)
    """,
    "where it comes from": """
        msg = self.make()
        self.scans.publish(msg)
        other = copy.deepcopy(self.template)
        self.scans.publish(other)
    """,
    "a part at a time": """
        msg = LaserScan()
        msg.header.stamp.sec = 1
        msg.header.frame_id = 'laser'
        self.scans.publish(msg)
    """,
    "by unpacking": """
        self.scans.publish(LaserScan(**self.settings))
    """,
    "in the turn before": """
        msg = LaserScan()
        while rclpy.ok():
            self.scans.publish(msg)
            msg.header.stamp, msg.header.frame_id = Time(), 'laser'
    """,
    "an image in no frame": """
        image = self.bridge.cv2_to_imgmsg(self.frame, 'bgr8')
        image.header.stamp = Time()
        self.images.publish(image)
    """,
    "an image that nobody places": """
        self.images.publish(self.bridge.cv2_to_imgmsg(self.frame, 'bgr8'))
    """,
    "a message without a header": """
        self.twists.publish(Twist())
    """,
    "a message in no frame": """
        msg = JointState()
        msg.header.stamp = Time()
        self.joints.publish(msg)
    """,
}


FILLING = """

def copy_stamp(source, destination):
    destination.sec = source.sec
    destination.nanosec = source.nanosec
"""


@pytest.mark.parametrize("lines", TOUCHED.values(), ids=TOUCHED)
def test_nothing_is_told_of_a_header_that_may_be_filled(lines: str) -> None:
    text = tick(lines) + FILLING
    assert told(text, "RM205") == told(text, "RM206") == []


@pytest.mark.parametrize(
    ("body", "end", "count"),
    [
        ("send();", "void send() {", 1),
        ("", "void send() {", 0),
        ("// send();", "void send() {", 0),
        ("", "void send() override {", 1),
    ],
)
def test_nothing_is_told_of_a_function_that_nobody_calls(body: str, end: str, count: int) -> None:
    text = f"""\
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
class N : public rclcpp::Node {{
public:
  N() : Node("n") {{
    pub_ = create_publisher<sensor_msgs::msg::LaserScan>("a", 1);
    {body}
  }}
  {end}
    sensor_msgs::msg::LaserScan scan;
    scan.header.frame_id = "laser";
    pub_->publish(scan);
  }}
  rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr pub_;
}};
int main(int argc, char ** argv) {{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<N>());
}}
"""
    assert len(told(text, "RM205", ".cpp")) == count


@pytest.mark.parametrize(("action", "count"), [("ADD", 1), ("DELETE", 0), ("DELETEALL", 0)])
def test_marker_that_is_taken_away_in_cpp_stands_in_no_frame(action: str, count: int) -> None:
    text = f"""\
#include "rclcpp/rclcpp.hpp"
#include "visualization_msgs/msg/marker.hpp"
class N : public rclcpp::Node {{
public:
  N() : Node("n") {{
    pub_ = create_publisher<visualization_msgs::msg::Marker>("a", 1);
    visualization_msgs::msg::Marker marker;
    marker.action = visualization_msgs::msg::Marker::{action};
    pub_->publish(marker);
  }}
  rclcpp::Publisher<visualization_msgs::msg::Marker>::SharedPtr pub_;
}};
"""
    assert len(told(text, "RM206", ".cpp")) == count
