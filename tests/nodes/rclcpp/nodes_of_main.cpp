#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

class Relay : public rclcpp::Node
{
public:
  using rclcpp::Node::Node;

  void start(const std::string & from, const std::string & to = "relayed")
  {
    pub_ = create_publisher<std_msgs::msg::Bool>(to, 1);
    sub_ = create_subscription<std_msgs::msg::Bool>(from, 1, [this](const std_msgs::msg::Bool & b) {pub_->publish(b);});
  }

private:
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr sub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto relay = std::make_shared<Relay>("relay");
  relay->start("original");
  auto beat = relay->create_publisher<std_msgs::msg::Bool>("beat", 1);
  auto extra = std::make_shared<rclcpp::Node>("extra");
  auto timer = extra->create_wall_timer(std::chrono::seconds(1), [&beat]() {beat->publish(std_msgs::msg::Bool());});

  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(relay);
  executor.add_node(extra);
  executor.spin();
  rclcpp::shutdown();
}
