// Timers of the stand-in: see rclcpp.hpp.

#ifndef RCLCPP__TIMER_HPP_
#define RCLCPP__TIMER_HPP_

#include <chrono>
#include <memory>
#include <type_traits>
#include <utility>

#include "rcl/timer.h"
#include "rclcpp/node_base.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp
{

class TimerBase : public stand_in::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimerBase)

  TimerBase(
    stand_in::NodeBase node, Clock::SharedPtr clock, std::chrono::nanoseconds period,
    CallbackGroup::SharedPtr group, bool autostart);
  ~TimerBase() override;

  void cancel();
  bool is_canceled();
  void reset();
  bool is_ready();
  virtual bool is_steady() {return clock_->get_clock_type() == RCL_STEADY_TIME;}
  std::chrono::nanoseconds time_until_trigger();

  void add_to(rcl_wait_set_t * wait_set) override;
  bool is_ready(const rcl_wait_set_t * wait_set) const override;
  void handle() override;

protected:
  virtual void call() = 0;

private:
  Clock::SharedPtr clock_;
  rcl_timer_t timer_;
};

template<class CallbackT>
class GenericTimer : public TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer<CallbackT>)

  GenericTimer(
    stand_in::NodeBase node, Clock::SharedPtr clock, std::chrono::nanoseconds period,
    CallbackT callback, CallbackGroup::SharedPtr group, bool autostart)
  : TimerBase(node, clock, period, group, autostart), callback_(std::move(callback)) {}

private:
  void call() override
  {
    if constexpr (std::is_invocable_v<CallbackT &>) {
      callback_();
    } else {
      callback_(static_cast<TimerBase &>(*this));
    }
  }

  CallbackT callback_;
};

template<class CallbackT>
using WallTimer = GenericTimer<CallbackT>;

}  // namespace rclcpp

#endif  // RCLCPP__TIMER_HPP_
