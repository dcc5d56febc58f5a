// How the stand-in waits and handles.

#include <algorithm>
#include <memory>
#include <thread>
#include <vector>

#include "rcl/error_handling.h"
#include "rcl/wait.h"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{

namespace
{

using Nanoseconds = std::chrono::nanoseconds;
using SteadyClock = std::chrono::steady_clock;

// So often it is looked whether ROS was shut down, or there is more to wait for.
constexpr Nanoseconds SLICE = std::chrono::milliseconds(20);

class WaitSet
{
public:
  explicit WaitSet(size_t size)
  : set_(rcl_get_zero_initialized_wait_set())
  {
    stand_in::check(
      rcl_wait_set_init(
        &set_, size, 0, size, size, size, 0, contexts::get_global_default_context()->get(),
        rcl_get_default_allocator()),
      "wait set");
  }
  ~WaitSet()
  {
    if (rcl_wait_set_fini(&set_) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }
  WaitSet(const WaitSet &) = delete;
  WaitSet & operator=(const WaitSet &) = delete;
  rcl_wait_set_t * get() {return &set_;}

private:
  rcl_wait_set_t set_;
};

bool is_free(stand_in::Entity & entity)
{
  const bool is_exclusive = entity.group().type() == CallbackGroupType::MutuallyExclusive;
  return !entity.busy && !(is_exclusive && entity.group().busy > 0);
}

// What is handled is busy for so long.
class Busy
{
public:
  explicit Busy(std::shared_ptr<stand_in::Entity> entity)
  : entity_(entity)
  {
    entity_->busy = true;
    ++entity_->group().busy;
  }
  ~Busy()
  {
    --entity_->group().busy;
    entity_->busy = false;
  }
  Busy(const Busy &) = delete;
  Busy & operator=(const Busy &) = delete;

private:
  std::shared_ptr<stand_in::Entity> entity_;
};

}  // namespace

void Executor::add_node(stand_in::NodeBase node)
{
  std::lock_guard<std::mutex> lock(nodes_mutex_);
  nodes_.push_back(node);
}

void Executor::remove_node(stand_in::NodeBase node)
{
  std::lock_guard<std::mutex> lock(nodes_mutex_);
  nodes_.erase(
    std::remove_if(
      nodes_.begin(), nodes_.end(), [&node](const auto & each) {return each.lock() == node;}),
    nodes_.end());
}

std::shared_ptr<stand_in::Entity> Executor::wait(Nanoseconds timeout)
{
  const auto take_free = [this]() -> std::shared_ptr<stand_in::Entity> {
      const auto found = std::find_if(
        ready_.begin(), ready_.end(), [](const auto & each) {return is_free(*each);});
      if (found == ready_.end()) {
        return nullptr;
      }
      const auto entity = *found;
      ready_.erase(found);
      return entity;
    };
  if (const auto entity = take_free()) {
    return entity;
  }
  std::vector<std::shared_ptr<stand_in::Entity>> entities;
  std::unique_lock<std::mutex> nodes_lock(nodes_mutex_);
  for (const auto & each : nodes_) {
    if (const auto node = each.lock()) {
      for (const auto & entity : node->entities()) {
        const bool is_known = std::find(ready_.begin(), ready_.end(), entity) != ready_.end();
        if (!is_known && is_free(*entity)) {
          entities.push_back(entity);
        }
      }
    }
  }
  nodes_lock.unlock();
  if (entities.empty()) {
    std::this_thread::sleep_for(timeout);
    return nullptr;
  }
  WaitSet set(entities.size());
  for (const auto & entity : entities) {
    entity->add_to(set.get());
  }
  const rcl_ret_t result = rcl_wait(set.get(), timeout.count());
  if (result == RCL_RET_TIMEOUT) {
    rcl_reset_error();
    return nullptr;
  }
  stand_in::check(result, "wait");
  // Timers first, as with rclcpp: a node that is sent much still does what it does at its rate.
  for (const bool wants_timer : {true, false}) {
    for (const auto & entity : entities) {
      const bool is_timer = dynamic_cast<TimerBase *>(entity.get()) != nullptr;
      if (is_timer == wants_timer && entity->is_ready(set.get())) {
        ready_.push_back(entity);
      }
    }
  }
  return take_free();
}

bool Executor::handle_one(Nanoseconds timeout)
{
  const auto end = SteadyClock::now() + timeout;
  while (ok()) {
    const Nanoseconds left = end - SteadyClock::now();
    const bool is_last = timeout.count() >= 0 && left <= SLICE;
    const Nanoseconds slice = is_last ? std::max(left, Nanoseconds(0)) : SLICE;
    std::unique_lock<std::mutex> lock(wait_mutex_);
    if (const auto entity = wait(slice)) {
      const Busy busy(entity);
      lock.unlock();
      entity->handle();
      return true;
    }
    if (is_last || is_canceled_) {
      return false;
    }
  }
  return false;
}

void Executor::work()
{
  is_canceled_ = false;
  while (ok() && !is_canceled_) {
    handle_one(SLICE);
  }
}

void Executor::spin_once(Nanoseconds timeout)
{
  is_canceled_ = false;
  handle_one(timeout);
}

void Executor::spin_some(Nanoseconds limit)
{
  is_canceled_ = false;
  const auto end = SteadyClock::now() + limit;
  // What is ready at first, and no more: what is always ready would never end.
  size_t left = 1;
  while (left > 0 && handle_one(Nanoseconds(0))) {
    std::lock_guard<std::mutex> lock(wait_mutex_);
    left = ready_.size();
    if (limit.count() > 0 && SteadyClock::now() >= end) {
      return;
    }
  }
}

FutureReturnCode Executor::spin_until(const std::function<bool()> & is_done, Nanoseconds timeout)
{
  is_canceled_ = false;
  const auto end = SteadyClock::now() + timeout;
  while (!is_done()) {
    if (!ok() || is_canceled_) {
      return FutureReturnCode::INTERRUPTED;
    }
    const Nanoseconds left = end - SteadyClock::now();
    if (timeout.count() >= 0 && left.count() <= 0) {
      return FutureReturnCode::TIMEOUT;
    }
    handle_one(timeout.count() >= 0 ? std::min(left, SLICE) : SLICE);
  }
  return FutureReturnCode::SUCCESS;
}

size_t executors::MultiThreadedExecutor::get_number_of_threads()
{
  return threads_ != 0 ? threads_ : std::max(2U, std::thread::hardware_concurrency());
}

void executors::MultiThreadedExecutor::spin()
{
  std::vector<std::thread> threads;
  while (threads.size() + 1 < get_number_of_threads()) {
    threads.emplace_back([this] {work();});
  }
  work();
  for (std::thread & thread : threads) {
    thread.join();
  }
}

void spin(stand_in::NodeBase node)
{
  executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
}

void spin(std::shared_ptr<Node> node)
{
  spin(node->get_node_base_interface());
}

void spin_some(stand_in::NodeBase node)
{
  executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_some();
}

void spin_some(std::shared_ptr<Node> node)
{
  spin_some(node->get_node_base_interface());
}

}  // namespace rclcpp
