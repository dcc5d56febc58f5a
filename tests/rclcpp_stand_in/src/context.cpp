// Beginning and ending, time, quality of service and logging of the stand-in.

#include <algorithm>
#include <csignal>
#include <stdexcept>
#include <thread>
#include <utility>

#include "rcl/arguments.h"
#include "rcl/error_handling.h"
#include "rcl/init.h"
#include "rcl/init_options.h"
#include "rcl/logging.h"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{

namespace
{

volatile std::sig_atomic_t was_signalled = 0;

void on_signal(int)
{
  was_signalled = 1;
}

Context::SharedPtr given_or_default(Context::SharedPtr context)
{
  return context ? context : contexts::get_global_default_context();
}

}  // namespace

void stand_in::check(rcl_ret_t result, const char * what)
{
  if (result != RCL_RET_OK) {
    const std::string message = std::string(what) + ": " + rcl_get_error_string().str;
    rcl_reset_error();
    throw exceptions::RCLError(message);
  }
}

Context::Context()
: context_(rcl_get_zero_initialized_context()) {}

Context::~Context()
{
  if (context_.impl != nullptr) {
    shutdown("the context is gone");
    if (rcl_context_fini(&context_) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }
}

void Context::init(int argc, char const * const * argv)
{
  const rcl_allocator_t allocator = rcl_get_default_allocator();
  rcl_init_options_t options = rcl_get_zero_initialized_init_options();
  stand_in::check(rcl_init_options_init(&options, allocator), "init options");
  stand_in::check(rcl_init(argc, argv, &options, &context_), "init");
  stand_in::check(rcl_init_options_fini(&options), "init options");
  stand_in::check(rcl_logging_configure(&context_.global_arguments, &allocator), "logging");
}

bool Context::is_valid() const
{
  return rcl_context_is_valid(&context_);
}

bool Context::shutdown(const std::string &)
{
  std::unique_lock<std::mutex> lock(mutex_);
  if (!is_valid()) {
    return false;
  }
  stand_in::check(rcl_shutdown(&context_), "shutdown");
  const auto callbacks = std::exchange(callbacks_, {});
  lock.unlock();
  for (const auto & callback : callbacks) {
    callback();
  }
  return true;
}

void Context::on_shutdown(std::function<void()> callback)
{
  std::lock_guard<std::mutex> lock(mutex_);
  callbacks_.push_back(std::move(callback));
}

namespace
{

// After a shutdown there is a new one: nodes of the earlier may still hold that.
Context::SharedPtr & default_context()
{
  static Context::SharedPtr context = std::make_shared<Context>();
  return context;
}

}  // namespace

Context::SharedPtr contexts::get_global_default_context()
{
  return default_context();
}

void init(int argc, char const * const * argv)
{
  if (default_context()->get()->impl != nullptr) {
    if (default_context()->is_valid()) {
      throw std::runtime_error("it is initialized already");
    }
    default_context() = std::make_shared<Context>();
  }
  was_signalled = 0;
  default_context()->init(argc, argv);
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool ok(Context::SharedPtr context)
{
  context = given_or_default(context);
  if (was_signalled) {
    context->shutdown("a signal came");
  }
  return context->is_valid();
}

bool shutdown(Context::SharedPtr context, const std::string & reason)
{
  return given_or_default(context)->shutdown(reason);
}

void on_shutdown(std::function<void()> callback, Context::SharedPtr context)
{
  given_or_default(context)->on_shutdown(std::move(callback));
}

std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv)
{
  const rcl_allocator_t allocator = rcl_get_default_allocator();
  rcl_arguments_t parsed = rcl_get_zero_initialized_arguments();
  stand_in::check(rcl_parse_arguments(argc, argv, allocator, &parsed), "arguments");
  int count = 0;
  const char ** left = nullptr;
  stand_in::check(rcl_remove_ros_arguments(argv, &parsed, allocator, &count, &left), "arguments");
  std::vector<std::string> result(left, left + count);
  allocator.deallocate(left, allocator.state);
  stand_in::check(rcl_arguments_fini(&parsed), "arguments");
  return result;
}

bool sleep_for(const std::chrono::nanoseconds & duration, Context::SharedPtr context)
{
  const auto end = std::chrono::steady_clock::now() + duration;
  while (ok(context) && std::chrono::steady_clock::now() < end) {
    const std::chrono::nanoseconds left = end - std::chrono::steady_clock::now();
    std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(
      left, std::chrono::milliseconds(20)));
  }
  return ok(context);
}

namespace
{

// Seconds and nanoseconds, as messages have them: the nanoseconds are never negative.
template<class MessageT>
MessageT to_message(int64_t nanoseconds)
{
  MessageT message;
  const int64_t billion = 1000000000;
  const int64_t rest = (nanoseconds % billion + billion) % billion;
  message.sec = static_cast<int32_t>((nanoseconds - rest) / billion);
  message.nanosec = static_cast<uint32_t>(rest);
  return message;
}

Duration from_rmw(const rmw_time_t & time)
{
  return Duration::from_nanoseconds(rmw_time_total_nsec(time));
}

}  // namespace

Duration::operator builtin_interfaces::msg::Duration() const
{
  return to_message<builtin_interfaces::msg::Duration>(nanoseconds_);
}

rmw_time_t Duration::to_rmw_time() const
{
  if (nanoseconds_ < 0) {
    throw std::runtime_error("rmw_time_t cannot be negative");
  }
  return rmw_time_from_nsec(nanoseconds_);
}

Time::Time(int32_t seconds, uint32_t nanoseconds, rcl_clock_type_t type)
: nanoseconds_(seconds * INT64_C(1000000000) + nanoseconds), type_(type)
{
  if (seconds < 0) {
    throw std::runtime_error("cannot store a negative time point in rclcpp::Time");
  }
}

Time::operator builtin_interfaces::msg::Time() const
{
  return to_message<builtin_interfaces::msg::Time>(nanoseconds_);
}

Duration Time::operator-(const Time & other) const
{
  if (type_ != other.type_) {
    throw std::runtime_error("times of two kinds of clocks");
  }
  return Duration::from_nanoseconds(nanoseconds_ - other.nanoseconds_);
}

Clock::Clock(rcl_clock_type_t type)
{
  rcl_allocator_t allocator = rcl_get_default_allocator();
  stand_in::check(rcl_clock_init(type, &clock_, &allocator), "clock");
}

Clock::~Clock()
{
  if (rcl_clock_fini(&clock_) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

Time Clock::now() const
{
  rcl_time_point_value_t now = 0;
  stand_in::check(rcl_clock_get_now(&clock_, &now), "clock");
  return Time(now, clock_.type);
}

Rate::Rate(double hertz, Clock::SharedPtr clock)
: Rate(Duration::from_seconds(1 / hertz), clock)
{
  if (hertz <= 0) {
    throw std::invalid_argument("a rate is greater than 0");
  }
}

Rate::Rate(const Duration & period, Clock::SharedPtr clock)
: clock_(clock), period_(period), last_(clock->now()) {}

bool Rate::sleep()
{
  const Time now = clock_->now();
  const Time next = last_ + period_;
  if (next <= now) {
    // It does not run after what it has missed.
    last_ = now > next + period_ ? now : next;
    return false;
  }
  last_ = next;
  return sleep_for((next - now).to_chrono<std::chrono::nanoseconds>());
}

QoS::QoS(const QoSInitialization & initialization, const rmw_qos_profile_t & profile)
: profile_(profile)
{
  profile_.history = initialization.history_policy;
  profile_.depth = initialization.depth;
}

QoS & QoS::history(HistoryPolicy policy)
{
  profile_.history = static_cast<rmw_qos_history_policy_t>(policy);
  return *this;
}

QoS & QoS::keep_last(size_t depth)
{
  profile_.depth = depth;
  return history(HistoryPolicy::KeepLast);
}

QoS & QoS::reliability(ReliabilityPolicy policy)
{
  profile_.reliability = static_cast<rmw_qos_reliability_policy_t>(policy);
  return *this;
}

QoS & QoS::durability(DurabilityPolicy policy)
{
  profile_.durability = static_cast<rmw_qos_durability_policy_t>(policy);
  return *this;
}

QoS & QoS::deadline(rmw_time_t time)
{
  profile_.deadline = time;
  return *this;
}

QoS & QoS::lifespan(rmw_time_t time)
{
  profile_.lifespan = time;
  return *this;
}

QoS & QoS::liveliness(LivelinessPolicy policy)
{
  profile_.liveliness = static_cast<rmw_qos_liveliness_policy_t>(policy);
  return *this;
}

QoS & QoS::liveliness_lease_duration(rmw_time_t time)
{
  profile_.liveliness_lease_duration = time;
  return *this;
}

QoS & QoS::avoid_ros_namespace_conventions(bool avoid)
{
  profile_.avoid_ros_namespace_conventions = avoid;
  return *this;
}

Duration QoS::deadline() const
{
  return from_rmw(profile_.deadline);
}

Duration QoS::lifespan() const
{
  return from_rmw(profile_.lifespan);
}

Duration QoS::liveliness_lease_duration() const
{
  return from_rmw(profile_.liveliness_lease_duration);
}

void Logger::set_level(Level level)
{
  if (rcutils_logging_set_logger_level(get_name(), static_cast<int>(level)) != RCUTILS_RET_OK) {
    rcutils_reset_error();
    throw exceptions::RCLError("the level of a logger cannot be set");
  }
}

}  // namespace rclcpp
