// A node of the stand-in: see rclcpp.hpp.

#ifndef RCLCPP__NODE_HPP_
#define RCLCPP__NODE_HPP_

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/list_parameters_result.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/services.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/topics.hpp"

namespace rclcpp
{

namespace node_interfaces
{

using OnSetParametersCallback = std::function<
  rcl_interfaces::msg::SetParametersResult (const std::vector<Parameter> &)>;
using PostSetParametersCallback = std::function<void (const std::vector<Parameter> &)>;

struct OnSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(OnSetParametersCallbackHandle)
  OnSetParametersCallback callback;
};

struct PostSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(PostSetParametersCallbackHandle)
  PostSetParametersCallback callback;
};

}  // namespace node_interfaces

namespace stand_in
{
// The parameters of a node, with the services and the topic that show them.
class Parameters;
}  // namespace stand_in

class Node : public std::enable_shared_from_this<Node>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)

  explicit Node(const std::string & name, const NodeOptions & options = NodeOptions())
  : Node(name, "", options) {}
  Node(
    const std::string & name, const std::string & namespace_,
    const NodeOptions & options = NodeOptions());
  virtual ~Node();
  Node(const Node &) = delete;
  Node & operator=(const Node &) = delete;

  const char * get_name() const {return base_->get_name();}
  const char * get_namespace() const {return base_->get_namespace();}
  const char * get_fully_qualified_name() const {return base_->get_fully_qualified_name();}
  Logger get_logger() const;
  Clock::SharedPtr get_clock() {return clock_;}
  Clock::ConstSharedPtr get_clock() const {return clock_;}
  Time now() const {return clock_->now();}
  node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return base_;}
  const NodeOptions & get_node_options() const {return options_;}
  size_t count_publishers(const std::string & topic) const;
  size_t count_subscribers(const std::string & topic) const;

  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType group_type)
  {
    return std::make_shared<CallbackGroup>(group_type);
  }

  template<class MessageT>
  std::shared_ptr<Publisher<MessageT>> create_publisher(
    const std::string & topic, const QoS & qos, const PublisherOptions & = PublisherOptions())
  {
    return std::make_shared<Publisher<MessageT>>(base_, topic, qos);
  }

  template<class MessageT, class CallbackT>
  std::shared_ptr<Subscription<MessageT>> create_subscription(
    const std::string & topic, const QoS & qos, CallbackT && callback,
    const SubscriptionOptions & options = SubscriptionOptions())
  {
    return added(
      std::make_shared<Subscription<MessageT>>(
        base_, topic, qos, std::forward<CallbackT>(callback), options));
  }

  template<class ServiceT, class CallbackT>
  typename Service<ServiceT>::SharedPtr create_service(
    const std::string & name, CallbackT && callback, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    return added(
      std::make_shared<Service<ServiceT>>(
        base_, name, std::forward<CallbackT>(callback), qos, group));
  }

  template<class ServiceT>
  typename Client<ServiceT>::SharedPtr create_client(
    const std::string & name, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    return added(std::make_shared<Client<ServiceT>>(base_, name, qos, group));
  }

  template<class Rep = int64_t, class Period = std::milli, class CallbackT>
  typename WallTimer<CallbackT>::SharedPtr create_wall_timer(
    std::chrono::duration<Rep, Period> period, CallbackT callback,
    CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    return added(
      std::make_shared<WallTimer<CallbackT>>(
        base_, std::make_shared<Clock>(RCL_STEADY_TIME), nanoseconds_of(period),
        std::move(callback), group, autostart));
  }

  template<class Rep = int64_t, class Period = std::milli, class CallbackT>
  typename GenericTimer<CallbackT>::SharedPtr create_timer(
    std::chrono::duration<Rep, Period> period, CallbackT callback,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return added(
      std::make_shared<GenericTimer<CallbackT>>(
        base_, clock_, nanoseconds_of(period), std::move(callback), group, true));
  }

  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  using OnSetParametersCallbackType = node_interfaces::OnSetParametersCallback;
  using PostSetParametersCallbackHandle = node_interfaces::PostSetParametersCallbackHandle;
  using PostSetParametersCallbackType = node_interfaces::PostSetParametersCallback;

  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & value,
    const Descriptor & descriptor = Descriptor(), bool ignore_override = false);
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type, const Descriptor & descriptor = Descriptor(),
    bool ignore_override = false);
  template<class T>
  auto declare_parameter(
    const std::string & name, const T & value, const Descriptor & descriptor = Descriptor(),
    bool ignore_override = false)
  {
    const ParameterValue given(value);
    try {
      return declare_parameter(name, given, descriptor, ignore_override).template get<T>();
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException(name, error.what());
    }
  }
  template<class T>
  auto declare_parameter(
    const std::string & name, const Descriptor & descriptor = Descriptor(),
    bool ignore_override = false)
  {
    const ParameterType type = ParameterValue(T{}).get_type();
    try {
      return declare_parameter(name, type, descriptor, ignore_override).template get<T>();
    } catch (const ParameterTypeException &) {
      throw exceptions::UninitializedStaticallyTypedParameterException(name);
    }
  }
  void undeclare_parameter(const std::string & name);
  bool has_parameter(const std::string & name) const;

  rcl_interfaces::msg::SetParametersResult set_parameter(const Parameter & parameter);
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(
    const std::vector<Parameter> & parameters);
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(
    const std::vector<Parameter> & parameters);

  Parameter get_parameter(const std::string & name) const;
  bool get_parameter(const std::string & name, Parameter & parameter) const;
  template<class T>
  bool get_parameter(const std::string & name, T & value) const
  {
    Parameter parameter;
    const bool is_there = get_parameter(name, parameter);
    if (is_there) {
      value = static_cast<T>(parameter.get_value<T>());
    }
    return is_there;
  }
  template<class T>
  bool get_parameter_or(const std::string & name, T & value, const T & alternative) const
  {
    const bool is_there = get_parameter(name, value);
    if (!is_there) {
      value = alternative;
    }
    return is_there;
  }
  template<class T>
  T get_parameter_or(const std::string & name, const T & alternative) const
  {
    T value;
    get_parameter_or(name, value, alternative);
    return value;
  }
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const;
  Descriptor describe_parameter(const std::string & name) const;
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, uint64_t depth) const;

  [[nodiscard]] OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
    OnSetParametersCallbackType callback);
  [[nodiscard]] PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
    PostSetParametersCallbackType callback);
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * const handle);
  void remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * const handle);

private:
  template<class EntityT>
  std::shared_ptr<EntityT> added(std::shared_ptr<EntityT> entity)
  {
    base_->add(entity);
    return entity;
  }

  template<class Rep, class Period>
  static std::chrono::nanoseconds nanoseconds_of(std::chrono::duration<Rep, Period> period)
  {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(period);
  }

  NodeOptions options_;
  stand_in::NodeBase base_;
  Clock::SharedPtr clock_;
  std::shared_ptr<stand_in::Parameters> parameters_;
};

}  // namespace rclcpp

#endif  // RCLCPP__NODE_HPP_
