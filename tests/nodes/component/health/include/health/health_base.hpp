#pragma once
#include "rclcpp/rclcpp.hpp"

namespace health
{
class HealthBase : public rclcpp::Node
{
protected:
  HealthBase(const std::string & name, const rclcpp::NodeOptions & options) : rclcpp::Node(name, options)
  {
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&HealthBase::sample, this));
  }
  virtual void sample() = 0;

private:
  rclcpp::TimerBase::SharedPtr timer_;
};
}
