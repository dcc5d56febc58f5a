#include <rclcpp_shop/shop.hpp>

namespace shop
{
using MarkerQueue = std_msgs::msg::Int32;

std::shared_ptr<Shop> Shop::make(const std::string & topic)
{
  auto shop = std::shared_ptr<Shop>(new Shop());
  shop->orders_ = shop->create_subscription<std_msgs::msg::String>(
    topic, 10, std::bind(&Shop::order, shop.get(), std::placeholders::_1));
  shop->queue_ = shop->create_publisher<MarkerQueue>(kQueue, 10);
  return shop;
}

Shop::Shop()
: Node("shop")
{
  open_ = create_publisher<std_msgs::msg::Bool>("open", rclcpp::QoS(1).transient_local());
}

void Shop::order(std_msgs::msg::String::ConstSharedPtr) {queue_->publish(MarkerQueue());}
}  // namespace shop

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(shop::Shop::make("orders"));
  rclcpp::shutdown();
}
