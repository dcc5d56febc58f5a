#include "split_component/station_component.hpp"

void StationComponent::windCallback(const geometry_msgs::msg::Vector3Stamped::SharedPtr) {}
void StationComponent::timerCallback() {weather_->publish(sensor_msgs::msg::Temperature());}
