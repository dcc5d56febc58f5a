#include <image_transport/image_transport.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>

namespace vision {

class ImageFlipper final : public rclcpp::Node {
public:
    explicit ImageFlipper(const rclcpp::NodeOptions& options) : Node("image_flipper", options) {
        const auto transport = declare_parameter<std::string>("transport", "raw");
        pub_ = image_transport::create_publisher(this, "image_out");
        sub_ = image_transport::create_subscription(this, "image_in",
            std::bind(&ImageFlipper::flip, this, std::placeholders::_1), transport, rmw_qos_profile_sensor_data);
    }

private:
    void flip(const sensor_msgs::msg::Image::ConstSharedPtr& image) { pub_.publish(image); }

    image_transport::Publisher pub_;
    image_transport::Subscriber sub_;
};

}

RCLCPP_COMPONENTS_REGISTER_NODE(vision::ImageFlipper)
