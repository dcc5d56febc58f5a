// A node that uses each kind of endpoint, with rclcpp or its stand-in.

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"

using std_msgs::msg::String;
using std_srvs::srv::SetBool;

class Everything : public rclcpp::Node
{
public:
  Everything()
  : Node("everything")
  {
    label_ = declare_parameter<std::string>("label", "none");
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    rcl_interfaces::msg::FloatingPointRange range;
    range.from_value = 1.0;
    range.to_value = 100.0;
    descriptor.description = "how often, in hertz";
    descriptor.floating_point_range.push_back(range);
    declare_parameter<double>("rate", 20.0, descriptor);
    on_set_ = add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> & parameters) {
        rcl_interfaces::msg::SetParametersResult result;
        result.successful = true;
        for (const auto & each : parameters) {
          if (each.get_name() == "label" && each.as_string().empty()) {
            result.successful = false;
            result.reason = "a label is not empty";
          }
        }
        return result;
      });
    post_set_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {follow();});
    ticks_ = create_publisher<String>("ticks", rclcpp::SensorDataQoS());
    echoes_ = create_publisher<String>("echoes", rclcpp::QoS(10).reliable().transient_local());
    words_ = create_subscription<String>(
      "words", 10, [this](const String & message) {handle(message);});
    service_ = create_service<SetBool>(
      "switch", [this](
        const SetBool::Request::SharedPtr request, SetBool::Response::SharedPtr response) {
        response->success = request->data;
        response->message = label_;
      });
    client_ = create_client<SetBool>("answer");
    follow();
  }

private:
  void follow()
  {
    get_parameter("label", label_);
    const auto period = std::chrono::duration<double>(1.0 / get_parameter("rate").as_double());
    timer_ = create_wall_timer(period, [this]() {tick();});
  }

  void tick()
  {
    auto message = std::make_unique<String>();
    message->data = label_;
    ticks_->publish(std::move(message));
  }

  // Ask the other side about a word, and say what it answers.
  void handle(const String & message)
  {
    RCLCPP_INFO_STREAM(get_logger(), "words: " << to_yaml(message, true));
    if (!client_->wait_for_service(std::chrono::seconds(30))) {
      RCLCPP_ERROR(get_logger(), "%s is not there", client_->get_service_name());
      return;
    }
    auto request = std::make_shared<SetBool::Request>();
    request->data = message.data == "true";
    client_->async_send_request(
      request, [this](rclcpp::Client<SetBool>::SharedFuture future) {
        String echo;
        echo.data = future.get()->message;
        echoes_->publish(echo);
      });
  }

  std::string label_;
  OnSetParametersCallbackHandle::SharedPtr on_set_;
  PostSetParametersCallbackHandle::SharedPtr post_set_;
  rclcpp::Publisher<String>::SharedPtr ticks_;
  rclcpp::Publisher<String>::SharedPtr echoes_;
  rclcpp::Subscription<String>::SharedPtr words_;
  rclcpp::Service<SetBool>::SharedPtr service_;
  rclcpp::Client<SetBool>::SharedPtr client_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Everything>());
  rclcpp::shutdown();
  return 0;
}
