#include <functional>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/u_int32.hpp>

namespace dds {
struct Reader {};
struct Participant {
  template <class T> Reader create_subscription(const std::string &, std::function<void(const T &)>) { return {}; }
  template <class T> int create_publisher(const std::string &) { return 0; }
  template <class T> int create_service(const std::string &) { return 0; }
  double declare_parameter(const std::string &, double value) { return value; }
  double get_parameter(const std::string &) { return 0; }
  int create_wall_timer(int, std::function<void()>) { return 0; }
};
}

class OtherProtocol : public rclcpp::Node {
public:
  OtherProtocol() : Node("other_protocol"), participant_(std::make_unique<dds::Participant>()) {
    participant_->create_subscription<int>("ints", [this](const int & n) { send(n); });
    participant_->create_publisher<int>("ints");
    participant_->create_service<int>("service");
    participant_->declare_parameter("depth", 2.0);
    participant_->get_parameter("depth");
    participant().create_wall_timer(10, [] {});
    dds::Participant other, * const pointer = &other;
    other.create_publisher<std_msgs::msg::UInt32>("other");
    pointer->create_publisher<std_msgs::msg::UInt32>("pointer");
    out_ = this->create_publisher<std_msgs::msg::UInt32>("out", 1);
    for (auto & p : more_) { p.create_publisher<std_msgs::msg::UInt32>("more"); }
  }

private:
  dds::Participant & participant() { return *participant_; }
  void send(int n) {
    std_msgs::msg::UInt32 m;
    m.data = n;
    out_->publish(m);
  }
  std::unique_ptr<dds::Participant> participant_;
  std::vector<dds::Participant> more_;
  rclcpp::Publisher<std_msgs::msg::UInt32>::SharedPtr out_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<OtherProtocol>());
  rclcpp::shutdown();
}
