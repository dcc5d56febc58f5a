// Logging of the stand-in, with rcutils: see rclcpp.hpp.

#ifndef RCLCPP__LOGGING_HPP_
#define RCLCPP__LOGGING_HPP_

#include <sstream>
#include <string>
#include <type_traits>

#include "rcutils/logging_macros.h"
#include "rcutils/time.h"

namespace rclcpp
{

class Logger
{
public:
  enum class Level
  {
    Unset = RCUTILS_LOG_SEVERITY_UNSET,
    Debug = RCUTILS_LOG_SEVERITY_DEBUG,
    Info = RCUTILS_LOG_SEVERITY_INFO,
    Warn = RCUTILS_LOG_SEVERITY_WARN,
    Error = RCUTILS_LOG_SEVERITY_ERROR,
    Fatal = RCUTILS_LOG_SEVERITY_FATAL,
  };

  const char * get_name() const {return name_.c_str();}
  Logger get_child(const std::string & suffix) {return Logger(name_ + "." + suffix);}
  void set_level(Level level);

private:
  explicit Logger(const std::string & name)
  : name_(name) {}
  friend Logger get_logger(const std::string & name);

  std::string name_;
};

inline Logger get_logger(const std::string & name)
{
  return Logger(name);
}

}  // namespace rclcpp

// As rclcpp does, refuse what is no logger.
#define RCLCPP_STAND_IN_CHECK(logger) \
  static_assert( \
    ::std::is_convertible_v<decltype(logger), ::rclcpp::Logger>, \
    "the first argument is a logger")

#define RCLCPP_DEBUG(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_DEBUG_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_ONCE(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_DEBUG_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_SKIPFIRST(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_DEBUG_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_EXPRESSION(logger, expression, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_DEBUG_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_DEBUG_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_SKIPFIRST_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_DEBUG_SKIPFIRST_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_STREAM(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_DEBUG(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_DEBUG_STREAM_ONCE(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_DEBUG_ONCE(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_DEBUG_STREAM_THROTTLE(logger, clock, milliseconds, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_DEBUG_THROTTLE( \
      logger, clock, milliseconds, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)

#define RCLCPP_INFO(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_INFO_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_ONCE(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_INFO_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_SKIPFIRST(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_INFO_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_EXPRESSION(logger, expression, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_INFO_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_INFO_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_SKIPFIRST_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_INFO_SKIPFIRST_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_STREAM(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_INFO(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_INFO_STREAM_ONCE(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_INFO_ONCE(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_INFO_STREAM_THROTTLE(logger, clock, milliseconds, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_INFO_THROTTLE( \
      logger, clock, milliseconds, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)

#define RCLCPP_WARN(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_WARN_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_ONCE(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_WARN_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_SKIPFIRST(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_WARN_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_EXPRESSION(logger, expression, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_WARN_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_WARN_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_SKIPFIRST_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_WARN_SKIPFIRST_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_STREAM(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_WARN(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_WARN_STREAM_ONCE(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_WARN_ONCE(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_WARN_STREAM_THROTTLE(logger, clock, milliseconds, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_WARN_THROTTLE( \
      logger, clock, milliseconds, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)

#define RCLCPP_ERROR(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_ERROR_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_ONCE(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_ERROR_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_SKIPFIRST(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_ERROR_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_EXPRESSION(logger, expression, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_ERROR_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_ERROR_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_SKIPFIRST_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_ERROR_SKIPFIRST_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_STREAM(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_ERROR(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_ERROR_STREAM_ONCE(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_ERROR_ONCE(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_ERROR_STREAM_THROTTLE(logger, clock, milliseconds, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_ERROR_THROTTLE( \
      logger, clock, milliseconds, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)

#define RCLCPP_FATAL(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_FATAL_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_ONCE(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_FATAL_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_SKIPFIRST(logger, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_FATAL_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_EXPRESSION(logger, expression, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    RCUTILS_LOG_FATAL_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_FATAL_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_SKIPFIRST_THROTTLE(logger, clock, milliseconds, ...) \
  do { \
    RCLCPP_STAND_IN_CHECK(logger); \
    auto rclcpp_stand_in_now = [&c = clock](rcutils_time_point_value_t * now) -> rcutils_ret_t { \
        *now = c.now().nanoseconds(); \
        return RCUTILS_RET_OK; \
      }; \
    RCUTILS_LOG_FATAL_SKIPFIRST_THROTTLE_NAMED( \
      rclcpp_stand_in_now, milliseconds, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_STREAM(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_FATAL(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_FATAL_STREAM_ONCE(logger, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_FATAL_ONCE(logger, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)
#define RCLCPP_FATAL_STREAM_THROTTLE(logger, clock, milliseconds, stream_arg) \
  do { \
    std::stringstream rclcpp_stand_in_stream; \
    rclcpp_stand_in_stream << stream_arg; \
    RCLCPP_FATAL_THROTTLE( \
      logger, clock, milliseconds, "%s", rclcpp_stand_in_stream.str().c_str()); \
  } while (0)

#endif  // RCLCPP__LOGGING_HPP_
