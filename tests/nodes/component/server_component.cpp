#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "std_srvs/srv/trigger.hpp"

namespace demo
{
class TriggerServer : public rclcpp::Node
{
public:
  explicit TriggerServer(const rclcpp::NodeOptions & options)
  : rclcpp::Node("trigger_server", options)
  {
    auto handle =
      [this](
      const std::shared_ptr<std_srvs::srv::Trigger::Request>,
      std::shared_ptr<std_srvs::srv::Trigger::Response> response) -> void
      {
        response->success = true;
        std::flush(std::cout);
      };
    server_ = create_service<std_srvs::srv::Trigger>("trigger", handle);
    client_ = create_client<std_srvs::srv::Trigger>("next/trigger");
  }

private:
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr server_;
  rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr client_;
};
}

RCLCPP_COMPONENTS_REGISTER_NODE(demo::TriggerServer)
