// Temperaturwächter für den großen Ofen - nein, für beide (°C)
#include <ros/ros.h>
#include <sensor_msgs/Temperature.h>

/* hört zu */ void heiss(const sensor_msgs::Temperature& t) { ROS_WARN("%f °C", t.temperature); }

int main(int argc, char** argv) {
  ros::init(argc, argv, "ofen");
  ros::NodeHandle nh; /* größer */ ros::Subscriber sub = nh.subscribe("wärme", 1, heiss);
  ros::spin();
}
