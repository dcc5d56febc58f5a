#ifndef EMPTY_POINTERS_EVERYTHING_H
#define EMPTY_POINTERS_EVERYTHING_H

#include <actionlib/TestAction.h>
#include <actionlib/client/simple_action_client.h>
#include <actionlib/server/simple_action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <image_transport/image_transport.h>
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

class Everything
{
  typedef actionlib::SimpleActionServer<actionlib::TestAction> Server;
  typedef actionlib::SimpleActionClient<actionlib::TestAction> Client;

public:
  Everything();
  ~Everything();

private:
  void onGoal();
  void onPreempt();
  void onImage(const sensor_msgs::ImageConstPtr& image);

  Server* server_;
  Client* client_;
  tf2_ros::TransformListener* listener_;
  message_filters::Subscriber<sensor_msgs::LaserScan>* scan_;
  boost::shared_ptr<image_transport::ImageTransport> transport_;
  ros::NodeHandle* nh_;
  message_filters::Subscriber<geometry_msgs::PoseStamped> pose_;
  tf2_ros::Buffer buffer_;
  image_transport::Subscriber image_;
};

#endif
