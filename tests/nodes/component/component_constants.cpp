#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/color_rgba.hpp>

#define ROVER(x) "rover/" x
#define ON_TOPIC "on"

class Lights : public rclcpp::Node
{
    enum class Side { Left, Right };
    static inline const std::string BASE = "rover";
    static constexpr std::size_t DEPTH{6};
    using Colour = std_msgs::msg::ColorRGBA;

public:
    explicit Lights(const rclcpp::NodeOptions &options)
        : Node(BASE + "_lights", options)
    {
        left_ = create_publisher<Colour>(BASE + "/left", DEPTH);
        right_ = create_publisher<Colour>(topic(Side::Right), DEPTH);
        roof_ = create_publisher<Colour>(ROVER("roof"), DEPTH);
        on_ = create_subscription<Colour>(ON_TOPIC, DEPTH, std::bind(&Lights::on, this, std::placeholders::_1));
    }

private:
    static std::string topic(Side side) { return side == Side::Left ? "rover/left" : "rover/right"; }
    void on(Colour::ConstSharedPtr) {}
    rclcpp::Publisher<Colour>::SharedPtr left_, right_, roof_;
    rclcpp::Subscription<Colour>::SharedPtr on_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Lights)
