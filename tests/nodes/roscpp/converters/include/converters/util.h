#ifndef CONVERTERS_UTIL_H
#define CONVERTERS_UTIL_H
#include <ros/ros.h>

namespace util
{
inline void spinAt(double hz)
{
  ros::Rate rate(hz);
  while (ros::ok())
  {
    ros::spinOnce();
    rate.sleep();
  }
}
}
#endif
