// A program that asks once, waits for the answer, and ends.

#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/set_bool.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("asks");
  const auto client = node->create_client<std_srvs::srv::SetBool>("switch");
  if (!client->wait_for_service(std::chrono::seconds(30))) {
    return 1;
  }
  const auto request = std::make_shared<std_srvs::srv::SetBool::Request>();
  request->data = true;
  const auto sent = client->async_send_request(request).share();
  const auto code = rclcpp::spin_until_future_complete(node, sent, std::chrono::seconds(30));
  if (code != rclcpp::FutureReturnCode::SUCCESS) {
    return 2;
  }
  RCLCPP_INFO(node->get_logger(), "answered: %s", sent.get()->message.c_str());
  rclcpp::shutdown();
  return 0;
}
