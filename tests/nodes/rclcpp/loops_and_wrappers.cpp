#include <array>
#include <map>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/range.hpp>

using sensor_msgs::msg::Range;

static const std::array<std::string, 2> kSides = {"left", "right"};

class Loops : public rclcpp::Node {
 public:
  Loops() : Node("loops") {
    for (const auto& side : kSides) {
      subs_.push_back(create_subscription<Range>(
          side + "/range", 1, [this, side](Range::ConstSharedPtr r) { last_[side] = r->range; }));
    }
    front_ = Advertise("front");
    rear_ = Advertise("rear");
    for (size_t i = 0; i < last_.size(); ++i) {
      more_.push_back(create_publisher<Range>("more" + std::to_string(i), 1));
    }
  }

 private:
  rclcpp::Publisher<Range>::SharedPtr Advertise(const std::string& name) {
    return create_publisher<Range>("~/" + name, 5);
  }

  std::vector<rclcpp::Subscription<Range>::SharedPtr> subs_;
  std::vector<rclcpp::Publisher<Range>::SharedPtr> more_;
  rclcpp::Publisher<Range>::SharedPtr front_, rear_;
  std::map<std::string, float> last_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Loops>());
  rclcpp::shutdown();
}
