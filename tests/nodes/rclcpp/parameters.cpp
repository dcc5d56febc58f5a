#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"

class Parameters : public rclcpp::Node
{
public:
  Parameters()
  : Node("parameters")
  {
    this->declare_parameter("frame", "map");
    this->declare_parameter<int>("count", 3);
    this->declare_parameter("on", true);
    declare_parameter("gains", std::vector<double>{1.0, 2.0});
    declare_parameter<std::string>("required");
    declare_parameter("typed", rclcpp::ParameterType::PARAMETER_DOUBLE);

    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = "how fast";
    rcl_interfaces::msg::FloatingPointRange range;
    range.from_value = 0.0;
    range.to_value = 2.0;
    descriptor.floating_point_range.push_back(range);
    declare_parameter("speed", 1.0, descriptor);
    auto fixed = rcl_interfaces::msg::ParameterDescriptor{};
    fixed.read_only = true;
    declare_parameter("serial", "none", fixed);

    if (!has_parameter("late")) {
      declare_parameter("late", rclcpp::ParameterValue(5));
    }
    get_parameter("frame", frame_);
    count_ = get_parameter("count").as_int();
    get_parameter_or("other", count_, 4L);
    on_set_ = add_on_set_parameters_callback(
      [](const std::vector<rclcpp::Parameter> &) {
        rcl_interfaces::msg::SetParametersResult result;
        result.successful = true;
        return result;
      });
  }

private:
  std::string frame_;
  int64_t count_;
  OnSetParametersCallbackHandle::SharedPtr on_set_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Parameters>());
  rclcpp::shutdown();
  return 0;
}
