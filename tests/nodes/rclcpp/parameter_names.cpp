#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/u_int16.hpp>

class ParameterNames : public rclcpp::Node {
 public:
  ParameterNames() : Node("parameter_names") {
    std::string key = "frame_id";
    frame_ = declare_parameter(key, "base");
    key = "rate";
    rate_ = declare_parameter(key, 3.0);
    const std::string prefix = "pid.";
    for (const auto& gain : {"p", "i", "d"}) {
      gains_.push_back(declare_parameter(prefix + gain, 1.0));
    }
    Config config{"elsewhere", 4};
    Config standard;
    a_ = create_publisher<std_msgs::msg::UInt16>(config.topic, config.depth);
    b_ = create_publisher<std_msgs::msg::UInt16>(standard.topic, standard.depth);
  }

 private:
  struct Config {
    std::string topic = "ports";
    int depth = 2;
  };
  std::string frame_;
  double rate_;
  std::vector<double> gains_;
  rclcpp::Publisher<std_msgs::msg::UInt16>::SharedPtr a_, b_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<ParameterNames>());
  rclcpp::shutdown();
}
