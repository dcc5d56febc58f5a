"""What is taken out of nodes of rclcpp and components with an endpoint."""

from __future__ import annotations

import pytest
from patches import check, refusal

from plastron_tui.model.source import EndpointKind, Remove

K = EndpointKind

REMOVALS = [
    (
        "a publisher that a timer publishes on, with the message and the include",
        K.PUBLISHER,
        "chatter",
        """
 #include <chrono>

 #include "rclcpp/rclcpp.hpp"
-#include "std_msgs/msg/string.hpp"

 using namespace std::chrono_literals;

 class Talker : public rclcpp::Node
 {
 public:
   Talker()
   : Node("talker")
   {
-    publisher_ = create_publisher<std_msgs::msg::String>("chatter", 10);
     timer_ = create_wall_timer(500ms, [this]() {tick();});
   }

 private:
   void tick()
   {
-    auto message = std_msgs::msg::String();
-    message.data = "hello " + std::to_string(count_);
-    publisher_->publish(message);
     count_++;
   }

-  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
   rclcpp::TimerBase::SharedPtr timer_;
   int count_ = 0;
 };

 int main(int argc, char ** argv)
 {
   rclcpp::init(argc, argv);
   rclcpp::spin(std::make_shared<Talker>());
   rclcpp::shutdown();
 }
""",
    ),
    (
        "a subscription over several lines with a lambda",
        K.SUBSCRIPTION,
        "scan",
        """
 #include <rclcpp/rclcpp.hpp>
-#include <sensor_msgs/msg/laser_scan.hpp>
 #include <std_msgs/msg/string.hpp>

 class Ears : public rclcpp::Node {
  public:
   explicit Ears(const rclcpp::NodeOptions& options) : Node("ears", options) {
-    // what it sees
-    scan_ = create_subscription<sensor_msgs::msg::LaserScan>(
-        "scan", rclcpp::SensorDataQoS(),
-        [this](const sensor_msgs::msg::LaserScan& msg) {
-          RCLCPP_INFO(get_logger(), "%f", msg.range_min);
-        });
-
     voice_ = create_publisher<std_msgs::msg::String>("voice", 1);
   }

  private:
-  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scan_;
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr voice_;
 };

 #include <rclcpp_components/register_node_macro.hpp>
 RCLCPP_COMPONENTS_REGISTER_NODE(Ears)
""",
    ),
    (
        "a component in two files, with what binds and declares the callback",
        K.SERVICE,
        "reset",
        """
 #include "robot/x.hpp"

-using std::placeholders::_1;
-using std::placeholders::_2;
-
 namespace robot
 {

 Robot::Robot(const rclcpp::NodeOptions & options)
 : Node("robot", options)
 {
   speed_ = declare_parameter("speed", 1.0);
-  reset_service_ = create_service<std_srvs::srv::Trigger>(
-    "reset", std::bind(&Robot::on_reset, this, _1, _2));
 }

-void Robot::on_reset(
-  const std_srvs::srv::Trigger::Request::SharedPtr request,
-  std_srvs::srv::Trigger::Response::SharedPtr response)
-{
-  (void)request;
-  (void)response;
-  RCLCPP_INFO(get_logger(), "reset");
-}
-
 }  // namespace robot

 #include "rclcpp_components/register_node_macro.hpp"
 RCLCPP_COMPONENTS_REGISTER_NODE(robot::Robot)
=== x.hpp
 #ifndef X_HPP_
 #define X_HPP_

 #include "rclcpp/rclcpp.hpp"
-#include "std_srvs/srv/trigger.hpp"

 namespace robot
 {

 class Robot : public rclcpp::Node
 {
 public:
   explicit Robot(const rclcpp::NodeOptions & options);

 private:
-  /// Put all back.
-  void on_reset(
-    const std_srvs::srv::Trigger::Request::SharedPtr request,
-    std_srvs::srv::Trigger::Response::SharedPtr response);
-
-  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr reset_service_;
   double speed_;
 };

 }  // namespace robot

 #endif  // X_HPP_
""",
    ),
    (
        "a client that is only waited for",
        K.CLIENT,
        "toggle",
        """
 #include <rclcpp/rclcpp.hpp>
-#include <std_srvs/srv/set_bool.hpp>

 int main(int argc, char** argv) {
   rclcpp::init(argc, argv);
   auto node = rclcpp::Node::make_shared("n");
-  auto client = node->create_client<std_srvs::srv::SetBool>("toggle");
   rclcpp::spin(node);
 }
""",
    ),
    (
        "the only entry behind the base in a list of initializers",
        K.PUBLISHER,
        "a",
        """
 #include <rclcpp/rclcpp.hpp>
-#include <std_msgs/msg/string.hpp>

 class A : public rclcpp::Node {
  public:
-  A() : Node("a"), pub_(create_publisher<std_msgs::msg::String>("a", 1)) {}
+  A() : Node("a") {}
-
- private:
-  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };
""",
    ),
    (
        "a member with its value, shut down at the end, and an alias for its type",
        K.PUBLISHER,
        "a",
        """
 #include <rclcpp/rclcpp.hpp>
-#include <std_msgs/msg/string.hpp>

 class A : public rclcpp::Node {
  public:
   A() : Node("a") {}
-  ~A() { pub_.reset(); }
+  ~A() {}

  private:
-  using String = std_msgs::msg::String;
-  rclcpp::Publisher<String>::SharedPtr pub_ = create_publisher<String>("a", 1);
   int count_ = 0;
 };
""",
    ),
    (
        "one node of two in a file",
        K.PUBLISHER,
        "a",
        """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 class One : public rclcpp::Node {
  public:
-  One() : Node("one") {
-    pub_ = create_publisher<std_msgs::msg::String>("a", 1);
-  }
+  One() : Node("one") {}
-  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };

 class Two : public rclcpp::Node {
  public:
   Two() : Node("two") {
     pub_ = create_publisher<std_msgs::msg::String>("b", 1);
   }
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };
""",
    ),
    (
        "a parameter that nothing reads",
        K.PARAMETER,
        "rate",
        """
 #include <rclcpp/rclcpp.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
-    declare_parameter("rate", 10.0);
     declare_parameter("frame", "map");
   }
 };
""",
    ),
    (
        "a parameter that only sets a member which nothing reads",
        K.PARAMETER,
        "rate",
        """
 #include <rclcpp/rclcpp.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
-    declare_parameter<double>("rate", 10.0);
-    get_parameter("rate", rate_);
     frame_ = declare_parameter("frame", "map");
   }
  private:
-  double rate_;
   std::string frame_;
 };
""",
    ),
    (
        "a guard around a publisher, with an else of its own",
        K.PUBLISHER,
        "a",
        """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
-    pub_ = create_publisher<std_msgs::msg::String>("a", 1);
     sub_ = create_subscription<std_msgs::msg::String>(
       "b", 1, [this](std_msgs::msg::String::UniquePtr msg) {
         heard_ = msg->data;
-        if (pub_->get_subscription_count() > 0)
-          pub_->publish(std::move(msg));
       });
   }
-  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
   std::string heard_;
 };
""",
    ),
    (
        "a publisher of a managed node, activated and deactivated",
        K.PUBLISHER,
        "a",
        """
 #include <rclcpp_lifecycle/lifecycle_node.hpp>
-#include <std_msgs/msg/string.hpp>

 class A : public rclcpp_lifecycle::LifecycleNode {
  public:
   A() : LifecycleNode("a") {}

   CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
-    pub_ = create_publisher<std_msgs::msg::String>("a", 1);
     return CallbackReturn::SUCCESS;
   }

   CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override {
     LifecycleNode::on_activate(state);
-    pub_->on_activate();
     return CallbackReturn::SUCCESS;
   }

   CallbackReturn on_cleanup(const rclcpp_lifecycle::State&) override {
-    pub_ = nullptr;
     return CallbackReturn::SUCCESS;
   }

  private:
-  std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::String>> pub_;
   int count_;
 };
""",
    ),
]


@pytest.mark.parametrize(
    ("kind", "name", "patch"), [each[1:] for each in REMOVALS], ids=[each[0] for each in REMOVALS]
)
def test_a_removal_takes_what_served_the_endpoint(
    kind: EndpointKind, name: str, patch: str
) -> None:
    check(patch, Remove(kind, name, node="one" if 'Node("one")' in patch else None))


USED = [
    ("return pub_;", "line 9"),
    ("f(pub_);", "line 9"),
    ("Guard guard(pub_);", "line 9"),
    ("const Guard<int> guard(pub_);", "line 9"),
    ("map_[1] = pub_;", "line 9"),
    ("show(pub_->get_subscription_count());", "line 9"),
    ("pub_->publish(last_ = message);", "line 9"),
    ("pub_->publish(made(count_++));", "line 9"),
]


@pytest.mark.parametrize(("statement", "line"), USED)
def test_an_endpoint_that_is_used_otherwise_stays(statement: str, line: str) -> None:
    text = f"""
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {{
  public:
   A() : Node("a") {{
     pub_ = create_publisher<std_msgs::msg::String>("a", 1);
   }}
   auto use() {{
     {statement}
   }}
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 }};
"""
    assert refusal(text, Remove(K.PUBLISHER, "a")) == (
        f"endpoint-in-use: the publisher `a` is used in {line}"
    )


@pytest.mark.parametrize("newline", ["\r\n", "\n"])
@pytest.mark.parametrize("tail", ["", "\n\n"])
def test_line_ends_stay(newline: str, tail: str) -> None:
    text = (
        ' #include "rclcpp/rclcpp.hpp"\n-#include "std_msgs/msg/string.hpp"\n'
        ' class A : public rclcpp::Node\n {\n public:\n \tA() : Node("a")\n \t{\n'
        '-\t\tpub_ = create_publisher<std_msgs::msg::String>("a", 1); // a\n'
        "-\t\tpub_->publish(std_msgs::msg::String());\n"
        " \t}\n-\trclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;\n };\n"
    )
    check(text.replace("\n", newline) + tail, Remove(K.PUBLISHER, "a"))
