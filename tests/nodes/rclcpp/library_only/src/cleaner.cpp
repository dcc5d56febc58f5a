#include "library_only/cleaner.hpp"

using std_msgs::msg::Float32;
using library_only::Cleaner;

Cleaner::Cleaner(const rclcpp::NodeOptions &opts) : rclcpp::Node{"cleaner", opts}
{
    brush_ = create_publisher<Float32>("brush", rclcpp::QoS{10}.reliable());
    dirt_ = create_subscription<Float32>("dirt", 10, std::bind(&Cleaner::dirt, this, std::placeholders::_1));
    dock_ = create_client<std_srvs::srv::SetBool>("dock");
}

void Cleaner::dirt(Float32::UniquePtr msg)
{
    if (msg->data > 0.9f && dock_->service_is_ready()) {
        auto request = std::make_shared<std_srvs::srv::SetBool::Request>();
        dock_->async_send_request(request, [](rclcpp::Client<std_srvs::srv::SetBool>::SharedFuture) {});
    }
    brush_->publish(std::move(msg));
}
