#include <ros/ros.h>
#include <std_msgs/String.h>

#define NODE_NAME "names"
#define TOPIC_A "a"
#define PREFIX "/robot"
#define QUEUE 7

static const std::string TOPIC_B = "b";
const char* const TOPIC_C = "c";
constexpr char kTopicD[] = "d";
constexpr auto TOPIC_E = "e";
namespace topics {
const std::string F("f");
inline constexpr const char* G{"g"};
}
struct Names {
  static constexpr const char* H = "h";
  static const std::string I;
};
const std::string Names::I = "i";

int main(int argc, char** argv) {
  ros::init(argc, argv, NODE_NAME);
  ros::NodeHandle nh;
  const std::string ns = "arm";
  std::string late;
  late = "late";

  ros::Publisher p[16];
  p[0] = nh.advertise<std_msgs::String>(TOPIC_A, QUEUE);
  p[1] = nh.advertise<std_msgs::String>(TOPIC_B, QUEUE);
  p[2] = nh.advertise<std_msgs::String>(TOPIC_C, QUEUE);
  p[3] = nh.advertise<std_msgs::String>(kTopicD, QUEUE);
  p[4] = nh.advertise<std_msgs::String>(TOPIC_E, QUEUE);
  p[5] = nh.advertise<std_msgs::String>(topics::F, QUEUE);
  p[6] = nh.advertise<std_msgs::String>(topics::G, QUEUE);
  p[7] = nh.advertise<std_msgs::String>(Names::H, QUEUE);
  p[8] = nh.advertise<std_msgs::String>(Names::I, QUEUE);
  p[9] = nh.advertise<std_msgs::String>(PREFIX "/joined", QUEUE);
  p[10] = nh.advertise<std_msgs::String>(ns + "/state", QUEUE);
  p[11] = nh.advertise<std_msgs::String>(std::string(PREFIX) + "/" + ns, QUEUE);
  p[12] = nh.advertise<std_msgs::String>(late, QUEUE);
  p[13] = nh.advertise<std_msgs::String>("one" "/two", QUEUE);
  p[14] = nh.advertise<std_msgs::String>(ros::this_node::getName() + "/x", QUEUE);
  p[15] = nh.advertise<std_msgs::String>(argv[1], QUEUE);
  ros::spin();
}
