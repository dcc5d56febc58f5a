#include "image_transport/image_transport.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/image.hpp"

static image_transport::Publisher pub;

void imageCallback(const sensor_msgs::msg::Image::ConstSharedPtr & msg)
{
  pub.publish(msg);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::Node::SharedPtr node = rclcpp::Node::make_shared("images", rclcpp::NodeOptions());
  image_transport::ImageTransport it(node);
  pub = it.advertise("out/image", 1);
  image_transport::Subscriber a = it.subscribe("in/image", 1, imageCallback);
  auto b = image_transport::create_subscription(node.get(), "more/image", imageCallback, "raw", rmw_qos_profile_sensor_data);
  auto c = image_transport::create_publisher(node.get(), "copy/image");
  rclcpp::spin(node);
}
