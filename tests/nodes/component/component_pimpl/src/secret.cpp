#include "component_pimpl/secret.hpp"
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/u_int8_multi_array.hpp>

namespace secret {

class Secret::Impl {
public:
	explicit Impl(Secret& owner) : owner_(owner) {
		sub_ = owner_.create_subscription<std_msgs::msg::UInt8MultiArray>("bytes", 10, [this](std_msgs::msg::UInt8MultiArray::UniquePtr m) { pub_->publish(std::move(m)); });
		pub_ = owner_.create_publisher<std_msgs::msg::UInt8MultiArray>("coded", 10);
	}

private:
	Secret& owner_;
	rclcpp::Subscription<std_msgs::msg::UInt8MultiArray>::SharedPtr sub_;
	rclcpp::Publisher<std_msgs::msg::UInt8MultiArray>::SharedPtr pub_;
};

Secret::Secret(const rclcpp::NodeOptions& options)
	: rclcpp::Node("secret", options), impl_(new Impl(*this)) {}

Secret::~Secret() = default;

}

RCLCPP_COMPONENTS_REGISTER_NODE(secret::Secret)
