// A stand-in of rclcpp, on the C API of rcl, for tests where there is no rclcpp.
//
// It has what most nodes use of rclcpp, under the same signatures; `signatures.cpp` uses each, and
// compiles with rclcpp as well. It has no actions, lifecycle, components, generic endpoints,
// events of quality of service, intra-process communication, sub-nodes or simulated time.

#ifndef RCLCPP__RCLCPP_HPP_
#define RCLCPP__RCLCPP_HPP_

#include <chrono>
#include <csignal>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/create.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp
{

// SIGINT and SIGTERM end what was begun.
void init(int argc, char const * const * argv);
bool ok(Context::SharedPtr context = nullptr);
bool shutdown(
  Context::SharedPtr context = nullptr, const std::string & reason = "it was asked for");
void on_shutdown(std::function<void()> callback, Context::SharedPtr context = nullptr);
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv);
// Return false where it was shut down meanwhile.
bool sleep_for(const std::chrono::nanoseconds & duration, Context::SharedPtr context = nullptr);

}  // namespace rclcpp

#endif  // RCLCPP__RCLCPP_HPP_
