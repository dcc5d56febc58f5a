// The functions of the stand-in that make the endpoints of a node: see rclcpp.hpp.

#ifndef RCLCPP__CREATE_HPP_
#define RCLCPP__CREATE_HPP_

#include <chrono>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/node.hpp"

namespace rclcpp
{

namespace stand_in
{

// A node is given as itself, or as a pointer to it.
template<class NodeT>
auto & node_of(NodeT && node)
{
  if constexpr (std::is_base_of_v<Node, std::decay_t<NodeT>>) {
    return node;
  } else {
    return *node;
  }
}

}  // namespace stand_in

template<class MessageT, class NodeT>
std::shared_ptr<Publisher<MessageT>> create_publisher(
  NodeT && node, const std::string & topic, const QoS & qos,
  const PublisherOptions & options = PublisherOptions())
{
  return stand_in::node_of(node).template create_publisher<MessageT>(topic, qos, options);
}

template<class MessageT, class CallbackT, class NodeT>
std::shared_ptr<Subscription<MessageT>> create_subscription(
  NodeT && node, const std::string & topic, const QoS & qos, CallbackT && callback,
  const SubscriptionOptions & options = SubscriptionOptions())
{
  return stand_in::node_of(node).template create_subscription<MessageT>(
    topic, qos, std::forward<CallbackT>(callback), options);
}

// A timer of a clock of its own.
template<class CallbackT, class NodeT>
TimerBase::SharedPtr create_timer(
  NodeT node, Clock::SharedPtr clock, Duration period, CallbackT && callback,
  CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  using F = std::decay_t<CallbackT>;
  const auto base = stand_in::node_of(node).get_node_base_interface();
  const auto timer = std::make_shared<GenericTimer<F>>(
    base, clock, period.to_chrono<std::chrono::nanoseconds>(),
    F(std::forward<CallbackT>(callback)), group, autostart);
  base->add(timer);
  return timer;
}

}  // namespace rclcpp

#endif  // RCLCPP__CREATE_HPP_
