#include "boat_drivers/sonar.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "sonar");
  ros::NodeHandle nh;
  ros::NodeHandle pnh("~");
  boat_drivers::Sonar sonar(nh, pnh);
  ros::spin();
  return 0;
}
