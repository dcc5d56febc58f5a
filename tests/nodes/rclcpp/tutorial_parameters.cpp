#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

class Tutorial : public rclcpp::Node
{
public:
  Tutorial() : Node("tutorial")
  {
    this->declare_parameter("wrapped", rclcpp::ParameterValue(std::string("value")));
    this->declare_parameter<std::string>("my_topic", "tutorial_topic");
    this->declare_parameter("ints", std::vector<int64_t>({1, 2, 3}));

    const std::string a = this->get_parameter("my_topic").get_parameter_value().get<std::string>();
    const auto b = this->get_parameter("my_topic").get_value<std::string>();
    rclcpp::Parameter c;
    this->get_parameter("my_topic", c);
    std::string d;
    this->get_parameter<std::string>("my_topic", d);

    pub_a_ = create_publisher<std_msgs::msg::String>(a, 10);
    pub_b_ = create_publisher<std_msgs::msg::String>(b + "_b", 10);
    pub_d_ = create_publisher<std_msgs::msg::String>(d, 10);
  }

private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_a_, pub_b_, pub_d_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Tutorial>());
  rclcpp::shutdown();
  return 0;
}
