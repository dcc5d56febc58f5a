#include <cinttypes>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/u_int64.hpp>
#if defined(USE_DEBUG_TOPIC) || defined(DEBUG)
#include <std_msgs/msg/string.hpp>
#endif

class Branchy : public rclcpp::Node {
public:
	explicit Branchy(const rclcpp::NodeOptions &options) : Node("branchy", options) {
#if RCLCPP_VERSION_MAJOR >= 16 || 1
		sub = create_subscription<std_msgs::msg::UInt64>("stamp", rclcpp::SensorDataQoS(),
#else
		sub = create_subscription<std_msgs::msg::UInt64>("stamp", 10,
#endif
			std::bind(&Branchy::on_stamp, this, std::placeholders::_1));
#if defined(USE_DEBUG_TOPIC) || defined(DEBUG)
		debug = create_publisher<std_msgs::msg::String>("debug", 1);
#endif
	}

private:
	void on_stamp(const std_msgs::msg::UInt64 &stamp) {
		RCLCPP_DEBUG(get_logger(), "%" PRIu64 "us", stamp.data);
	}
	rclcpp::Subscription<std_msgs::msg::UInt64>::SharedPtr sub;
#if defined(USE_DEBUG_TOPIC) || defined(DEBUG)
	rclcpp::Publisher<std_msgs::msg::String>::SharedPtr debug;
#endif
};

RCLCPP_COMPONENTS_REGISTER_NODE(Branchy)
