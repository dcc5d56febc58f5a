#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Float32.h>

namespace numbers
{
template <typename T>
class RelayBase : public nodelet::Nodelet
{
protected:
  template <typename M>
  ros::Publisher advertise(const std::string & topic, uint32_t queue = 1)
  {
    return getNodeHandle().advertise<M>(topic, queue);
  }

  ros::Publisher pub_;
};

class FloatRelay : public RelayBase<std_msgs::Float32>
{
  ros::Subscriber sub_;

  void onInit() override
  {
    pub_ = this->advertise<std_msgs::Float32>("relayed");
    sub_ = getNodeHandle().subscribe("float", 1, &FloatRelay::relay, this);
  }

  void relay(const std_msgs::Float32ConstPtr & f) {pub_.publish(f);}
};
}

PLUGINLIB_EXPORT_CLASS(numbers::FloatRelay, nodelet::Nodelet)
