#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Float32.h>
#include <std_msgs/Int32.h>

template <typename M>
class Holder
{
public:
  void hold(const M& m) { last_ = m; }
  M last_;
};

class ConvertInt : public nodelet::Nodelet
{
  Holder<std_msgs::Int32> holder_;
  ros::Subscriber sub_;

  void onInit() override
  {
    sub_ = getNodeHandle().subscribe("int", 1, &Holder<std_msgs::Int32>::hold, &holder_);
  }
};

class ConvertFloat : public nodelet::Nodelet
{
  Holder<std_msgs::Float32> holder_;
  ros::Subscriber sub_;

  void onInit() override
  {
    sub_ = getNodeHandle().subscribe<std_msgs::Float32>("float", 1, boost::bind(&Holder<std_msgs::Float32>::hold, &holder_, boost::bind(&ConvertFloat::get, boost::placeholders::_1)));
  }

  static std_msgs::Float32 get(const std_msgs::Float32ConstPtr& p) { return *p; }
};

PLUGINLIB_EXPORT_CLASS(ConvertInt, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(ConvertFloat, nodelet::Nodelet)
