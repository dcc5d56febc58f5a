#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <boost/make_shared.hpp>
#include <memory>
#include <geometry_msgs/WrenchStamped.h>
#include <geometry_msgs/Wrench.h>
#include <geometry_msgs/Vector3.h>

class Pointers : public nodelet::Nodelet
{
public:
  virtual void onInit()
  {
    nh_.reset(new ros::NodeHandle(getNodeHandle()));
    pnh_ = boost::make_shared<ros::NodeHandle>(getPrivateNodeHandle());
    sensor_nh_ = std::make_unique<ros::NodeHandle>(*nh_, "sensor");
    raw_ = &getMTNodeHandle();

    wrench_ = nh_->advertise<geometry_msgs::WrenchStamped>("wrench", 1);
    bias_ = pnh_->subscribe("bias", 1, &Pointers::bias, this);
    force_ = sensor_nh_->subscribe("force", 1, &Pointers::force, this);
    other_ = raw_->subscribe("other", 1, &Pointers::force, this);
  }

  void bias(const geometry_msgs::Wrench::Ptr&) {}
  void force(const geometry_msgs::Vector3::ConstPtr&) {}

private:
  boost::shared_ptr<ros::NodeHandle> nh_, pnh_;
  std::unique_ptr<ros::NodeHandle> sensor_nh_;
  ros::NodeHandle* raw_;
  ros::Publisher wrench_;
  ros::Subscriber bias_, force_, other_;
};

PLUGINLIB_EXPORT_CLASS(Pointers, nodelet::Nodelet)
