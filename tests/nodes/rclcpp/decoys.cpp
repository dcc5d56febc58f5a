#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/char.hpp>
#include <thread>

// create_publisher<std_msgs::msg::Char>("comment", 1);
/// Usage: node->create_subscription<T>("documentation", 10, callback);
static const char * const kText = "create_client<std_srvs::srv::Empty>(\"string\")";

class Factory
{
public:
  template<typename T>
  std::shared_ptr<T> create_publisher(const std::string &, int) {return std::make_shared<T>();}
  void create_wall_timer(int, void (*)()) {}
  void declare_parameter(const std::string &, double) {}
  int create_service(const char *) {return 0;}
};

class Decoys : public rclcpp::Node
{
  Factory factory_;
  rclcpp::Publisher<std_msgs::msg::Char>::SharedPtr real_;

public:
  Decoys() : Node("decoys")
  {
    auto fake = factory_.create_publisher<int>("fake", 1);
    factory_.create_wall_timer(100, [] {});
    factory_.declare_parameter("fake", 1.0);
    factory_.create_service("fake");
    real_ = create_publisher<std_msgs::msg::Char>("real", 1);
    std::thread([this] {rclcpp::sleep_for(std::chrono::seconds(1)); real_->publish(std_msgs::msg::Char());}).detach();
    RCLCPP_DEBUG(get_logger(), "%s R\"(create_timer)\"", kText);
    const char * raw = R"x(create_publisher<std_msgs::msg::Char>("raw", 1);)x";
    (void)raw;
    // auto old = create_publisher<std_msgs::msg::Char>("old", 1);
  }
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Decoys>());
  rclcpp::shutdown();
}
