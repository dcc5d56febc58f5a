#ifndef SPLIT_COMPONENT__STATION_COMPONENT_HPP_
#define SPLIT_COMPONENT__STATION_COMPONENT_HPP_
#include <geometry_msgs/msg/vector3_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/temperature.hpp>
#include <std_srvs/srv/trigger.hpp>

class StationComponent : public rclcpp::Node
{
public:
  explicit StationComponent(const rclcpp::NodeOptions & options);

private:
  void declareParameters();
  void createTopics();
  void windCallback(const geometry_msgs::msg::Vector3Stamped::SharedPtr wind);
  void timerCallback();

  std::string wind_topic_;
  double hz_;
  rclcpp::Subscription<geometry_msgs::msg::Vector3Stamped>::SharedPtr wind_;
  rclcpp::Publisher<sensor_msgs::msg::Temperature>::SharedPtr weather_;
  rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr calibrate_;
  rclcpp::TimerBase::SharedPtr timer_;
};
#endif
