#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <map>
#include <thread>

// pub = nh.advertise<std_msgs::Int32>("in_a_comment", 1);
/* ros::Subscriber old = nh.subscribe("old", 1, onOld);
   old = nh.subscribe("older", 1, onOld); */

const char* kHelp = "usage: nh.advertise<std_msgs::Int32>(\"in_a_string\", 1)";
const char* kRaw = R"(
  ros::Publisher p = nh.advertise<std_msgs::Int32>("raw", 1);
)";

struct Bus {
  template <typename T> int advertise(const std::string& name, int) { return names[name] = sizeof(T); }
  void subscribe(const std::string& name, int, void (*)(int)) { names[name] = 0; }
  void publish(const std::string&) {}
  bool param(const std::string&, int) { return true; }
  std::map<std::string, int> names;
};

namespace web {
struct Timer {};
inline Timer createTimer(double, void (*)()) { return Timer(); }
}

static void nothing(int) {}
static void tick() {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "decoys");
  ros::NodeHandle nh;
  Bus bus, *other = &bus;
  bus.advertise<std_msgs::Int32>("bus", 1);
  other->subscribe("bus", 1, nothing);
  bus.publish("bus");
  bus.param("bus", 1);
  web::createTimer(1.0, tick);
  std::thread worker([] { ros::Duration(0.1).sleep(); });
  ros::Publisher pub = nh.advertise<std_msgs::Int32>("real", 1);
  pub.publish(std_msgs::Int32());
  ROS_INFO("advertise<T>(\"%s\")", pub.getTopic().c_str());
  worker.join();
}
