#ifndef PLAN_KEEPER__PLAN_KEEPER_HPP_
#define PLAN_KEEPER__PLAN_KEEPER_HPP_

#include <memory>

#include "geometry_msgs/msg/pose_array.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/empty.hpp"

namespace plan_keeper
{

class PlanKeeper : public rclcpp::Node
{
public:
  explicit PlanKeeper(const rclcpp::NodeOptions & options = rclcpp::NodeOptions());

private:
  void planCallback(const geometry_msgs::msg::PoseArray::SharedPtr plan);
  void clearCallback(
    const std::shared_ptr<std_srvs::srv::Empty::Request> request,
    std::shared_ptr<std_srvs::srv::Empty::Response> response);
  void timerCallback();

  rclcpp::Subscription<geometry_msgs::msg::PoseArray>::SharedPtr plan_sub_;
  rclcpp::Publisher<geometry_msgs::msg::PoseArray>::SharedPtr plan_pub_;
  rclcpp::Service<std_srvs::srv::Empty>::SharedPtr clear_srv_;
  rclcpp::TimerBase::SharedPtr timer_;
  geometry_msgs::msg::PoseArray plan_;
  double rate_;
};

}  // namespace plan_keeper

#endif  // PLAN_KEEPER__PLAN_KEEPER_HPP_
