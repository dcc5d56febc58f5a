#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/empty.hpp>
#include <std_msgs/msg/u_int8.hpp>

struct Lambda : rclcpp::Node
{
    explicit Lambda(const rclcpp::NodeOptions &opts)
        : Node("lambda", opts)
        , count(create_publisher<std_msgs::msg::UInt8>("count", 1))
        , up(create_subscription<std_msgs::msg::Empty>("up", 1, [this](std_msgs::msg::Empty::ConstSharedPtr) { change(1); }))
        , down(create_subscription<std_msgs::msg::Empty>("down", 1, [this](const std_msgs::msg::Empty &) { change(-1); }))
    {
    }

    void change(int by)
    {
        std_msgs::msg::UInt8 m;
        m.data = n += by;
        count->publish(m);
    }

    int n = 0;
    rclcpp::Publisher<std_msgs::msg::UInt8>::SharedPtr count;
    rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr up, down;
};

#include <rclcpp_components/register_node_macro.hpp>
RCLCPP_COMPONENTS_REGISTER_NODE(Lambda)
