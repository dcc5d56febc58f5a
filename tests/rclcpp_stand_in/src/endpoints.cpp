// Publishers, subscriptions, services, clients and timers of the stand-in.

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rcl/arguments.h"
#include "rcl/error_handling.h"
#include "rcl/graph.h"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{

namespace
{

// What ends fails at most because ROS has ended before.
void ignore(rcl_ret_t result)
{
  if (result != RCL_RET_OK) {
    rcl_reset_error();
  }
}

// Tell whether there was something to take.
bool is_taken(rcl_ret_t result, const char * what)
{
  switch (result) {
    case RCL_RET_SUBSCRIPTION_TAKE_FAILED:
    case RCL_RET_SERVICE_TAKE_FAILED:
    case RCL_RET_CLIENT_TAKE_FAILED:
      rcl_reset_error();
      return false;
    default:
      stand_in::check(result, what);
      return true;
  }
}

QoS from_rmw(const rmw_qos_profile_t * profile)
{
  return QoS(QoSInitialization::from_rmw(*profile), *profile);
}

}  // namespace

namespace node_interfaces
{

NodeBaseInterface::NodeBaseInterface(
  const std::string & name, const std::string & namespace_, const NodeOptions & options)
: context_(contexts::get_global_default_context()), node_(rcl_get_zero_initialized_node()),
  group_(std::make_shared<CallbackGroup>(CallbackGroupType::MutuallyExclusive))
{
  rcl_node_options_t own = rcl_node_get_default_options();
  own.use_global_arguments = options.use_global_arguments();
  own.enable_rosout = options.enable_rosout();
  std::vector<const char *> arguments;
  for (const std::string & each : options.arguments()) {
    arguments.push_back(each.c_str());
  }
  const int count = static_cast<int>(arguments.size());
  stand_in::check(
    rcl_parse_arguments(count, arguments.data(), own.allocator, &own.arguments), "arguments");
  const rcl_ret_t result = rcl_node_init(
    &node_, name.c_str(), namespace_.c_str(), context_->get(), &own);
  ignore(rcl_node_options_fini(&own));
  stand_in::check(result, "node");
}

NodeBaseInterface::~NodeBaseInterface()
{
  ignore(rcl_node_fini(&node_));
}

const char * NodeBaseInterface::get_fully_qualified_name() const
{
  return rcl_node_get_fully_qualified_name(&node_);
}

void NodeBaseInterface::add(const std::shared_ptr<stand_in::Entity> & entity)
{
  std::lock_guard<std::mutex> lock(mutex_);
  entities_.push_back(entity);
}

std::vector<std::shared_ptr<stand_in::Entity>> NodeBaseInterface::entities()
{
  std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::shared_ptr<stand_in::Entity>> found;
  for (const auto & each : entities_) {
    if (auto entity = each.lock()) {
      found.push_back(entity);
    }
  }
  entities_.assign(found.begin(), found.end());
  return found;
}

}  // namespace node_interfaces

PublisherBase::PublisherBase(
  stand_in::NodeBase node, const std::string & topic, const rosidl_message_type_support_t * type,
  const QoS & qos)
: node_(node), publisher_(rcl_get_zero_initialized_publisher())
{
  rcl_publisher_options_t options = rcl_publisher_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  stand_in::check(
    rcl_publisher_init(&publisher_, node->get_rcl_node_handle(), type, topic.c_str(), &options),
    "publisher");
}

PublisherBase::~PublisherBase()
{
  ignore(rcl_publisher_fini(&publisher_, node_->get_rcl_node_handle()));
}

size_t PublisherBase::get_subscription_count() const
{
  size_t count = 0;
  stand_in::check(rcl_publisher_get_subscription_count(&publisher_, &count), "publisher");
  return count;
}

QoS PublisherBase::get_actual_qos() const
{
  return from_rmw(rcl_publisher_get_actual_qos(&publisher_));
}

bool PublisherBase::assert_liveliness() const
{
  return rcl_publisher_assert_liveliness(&publisher_) == RCL_RET_OK;
}

void PublisherBase::publish_message(const void * message)
{
  const rcl_ret_t result = rcl_publish(&publisher_, message, nullptr);
  if (result != RCL_RET_OK && !node_->get_context()->is_valid()) {
    // As with rclcpp, nothing is published after the end, and nobody is told.
    rcl_reset_error();
    return;
  }
  stand_in::check(result, "publish");
}

SubscriptionBase::SubscriptionBase(
  stand_in::NodeBase node, const std::string & topic, const rosidl_message_type_support_t * type,
  const QoS & qos, const SubscriptionOptions & options)
: Entity(node, options.callback_group), subscription_(rcl_get_zero_initialized_subscription())
{
  rcl_subscription_options_t own = rcl_subscription_get_default_options();
  own.qos = qos.get_rmw_qos_profile();
  own.rmw_subscription_options.ignore_local_publications = options.ignore_local_publications;
  stand_in::check(
    rcl_subscription_init(&subscription_, node->get_rcl_node_handle(), type, topic.c_str(), &own),
    "subscription");
  ignore(rcl_subscription_options_fini(&own));
}

SubscriptionBase::~SubscriptionBase()
{
  ignore(rcl_subscription_fini(&subscription_, node_->get_rcl_node_handle()));
}

size_t SubscriptionBase::get_publisher_count() const
{
  size_t count = 0;
  stand_in::check(rcl_subscription_get_publisher_count(&subscription_, &count), "subscription");
  return count;
}

QoS SubscriptionBase::get_actual_qos() const
{
  return from_rmw(rcl_subscription_get_actual_qos(&subscription_));
}

void SubscriptionBase::add_to(rcl_wait_set_t * wait_set)
{
  stand_in::check(rcl_wait_set_add_subscription(wait_set, &subscription_, &index_), "wait");
}

bool SubscriptionBase::is_ready(const rcl_wait_set_t * wait_set) const
{
  return wait_set->subscriptions[index_] != nullptr;
}

void SubscriptionBase::handle()
{
  const auto message = create_message();
  rmw_message_info_t info = rmw_get_zero_initialized_message_info();
  if (is_taken(rcl_take(&subscription_, message.get(), &info, nullptr), "take")) {
    handle_message(message);
  }
}

ServiceBase::ServiceBase(
  stand_in::NodeBase node, const std::string & name, const rosidl_service_type_support_t * type,
  const QoS & qos, CallbackGroup::SharedPtr group)
: Entity(node, group), service_(rcl_get_zero_initialized_service())
{
  rcl_service_options_t options = rcl_service_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  stand_in::check(
    rcl_service_init(&service_, node->get_rcl_node_handle(), type, name.c_str(), &options),
    "service");
}

ServiceBase::~ServiceBase()
{
  ignore(rcl_service_fini(&service_, node_->get_rcl_node_handle()));
}

void ServiceBase::add_to(rcl_wait_set_t * wait_set)
{
  stand_in::check(rcl_wait_set_add_service(wait_set, &service_, &index_), "wait");
}

bool ServiceBase::is_ready(const rcl_wait_set_t * wait_set) const
{
  return wait_set->services[index_] != nullptr;
}

void ServiceBase::handle()
{
  const auto request = create_request();
  const auto id = std::make_shared<rmw_request_id_t>();
  if (is_taken(rcl_take_request(&service_, id.get(), request.get()), "take a request")) {
    // The callback may change it.
    rmw_request_id_t kept = *id;
    if (const auto response = respond(id, request)) {
      send_any_response(kept, response.get());
    }
  }
}

void ServiceBase::send_any_response(rmw_request_id_t & id, void * response)
{
  stand_in::check(rcl_send_response(&service_, &id, response), "send a response");
}

ClientBase::ClientBase(
  stand_in::NodeBase node, const std::string & name, const rosidl_service_type_support_t * type,
  const QoS & qos, CallbackGroup::SharedPtr group)
: Entity(node, group), client_(rcl_get_zero_initialized_client())
{
  rcl_client_options_t options = rcl_client_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  stand_in::check(
    rcl_client_init(&client_, node->get_rcl_node_handle(), type, name.c_str(), &options),
    "client");
}

ClientBase::~ClientBase()
{
  ignore(rcl_client_fini(&client_, node_->get_rcl_node_handle()));
}

bool ClientBase::service_is_ready() const
{
  bool is_there = false;
  const rcl_ret_t result = rcl_service_server_is_available(
    node_->get_rcl_node_handle(), &client_, &is_there);
  if (result != RCL_RET_OK && !node_->get_context()->is_valid()) {
    rcl_reset_error();
    return false;
  }
  stand_in::check(result, "client");
  return is_there;
}

bool ClientBase::wait_for(std::chrono::nanoseconds timeout) const
{
  const auto begin = std::chrono::steady_clock::now();
  while (!service_is_ready()) {
    const bool is_late =
      timeout.count() >= 0 && std::chrono::steady_clock::now() - begin >= timeout;
    if (is_late || !sleep_for(std::chrono::milliseconds(10), node_->get_context())) {
      return false;
    }
  }
  return true;
}

int64_t ClientBase::send(const void * request)
{
  int64_t number = 0;
  stand_in::check(rcl_send_request(&client_, request, &number), "send a request");
  return number;
}

void ClientBase::add_to(rcl_wait_set_t * wait_set)
{
  stand_in::check(rcl_wait_set_add_client(wait_set, &client_, &index_), "wait");
}

bool ClientBase::is_ready(const rcl_wait_set_t * wait_set) const
{
  return wait_set->clients[index_] != nullptr;
}

void ClientBase::handle()
{
  const auto response = create_response();
  rmw_request_id_t id;
  if (is_taken(rcl_take_response(&client_, &id, response.get()), "take a response")) {
    handle_response(id.sequence_number, response);
  }
}

TimerBase::TimerBase(
  stand_in::NodeBase node, Clock::SharedPtr clock, std::chrono::nanoseconds period,
  CallbackGroup::SharedPtr group, bool autostart)
: Entity(node, group), clock_(clock), timer_(rcl_get_zero_initialized_timer())
{
  if (period.count() < 0) {
    throw std::invalid_argument("timer period cannot be negative");
  }
  stand_in::check(
    rcl_timer_init2(
      &timer_, clock->get_clock_handle(), node->get_context()->get(), period.count(), nullptr,
      rcl_get_default_allocator(), autostart),
    "timer");
}

TimerBase::~TimerBase()
{
  ignore(rcl_timer_fini(&timer_));
}

void TimerBase::cancel()
{
  stand_in::check(rcl_timer_cancel(&timer_), "timer");
}

bool TimerBase::is_canceled()
{
  bool result = false;
  stand_in::check(rcl_timer_is_canceled(&timer_, &result), "timer");
  return result;
}

void TimerBase::reset()
{
  stand_in::check(rcl_timer_reset(&timer_), "timer");
}

bool TimerBase::is_ready()
{
  bool result = false;
  stand_in::check(rcl_timer_is_ready(&timer_, &result), "timer");
  return result;
}

std::chrono::nanoseconds TimerBase::time_until_trigger()
{
  int64_t left = 0;
  const rcl_ret_t result = rcl_timer_get_time_until_next_call(&timer_, &left);
  if (result == RCL_RET_TIMER_CANCELED) {
    return std::chrono::nanoseconds::max();
  }
  stand_in::check(result, "timer");
  return std::chrono::nanoseconds(left);
}

void TimerBase::add_to(rcl_wait_set_t * wait_set)
{
  stand_in::check(rcl_wait_set_add_timer(wait_set, &timer_, &index_), "wait");
}

bool TimerBase::is_ready(const rcl_wait_set_t * wait_set) const
{
  return wait_set->timers[index_] != nullptr;
}

void TimerBase::handle()
{
  // It may have been canceled since.
  const rcl_ret_t result = rcl_timer_call(&timer_);
  if (result == RCL_RET_TIMER_CANCELED) {
    rcl_reset_error();
    return;
  }
  stand_in::check(result, "timer");
  call();
}

}  // namespace rclcpp
