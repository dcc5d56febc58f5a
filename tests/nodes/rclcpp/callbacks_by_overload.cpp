#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/joy.hpp>
#include <std_msgs/msg/int32.hpp>
#include <std_srvs/srv/empty.hpp>

class Overloads : public rclcpp::Node
{
  using Int32 = std_msgs::msg::Int32;

public:
  Overloads() : Node("overloads")
  {
    std::function<void(Int32::SharedPtr)> function = std::bind(&Overloads::number, this, std::placeholders::_1, 3);
    a_ = create_subscription<Int32>("a", 1, function);
    b_ = create_subscription<Int32>("b", 1, std::function<void(Int32::SharedPtr)>(std::bind(&Overloads::number, this, std::placeholders::_1, 4)));
    c_ = create_subscription<Int32>("c", 1, &Overloads::fixed);
    d_ = create_subscription<sensor_msgs::msg::Joy>("d", 1, std::bind(static_cast<void (Overloads::*)(sensor_msgs::msg::Joy::SharedPtr)>(&Overloads::joy), this, std::placeholders::_1));
    e_ = create_service<std_srvs::srv::Empty>("e", [this](std_srvs::srv::Empty::Request::SharedPtr request, std_srvs::srv::Empty::Response::SharedPtr response) { empty(request, response); });
    f_ = create_subscription<Int32>("f", 1, Handler{this});
  }

private:
  struct Handler
  {
    Overloads * owner;
    void operator()(const Int32 &) const {}
  };
  void number(Int32::SharedPtr, int) {}
  static void fixed(const Int32 &) {}
  void joy(sensor_msgs::msg::Joy::SharedPtr) {}
  void joy(int) {}
  void empty(std_srvs::srv::Empty::Request::SharedPtr, std_srvs::srv::Empty::Response::SharedPtr) {}

  rclcpp::SubscriptionBase::SharedPtr a_, b_, c_, d_, f_;
  rclcpp::ServiceBase::SharedPtr e_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Overloads>());
  rclcpp::shutdown();
  return 0;
}
