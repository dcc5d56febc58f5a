#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float32.hpp"

class Arm : public rclcpp::Node
{
public:
  Arm() : Node("left")
  {
    sub_ = create_subscription<std_msgs::msg::Float32>("goal", 1, std::bind(&Arm::goal, this, std::placeholders::_1));
    pub_ = create_publisher<std_msgs::msg::Float32>("at", 1);
  }

private:
  void goal(const std_msgs::msg::Float32 & msg) {pub_->publish(msg);}
  rclcpp::Subscription<std_msgs::msg::Float32>::SharedPtr sub_;
  rclcpp::Publisher<std_msgs::msg::Float32>::SharedPtr pub_;
};

class Watcher : public rclcpp::Node
{
public:
  Watcher() : Node("watcher", "robot", rclcpp::NodeOptions().use_intra_process_comms(true))
  {
    sub_ = create_subscription<std_msgs::msg::Float32>("at", 1, [](std_msgs::msg::Float32::UniquePtr) {});
  }

private:
  rclcpp::Subscription<std_msgs::msg::Float32>::SharedPtr sub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::executors::SingleThreadedExecutor executor;
  auto arm = std::make_shared<Arm>();
  auto watcher = std::make_shared<Watcher>();
  executor.add_node(arm);
  executor.add_node(watcher);
  executor.spin();
  rclcpp::shutdown();
  return 0;
}
