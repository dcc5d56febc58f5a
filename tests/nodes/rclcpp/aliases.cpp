#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/joy.hpp>
#include <std_srvs/srv/set_bool.hpp>

typedef geometry_msgs::msg::Twist Twist;
namespace gm = geometry_msgs::msg;
using namespace sensor_msgs::msg;
using Switch = std_srvs::srv::SetBool;
template<typename T>
using Pub = typename rclcpp::Publisher<T>::SharedPtr;

class Aliases : public rclcpp::Node
{
  using SelfT = Aliases;
  using Stamped = gm::TwistStamped;

public:
  explicit Aliases(const std::string & name)
  : Node(name)
  {
    twist_ = create_publisher<Twist>("twist", 1);
    stamped_ = create_publisher<Stamped>("stamped", 1);
    joy_ = create_subscription<Joy>("joy", 1, std::bind(&SelfT::onJoy, this, std::placeholders::_1));
    client_ = create_client<Switch>("switch");
    pose_ = rclcpp::create_publisher<gm::Pose>(*this, "pose", 1);
  }

private:
  void onJoy(const Joy::SharedPtr) {}

  Pub<Twist> twist_;
  Pub<Stamped> stamped_;
  Pub<gm::Pose> pose_;
  rclcpp::Subscription<Joy>::SharedPtr joy_;
  rclcpp::Client<Switch>::SharedPtr client_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Aliases>("aliases");
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
  rclcpp::shutdown();
}
