#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <sensor_msgs/msg/image.hpp>

namespace cfg {

static rclcpp::NodeOptions withIntraProcess(rclcpp::NodeOptions options)
{
	return options.use_intra_process_comms(true);
}

class Intra : public rclcpp::Node {
	using Image = sensor_msgs::msg::Image;
	using SubscriptionT = rclcpp::Subscription<Image>;
	using PublisherT = rclcpp::Publisher<Image>;

public:
	Intra(const rclcpp::NodeOptions &options)
		: rclcpp::Node{"intra", withIntraProcess(options)}
	{
		rclcpp::SubscriptionOptions sub_options;
		sub_options.ignore_local_publications = true;

		std::weak_ptr<std::remove_pointer<decltype(pub_.get())>::type> captured =
			pub_ = this->create_publisher<Image>("out", rclcpp::SensorDataQoS{});
		sub_ = this->create_subscription<Image>(std::string{"in"}, rclcpp::SensorDataQoS{},
			[captured](Image::UniquePtr image) {
				if (auto pub = captured.lock())
					pub->publish(std::move(image));
			}, sub_options);
	}

private:
	PublisherT::SharedPtr pub_;
	SubscriptionT::SharedPtr sub_;
};

} // namespace cfg

RCLCPP_COMPONENTS_REGISTER_NODE(cfg::Intra)
