// Wärmt für Ö und Ü
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/empty.hpp"

class Groups : public rclcpp::Node
{
public:
  Groups() : Node("groups")
  {
    services_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    rclcpp::SubscriptionOptions options;
    options.callback_group = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    sub_ = create_subscription<std_msgs::msg::String>("text", rclcpp::QoS(5), std::bind(&Groups::text, this, std::placeholders::_1), options); /* hört */
    client_ = create_client<std_srvs::srv::Empty>("clear", rclcpp::ServicesQoS(), services_);
    server_ = create_service<std_srvs::srv::Empty>("again", std::bind(&Groups::again, this, std::placeholders::_1, std::placeholders::_2), rclcpp::ServicesQoS(), services_);
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&Groups::tick, this), services_);
  }

private:
  void text(const std_msgs::msg::String::SharedPtr) {client_->async_send_request(std::make_shared<std_srvs::srv::Empty::Request>());}
  void again(std_srvs::srv::Empty::Request::SharedPtr, std_srvs::srv::Empty::Response::SharedPtr) {}
  void tick() {}
  rclcpp::CallbackGroup::SharedPtr services_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
  rclcpp::Client<std_srvs::srv::Empty>::SharedPtr client_;
  rclcpp::Service<std_srvs::srv::Empty>::SharedPtr server_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::executors::MultiThreadedExecutor e(rclcpp::ExecutorOptions(), 2);
  auto n = std::make_shared<Groups>();
  e.add_node(n);
  e.spin();
}
