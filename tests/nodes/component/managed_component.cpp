#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <std_msgs/msg/float64.hpp>

using rclcpp_lifecycle::LifecycleNode;
using rclcpp_lifecycle::State;

class Gripper : public LifecycleNode
{
public:
    explicit Gripper(const rclcpp::NodeOptions &options) : LifecycleNode("gripper", options)
    {
        declare_parameter("force", 5.0);
    }

    CallbackReturn on_configure(const State &) override
    {
        states_ = create_publisher<sensor_msgs::msg::JointState>("joint_states", 10);
        return CallbackReturn::SUCCESS;
    }

    CallbackReturn on_activate(const State &) override
    {
        states_->on_activate();
        position_ = create_subscription<std_msgs::msg::Float64>("position", 1, std::bind(&Gripper::move, this, std::placeholders::_1));
        loop_ = create_wall_timer(std::chrono::milliseconds(20), std::bind(&Gripper::step, this));
        return CallbackReturn::SUCCESS;
    }

    CallbackReturn on_deactivate(const State &) override
    {
        loop_.reset();
        position_.reset();
        return CallbackReturn::SUCCESS;
    }

private:
    void move(const std_msgs::msg::Float64 &p) { at_ = p.data; }
    void step() { states_->publish(sensor_msgs::msg::JointState()); }

    double at_ = 0;
    rclcpp_lifecycle::LifecyclePublisher<sensor_msgs::msg::JointState>::SharedPtr states_;
    rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr position_;
    rclcpp::TimerBase::SharedPtr loop_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Gripper)
