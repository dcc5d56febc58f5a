#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <memory>
#include <std_msgs/Int8.h>

class Worker
{
public:
  Worker(ros::NodeHandle nh, ros::NodeHandle pnh)
  {
    pnh.param("limit", limit_, 3);
    in_ = nh.subscribe("work", 1, &Worker::work, this);
    done_ = pnh.advertise<std_msgs::Int8>("done", 1);
  }

private:
  void work(const std_msgs::Int8& n) { if (n.data < limit_) done_.publish(n); }
  int limit_;
  ros::Subscriber in_;
  ros::Publisher done_;
};

class Helped : public nodelet::Nodelet
{
  std::unique_ptr<Worker> worker_;

  void onInit() override { worker_.reset(new Worker(getNodeHandle(), getPrivateNodeHandle())); }
};

PLUGINLIB_EXPORT_CLASS(Helped, nodelet::Nodelet)
