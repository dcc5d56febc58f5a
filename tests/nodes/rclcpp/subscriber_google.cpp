#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_srvs/srv/set_bool.hpp"

namespace {

using sensor_msgs::msg::LaserScan;
using std::placeholders::_1;
using std::placeholders::_2;

constexpr char kNodeName[] = "scan_watch";

class ScanWatch final : public rclcpp::Node {
 public:
  ScanWatch() : rclcpp::Node(kNodeName) {
    limit_ = declare_parameter<double>("limit", 0.5);
    near_pub_ =
        create_publisher<std_msgs::msg::Bool>("near", rclcpp::QoS(1).transient_local());
    scan_sub_ = create_subscription<LaserScan>(
        "scan", rclcpp::SensorDataQoS(), std::bind(&ScanWatch::OnScan, this, _1));
    enable_srv_ = create_service<std_srvs::srv::SetBool>(
        "~/enable", std::bind(&ScanWatch::OnEnable, this, _1, _2));
  }

 private:
  void OnScan(const LaserScan::ConstSharedPtr scan) {
    std_msgs::msg::Bool near;
    near.data = enabled_ && !scan->ranges.empty() && scan->ranges[0] < limit_;
    near_pub_->publish(near);
  }

  void OnEnable(const std::shared_ptr<std_srvs::srv::SetBool::Request> request,
                std::shared_ptr<std_srvs::srv::SetBool::Response> response) {
    enabled_ = request->data;
    response->success = true;
  }

  bool enabled_ = true;
  double limit_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr near_pub_;
  rclcpp::Subscription<LaserScan>::SharedPtr scan_sub_;
  rclcpp::Service<std_srvs::srv::SetBool>::SharedPtr enable_srv_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<ScanWatch>());
  rclcpp::shutdown();
}
