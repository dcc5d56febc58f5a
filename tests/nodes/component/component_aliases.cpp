#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <geometry_msgs/msg/wrench.hpp>
#include <std_srvs/srv/empty.hpp>

namespace geo = geometry_msgs;
using rclcpp::Node;
using rclcpp::NodeOptions;
using W = geo::msg::Wrench;
using WrenchSub = rclcpp::Subscription<W>;
using namespace std_srvs::srv;

class A : public Node {
  typedef A This;
  typedef Empty Reset;
 public:
  explicit A(NodeOptions const& o) : Node("alias_component", o) {
    auto self = this;
    s_ = self->create_subscription<W>("w", 1, [this](W::SharedPtr w) { on(w); });
    t_ = this->create_subscription<geo::msg::Wrench>("v", 1, std::bind(&This::on, this, std::placeholders::_1));
    c_ = Node::create_client<Reset>("reset");
    p_ = rclcpp::Node::create_publisher<W>("x", 1);
  }
 private:
  void on(W::SharedPtr) {}
  WrenchSub::SharedPtr s_, t_;
  rclcpp::Client<Reset>::SharedPtr c_;
  rclcpp::Publisher<W>::SharedPtr p_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(A)
