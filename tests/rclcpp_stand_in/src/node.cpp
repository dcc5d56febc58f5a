// Nodes, and the values of parameters, of the stand-in.

#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "parameters.hpp"
#include "rcl/graph.h"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{

namespace
{

template<class T>
std::string printed(const std::vector<T> & values)
{
  std::ostringstream stream;
  stream << "[";
  for (size_t i = 0; i < values.size(); ++i) {
    stream << (i == 0 ? "" : ", ") << std::boolalpha << values[i];
  }
  return stream.str() + "]";
}

}  // namespace

Node::Node(const std::string & name, const std::string & namespace_, const NodeOptions & options)
: options_(options),
  base_(std::make_shared<node_interfaces::NodeBaseInterface>(name, namespace_, options)),
  clock_(std::make_shared<Clock>(RCL_ROS_TIME)),
  parameters_(std::make_shared<stand_in::Parameters>(base_, clock_, options)) {}

Node::~Node() = default;

Logger Node::get_logger() const
{
  return rclcpp::get_logger(rcl_node_get_logger_name(base_->get_rcl_node_handle()));
}

size_t Node::count_publishers(const std::string & topic) const
{
  char * name = nullptr;
  size_t count = 0;
  const rcl_allocator_t allocator = rcl_get_default_allocator();
  rcl_node_t * node = base_->get_rcl_node_handle();
  stand_in::check(
    rcl_node_resolve_name(node, topic.c_str(), allocator, false, false, &name), "topic");
  const rcl_ret_t result = rcl_count_publishers(node, name, &count);
  allocator.deallocate(name, allocator.state);
  stand_in::check(result, "count");
  return count;
}

size_t Node::count_subscribers(const std::string & topic) const
{
  char * name = nullptr;
  size_t count = 0;
  const rcl_allocator_t allocator = rcl_get_default_allocator();
  rcl_node_t * node = base_->get_rcl_node_handle();
  stand_in::check(
    rcl_node_resolve_name(node, topic.c_str(), allocator, false, false, &name), "topic");
  const rcl_ret_t result = rcl_count_subscribers(node, name, &count);
  allocator.deallocate(name, allocator.state);
  stand_in::check(result, "count");
  return count;
}

const ParameterValue & Node::declare_parameter(
  const std::string & name, const ParameterValue & value, const Descriptor & descriptor,
  bool ignore_override)
{
  return parameters_->declare(name, value, value.get_type(), descriptor, ignore_override);
}

const ParameterValue & Node::declare_parameter(
  const std::string & name, ParameterType type, const Descriptor & descriptor,
  bool ignore_override)
{
  return parameters_->declare(name, ParameterValue(), type, descriptor, ignore_override);
}

void Node::undeclare_parameter(const std::string & name)
{
  parameters_->undeclare(name);
}

bool Node::has_parameter(const std::string & name) const
{
  return parameters_->has(name);
}

rcl_interfaces::msg::SetParametersResult Node::set_parameter(const Parameter & parameter)
{
  return set_parameters_atomically({parameter});
}

std::vector<rcl_interfaces::msg::SetParametersResult> Node::set_parameters(
  const std::vector<Parameter> & parameters)
{
  std::vector<rcl_interfaces::msg::SetParametersResult> results;
  for (const Parameter & each : parameters) {
    results.push_back(set_parameter(each));
  }
  return results;
}

rcl_interfaces::msg::SetParametersResult Node::set_parameters_atomically(
  const std::vector<Parameter> & parameters)
{
  for (const Parameter & each : parameters) {
    if (!has_parameter(each.get_name()) && !parameters_->allows_undeclared()) {
      throw exceptions::ParameterNotDeclaredException(
              "parameter '" + each.get_name() + "' is not declared");
    }
  }
  return parameters_->set(parameters);
}

Parameter Node::get_parameter(const std::string & name) const
{
  Parameter parameter(name);
  const bool is_there = parameters_->get(name, parameter);
  if (!is_there && !parameters_->allows_undeclared()) {
    throw exceptions::ParameterNotDeclaredException("parameter '" + name + "' is not declared");
  }
  if (is_there && parameter.get_type() == PARAMETER_NOT_SET) {
    throw exceptions::ParameterUninitializedException("parameter '" + name + "' is not set");
  }
  return parameter;
}

bool Node::get_parameter(const std::string & name, Parameter & parameter) const
{
  Parameter found;
  const bool is_there =
    parameters_->get(name, found) && found.get_type() != PARAMETER_NOT_SET;
  if (is_there) {
    parameter = found;
  }
  return is_there;
}

std::vector<Parameter> Node::get_parameters(const std::vector<std::string> & names) const
{
  std::vector<Parameter> result;
  for (const std::string & name : names) {
    result.push_back(get_parameter(name));
  }
  return result;
}

Node::Descriptor Node::describe_parameter(const std::string & name) const
{
  return parameters_->describe(name);
}

rcl_interfaces::msg::ListParametersResult Node::list_parameters(
  const std::vector<std::string> & prefixes, uint64_t depth) const
{
  return parameters_->list(prefixes, depth);
}

Node::OnSetParametersCallbackHandle::SharedPtr Node::add_on_set_parameters_callback(
  OnSetParametersCallbackType callback)
{
  const auto handle = std::make_shared<OnSetParametersCallbackHandle>();
  handle->callback = std::move(callback);
  parameters_->add(handle);
  return handle;
}

Node::PostSetParametersCallbackHandle::SharedPtr Node::add_post_set_parameters_callback(
  PostSetParametersCallbackType callback)
{
  const auto handle = std::make_shared<PostSetParametersCallbackHandle>();
  handle->callback = std::move(callback);
  parameters_->add(handle);
  return handle;
}

void Node::remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * const handle)
{
  parameters_->remove(handle);
}

void Node::remove_post_set_parameters_callback(
  const PostSetParametersCallbackHandle * const handle)
{
  parameters_->remove(handle);
}

#define VALUE(value_type, kind, field) \
  ParameterValue::ParameterValue(value_type value) \
  { \
    value_.type = kind; \
    value_.field = value; \
  }

VALUE(bool, PARAMETER_BOOL, bool_value)
VALUE(int64_t, PARAMETER_INTEGER, integer_value)
VALUE(double, PARAMETER_DOUBLE, double_value)
VALUE(const std::string &, PARAMETER_STRING, string_value)
VALUE(const std::vector<uint8_t> &, PARAMETER_BYTE_ARRAY, byte_array_value)
VALUE(const std::vector<bool> &, PARAMETER_BOOL_ARRAY, bool_array_value)
VALUE(const std::vector<int64_t> &, PARAMETER_INTEGER_ARRAY, integer_array_value)
VALUE(const std::vector<double> &, PARAMETER_DOUBLE_ARRAY, double_array_value)
VALUE(const std::vector<std::string> &, PARAMETER_STRING_ARRAY, string_array_value)

#undef VALUE

rcl_interfaces::msg::Parameter Parameter::to_parameter_msg() const
{
  rcl_interfaces::msg::Parameter message;
  message.name = name_;
  message.value = value_.to_value_msg();
  return message;
}

std::string to_string(ParameterType type)
{
  static const char * const names[] = {
    "not set", "bool", "integer", "double", "string", "byte_array", "bool_array",
    "integer_array", "double_array", "string_array"};
  return type < std::size(names) ? names[type] : "unknown type";
}

std::string to_string(const ParameterValue & value)
{
  switch (value.get_type()) {
    case PARAMETER_BOOL:
      return value.get<PARAMETER_BOOL>() ? "true" : "false";
    case PARAMETER_INTEGER:
      return std::to_string(value.get<PARAMETER_INTEGER>());
    case PARAMETER_DOUBLE:
      return std::to_string(value.get<PARAMETER_DOUBLE>());
    case PARAMETER_STRING:
      return value.get<PARAMETER_STRING>();
    case PARAMETER_BYTE_ARRAY:
      {
        const auto & bytes = value.get<PARAMETER_BYTE_ARRAY>();
        return printed(std::vector<int>(bytes.begin(), bytes.end()));
      }
    case PARAMETER_BOOL_ARRAY:
      return printed(value.get<PARAMETER_BOOL_ARRAY>());
    case PARAMETER_INTEGER_ARRAY:
      return printed(value.get<PARAMETER_INTEGER_ARRAY>());
    case PARAMETER_DOUBLE_ARRAY:
      return printed(value.get<PARAMETER_DOUBLE_ARRAY>());
    case PARAMETER_STRING_ARRAY:
      return printed(value.get<PARAMETER_STRING_ARRAY>());
    default:
      return "not set";
  }
}

}  // namespace rclcpp
