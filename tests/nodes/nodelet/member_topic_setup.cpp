#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <geometry_msgs/Twist.h>
#include <cinttypes>

#define CMD_TOPIC "cmd_vel"
#define LOG_TICKS(n) NODELET_INFO("ticks %" PRIu64, (uint64_t)(n))

class TopicSetup : public nodelet::Nodelet
{
public:
  TopicSetup() : in_(CMD_TOPIC), out_(in_ + "_smooth") {}

private:
  void onInit() override
  {
    LOG_TICKS(0);
    NODELET_DEBUG_STREAM("from " << in_ << " to " << out_);
    connect();
  }

  void connect()
  {
    pub_ = getNodeHandle().advertise<geometry_msgs::Twist>(out_, depth_);
    sub_ = getNodeHandle().subscribe(in_, depth_, &TopicSetup::smooth, this, ros::TransportHints().unreliable().reliable().tcpNoDelay());
  }

  void smooth(const geometry_msgs::Twist::ConstPtr& t) { LOG_TICKS(1); pub_.publish(t); }

  const uint32_t depth_ = 4;
  const std::string in_;
  const std::string out_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
};

PLUGINLIB_EXPORT_CLASS(TopicSetup, nodelet::Nodelet)
