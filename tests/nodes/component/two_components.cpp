#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/u_int32.hpp>

using std_msgs::msg::UInt32;

namespace pair {

class Ping : public rclcpp::Node {
public:
	Ping(rclcpp::NodeOptions o) : Node("ping", o) {
		pub = create_publisher<UInt32>("ping", 1);
		sub = create_subscription<UInt32>("pong", 1, std::bind(&Ping::pong, this, std::placeholders::_1));
	}
private:
	void pong(const UInt32 &n) { pub->publish(n); }
	rclcpp::Publisher<UInt32>::SharedPtr pub;
	rclcpp::Subscription<UInt32>::SharedPtr sub;
};

class Pong : public rclcpp::Node {
public:
	Pong(rclcpp::NodeOptions o) : Node("pong", o) {
		pub = create_publisher<UInt32>("pong", 1);
		sub = create_subscription<UInt32>("ping", 1, std::bind(&Pong::ping, this, std::placeholders::_1));
	}
private:
	void ping(const UInt32 &n) { pub->publish(n); }
	rclcpp::Publisher<UInt32>::SharedPtr pub;
	rclcpp::Subscription<UInt32>::SharedPtr sub;
};

}

RCLCPP_COMPONENTS_REGISTER_NODE(pair::Ping)
RCLCPP_COMPONENTS_REGISTER_NODE(pair::Pong)
