"""Endpoints added to C++ nodes, as patches: what comes into their files, and how it is written."""

from __future__ import annotations

import pytest
from additions import parameter, provide, publish, request, subscribe
from patches import check

CASES = [
    pytest.param(
        subscribe("imu/data"),
        """
 #include <ros/ros.h>
+#include <sensor_msgs/Imu.h>
 #include <std_msgs/String.h>

 class Talker
 {
 public:
   Talker() : private_nh_("~")
   {
     chatter_pub_ = nh_.advertise<std_msgs::String>("chatter", 10);
     mode_sub_ = nh_.subscribe("mode", 10, &Talker::modeCallback, this);
+    imu_data_sub_ = nh_.subscribe(
+      "imu/data", 10, &Talker::imuDataCallback, this);
   }

 private:
   void modeCallback(const std_msgs::String::ConstPtr& msg)
   {
     ROS_INFO_STREAM("mode: " << msg->data);
   }

+  void imuDataCallback(const sensor_msgs::Imu::ConstPtr& msg)
+  {
+    ROS_INFO_STREAM("imu/data: " << *msg);
+  }
+
   ros::NodeHandle nh_;
   ros::NodeHandle private_nh_;
   ros::Publisher chatter_pub_;
   ros::Subscriber mode_sub_;
+  ros::Subscriber imu_data_sub_;
 };

 int main(int argc, char** argv)
 {
   ros::init(argc, argv, "talker");
   Talker talker;
   ros::spin();
   return 0;
 }
""",
        id="a subscription of roscpp, in a class",
    ),
    pytest.param(
        publish("~/raw"),
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

 class Talker
 {
 public:
   Talker() : private_nh_("~")
   {
     chatter_pub_ = nh_.advertise<std_msgs::String>("chatter", 10);
+    raw_pub_ = private_nh_.advertise<std_msgs::String>("raw", 10);
     mode_sub_ = nh_.subscribe("mode", 10, &Talker::modeCallback, this);
   }

 private:
   void modeCallback(const std_msgs::String::ConstPtr& msg)
   {
     ROS_INFO_STREAM("mode: " << msg->data);
   }

   ros::NodeHandle nh_;
   ros::NodeHandle private_nh_;
   ros::Publisher chatter_pub_;
+  ros::Publisher raw_pub_;
   ros::Subscriber mode_sub_;
 };

 int main(int argc, char** argv)
 {
   ros::init(argc, argv, "talker");
   Talker talker;
   ros::spin();
   return 0;
 }
""",
        id="a private publisher of roscpp, in a class",
    ),
    pytest.param(
        provide("go", "std_srvs/Trigger", success=True),
        """
 #include "x.hpp"

 namespace drive
 {

 Driver::Driver(ros::NodeHandle nh, ros::NodeHandle pnh) : m_nh(nh), m_pnh(pnh) {
     m_pubState = m_nh.advertise<std_msgs::String>("state", 1);
     m_subSpeed = m_nh.subscribe<std_msgs::Float64>(
         "speed", 1, boost::bind(&Driver::onSpeed, this, boost::placeholders::_1));
     m_timer = m_nh.createTimer(ros::Duration(0.5), &Driver::onTimer, this);
+    m_serverGo = m_nh.advertiseService("go", &Driver::onGo, this);
 }

 void Driver::onSpeed(const std_msgs::Float64ConstPtr &speed) {
     m_speed = speed->data;
 }

 void Driver::onTimer(const ros::TimerEvent &) {
     std_msgs::String state;
     state.data = m_speed > 0 ? "on" : "off";
     m_pubState.publish(state);
 }

+bool Driver::onGo(
+    std_srvs::Trigger::Request &req, std_srvs::Trigger::Response &res) {
+    ROS_INFO_STREAM("go: " << req);
+    res.success = true;
+    return true;
+}
+
 }  // namespace drive

 int main(int argc, char **argv) {
     ros::init(argc, argv, "driver");
     drive::Driver driver(ros::NodeHandle(), ros::NodeHandle("~"));
     ros::spin();
 }
=== x.hpp
 #ifndef DRIVE_DRIVER_HPP
 #define DRIVE_DRIVER_HPP

 #include <ros/ros.h>
 #include <std_msgs/Float64.h>
 #include <std_msgs/String.h>
+#include <std_srvs/Trigger.h>

 namespace drive
 {

 class Driver {
 public:
     Driver(ros::NodeHandle nh, ros::NodeHandle pnh);

 private:
     void onSpeed(const std_msgs::Float64ConstPtr &speed);
     void onTimer(const ros::TimerEvent &);
+    bool onGo(
+        std_srvs::Trigger::Request &req, std_srvs::Trigger::Response &res);

     ros::NodeHandle m_nh;
     ros::NodeHandle m_pnh;
     ros::Publisher m_pubState;
     ros::Subscriber m_subSpeed;
     ros::Timer m_timer;
+    ros::ServiceServer m_serverGo;
     double m_speed = 0.0;
 };

 }  // namespace drive

 #endif
""",
        id="a service of roscpp, in a source with its header",
    ),
    pytest.param(
        subscribe("imu"),
        """
 #include "x.hpp"

 namespace drive
 {

 Driver::Driver(ros::NodeHandle nh, ros::NodeHandle pnh) : m_nh(nh), m_pnh(pnh) {
     m_pubState = m_nh.advertise<std_msgs::String>("state", 1);
     m_subSpeed = m_nh.subscribe<std_msgs::Float64>(
         "speed", 1, boost::bind(&Driver::onSpeed, this, boost::placeholders::_1));
+    m_subImu = m_nh.subscribe("imu", 1, &Driver::onImu, this);
     m_timer = m_nh.createTimer(ros::Duration(0.5), &Driver::onTimer, this);
 }

 void Driver::onSpeed(const std_msgs::Float64ConstPtr &speed) {
     m_speed = speed->data;
+}
+
+void Driver::onImu(const sensor_msgs::ImuConstPtr &speed) {
+    ROS_INFO_STREAM("imu: " << *speed);
 }

 void Driver::onTimer(const ros::TimerEvent &) {
     std_msgs::String state;
     state.data = m_speed > 0 ? "on" : "off";
     m_pubState.publish(state);
 }

 }  // namespace drive

 int main(int argc, char **argv) {
     ros::init(argc, argv, "driver");
     drive::Driver driver(ros::NodeHandle(), ros::NodeHandle("~"));
     ros::spin();
 }
=== x.hpp
 #ifndef DRIVE_DRIVER_HPP
 #define DRIVE_DRIVER_HPP

 #include <ros/ros.h>
+#include <sensor_msgs/Imu.h>
 #include <std_msgs/Float64.h>
 #include <std_msgs/String.h>

 namespace drive
 {

 class Driver {
 public:
     Driver(ros::NodeHandle nh, ros::NodeHandle pnh);

 private:
     void onSpeed(const std_msgs::Float64ConstPtr &speed);
+    void onImu(const sensor_msgs::ImuConstPtr &speed);
     void onTimer(const ros::TimerEvent &);

     ros::NodeHandle m_nh;
     ros::NodeHandle m_pnh;
     ros::Publisher m_pubState;
     ros::Subscriber m_subSpeed;
+    ros::Subscriber m_subImu;
     ros::Timer m_timer;
     double m_speed = 0.0;
 };

 }  // namespace drive

 #endif
""",
        id="a subscription of roscpp, bound as the others are",
    ),
    pytest.param(
        publish("state", data="on"),
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

 int main(int argc, char **argv)
 {
     ros::init(argc, argv, "talker");
     ros::NodeHandle nh;
     ros::Publisher pub = nh.advertise<std_msgs::String>("chatter", 1000);
+    ros::Publisher state_pub = nh.advertise<std_msgs::String>("state", 1000);
     ros::Rate loop_rate(10);
     while (ros::ok()) {
         std_msgs::String msg;
         msg.data = "hello";
         pub.publish(msg);
+        std_msgs::String state_message;
+        state_message.data = "on";
+        state_pub.publish(state_message);
         ros::spinOnce();
         loop_rate.sleep();
     }
     return 0;
 }
""",
        id="a message in the loop of main",
    ),
    pytest.param(
        publish("echo", heard="chatter", data="x"),
        """
 #include "ros/ros.h"
 #include "std_msgs/String.h"
+
+ros::Publisher echo_pub;

 void chatterCallback(const std_msgs::String::ConstPtr& msg)
 {
   ROS_INFO("I heard: [%s]", msg->data.c_str());
+  std_msgs::String echo_message;
+  echo_message.data = "x";
+  echo_pub.publish(echo_message);
 }

 int main(int argc, char **argv)
 {
   ros::init(argc, argv, "listener");
   ros::NodeHandle n;
   ros::Subscriber sub = n.subscribe("chatter", 1000, chatterCallback);
+  echo_pub = n.advertise<std_msgs::String>("echo", 10);
   ros::spin();
   return 0;
 }
""",
        id="a message for each that main hears",
    ),
    pytest.param(
        request("ask", data=True),
        """
 #include <nodelet/nodelet.h>
 #include <pluginlib/class_list_macros.hpp>
+#include <ros/callback_queue.h>
 #include <ros/ros.h>
 #include <std_msgs/Bool.h>
+#include <std_srvs/SetBool.h>

 namespace lamps {

 class LampNodelet : public nodelet::Nodelet {
  private:
   void onInit() override {
     ros::NodeHandle& nh = getNodeHandle();
     ros::NodeHandle& private_nh = getPrivateNodeHandle();
     private_nh.param("dim", dim_, 0.5);
     switch_sub_ = nh.subscribe("switch", 1, &LampNodelet::SwitchCb, this);
+    ask_client_ = nh.serviceClient<std_srvs::SetBool>("ask");
+    ask_nh_.setCallbackQueue(&ask_queue_);
+    ask_spinner_.start();
+    ask_timer_ = ask_nh_.createTimer(
+      ros::Duration(0.1), &LampNodelet::callAsk, this, true);
   }

   void SwitchCb(const std_msgs::BoolConstPtr& msg) {
     NODELET_INFO("switch: %d", msg->data);
   }

+  void callAsk(const ros::TimerEvent&) {
+    std_srvs::SetBool call;
+    call.request.data = true;
+    if (
+      ask_client_.waitForExistence(ros::Duration(10.0)) && ask_client_.call(call)) {
+      NODELET_INFO_STREAM("ask: " << call.response);
+    } else {
+      NODELET_ERROR("ask: there was no answer");
+    }
+  }
+
   double dim_;
   ros::Subscriber switch_sub_;
+  ros::ServiceClient ask_client_;
+  ros::CallbackQueue ask_queue_;
+  ros::AsyncSpinner ask_spinner_{1, &ask_queue_};
+  ros::NodeHandle ask_nh_;
+  ros::Timer ask_timer_;
 };

 }  // namespace lamps

 PLUGINLIB_EXPORT_CLASS(lamps::LampNodelet, nodelet::Nodelet)
""",
        id="a request of roscpp, in a thread of its own",
    ),
    pytest.param(
        provide("shut", "std_srvs/Trigger"),
        """
 #include <ros/ros.h>
 #include <std_srvs/Trigger.h>

 class Gate {
  public:
   explicit Gate(ros::NodeHandle* nh)
-      : nh_(*nh), open_server_(nh_.advertiseService("open", &Gate::HandleOpen, this)) {}
+      : nh_(*nh), open_server_(nh_.advertiseService("open", &Gate::HandleOpen, this)) {
+    shut_server_ = ros::NodeHandle().advertiseService("shut", &Gate::HandleShut, this);
+  }

  private:
   bool HandleOpen(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response) {
     response.success = true;
     (void)request;
     return true;
   }

+  bool HandleShut(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response) {
+    ROS_INFO_STREAM("shut: " << request);
+    (void)response;
+    return true;
+  }
+
   ros::NodeHandle nh_;
   ros::ServiceServer open_server_;
+  ros::ServiceServer shut_server_;
 };

 int main(int argc, char** argv) {
   ros::init(argc, argv, "gate");
   ros::NodeHandle nh("~");
   Gate gate(&nh);
   ros::spin();
 }
""",
        id="a service beside one that an initializer creates",
    ),
    pytest.param(
        parameter("~/gain", "float", 2.5),
        """
 #include <nodelet/nodelet.h>
 #include <pluginlib/class_list_macros.hpp>
 #include <ros/ros.h>
 #include <std_msgs/Bool.h>

 namespace lamps {

 class LampNodelet : public nodelet::Nodelet {
  private:
   void onInit() override {
     ros::NodeHandle& nh = getNodeHandle();
     ros::NodeHandle& private_nh = getPrivateNodeHandle();
     private_nh.param("dim", dim_, 0.5);
+    private_nh.param<double>("gain", gain_, 2.5);
     switch_sub_ = nh.subscribe("switch", 1, &LampNodelet::SwitchCb, this);
   }

   void SwitchCb(const std_msgs::BoolConstPtr& msg) {
     NODELET_INFO("switch: %d", msg->data);
   }

   double dim_;
+  double gain_;
   ros::Subscriber switch_sub_;
 };

 }  // namespace lamps

 PLUGINLIB_EXPORT_CLASS(lamps::LampNodelet, nodelet::Nodelet)
""",
        id="a parameter of a nodelet",
    ),
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
+        "imu", rclcpp::QoS(1), std::bind(&DriveNode::imuCallback, this, std::placeholders::_1));
+}
+
+void DriveNode::imuCallback(const sensor_msgs::msg::Imu::SharedPtr msg) {
+    RCLCPP_INFO(logger_, "imu: %s", to_yaml(*msg).c_str());
 }

 void DriveNode::onSpeed(const std_msgs::msg::Float64::ConstSharedPtr& msg) {
     RCLCPP_INFO(logger_, "speed: %f", msg->data);
 }

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
+    void imuCallback(const sensor_msgs::msg::Imu::SharedPtr msg);

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
        publish("state", rate=2.0, data="on"),
        """
+#include <chrono>
+
 #include "rclcpp/rclcpp.hpp"
 #include "std_msgs/msg/string.hpp"

 rclcpp::Node::SharedPtr g_node = nullptr;

 void topic_callback(const std_msgs::msg::String::SharedPtr msg)
 {
   RCLCPP_INFO(g_node->get_logger(), "I heard: '%s'", msg->data.c_str());
 }

 int main(int argc, char * argv[])
 {
   rclcpp::init(argc, argv);
   g_node = rclcpp::Node::make_shared("listener");
   auto subscription =
     g_node->create_subscription<std_msgs::msg::String>("topic", 10, topic_callback);
+  auto state_pub = g_node->create_publisher<std_msgs::msg::String>("state", 10);
+  rclcpp::TimerBase::SharedPtr state_timer = g_node->create_wall_timer(
+    std::chrono::milliseconds(500), [state_pub]() {
+      std_msgs::msg::String message;
+      message.data = "on";
+      state_pub->publish(message);
+    });
   rclcpp::spin(g_node);
   rclcpp::shutdown();
   return 0;
 }
""",
        id="a message at a rate, in main",
    ),
    pytest.param(
        request("ask", data=True),
        """
+#include <chrono>
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
+  rclcpp::Client<std_srvs::srv::SetBool>::SharedPtr ask_client_;
+
+private:
+  rclcpp::TimerBase::SharedPtr ask_timer_;
+
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
        parameter("speed", "int", 5, minimum=1, maximum=9),
        """
 #include <memory>
 #include <string>

 #include "geometry_msgs/msg/twist.hpp"
+#include "rcl_interfaces/msg/parameter_descriptor.hpp"
 #include "rclcpp/rclcpp.hpp"

 namespace wheels
 {
 using geometry_msgs::msg::Twist;

 class Wheels final : public rclcpp::Node
 {
 public:
   explicit Wheels(const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
   : rclcpp::Node("wheels", options)
   {
     gain_ = this->declare_parameter<double>("gain", 1.0);
+    {
+      rcl_interfaces::msg::ParameterDescriptor descriptor;
+      descriptor.integer_range.resize(1);
+      descriptor.integer_range[0].from_value = 1;
+      descriptor.integer_range[0].to_value = 9;
+      this->declare_parameter<int64_t>("speed", 5, descriptor);
+    }
     sub_twist_ = this->create_subscription<Twist>(
       "cmd_vel", rclcpp::SensorDataQoS(),
       std::bind(&Wheels::onTwist, this, std::placeholders::_1));
   }

 private:
   void onTwist(Twist::UniquePtr twist)
   {
     RCLCPP_DEBUG(this->get_logger(), "%f", gain_ * twist->linear.x);
   }

   double gain_;
   rclcpp::Subscription<Twist>::SharedPtr sub_twist_;
 };
 }  // namespace wheels

 int main(int argc, char ** argv)
 {
   rclcpp::init(argc, argv);
   rclcpp::spin(std::make_shared<wheels::Wheels>());
   rclcpp::shutdown();
 }
""",
        id="a parameter of rclcpp with a range",
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
