#ifndef SPLIT_SETUP_STATION_H
#define SPLIT_SETUP_STATION_H

#include <geometry_msgs/Vector3Stamped.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/RelativeHumidity.h>
#include <sensor_msgs/Temperature.h>

namespace split_setup
{
class Station : public nodelet::Nodelet
{
public:
  virtual void onInit();

private:
  void readParameters();
  void createPublishers();
  void createSubscribers();
  void windCb(const geometry_msgs::Vector3Stamped& wind);
  void timerCb(const ros::TimerEvent& event);

  std::string name_;
  std::string wind_topic_ = "wind";
  double hz_;
  ros::Publisher weather_, humid_;
  ros::Subscriber wind_;
  ros::Timer timer_;
};
}  // namespace split_setup

#endif
