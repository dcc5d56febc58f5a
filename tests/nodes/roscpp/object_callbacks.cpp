#include <boost/make_shared.hpp>
#include <ros/ros.h>
#include <sensor_msgs/Joy.h>
#include <std_msgs/Int32.h>
#include <std_msgs/UInt8.h>
#include <std_srvs/Empty.h>

struct Counter
{
  int n = 0;
  void add(const std_msgs::Int32::Ptr& m) { n += m->data; }
  void take(const std_msgs::UInt8Ptr m) { n -= m->data; }
  void joy(sensor_msgs::Joy m) { n = m.buttons.size(); }
  bool reset(std_srvs::EmptyRequest&, std_srvs::EmptyResponse&) { n = 0; return true; }
  void tick(const ros::TimerEvent&) const {}
};

template <class M>
void any(const boost::shared_ptr<M const>&) {}

void with(const std_msgs::Int32::ConstPtr&, Counter&, const std::string&) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "object_callbacks");
  ros::NodeHandle nh;
  Counter counter;
  ros::Subscriber a = nh.subscribe("add", 1, &Counter::add, &counter);
  ros::Subscriber b = nh.subscribe("take", 1, &Counter::take, boost::make_shared<Counter>());
  ros::Subscriber c = nh.subscribe("joy", 1, &Counter::joy, &counter);
  ros::Subscriber d = nh.subscribe("any", 1, any<std_msgs::UInt8>);
  ros::Subscriber e = nh.subscribe<std_msgs::Int32>("with", 1, boost::bind(with, boost::placeholders::_1, boost::ref(counter), "text"));
  ros::ServiceServer f = nh.advertiseService("reset", &Counter::reset, &counter);
  ros::Timer g = nh.createTimer(ros::Duration(60.0 * 5), &Counter::tick, &counter);
  ros::spin();
}
