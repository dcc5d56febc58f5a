#include<rclcpp/rclcpp.hpp>
#include<rclcpp_components/register_node_macro.hpp>
#include<std_msgs/msg/bool.hpp>
using B=std_msgs::msg::Bool;
class D:public rclcpp::Node{
rclcpp::Publisher<B>::SharedPtr p=create_publisher<B>("p",1);
rclcpp::Subscription<B>::SharedPtr s{create_subscription<B>("s",1,[this](const B&b){p->publish(b);})};
public:D(const rclcpp::NodeOptions&o):Node("d",o){}};
RCLCPP_COMPONENTS_REGISTER_NODE(D)
