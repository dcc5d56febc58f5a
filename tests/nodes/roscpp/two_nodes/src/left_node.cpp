#include "two_nodes/side.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "left_node");
  Side side("left");
  ros::spin();
}
