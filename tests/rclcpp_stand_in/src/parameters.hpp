// The parameters of a node of the stand-in, with the services and the topic that show them.

#ifndef PARAMETERS_HPP_
#define PARAMETERS_HPP_

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/node.hpp"

namespace rclcpp::stand_in
{

class Parameters
{
public:
  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using Result = rcl_interfaces::msg::SetParametersResult;
  using OnSet = node_interfaces::OnSetParametersCallbackHandle;
  using PostSet = node_interfaces::PostSetParametersCallbackHandle;

  Parameters(NodeBase node, Clock::SharedPtr clock, const NodeOptions & options);

  // Declare one, with a value or of a type that it gets later; return its value.
  const ParameterValue & declare(
    const std::string & name, const ParameterValue & value, ParameterType type,
    Descriptor descriptor, bool ignore_override);
  void undeclare(const std::string & name);
  bool has(const std::string & name) const;
  // Set all or none.
  Result set(const std::vector<Parameter> & parameters);
  bool get(const std::string & name, Parameter & parameter) const;
  bool allows_undeclared() const {return allows_undeclared_;}
  Descriptor describe(const std::string & name) const;
  rcl_interfaces::msg::ListParametersResult list(
    const std::vector<std::string> & prefixes, uint64_t depth) const;

  void add(std::shared_ptr<OnSet> handle) {on_set_.push_front(handle);}
  void add(std::shared_ptr<PostSet> handle) {post_set_.push_front(handle);}
  void remove(const OnSet * handle);
  void remove(const PostSet * handle);

private:
  struct Declared
  {
    ParameterValue value;
    Descriptor descriptor;
  };

  void read_overrides(const rcl_arguments_t & arguments);
  void serve();
  template<class ServiceT, class HandlerT>
  void serve(const std::string & name, HandlerT && handler);
  // Return why a parameter cannot have a value, nothing where it can.
  std::string refusal(const Declared & declared, const Parameter & parameter) const;
  // Return what the callbacks say; the first that refuses has the word.
  Result ask(const std::vector<Parameter> & parameters) const;
  void tell(const std::vector<Parameter> & changed, bool is_new);

  NodeBase node_;
  Clock::SharedPtr clock_;
  bool allows_undeclared_;
  mutable std::recursive_mutex mutex_;
  std::map<std::string, Declared> declared_;
  std::map<std::string, ParameterValue> overrides_;
  std::list<std::weak_ptr<OnSet>> on_set_;
  std::list<std::weak_ptr<PostSet>> post_set_;
  std::unique_ptr<Publisher<rcl_interfaces::msg::ParameterEvent>> events_;
  std::vector<std::shared_ptr<ServiceBase>> services_;
};

}  // namespace rclcpp::stand_in

#endif  // PARAMETERS_HPP_
