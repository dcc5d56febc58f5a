// Durations, points in time, clocks and rates of the stand-in: see rclcpp.hpp.

#ifndef RCLCPP__TIME_HPP_
#define RCLCPP__TIME_HPP_

#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>

#include "builtin_interfaces/msg/duration.hpp"
#include "builtin_interfaces/msg/time.hpp"
#include "rcl/time.h"
#include "rmw/types.h"

// The types of pointers that each class of rclcpp has, and what makes them.
#define RCLCPP_SMART_PTR_DEFINITIONS(...) \
  using SharedPtr = std::shared_ptr<__VA_ARGS__>; \
  using ConstSharedPtr = std::shared_ptr<const __VA_ARGS__>; \
  using WeakPtr = std::weak_ptr<__VA_ARGS__>; \
  using UniquePtr = std::unique_ptr<__VA_ARGS__>; \
  template<class ... Args> \
  static std::shared_ptr<__VA_ARGS__> make_shared(Args && ... args) \
  { \
    return std::make_shared<__VA_ARGS__>(std::forward<Args>(args)...); \
  } \
  template<class ... Args> \
  static std::unique_ptr<__VA_ARGS__> make_unique(Args && ... args) \
  { \
    return std::make_unique<__VA_ARGS__>(std::forward<Args>(args)...); \
  }

namespace rclcpp
{

class Duration
{
public:
  Duration(int32_t seconds, uint32_t nanoseconds)
  : nanoseconds_(seconds * INT64_C(1000000000) + nanoseconds) {}
  explicit Duration(std::chrono::nanoseconds nanoseconds)
  : nanoseconds_(nanoseconds.count()) {}
  template<class Rep, class Period>
  Duration(const std::chrono::duration<Rep, Period> & duration)
  : Duration(std::chrono::duration_cast<std::chrono::nanoseconds>(duration)) {}
  Duration(const builtin_interfaces::msg::Duration & message)
  : Duration(message.sec, message.nanosec) {}

  operator builtin_interfaces::msg::Duration() const;

  bool operator==(const Duration & other) const {return nanoseconds_ == other.nanoseconds_;}
  bool operator!=(const Duration & other) const {return nanoseconds_ != other.nanoseconds_;}
  bool operator<(const Duration & other) const {return nanoseconds_ < other.nanoseconds_;}
  bool operator<=(const Duration & other) const {return nanoseconds_ <= other.nanoseconds_;}
  bool operator>(const Duration & other) const {return nanoseconds_ > other.nanoseconds_;}
  bool operator>=(const Duration & other) const {return nanoseconds_ >= other.nanoseconds_;}
  Duration operator+(const Duration & other) const
  {
    return from_nanoseconds(nanoseconds_ + other.nanoseconds_);
  }
  Duration operator-(const Duration & other) const
  {
    return from_nanoseconds(nanoseconds_ - other.nanoseconds_);
  }
  Duration operator*(double scale) const
  {
    return from_nanoseconds(static_cast<int64_t>(static_cast<long double>(nanoseconds_) * scale));
  }

  rcl_duration_value_t nanoseconds() const {return nanoseconds_;}
  double seconds() const {return static_cast<double>(nanoseconds_) / 1e9;}
  static Duration max() {return from_nanoseconds(INT64_MAX);}
  static Duration from_seconds(double seconds)
  {
    return from_nanoseconds(static_cast<int64_t>(seconds * 1e9));
  }
  static Duration from_nanoseconds(rcl_duration_value_t nanoseconds)
  {
    return Duration(std::chrono::nanoseconds(nanoseconds));
  }
  template<class T>
  T to_chrono() const
  {
    return std::chrono::duration_cast<T>(std::chrono::nanoseconds(nanoseconds_));
  }
  rmw_time_t to_rmw_time() const;

private:
  rcl_duration_value_t nanoseconds_;
};

class Time
{
public:
  Time(int32_t seconds, uint32_t nanoseconds, rcl_clock_type_t type = RCL_SYSTEM_TIME);
  explicit Time(int64_t nanoseconds = 0, rcl_clock_type_t type = RCL_SYSTEM_TIME)
  : nanoseconds_(nanoseconds), type_(type) {}
  Time(const builtin_interfaces::msg::Time & message, rcl_clock_type_t type = RCL_ROS_TIME)
  : Time(message.sec, message.nanosec, type) {}

  operator builtin_interfaces::msg::Time() const;

  // Times of two kinds of clocks cannot be compared: std::runtime_error.
  bool operator==(const Time & other) const {return (*this - other).nanoseconds() == 0;}
  bool operator!=(const Time & other) const {return (*this - other).nanoseconds() != 0;}
  bool operator<(const Time & other) const {return (*this - other).nanoseconds() < 0;}
  bool operator<=(const Time & other) const {return (*this - other).nanoseconds() <= 0;}
  bool operator>(const Time & other) const {return (*this - other).nanoseconds() > 0;}
  bool operator>=(const Time & other) const {return (*this - other).nanoseconds() >= 0;}
  Time operator+(const Duration & other) const
  {
    return Time(nanoseconds_ + other.nanoseconds(), type_);
  }
  Time operator-(const Duration & other) const
  {
    return Time(nanoseconds_ - other.nanoseconds(), type_);
  }
  Duration operator-(const Time & other) const;

  rcl_time_point_value_t nanoseconds() const {return nanoseconds_;}
  double seconds() const {return static_cast<double>(nanoseconds_) / 1e9;}
  rcl_clock_type_t get_clock_type() const {return type_;}

private:
  rcl_time_point_value_t nanoseconds_;
  rcl_clock_type_t type_;
};

// A clock of ROS time is the system's: no simulated time is followed.
class Clock
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)

  explicit Clock(rcl_clock_type_t type = RCL_SYSTEM_TIME);
  ~Clock();
  Clock(const Clock &) = delete;
  Clock & operator=(const Clock &) = delete;

  Time now() const;
  rcl_clock_type_t get_clock_type() const noexcept {return clock_.type;}
  rcl_clock_t * get_clock_handle() noexcept {return &clock_;}

private:
  mutable rcl_clock_t clock_;
};

class Rate
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)

  explicit Rate(double hertz, Clock::SharedPtr clock = std::make_shared<Clock>());
  explicit Rate(const Duration & period, Clock::SharedPtr clock = std::make_shared<Clock>());
  virtual ~Rate() = default;

  virtual bool sleep();
  std::chrono::nanoseconds period() const {return period_.to_chrono<std::chrono::nanoseconds>();}

private:
  Clock::SharedPtr clock_;
  Duration period_;
  Time last_;
};

class WallRate : public Rate
{
public:
  explicit WallRate(double hertz)
  : Rate(hertz, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
  explicit WallRate(const Duration & period)
  : Rate(period, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
};

}  // namespace rclcpp

#endif  // RCLCPP__TIME_HPP_
