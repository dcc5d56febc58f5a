// Executors of the stand-in: see rclcpp.hpp.

#ifndef RCLCPP__EXECUTORS_HPP_
#define RCLCPP__EXECUTORS_HPP_

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <vector>

#include "rclcpp/node.hpp"

namespace rclcpp
{

enum class FutureReturnCode {SUCCESS, INTERRUPTED, TIMEOUT};

struct ExecutorOptions
{
  Context::SharedPtr context;
};

// It looks 50 times a second whether ROS was shut down, or there is more to wait for.
class Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Executor)

  explicit Executor(const ExecutorOptions & = ExecutorOptions()) {}
  virtual ~Executor() = default;
  Executor(const Executor &) = delete;
  Executor & operator=(const Executor &) = delete;

  void add_node(stand_in::NodeBase node);
  void add_node(std::shared_ptr<Node> node) {add_node(node->get_node_base_interface());}
  void remove_node(stand_in::NodeBase node);
  void remove_node(std::shared_ptr<Node> node) {remove_node(node->get_node_base_interface());}

  virtual void spin() = 0;
  void spin_some(std::chrono::nanoseconds limit = std::chrono::nanoseconds(0));
  void spin_once(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  void cancel() {is_canceled_ = true;}

  template<class FutureT, class Rep = int64_t, class Period = std::milli>
  FutureReturnCode spin_until_future_complete(
    const FutureT & future,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return spin_until(
      [&future] {return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;},
      std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

protected:
  void work();
  std::atomic<bool> is_canceled_{false};

private:
  // Wait for something to handle and handle it; tell whether there was anything.
  bool handle_one(std::chrono::nanoseconds timeout);
  std::shared_ptr<stand_in::Entity> wait(std::chrono::nanoseconds timeout);
  FutureReturnCode spin_until(
    const std::function<bool()> & is_done, std::chrono::nanoseconds timeout);

  std::mutex nodes_mutex_;
  std::mutex wait_mutex_;
  std::vector<std::weak_ptr<node_interfaces::NodeBaseInterface>> nodes_;
  std::vector<std::shared_ptr<stand_in::Entity>> ready_;
};

namespace executors
{

class SingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SingleThreadedExecutor)
  using Executor::Executor;
  void spin() override {work();}
};

class MultiThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MultiThreadedExecutor)
  // Without a number of threads there is one for each processor, and at least two.
  explicit MultiThreadedExecutor(
    const ExecutorOptions & options = ExecutorOptions(), size_t threads = 0)
  : Executor(options), threads_(threads) {}
  void spin() override;
  size_t get_number_of_threads();

private:
  size_t threads_;
};

}  // namespace executors

void spin(stand_in::NodeBase node);
void spin(std::shared_ptr<Node> node);
void spin_some(stand_in::NodeBase node);
void spin_some(std::shared_ptr<Node> node);

template<class FutureT, class Rep = int64_t, class Period = std::milli>
FutureReturnCode spin_until_future_complete(
  stand_in::NodeBase node, const FutureT & future,
  std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  return executor.spin_until_future_complete(future, timeout);
}

template<class NodeT = Node, class FutureT, class Rep = int64_t, class Period = std::milli>
FutureReturnCode spin_until_future_complete(
  std::shared_ptr<NodeT> node, const FutureT & future,
  std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  return spin_until_future_complete(node->get_node_base_interface(), future, timeout);
}

}  // namespace rclcpp

#endif  // RCLCPP__EXECUTORS_HPP_
