// A program that asks twice and ends: it spins until the answer is there, and waits in a callback.

#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/set_bool.hpp"

using std_srvs::srv::SetBool;
using namespace std::chrono_literals;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("asks");
  const auto client = node->create_client<SetBool>("switch");
  if (!client->wait_for_service(30s)) {
    return 1;
  }
  const auto request = std::make_shared<SetBool::Request>();
  request->data = true;
  const auto sent = client->async_send_request(request).share();
  if (rclcpp::spin_until_future_complete(node, sent, 30s) != rclcpp::FutureReturnCode::SUCCESS) {
    return 2;
  }
  RCLCPP_INFO(node->get_logger(), "answered: %s", sent.get()->message.c_str());

  rclcpp::executors::MultiThreadedExecutor executor;
  const auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  const auto timer = node->create_wall_timer(
    10ms, [&]() {
      const auto again = client->async_send_request(request).share();
      if (again.wait_for(30s) == std::future_status::ready) {
        RCLCPP_INFO(node->get_logger(), "waited for: %s", again.get()->message.c_str());
      }
      executor.cancel();
    }, group);
  executor.add_node(node);
  executor.spin();
  rclcpp::shutdown();
  return 0;
}
