// Parameters of the stand-in, and what a node is made with: see rclcpp.hpp.

#ifndef RCLCPP__PARAMETER_HPP_
#define RCLCPP__PARAMETER_HPP_

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "rcl_interfaces/msg/parameter.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/parameter_type.hpp"
#include "rcl_interfaces/msg/parameter_value.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"

namespace rclcpp
{

enum ParameterType : uint8_t
{
  PARAMETER_NOT_SET = rcl_interfaces::msg::ParameterType::PARAMETER_NOT_SET,
  PARAMETER_BOOL = rcl_interfaces::msg::ParameterType::PARAMETER_BOOL,
  PARAMETER_INTEGER = rcl_interfaces::msg::ParameterType::PARAMETER_INTEGER,
  PARAMETER_DOUBLE = rcl_interfaces::msg::ParameterType::PARAMETER_DOUBLE,
  PARAMETER_STRING = rcl_interfaces::msg::ParameterType::PARAMETER_STRING,
  PARAMETER_BYTE_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_BYTE_ARRAY,
  PARAMETER_BOOL_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_BOOL_ARRAY,
  PARAMETER_INTEGER_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_INTEGER_ARRAY,
  PARAMETER_DOUBLE_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_DOUBLE_ARRAY,
  PARAMETER_STRING_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_STRING_ARRAY,
};

std::string to_string(ParameterType type);

class ParameterTypeException : public std::runtime_error
{
public:
  ParameterTypeException(ParameterType expected, ParameterType actual)
  : std::runtime_error("expected [" + to_string(expected) + "] got [" + to_string(actual) + "]") {}
};

namespace exceptions
{

#define RCLCPP_STAND_IN_EXCEPTION(name) \
  class name : public std::runtime_error \
  { \
public: \
    using std::runtime_error::runtime_error; \
  }

RCLCPP_STAND_IN_EXCEPTION(RCLError);
RCLCPP_STAND_IN_EXCEPTION(InvalidParametersException);
RCLCPP_STAND_IN_EXCEPTION(InvalidParameterValueException);
RCLCPP_STAND_IN_EXCEPTION(ParameterAlreadyDeclaredException);
RCLCPP_STAND_IN_EXCEPTION(ParameterNotDeclaredException);
RCLCPP_STAND_IN_EXCEPTION(ParameterImmutableException);
RCLCPP_STAND_IN_EXCEPTION(ParameterUninitializedException);

#undef RCLCPP_STAND_IN_EXCEPTION

class UninitializedStaticallyTypedParameterException : public std::runtime_error
{
public:
  explicit UninitializedStaticallyTypedParameterException(const std::string & name)
  : std::runtime_error("parameter '" + name + "' has a type, and no value") {}
};

class InvalidParameterTypeException : public std::runtime_error
{
public:
  InvalidParameterTypeException(const std::string & name, const std::string & message)
  : std::runtime_error("parameter '" + name + "' has invalid type: " + message) {}
};

}  // namespace exceptions

class ParameterValue
{
public:
  ParameterValue() = default;
  explicit ParameterValue(const rcl_interfaces::msg::ParameterValue & value)
  : value_(value) {}
  explicit ParameterValue(bool value);
  explicit ParameterValue(int value)
  : ParameterValue(static_cast<int64_t>(value)) {}
  explicit ParameterValue(int64_t value);
  explicit ParameterValue(float value)
  : ParameterValue(static_cast<double>(value)) {}
  explicit ParameterValue(double value);
  explicit ParameterValue(const std::string & value);
  explicit ParameterValue(const char * value)
  : ParameterValue(std::string(value)) {}
  explicit ParameterValue(const std::vector<uint8_t> & value);
  explicit ParameterValue(const std::vector<bool> & value);
  explicit ParameterValue(const std::vector<int> & value)
  : ParameterValue(std::vector<int64_t>(value.begin(), value.end())) {}
  explicit ParameterValue(const std::vector<int64_t> & value);
  explicit ParameterValue(const std::vector<float> & value)
  : ParameterValue(std::vector<double>(value.begin(), value.end())) {}
  explicit ParameterValue(const std::vector<double> & value);
  explicit ParameterValue(const std::vector<std::string> & value);

  ParameterType get_type() const {return static_cast<ParameterType>(value_.type);}
  rcl_interfaces::msg::ParameterValue to_value_msg() const {return value_;}
  bool operator==(const ParameterValue & other) const {return value_ == other.value_;}
  bool operator!=(const ParameterValue & other) const {return value_ != other.value_;}

  // Return the value; a ParameterTypeException where it is of another type.
  template<ParameterType type>
  const auto & get() const
  {
    if (get_type() != type) {
      throw ParameterTypeException(type, get_type());
    }
    if constexpr (type == PARAMETER_BOOL) {
      return value_.bool_value;
    } else if constexpr (type == PARAMETER_INTEGER) {
      return value_.integer_value;
    } else if constexpr (type == PARAMETER_DOUBLE) {
      return value_.double_value;
    } else if constexpr (type == PARAMETER_STRING) {
      return value_.string_value;
    } else if constexpr (type == PARAMETER_BYTE_ARRAY) {
      return value_.byte_array_value;
    } else if constexpr (type == PARAMETER_BOOL_ARRAY) {
      return value_.bool_array_value;
    } else if constexpr (type == PARAMETER_INTEGER_ARRAY) {
      return value_.integer_array_value;
    } else if constexpr (type == PARAMETER_DOUBLE_ARRAY) {
      return value_.double_array_value;
    } else {
      static_assert(type == PARAMETER_STRING_ARRAY, "a parameter that is not set has no value");
      return value_.string_array_value;
    }
  }

  template<class T>
  const auto & get() const
  {
    return get<type_of<T>()>();
  }

private:
  template<class T>
  static constexpr ParameterType type_of()
  {
    if constexpr (std::is_same_v<T, bool>) {
      return PARAMETER_BOOL;
    } else if constexpr (std::is_integral_v<T>) {
      return PARAMETER_INTEGER;
    } else if constexpr (std::is_floating_point_v<T>) {
      return PARAMETER_DOUBLE;
    } else if constexpr (std::is_convertible_v<T, std::string>) {
      return PARAMETER_STRING;
    } else if constexpr (std::is_same_v<T, std::vector<uint8_t>>) {
      return PARAMETER_BYTE_ARRAY;
    } else if constexpr (std::is_same_v<T, std::vector<bool>>) {
      return PARAMETER_BOOL_ARRAY;
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
      return PARAMETER_STRING_ARRAY;
    } else if constexpr (std::is_floating_point_v<typename T::value_type>) {
      return PARAMETER_DOUBLE_ARRAY;
    } else {
      return PARAMETER_INTEGER_ARRAY;
    }
  }

  rcl_interfaces::msg::ParameterValue value_;
};

std::string to_string(const ParameterValue & value);

class Parameter
{
private:
  template<ParameterType type>
  const auto & as() const
  {
    try {
      return value_.get<type>();
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException(name_, error.what());
    }
  }

public:
  Parameter() = default;
  explicit Parameter(const std::string & name)
  : name_(name) {}
  Parameter(const std::string & name, const ParameterValue & value)
  : name_(name), value_(value) {}
  template<class T>
  Parameter(const std::string & name, T value)
  : Parameter(name, ParameterValue(value)) {}

  bool operator==(const Parameter & other) const
  {
    return name_ == other.name_ && value_ == other.value_;
  }
  bool operator!=(const Parameter & other) const {return !(*this == other);}

  const std::string & get_name() const {return name_;}
  ParameterType get_type() const {return value_.get_type();}
  std::string get_type_name() const {return to_string(get_type());}
  const ParameterValue & get_parameter_value() const {return value_;}
  rcl_interfaces::msg::ParameterValue get_value_message() const {return value_.to_value_msg();}

  template<class T>
  auto get_value() const
  {
    try {
      return value_.get<T>();
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException(name_, error.what());
    }
  }

  bool as_bool() const {return get_value<bool>();}
  int64_t as_int() const {return get_value<int64_t>();}
  double as_double() const {return get_value<double>();}
  const std::string & as_string() const {return as<PARAMETER_STRING>();}
  const std::vector<uint8_t> & as_byte_array() const {return as<PARAMETER_BYTE_ARRAY>();}
  const std::vector<bool> & as_bool_array() const {return as<PARAMETER_BOOL_ARRAY>();}
  const std::vector<int64_t> & as_integer_array() const {return as<PARAMETER_INTEGER_ARRAY>();}
  const std::vector<double> & as_double_array() const {return as<PARAMETER_DOUBLE_ARRAY>();}
  const std::vector<std::string> & as_string_array() const {return as<PARAMETER_STRING_ARRAY>();}

  std::string value_to_string() const {return to_string(value_);}
  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter & message)
  {
    return Parameter(message.name, ParameterValue(message.value));
  }
  rcl_interfaces::msg::Parameter to_parameter_msg() const;

private:
  std::string name_;
  ParameterValue value_;
};

class NodeOptions
{
public:
  const std::vector<std::string> & arguments() const {return arguments_;}
  NodeOptions & arguments(const std::vector<std::string> & arguments)
  {
    arguments_ = arguments;
    return *this;
  }

  std::vector<Parameter> & parameter_overrides() {return parameter_overrides_;}
  const std::vector<Parameter> & parameter_overrides() const {return parameter_overrides_;}
  NodeOptions & parameter_overrides(const std::vector<Parameter> & overrides)
  {
    parameter_overrides_ = overrides;
    return *this;
  }
  template<class T>
  NodeOptions & append_parameter_override(const std::string & name, const T & value)
  {
    parameter_overrides_.emplace_back(name, ParameterValue(value));
    return *this;
  }

#define RCLCPP_STAND_IN_OPTION(name, value) \
public: \
  bool name() const {return name ## _;} \
  NodeOptions & name(bool wanted) {name ## _ = wanted; return *this;} \
\
private: \
  bool name ## _ = value

  RCLCPP_STAND_IN_OPTION(use_global_arguments, true);
  RCLCPP_STAND_IN_OPTION(enable_rosout, true);
  RCLCPP_STAND_IN_OPTION(use_intra_process_comms, false);
  RCLCPP_STAND_IN_OPTION(start_parameter_services, true);
  RCLCPP_STAND_IN_OPTION(start_parameter_event_publisher, true);
  RCLCPP_STAND_IN_OPTION(allow_undeclared_parameters, false);
  RCLCPP_STAND_IN_OPTION(automatically_declare_parameters_from_overrides, false);

#undef RCLCPP_STAND_IN_OPTION

private:
  std::vector<std::string> arguments_;
  std::vector<Parameter> parameter_overrides_;
};

}  // namespace rclcpp

#endif  // RCLCPP__PARAMETER_HPP_
