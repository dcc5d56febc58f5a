#pragma once
#include <memory>
#include <rclcpp/rclcpp.hpp>

namespace secret {

class Secret : public rclcpp::Node {
public:
	explicit Secret(const rclcpp::NodeOptions& options);
	~Secret() override;

private:
	class Impl;
	std::unique_ptr<Impl> impl_;
};

}
