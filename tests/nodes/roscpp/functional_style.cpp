#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <std_msgs/Bool.h>
#include <functional>
#include <map>
#include <vector>

int main(int argc, char** argv) {
  ros::init(argc, argv, "functional");
  ros::NodeHandle nh;

  std::map<std::string, ros::Publisher> publishers;
  std::vector<ros::Subscriber> subscribers;
  publishers.emplace("sum", nh.advertise<std_msgs::Int32>("sum", 1));
  publishers["even"] = nh.advertise<std_msgs::Bool>("even", 1);
  publishers.insert({"odd", nh.advertise<std_msgs::Bool>("odd", 1)});

  int sum = 0;
  auto connect = [&] {
    subscribers.push_back(nh.subscribe<std_msgs::Int32>("number", 1, [&](const std_msgs::Int32::ConstPtr& n) {
      sum += n->data;
      std_msgs::Int32 out;
      out.data = sum;
      publishers.at("sum").publish(out);
    }));
  };
  connect();

  auto [first, second] = std::make_pair(nh.advertise<std_msgs::Bool>("first", 1), nh.advertise<std_msgs::Bool>("second", 1));
  ros::Timer watch = nh.createTimer(ros::Duration(0, 100'000'000), std::function<void(const ros::TimerEvent&)>([](const ros::TimerEvent&) {}));
  ros::spin();
}
