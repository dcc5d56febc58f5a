#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/UInt8.h>
#include <std_srvs/Trigger.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "lambdas");
  ros::NodeHandle nh{"~"};
  uint8_t level = 0;

  auto pub = nh.advertise<std_msgs::UInt8>("level", 1);

  boost::function<void(const std_msgs::Empty::ConstPtr&)> up = [&](const std_msgs::Empty::ConstPtr&) {
    std_msgs::UInt8 msg;
    msg.data = ++level;
    pub.publish(msg);
  };
  auto up_sub = nh.subscribe<std_msgs::Empty>("up", 1, up);

  ros::Subscriber down_sub = nh.subscribe<std_msgs::Empty>(
      "down", 1, boost::function<void(const std_msgs::Empty::ConstPtr&)>([&level](const auto&) { --level; }));

  boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> clear =
      [&level](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& res) {
        level = 0;
        res.success = true;
        return true;
      };
  ros::ServiceServer server = nh.advertiseService("clear", clear);
  ros::Timer timer = nh.createTimer(ros::Duration(2), [&](const ros::TimerEvent& event) {
    (void)event;
    ROS_INFO("level %d", level);
  });
  ros::spin();
}
