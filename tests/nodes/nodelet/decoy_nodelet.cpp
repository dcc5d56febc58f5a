#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Float32.h>
#include <thread>

namespace real {

class Registry
{
public:
  template <class T>
  Registry& advertise(const char*, int) { return *this; }
  void subscribe(const char*, int) {}
  bool getParam(const char*, int&) const { return false; }
  void createTimer(ros::Duration, void (*)()) {}
};

class Sampler : public nodelet::Nodelet
{
  Registry registry_;
  ros::Publisher sample_;
  std::thread worker_;
  int n_ = 0;

  void onInit() override
  {
    registry_.advertise<std_msgs::Float32>("nothing", 1).subscribe("nothing", 1);
    registry_.getParam("nothing", n_);
    registry_.createTimer(ros::Duration(1), [] {});
    // sub_ = getNodeHandle().subscribe("disabled", 1, &Sampler::disabled, this);
    sample_ = getNodeHandle().advertise<std_msgs::Float32>("sample", 1);
    NODELET_INFO("nh.advertise<std_msgs::Float32>(\"printed\", 1)");
    worker_ = std::thread(&Sampler::work, this);
#if 0
    getNodeHandle().subscribe("zero", 1, &Sampler::zero, this);
#endif
  }

  void work()
  {
    ros::Rate rate(10);
    while (ros::ok()) {
      sample_.publish(std_msgs::Float32());
      rate.sleep();
    }
  }

public:
  ~Sampler() { if (worker_.joinable()) worker_.join(); }
};

}

PLUGINLIB_EXPORT_CLASS(real::Sampler, nodelet::Nodelet)
