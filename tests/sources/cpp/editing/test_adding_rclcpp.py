"""Endpoints added to nodes of rclcpp, as patches: what comes into their files, and how."""

from __future__ import annotations

import pytest
from additions import publish, request, subscribe
from patches import check

CASES = [
    pytest.param(
        subscribe("imu/data"),
        """
 #include "rclcpp/rclcpp.hpp"
+#include "sensor_msgs/msg/imu.hpp"
 #include "std_msgs/msg/string.hpp"

 class Talker : public rclcpp::Node
 {
 public:
   Talker()
   : Node("talker")
   {
     chatter_pub_ = create_publisher<std_msgs::msg::String>("chatter", 10);
     mode_sub_ = create_subscription<std_msgs::msg::String>(
       "mode", 10, std::bind(&Talker::on_mode, this, std::placeholders::_1));
+    imu_data_sub_ = create_subscription<sensor_msgs::msg::Imu>(
+      "imu/data", 10, std::bind(&Talker::on_imu_data, this, std::placeholders::_1));
   }

 private:
   void on_mode(const std_msgs::msg::String::SharedPtr msg)
   {
     RCLCPP_INFO(get_logger(), "mode: %s", msg->data.c_str());
   }

+  void on_imu_data(const sensor_msgs::msg::Imu::SharedPtr msg)
+  {
+    RCLCPP_INFO(get_logger(), "imu/data: %s", to_yaml(*msg).c_str());
+  }
+
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr chatter_pub_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr mode_sub_;
+  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_data_sub_;
 };

 int main(int argc, char * argv[])
 {
   rclcpp::init(argc, argv);
   rclcpp::spin(std::make_shared<Talker>());
   rclcpp::shutdown();
   return 0;
 }
""",
        id="a subscription of rclcpp, in a class",
    ),
    pytest.param(
        subscribe("mode_2", "std_msgs/String", "on_mode"),
        """
 #include "rclcpp/rclcpp.hpp"
 #include "std_msgs/msg/string.hpp"

 class Talker : public rclcpp::Node
 {
 public:
   Talker()
   : Node("talker")
   {
     chatter_pub_ = create_publisher<std_msgs::msg::String>("chatter", 10);
     mode_sub_ = create_subscription<std_msgs::msg::String>(
       "mode", 10, std::bind(&Talker::on_mode, this, std::placeholders::_1));
+    mode_2_sub_ = create_subscription<std_msgs::msg::String>(
+      "mode_2", 10, std::bind(&Talker::on_mode, this, std::placeholders::_1));
   }

 private:
   void on_mode(const std_msgs::msg::String::SharedPtr msg)
   {
     RCLCPP_INFO(get_logger(), "mode: %s", msg->data.c_str());
   }

   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr chatter_pub_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr mode_sub_;
+  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr mode_2_sub_;
 };

 int main(int argc, char * argv[])
 {
   rclcpp::init(argc, argv);
   rclcpp::spin(std::make_shared<Talker>());
   rclcpp::shutdown();
   return 0;
 }
""",
        id="a subscription of rclcpp that calls a method that is there",
    ),
    pytest.param(
        publish("first", once=True, data="x"),
        """
+#include <chrono>
+
 #include "rclcpp/rclcpp.hpp"
 #include "std_msgs/msg/string.hpp"

 class Talker : public rclcpp::Node
 {
 public:
   Talker()
   : Node("talker")
   {
     chatter_pub_ = create_publisher<std_msgs::msg::String>("chatter", 10);
+    first_pub_ = create_publisher<std_msgs::msg::String>(
+      "first", rclcpp::QoS(10).transient_local());
+    first_timer_ = create_wall_timer(
+      std::chrono::milliseconds(200), std::bind(&Talker::publish_first, this));
     mode_sub_ = create_subscription<std_msgs::msg::String>(
       "mode", 10, std::bind(&Talker::on_mode, this, std::placeholders::_1));
   }

 private:
   void on_mode(const std_msgs::msg::String::SharedPtr msg)
   {
     RCLCPP_INFO(get_logger(), "mode: %s", msg->data.c_str());
   }

+  void publish_first()
+  {
+    const bool was_heard = first_is_heard_;
+    first_is_heard_ = first_pub_->get_subscription_count() > 0;
+    if (was_heard && first_is_heard_) {
+      // A subscription that is there for so long knows this publisher too.
+      first_timer_->cancel();
+      std_msgs::msg::String message;
+      message.data = "x";
+      first_pub_->publish(message);
+    }
+  }
+
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr chatter_pub_;
+  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr first_pub_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr mode_sub_;
+  rclcpp::TimerBase::SharedPtr first_timer_;
+  bool first_is_heard_ = false;
 };

 int main(int argc, char * argv[])
 {
   rclcpp::init(argc, argv);
   rclcpp::spin(std::make_shared<Talker>());
   rclcpp::shutdown();
   return 0;
 }
""",
        id="a message once of rclcpp",
    ),
    pytest.param(
        publish("state", data="on"),
        """
 #include <chrono>
 #include <functional>
 #include <memory>
 #include <string>

 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 using namespace std::chrono_literals;
 using std::placeholders::_1;

 class MinimalNode : public rclcpp::Node
 {
   public:
     MinimalNode()
     : Node("minimal_node"), count_(0)
     {
       publisher_ = this->create_publisher<std_msgs::msg::String>("topic", 10);
+      state_publisher_ = this->create_publisher<std_msgs::msg::String>("state", 10);
       subscription_ = this->create_subscription<std_msgs::msg::String>(
       "in", 10, std::bind(&MinimalNode::topic_callback, this, _1));
       timer_ = this->create_wall_timer(
       500ms, std::bind(&MinimalNode::timer_callback, this));
     }

   private:
     void timer_callback()
     {
       auto message = std_msgs::msg::String();
       message.data = "Hello, world! " + std::to_string(count_++);
       publisher_->publish(message);
+      std_msgs::msg::String state_message;
+      state_message.data = "on";
+      state_publisher_->publish(state_message);
     }
     void topic_callback(const std_msgs::msg::String & msg) const
     {
       RCLCPP_INFO_STREAM(this->get_logger(), "I heard: " << msg.data);
     }
     rclcpp::TimerBase::SharedPtr timer_;
     rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
+    rclcpp::Publisher<std_msgs::msg::String>::SharedPtr state_publisher_;
     rclcpp::Subscription<std_msgs::msg::String>::SharedPtr subscription_;
     size_t count_;
 };

 int main(int argc, char * argv[])
 {
   rclcpp::init(argc, argv);
   rclcpp::spin(std::make_shared<MinimalNode>());
   rclcpp::shutdown();
   return 0;
 }
""",
        id="a message in the timer of rclcpp",
    ),
    pytest.param(
        subscribe("imu"),
        """
 #include "x.hpp"

 namespace drive {

 DriveNode::DriveNode(const rclcpp::NodeOptions& options) : rclcpp::Node("drive", options) {
     state_publisher_ = create_publisher<std_msgs::msg::String>("state", rclcpp::QoS(1));
     speed_subscriber_ = create_subscription<std_msgs::msg::Float64>(
         "speed", rclcpp::QoS(1),
         [this](const std_msgs::msg::Float64::ConstSharedPtr msg) { onSpeed(msg); });
+    imu_subscriber_ = create_subscription<sensor_msgs::msg::Imu>(
+        "imu", rclcpp::QoS(1),
+        [this](const sensor_msgs::msg::Imu::ConstSharedPtr msg) { onImu(msg); });
 }

 void DriveNode::onSpeed(const std_msgs::msg::Float64::ConstSharedPtr& msg) {
     RCLCPP_INFO(logger_, "speed: %f", msg->data);
 }

+void DriveNode::onImu(const sensor_msgs::msg::Imu::ConstSharedPtr& msg) {
+    RCLCPP_INFO(logger_, "imu: %s", to_yaml(*msg).c_str());
+}
+
 }  // namespace drive
=== x.hpp
 #pragma once

 #include <rclcpp/rclcpp.hpp>
+#include <sensor_msgs/msg/imu.hpp>
 #include <std_msgs/msg/float64.hpp>
 #include <std_msgs/msg/string.hpp>

 namespace drive {

 class DriveNode : public rclcpp::Node {
 public:
     explicit DriveNode(const rclcpp::NodeOptions& options);

 private:
     void onSpeed(const std_msgs::msg::Float64::ConstSharedPtr& msg);
+    void onImu(const sensor_msgs::msg::Imu::ConstSharedPtr& msg);

     rclcpp::Logger logger_ = get_logger();
     rclcpp::Publisher<std_msgs::msg::String>::SharedPtr state_publisher_;
     rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr speed_subscriber_;
+    rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_subscriber_;
 };

 }  // namespace drive
""",
        id="a subscription of rclcpp, in a source with its header",
    ),
    pytest.param(
        request("ask", data=True),
        """
+#include <chrono>
+#include <functional>
 #include <memory>

 #include "rclcpp/rclcpp.hpp"
+#include "std_srvs/srv/set_bool.hpp"

 class Empty : public rclcpp::Node
 {
 public:
-  Empty() : Node("empty") {}
+  Empty() : Node("empty")
+  {
+    ask_client_ = create_client<std_srvs::srv::SetBool>("ask");
+    ask_timer_ = create_wall_timer(
+      std::chrono::milliseconds(100), std::bind(&Empty::call_ask, this));
+  }
+
+private:
+  void call_ask()
+  {
+    if (!ask_client_->service_is_ready()) {
+      RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 10000, "ask: waiting for the service");
+      return;
+    }
+    ask_timer_->cancel();
+    auto request = std::make_shared<std_srvs::srv::SetBool::Request>();
+    request->data = true;
+    ask_client_->async_send_request(
+      request, [this](rclcpp::Client<std_srvs::srv::SetBool>::SharedFuture future) {
+        RCLCPP_INFO(get_logger(), "ask: %s", to_yaml(*future.get()).c_str());
+      });
+  }
+
+  rclcpp::Client<std_srvs::srv::SetBool>::SharedPtr ask_client_;
+  rclcpp::TimerBase::SharedPtr ask_timer_;
 };

 int main(int argc, char ** argv)
 {
   rclcpp::init(argc, argv);
   rclcpp::spin(std::make_shared<Empty>());
   rclcpp::shutdown();
 }
""",
        id="a request of rclcpp",
    ),
    pytest.param(
        publish("b"),
        """
 #include "rclcpp_lifecycle/lifecycle_node.hpp"
 #include "std_msgs/msg/string.hpp"
 using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
 class M : public rclcpp_lifecycle::LifecycleNode
 {
 public:
   M() : rclcpp_lifecycle::LifecycleNode("m") {}
   CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
   {
     pub_ = create_publisher<std_msgs::msg::String>("a", 10);
+    b_pub_ = create_publisher<std_msgs::msg::String>("b", 10);
     return CallbackReturn::SUCCESS;
   }
   CallbackReturn on_activate(const rclcpp_lifecycle::State &) override
   {
     pub_->on_activate();
+    b_pub_->on_activate();
     return CallbackReturn::SUCCESS;
   }
   CallbackReturn on_deactivate(const rclcpp_lifecycle::State &) override
   {
     pub_->on_deactivate();
+    b_pub_->on_deactivate();
     return CallbackReturn::SUCCESS;
   }
   CallbackReturn on_cleanup(const rclcpp_lifecycle::State &) override
   {
     pub_.reset();
+    b_pub_.reset();
     return CallbackReturn::SUCCESS;
   }
 private:
   rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::String>::SharedPtr pub_;
+  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::String>::SharedPtr b_pub_;
 };
""",
        id="a publisher of a managed node",
    ),
]


@pytest.mark.parametrize(("change", "patch"), CASES)
def test_a_patch(change, patch):
    check(patch, change)
