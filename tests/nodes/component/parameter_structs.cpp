#include <rcl_interfaces/msg/parameter_descriptor.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/float64.hpp>

class Structs : public rclcpp::Node
{
public:
    explicit Structs(const rclcpp::NodeOptions& options)
        : Node("structs", options)
        , params_{
              declare_parameter<std::string>("params.topic", "measured"),
              declare_parameter("params.gain", 0.5, describe("gain of the loop", 0.0, 1.0)),
          }
    {
        pub_ = create_publisher<std_msgs::msg::Float64>("value", depth());
        change_ = add_on_set_parameters_callback(std::bind(&Structs::onChange, this, std::placeholders::_1));
    }

private:
    struct Params { std::string topic; double gain; };

    static rcl_interfaces::msg::ParameterDescriptor describe(const std::string& text, double low, double high)
    {
        rcl_interfaces::msg::ParameterDescriptor d;
        d.description = text;
        d.floating_point_range.resize(1);
        d.floating_point_range[0].from_value = low;
        d.floating_point_range[0].to_value = high;
        return d;
    }
    int depth() { return static_cast<int>(declare_parameter<int64_t>("depth", 10)); }
    rcl_interfaces::msg::SetParametersResult onChange(const std::vector<rclcpp::Parameter>&) { return {}; }

    Params params_;
    rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr pub_;
    OnSetParametersCallbackHandle::SharedPtr change_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Structs)
