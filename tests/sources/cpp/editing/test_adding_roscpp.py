"""Endpoints added to nodes of roscpp, as patches: what comes into their files, and how."""

from __future__ import annotations

import pytest
from additions import provide, publish, request, subscribe
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

+bool Driver::onGo(std_srvs::Trigger::Request &req, std_srvs::Trigger::Response &res) {
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
+    bool onGo(std_srvs::Trigger::Request &req, std_srvs::Trigger::Response &res);

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
+void Driver::onImu(const sensor_msgs::ImuConstPtr &msg) {
+    ROS_INFO_STREAM("imu: " << *msg);
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
+    void onImu(const sensor_msgs::ImuConstPtr &msg);
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
+    if (ask_client_.waitForExistence(ros::Duration(10.0)) &&
+        ask_client_.call(call)) {
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
]


@pytest.mark.parametrize(("change", "patch"), CASES)
def test_a_patch(change, patch):
    check(patch, change)
