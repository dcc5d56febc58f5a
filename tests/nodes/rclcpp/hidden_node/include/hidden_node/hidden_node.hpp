#pragma once
#include <memory>
#include <rclcpp/rclcpp.hpp>

class HiddenNode : public rclcpp::Node
{
public:
  HiddenNode();
  ~HiddenNode() override;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};
