// How parameters are declared, set and shown.

#include "parameters.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rcl/arguments.h"
#include "rcl_yaml_param_parser/parser.h"

namespace rclcpp::stand_in
{

namespace
{

template<class ArrayT>
auto listed(const ArrayT & array)
{
  return std::vector<std::decay_t<decltype(*array.values)>>(
    array.values, array.values + array.size);
}

ParameterValue from_variant(const rcl_variant_t & given)
{
  if (given.bool_value) {
    return ParameterValue(*given.bool_value);
  } else if (given.integer_value) {
    return ParameterValue(*given.integer_value);
  } else if (given.double_value) {
    return ParameterValue(*given.double_value);
  } else if (given.string_value) {
    return ParameterValue(given.string_value);
  } else if (given.byte_array_value) {
    return ParameterValue(listed(*given.byte_array_value));
  } else if (given.bool_array_value) {
    return ParameterValue(listed(*given.bool_array_value));
  } else if (given.integer_array_value) {
    return ParameterValue(listed(*given.integer_array_value));
  } else if (given.double_array_value) {
    return ParameterValue(listed(*given.double_array_value));
  } else if (given.string_array_value) {
    const rcutils_string_array_t & array = *given.string_array_value;
    return ParameterValue(std::vector<std::string>(array.data, array.data + array.size));
  }
  return ParameterValue();
}

// Tell whether a file's name of a node, which may have wildcards for namespaces, is that of one.
bool is_for(const std::string & pattern, const std::string & node)
{
  if (pattern == "/**" || pattern == node) {
    return true;
  }
  const size_t last = node.rfind('/');
  return pattern == "/**" + node.substr(last) || (last == 0 && pattern == "/*");
}

template<class RangeT, class NumberT>
bool is_in(const RangeT & range, NumberT number)
{
  const auto is_near = [](double one, double other) {
      return std::abs(one - other) <= 1e-9 * std::max({1.0, std::abs(one), std::abs(other)});
    };
  if (number == range.from_value || number == range.to_value) {
    return true;
  }
  if (number < range.from_value || number > range.to_value) {
    return false;
  }
  const double steps = range.step == 0 ?
    0.0 : static_cast<double>(number - range.from_value) / static_cast<double>(range.step);
  return is_near(steps, std::round(steps));
}

Parameters::Result succeeded()
{
  Parameters::Result result;
  result.successful = true;
  return result;
}

Parameters::Result failed(const std::string & reason)
{
  Parameters::Result result;
  result.successful = false;
  result.reason = reason;
  return result;
}

}  // namespace

Parameters::Parameters(NodeBase node, Clock::SharedPtr clock, const NodeOptions & options)
: node_(node), clock_(clock), allows_undeclared_(options.allow_undeclared_parameters())
{
  if (options.use_global_arguments()) {
    read_overrides(node->get_context()->get()->global_arguments);
  }
  read_overrides(rcl_node_get_options(node->get_rcl_node_handle())->arguments);
  for (const Parameter & each : options.parameter_overrides()) {
    overrides_[each.get_name()] = each.get_parameter_value();
  }
  if (options.start_parameter_event_publisher()) {
    events_ = std::make_unique<Publisher<rcl_interfaces::msg::ParameterEvent>>(
      node, "/parameter_events", ParameterEventsQoS());
  }
  declare("use_sim_time", ParameterValue(false), PARAMETER_BOOL, Descriptor(), false);
  if (options.automatically_declare_parameters_from_overrides()) {
    for (const auto & [name, value] : overrides_) {
      if (!has(name)) {
        declare(name, value, value.get_type(), Descriptor(), false);
      }
    }
  }
  if (options.start_parameter_services()) {
    serve();
  }
}

void Parameters::read_overrides(const rcl_arguments_t & arguments)
{
  rcl_params_t * given = nullptr;
  check(rcl_arguments_get_param_overrides(&arguments, &given), "parameters");
  if (given == nullptr) {
    return;
  }
  const std::string own = node_->get_fully_qualified_name();
  for (size_t i = 0; i < given->num_nodes; ++i) {
    const std::string pattern = given->node_names[i];
    if (is_for(pattern.front() == '/' ? pattern : "/" + pattern, own)) {
      const rcl_node_params_t & of_node = given->params[i];
      for (size_t j = 0; j < of_node.num_params; ++j) {
        overrides_[of_node.parameter_names[j]] = from_variant(of_node.parameter_values[j]);
      }
    }
  }
  rcl_yaml_node_struct_fini(given);
}

const ParameterValue & Parameters::declare(
  const std::string & name, const ParameterValue & value, ParameterType type,
  Descriptor descriptor, bool ignore_override)
{
  std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (name.empty()) {
    throw exceptions::InvalidParametersException("parameter name must not be empty");
  }
  if (declared_.count(name) != 0) {
    throw exceptions::ParameterAlreadyDeclaredException(
            "parameter '" + name + "' has already been declared");
  }
  descriptor.name = name;
  descriptor.type = type;
  Declared made{ParameterValue(), descriptor};
  const auto found = overrides_.find(name);
  const bool is_overridden = found != overrides_.end() && !ignore_override;
  const Parameter wanted(name, is_overridden ? found->second : value);
  if (wanted.get_type() != PARAMETER_NOT_SET) {
    if (!descriptor.dynamic_typing && wanted.get_type() != type) {
      throw exceptions::InvalidParameterTypeException(
              name, "expected [" + to_string(type) + "] got [" + wanted.get_type_name() + "]");
    }
    made.descriptor.read_only = false;
    std::string reason = refusal(made, wanted);
    if (reason.empty()) {
      const Result result = ask({wanted});
      reason = result.successful ? "" : result.reason;
    }
    if (!reason.empty()) {
      throw exceptions::InvalidParameterValueException(
              "parameter '" + name + "' could not be set: " + reason);
    }
    made.descriptor.read_only = descriptor.read_only;
    made.value = wanted.get_parameter_value();
  }
  const ParameterValue & result = (declared_[name] = made).value;
  if (wanted.get_type() != PARAMETER_NOT_SET) {
    tell({wanted}, true);
  }
  return result;
}

void Parameters::undeclare(const std::string & name)
{
  std::lock_guard<std::recursive_mutex> lock(mutex_);
  const auto found = declared_.find(name);
  if (found == declared_.end()) {
    throw exceptions::ParameterNotDeclaredException("parameter '" + name + "' is not declared");
  }
  if (found->second.descriptor.read_only) {
    throw exceptions::ParameterImmutableException("parameter '" + name + "' is read-only");
  }
  declared_.erase(found);
}

bool Parameters::has(const std::string & name) const
{
  std::lock_guard<std::recursive_mutex> lock(mutex_);
  return declared_.count(name) != 0;
}

std::string Parameters::refusal(const Declared & declared, const Parameter & parameter) const
{
  const Descriptor & descriptor = declared.descriptor;
  const std::string named = "parameter '" + descriptor.name + "' ";
  if (descriptor.read_only) {
    return named + "cannot be set because it is read-only";
  }
  if (!descriptor.dynamic_typing && parameter.get_type() != descriptor.type) {
    return named + "is of type " + to_string(static_cast<ParameterType>(descriptor.type)) +
           ", and cannot be of type " + parameter.get_type_name();
  }
  bool is_right = true;
  if (parameter.get_type() == PARAMETER_DOUBLE && !descriptor.floating_point_range.empty()) {
    is_right = is_in(descriptor.floating_point_range.front(), parameter.as_double());
  } else if (parameter.get_type() == PARAMETER_INTEGER && !descriptor.integer_range.empty()) {
    const auto & range = descriptor.integer_range.front();
    is_right = parameter.as_int() <= range.to_value && is_in(range, parameter.as_int());
  }
  return is_right ? "" : named + "is not in its range";
}

Parameters::Result Parameters::ask(const std::vector<Parameter> & parameters) const
{
  // A callback may remove itself.
  for (const auto & each : std::list<std::weak_ptr<OnSet>>(on_set_)) {
    if (const auto handle = each.lock()) {
      const Result result = handle->callback(parameters);
      if (!result.successful) {
        return result;
      }
    }
  }
  return succeeded();
}

Parameters::Result Parameters::set(const std::vector<Parameter> & parameters)
{
  std::lock_guard<std::recursive_mutex> lock(mutex_);
  for (const Parameter & each : parameters) {
    const auto found = declared_.find(each.get_name());
    if (found == declared_.end()) {
      if (!allows_undeclared_) {
        return failed("parameter '" + each.get_name() + "' is not declared");
      }
    } else if (const std::string reason = refusal(found->second, each); !reason.empty()) {
      return failed(reason);
    }
  }
  const Result result = ask(parameters);
  if (!result.successful) {
    return result;
  }
  for (const Parameter & each : parameters) {
    Declared & declared = declared_[each.get_name()];
    declared.value = each.get_parameter_value();
    declared.descriptor.name = each.get_name();
    declared.descriptor.type = each.get_type();
  }
  for (const auto & each : std::list<std::weak_ptr<PostSet>>(post_set_)) {
    if (const auto handle = each.lock()) {
      handle->callback(parameters);
    }
  }
  tell(parameters, false);
  return result;
}

void Parameters::tell(const std::vector<Parameter> & changed, bool is_new)
{
  if (events_) {
    rcl_interfaces::msg::ParameterEvent event;
    event.stamp = clock_->now();
    event.node = node_->get_fully_qualified_name();
    for (const Parameter & each : changed) {
      (is_new ? event.new_parameters : event.changed_parameters).push_back(
        each.to_parameter_msg());
    }
    events_->publish(event);
  }
}

bool Parameters::get(const std::string & name, Parameter & parameter) const
{
  std::lock_guard<std::recursive_mutex> lock(mutex_);
  const auto found = declared_.find(name);
  if (found == declared_.end()) {
    return false;
  }
  parameter = Parameter(name, found->second.value);
  return true;
}

Parameters::Descriptor Parameters::describe(const std::string & name) const
{
  std::lock_guard<std::recursive_mutex> lock(mutex_);
  const auto found = declared_.find(name);
  if (found != declared_.end()) {
    return found->second.descriptor;
  }
  if (!allows_undeclared_) {
    throw exceptions::ParameterNotDeclaredException("parameter '" + name + "' is not declared");
  }
  Descriptor unknown;
  unknown.name = name;
  return unknown;
}

rcl_interfaces::msg::ListParametersResult Parameters::list(
  const std::vector<std::string> & prefixes, uint64_t depth) const
{
  std::lock_guard<std::recursive_mutex> lock(mutex_);
  const auto is_deep = [depth](const std::string & rest) {
      return depth != 0 &&
             static_cast<uint64_t>(std::count(rest.begin(), rest.end(), '.')) >= depth;
    };
  rcl_interfaces::msg::ListParametersResult result;
  for (const auto & [name, declared] : declared_) {
    bool is_wanted = prefixes.empty() && !is_deep(name);
    for (const std::string & prefix : prefixes) {
      const bool is_inside = name.rfind(prefix + ".", 0) == 0;
      is_wanted = is_wanted || name == prefix ||
        (is_inside && !is_deep(name.substr(prefix.size() + 1)));
    }
    if (is_wanted) {
      result.names.push_back(name);
      const size_t last = name.rfind('.');
      const std::string prefix = last == std::string::npos ? "" : name.substr(0, last);
      const auto & known = result.prefixes;
      if (!prefix.empty() && std::find(known.begin(), known.end(), prefix) == known.end()) {
        result.prefixes.push_back(prefix);
      }
    }
  }
  return result;
}

void Parameters::remove(const OnSet * handle)
{
  on_set_.remove_if([handle](const auto & each) {return each.lock().get() == handle;});
}

void Parameters::remove(const PostSet * handle)
{
  post_set_.remove_if([handle](const auto & each) {return each.lock().get() == handle;});
}

}  // namespace rclcpp::stand_in
