#include "plan_keeper/plan_keeper.hpp"

#include <functional>
#include <memory>

namespace plan_keeper
{

using std::placeholders::_1;
using std::placeholders::_2;

PlanKeeper::PlanKeeper(const rclcpp::NodeOptions & options)
: Node("plan_keeper", options)
{
  rate_ = declare_parameter("rate", 2.0);
  plan_sub_ = create_subscription<geometry_msgs::msg::PoseArray>(
    "plan", rclcpp::SystemDefaultsQoS(), std::bind(&PlanKeeper::planCallback, this, _1));
  plan_pub_ = create_publisher<geometry_msgs::msg::PoseArray>("kept_plan", rclcpp::QoS(1).transient_local());
  clear_srv_ = create_service<std_srvs::srv::Empty>(
    "clear_plan", std::bind(&PlanKeeper::clearCallback, this, _1, _2));
  timer_ = create_wall_timer(
    std::chrono::milliseconds(500), std::bind(&PlanKeeper::timerCallback, this));
}

void PlanKeeper::planCallback(const geometry_msgs::msg::PoseArray::SharedPtr plan)
{
  plan_ = *plan;
}

void PlanKeeper::clearCallback(
  const std::shared_ptr<std_srvs::srv::Empty::Request>,
  std::shared_ptr<std_srvs::srv::Empty::Response>)
{
  plan_.poses.clear();
}

void PlanKeeper::timerCallback()
{
  plan_pub_->publish(plan_);
}

}  // namespace plan_keeper

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<plan_keeper::PlanKeeper>());
  rclcpp::shutdown();
  return 0;
}
