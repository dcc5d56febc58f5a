#include <chrono>
#include <memory>
#include <vector>

#include <geometry_msgs/msg/pose_stamped.hpp>
#include <lift_msgs/msg/lift_status.hpp>
#include <lift_msgs/msg/pallet.hpp>
#include <lift_msgs/srv/move_to.hpp>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/string.hpp>

using lift_msgs::msg::Pallet;
using MoveTo = lift_msgs::srv::MoveTo;

constexpr char kPalletTopic[] = "pallets";

class Planner : public rclcpp::Node
{
public:
  Planner() : rclcpp::Node("planner")
  {
    declare_parameter<std::vector<double>>("shelf_heights", {0.2, 1.4, 2.6});
    declare_parameter("robot_name", "lifty");
    declare_parameter("weight_limit", 400.0);
    this->get_parameter("weight_limit", weight_limit_);

    pallet_sub_ = create_subscription<Pallet>(
      kPalletTopic, rclcpp::QoS(10).transient_local(),
      [this](const Pallet & pallet) { this->on_pallet(pallet); });
    status_sub_ = this->create_subscription<lift_msgs::msg::LiftStatus>(
      "lift/status", 10, [this](lift_msgs::msg::LiftStatus::ConstSharedPtr status) {
        height_ = status->height;
        if (!status->error.empty()) {
          RCLCPP_ERROR(get_logger(), "lift: %s", status->error.c_str());
        }
      });
    weight_sub_ = create_subscription<std_msgs::msg::Float64>(
      "scale/weight", rclcpp::QoS(rclcpp::KeepLast(5)).best_effort(),
      std::bind(&Planner::on_weight, this, std::placeholders::_1));
    goal_pub_ = create_publisher<geometry_msgs::msg::PoseStamped>("goal", 1);
    mode_pub_ = create_publisher<std_msgs::msg::String>("scale/mode", rclcpp::QoS{1}.reliable().transient_local());
    client_ = create_client<MoveTo>("lift/move_to");
    timer_ = rclcpp::create_timer(this, get_clock(), rclcpp::Duration::from_seconds(1.0), [this]() { tick(); });
  }

private:
  void on_pallet(const Pallet & pallet)
  {
    if (pallet.weight > weight_limit_) {
      return;
    }
    geometry_msgs::msg::PoseStamped goal;
    goal.header.frame_id = "map";
    goal.header.stamp = get_clock()->now();
    goal.pose.position = pallet.position;
    goal.pose.orientation.w = 1.0;
    goal_pub_->publish(goal);
    move(pallet.position.z);
  }

  void on_weight(const std_msgs::msg::Float64::SharedPtr msg)
  {
    weight_ = msg->data;
  }

  void move(double height)
  {
    auto request = std::make_shared<MoveTo::Request>();
    request->height = height;
    request->slowly = weight_ > 100.0;
    client_->async_send_request(request, [this](rclcpp::Client<MoveTo>::SharedFuture future) {
      const auto response = future.get();
      if (!response->accepted) {
        RCLCPP_WARN(get_logger(), "refused: %s", response->reason.c_str());
      }
    });
  }

  void tick()
  {
    auto mode = std::make_unique<std_msgs::msg::String>();
    mode->data = get_parameter("robot_name").as_string();
    mode_pub_->publish(std::move(mode));
  }

  double weight_limit_{};
  double weight_{};
  double height_{};
  rclcpp::Subscription<Pallet>::SharedPtr pallet_sub_;
  rclcpp::Subscription<lift_msgs::msg::LiftStatus>::SharedPtr status_sub_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr weight_sub_;
  rclcpp::Publisher<geometry_msgs::msg::PoseStamped>::SharedPtr goal_pub_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr mode_pub_;
  rclcpp::Client<MoveTo>::SharedPtr client_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Planner>();
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
