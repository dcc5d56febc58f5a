#include "foreign_lifecycle/controller.hpp"

#include <utility>

using namespace std::chrono_literals;

namespace nav
{

Controller::Controller(const rclcpp::NodeOptions & options)
: robot_utils::LifecycleNode("controller", "", options)
{
  RCLCPP_INFO(get_logger(), "Creating controller");
  declare_parameter("frequency", rclcpp::ParameterValue(20.0));
}

Controller::~Controller() {}

robot_utils::CallbackReturn
Controller::on_configure(const rclcpp_lifecycle::State & /*state*/)
{
  auto node = shared_from_this();

  vel_publisher_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 1);
  odom_sub_ = node->create_subscription<geometry_msgs::msg::PoseStamped>(
    "odom", rclcpp::SystemDefaultsQoS(), std::bind(&Controller::odom, this, std::placeholders::_1));
  speed_limit_sub_ = create_subscription<std_msgs::msg::Float64>(
    "speed_limit", rclcpp::QoS(10),
    std::bind(&Controller::speedLimit, this, std::placeholders::_1));
  return robot_utils::CallbackReturn::SUCCESS;
}

robot_utils::CallbackReturn
Controller::on_activate(const rclcpp_lifecycle::State & /*state*/)
{
  vel_publisher_->on_activate();
  createBond();
  return robot_utils::CallbackReturn::SUCCESS;
}

void Controller::odom(geometry_msgs::msg::PoseStamped::SharedPtr) {}
void Controller::speedLimit(const std_msgs::msg::Float64::SharedPtr) {}

}  // namespace nav
