// What the endpoints of the stand-in have in common: see rclcpp.hpp.

#ifndef RCLCPP__NODE_BASE_HPP_
#define RCLCPP__NODE_BASE_HPP_

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rcl/node.h"
#include "rcl/wait.h"
#include "rclcpp/parameter.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp
{

// All that rclcpp::init begins and rclcpp::shutdown ends.
class Context
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Context)

  Context();
  ~Context();
  Context(const Context &) = delete;
  Context & operator=(const Context &) = delete;

  void init(int argc, char const * const * argv);
  bool is_valid() const;
  bool shutdown(const std::string & reason);
  void on_shutdown(std::function<void()> callback);
  rcl_context_t * get() {return &context_;}

private:
  rcl_context_t context_;
  std::mutex mutex_;
  std::vector<std::function<void()>> callbacks_;
};

namespace contexts
{
Context::SharedPtr get_global_default_context();
}  // namespace contexts

enum class CallbackGroupType
{
  MutuallyExclusive,
  Reentrant,
};

class CallbackGroup
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)

  explicit CallbackGroup(CallbackGroupType group_type)
  : type_(group_type) {}
  const CallbackGroupType & type() const {return type_;}
  // What of it is at work now.
  std::atomic<int> busy{0};

private:
  CallbackGroupType type_;
};

namespace stand_in
{

// Throw an RCLError with the message of rcl where a call of rcl has failed.
void check(rcl_ret_t result, const char * what);

class Entity;

}  // namespace stand_in

namespace node_interfaces
{

class NodeBaseInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(NodeBaseInterface)

  NodeBaseInterface(
    const std::string & name, const std::string & namespace_, const NodeOptions & options);
  ~NodeBaseInterface();
  NodeBaseInterface(const NodeBaseInterface &) = delete;
  NodeBaseInterface & operator=(const NodeBaseInterface &) = delete;

  const char * get_name() const {return rcl_node_get_name(&node_);}
  const char * get_namespace() const {return rcl_node_get_namespace(&node_);}
  const char * get_fully_qualified_name() const;
  Context::SharedPtr get_context() {return context_;}
  rcl_node_t * get_rcl_node_handle() {return &node_;}
  CallbackGroup::SharedPtr get_default_callback_group() {return group_;}

  void add(const std::shared_ptr<stand_in::Entity> & entity);
  std::vector<std::shared_ptr<stand_in::Entity>> entities();

private:
  Context::SharedPtr context_;
  rcl_node_t node_;
  CallbackGroup::SharedPtr group_;
  std::mutex mutex_;
  std::vector<std::weak_ptr<stand_in::Entity>> entities_;
};

}  // namespace node_interfaces

namespace stand_in
{

using NodeBase = std::shared_ptr<node_interfaces::NodeBaseInterface>;

// What an executor waits for and handles: a subscription, a service, a client or a timer.
class Entity
{
public:
  Entity(NodeBase node, CallbackGroup::SharedPtr group)
  : node_(node), group_(group ? group : node->get_default_callback_group()) {}
  virtual ~Entity() = default;
  Entity(const Entity &) = delete;
  Entity & operator=(const Entity &) = delete;

  virtual void add_to(rcl_wait_set_t * wait_set) = 0;
  virtual bool is_ready(const rcl_wait_set_t * wait_set) const = 0;
  virtual void handle() = 0;
  CallbackGroup & group() {return *group_;}
  std::atomic<bool> busy{false};

protected:
  NodeBase node_;
  size_t index_ = 0;

private:
  CallbackGroup::SharedPtr group_;
};

}  // namespace stand_in

}  // namespace rclcpp

#endif  // RCLCPP__NODE_BASE_HPP_
