#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;

class Comments : public rclcpp::Node
{
public:
  Comments()
  : Node(/* name */ "comments") // base
  {
    pub_ = this->create_publisher<std_msgs::msg::String /* text */>(
      "spoken",  // topic
      // create_publisher<std_msgs::msg::String>("unspoken", 1)
      10 /* depth */);
    sub_ = this /* node */ ->create_subscription<std_msgs::msg::String>(
      /* topic */ "heard", 1'000, // deep
      [this](const std_msgs::msg::String::ConstSharedPtr /* msg */) -> void {});
    timer_ = create_wall_timer(1'500ms, /* ticks */ [] {});
  }

private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Comments>());
  rclcpp::shutdown();
}
