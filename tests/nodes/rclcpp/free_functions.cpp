#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_srvs/srv/empty.hpp>

rclcpp::Node::SharedPtr g_node = nullptr;
static rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr g_pub;

void on_value(const std_msgs::msg::Float64::SharedPtr msg)
{
    std_msgs::msg::Float64 twice;
    twice.data = 2 * msg->data;
    g_pub->publish(twice);
}

void on_reset(
    const std::shared_ptr<rmw_request_id_t>,
    const std::shared_ptr<std_srvs::srv::Empty::Request>,
    std::shared_ptr<std_srvs::srv::Empty::Response>)
{
    RCLCPP_INFO(g_node->get_logger(), "reset");
}

int main(int argc, char *argv[])
{
    rclcpp::init(argc, argv);
    g_node = std::make_shared<rclcpp::Node>("free_functions");
    g_pub = g_node->create_publisher<std_msgs::msg::Float64>("twice", 1);
    auto sub = g_node->create_subscription<std_msgs::msg::Float64>("value", 1, on_value);
    auto srv = g_node->create_service<std_srvs::srv::Empty>("reset", &on_reset);
    rclcpp::spin(g_node);
    rclcpp::shutdown();
    g_pub = nullptr;
    g_node = nullptr;
    return 0;
}
