#include "split_setup/station.h"

namespace split_setup
{
void Station::windCb(const geometry_msgs::Vector3Stamped& wind)
{
  NODELET_DEBUG("wind %f", wind.vector.x);
}

void Station::timerCb(const ros::TimerEvent&)
{
  weather_.publish(sensor_msgs::Temperature());
  humid_.publish(sensor_msgs::RelativeHumidity());
}
}  // namespace split_setup
