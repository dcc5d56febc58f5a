#pragma once
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/fluid_pressure.hpp>
#include <std_msgs/msg/string.hpp>

namespace ocean::deep
{
using Depth = sensor_msgs::msg::FluidPressure;
using State = std_msgs::msg::String;

class Marine : public rclcpp::Node
{
public:
	explicit Marine(const rclcpp::NodeOptions &options);

private:
	static std::string topic(const std::string &name) { return "marine/" + name; }
	void onDepth(Depth::ConstSharedPtr msg);

	rclcpp::Subscription<Depth>::SharedPtr depth_;
	rclcpp::Publisher<State>::SharedPtr state_;
};
} // namespace ocean::deep
