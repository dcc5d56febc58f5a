#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "namespaces");
  typedef std_msgs::String S;
  ros::NodeHandle nh;
  ros::NodeHandle arm("arm");
  ros::NodeHandle gripper(arm, "gripper");
  ros::NodeHandle root("/");
  ros::NodeHandle pnh("~");
  ros::NodeHandle debug("~/debug");
  ros::NodeHandle camera = ros::NodeHandle("camera");
  std::string side = "left";
  ros::NodeHandle sided(side);
  ros::NodeHandle unknown(argv[1]);

  ros::Publisher a = nh.advertise<S>("a", 1);
  ros::Publisher b = arm.advertise<S>("b", 1);
  ros::Publisher c = gripper.advertise<S>("c", 1);
  ros::Publisher d = root.advertise<S>("d", 1);
  ros::Publisher e = pnh.advertise<S>("e", 1);
  ros::Publisher f = debug.advertise<S>("f", 1);
  ros::Publisher g = camera.advertise<S>("g", 1);
  ros::Publisher h = arm.advertise<S>("/h", 1);
  ros::Publisher i = ros::NodeHandle("~").advertise<S>("i", 1);
  ros::Publisher j = ros::NodeHandle().advertise<S>("j", 1);
  ros::Publisher k = sided.advertise<S>("k", 1);
  ros::Publisher l = unknown.advertise<S>("l", 1);
  int m = arm.param("m", 3);
  ros::spin();
  return m;
}
