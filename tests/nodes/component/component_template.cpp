#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/float32.hpp>

template <typename Msg>
class Filter : public rclcpp::Node
{
public:
  Filter(const std::string & name, const rclcpp::NodeOptions & options)
  : rclcpp::Node(name, options)
  {
    out_ = this->template create_publisher<Msg>("out", 1);
    in_ = this->template create_subscription<Msg>("in", 1, std::bind(&Filter::on, this, std::placeholders::_1));
  }

protected:
  virtual Msg filter(const Msg & m) = 0;

private:
  void on(std::shared_ptr<const Msg> m) {out_->publish(filter(*m));}
  typename rclcpp::Publisher<Msg>::SharedPtr out_;
  typename rclcpp::Subscription<Msg>::SharedPtr in_;
};

class SmoothFloat : public Filter<std_msgs::msg::Float32>
{
public:
  explicit SmoothFloat(const rclcpp::NodeOptions & options)
  : Filter<std_msgs::msg::Float32>("smooth", options)
  {
    state_pub_ = create_publisher<std_msgs::msg::Float32>("state", 1);
  }

protected:
  std_msgs::msg::Float32 filter(const std_msgs::msg::Float32 & m) override
  {
    state_.data = 0.9f * state_.data + 0.1f * m.data;
    state_pub_->publish(state_);
    return state_;
  }

private:
  std_msgs::msg::Float32 state_;
  rclcpp::Publisher<std_msgs::msg::Float32>::SharedPtr state_pub_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(SmoothFloat)
