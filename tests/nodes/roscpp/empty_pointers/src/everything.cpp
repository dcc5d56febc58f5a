#include "empty_pointers/everything.h"

Everything::Everything()
  : server_(nullptr)
  , client_(NULL)
  , listener_(nullptr)
  , scan_(NULL)
  , transport_()
  , nh_(new ros::NodeHandle("all"))
  , pose_(*nh_, "pose", 1)
  , buffer_(ros::Duration(10))
{
  listener_ = new tf2_ros::TransformListener(buffer_);
  scan_ = new message_filters::Subscriber<sensor_msgs::LaserScan>();
  scan_->subscribe(*nh_, "scan", 2);
  client_ = new Client("run", true);
  server_ = new Server(*nh_, "run", false);
  server_->registerGoalCallback(boost::bind(&Everything::onGoal, this));
  server_->registerPreemptCallback(boost::bind(&Everything::onPreempt, this));
  server_->start();
  transport_.reset(new image_transport::ImageTransport(*nh_));
  image_ = transport_->subscribe("image", 1, boost::bind(&Everything::onImage, this, boost::placeholders::_1));
}

Everything::~Everything()
{
  delete server_;
  delete client_;
  delete scan_;
  delete listener_;
  delete nh_;
}

void Everything::onGoal() { server_->acceptNewGoal(); }
void Everything::onPreempt() { server_->setPreempted(); }
void Everything::onImage(const sensor_msgs::ImageConstPtr&) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "empty_pointers");
  Everything everything;
  ros::spin();
}
