// Quality of service of the stand-in: see rclcpp.hpp.

#ifndef RCLCPP__QOS_HPP_
#define RCLCPP__QOS_HPP_

#include <cstddef>

#include "rclcpp/time.hpp"
#include "rmw/qos_profiles.h"
#include "rmw/types.h"

namespace rclcpp
{

enum class HistoryPolicy
{
  KeepLast = RMW_QOS_POLICY_HISTORY_KEEP_LAST,
  KeepAll = RMW_QOS_POLICY_HISTORY_KEEP_ALL,
  SystemDefault = RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT,
  Unknown = RMW_QOS_POLICY_HISTORY_UNKNOWN,
};

enum class ReliabilityPolicy
{
  BestEffort = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT,
  Reliable = RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  SystemDefault = RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_RELIABILITY_UNKNOWN,
};

enum class DurabilityPolicy
{
  Volatile = RMW_QOS_POLICY_DURABILITY_VOLATILE,
  TransientLocal = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  SystemDefault = RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_DURABILITY_UNKNOWN,
};

enum class LivelinessPolicy
{
  Automatic = RMW_QOS_POLICY_LIVELINESS_AUTOMATIC,
  ManualByTopic = RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC,
  SystemDefault = RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_LIVELINESS_UNKNOWN,
};

struct QoSInitialization
{
  rmw_qos_history_policy_t history_policy;
  size_t depth;

  QoSInitialization(rmw_qos_history_policy_t history, size_t depth_of_it)
  : history_policy(history), depth(depth_of_it) {}
  static QoSInitialization from_rmw(const rmw_qos_profile_t & profile)
  {
    return {profile.history, profile.depth};
  }
};

struct KeepAll : QoSInitialization
{
  KeepAll()
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0) {}
};

struct KeepLast : QoSInitialization
{
  explicit KeepLast(size_t depth_of_it)
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, depth_of_it) {}
};

class QoS
{
public:
  explicit QoS(
    const QoSInitialization & initialization,
    const rmw_qos_profile_t & profile = rmw_qos_profile_default);
  QoS(size_t depth)
  : QoS(KeepLast(depth)) {}

  rmw_qos_profile_t & get_rmw_qos_profile() {return profile_;}
  const rmw_qos_profile_t & get_rmw_qos_profile() const {return profile_;}

  QoS & history(HistoryPolicy policy);
  QoS & history(rmw_qos_history_policy_t policy)
  {
    return history(static_cast<HistoryPolicy>(policy));
  }
  QoS & keep_last(size_t depth);
  QoS & keep_all() {return history(HistoryPolicy::KeepAll);}
  QoS & reliability(ReliabilityPolicy policy);
  QoS & reliability(rmw_qos_reliability_policy_t policy)
  {
    return reliability(static_cast<ReliabilityPolicy>(policy));
  }
  QoS & reliable() {return reliability(ReliabilityPolicy::Reliable);}
  QoS & best_effort() {return reliability(ReliabilityPolicy::BestEffort);}
  QoS & reliability_best_available() {return reliability(ReliabilityPolicy::BestAvailable);}
  QoS & durability(DurabilityPolicy policy);
  QoS & durability(rmw_qos_durability_policy_t policy)
  {
    return durability(static_cast<DurabilityPolicy>(policy));
  }
  QoS & durability_volatile() {return durability(DurabilityPolicy::Volatile);}
  QoS & transient_local() {return durability(DurabilityPolicy::TransientLocal);}
  QoS & durability_best_available() {return durability(DurabilityPolicy::BestAvailable);}
  QoS & deadline(const Duration & duration) {return deadline(duration.to_rmw_time());}
  QoS & deadline(rmw_time_t time);
  QoS & lifespan(const Duration & duration) {return lifespan(duration.to_rmw_time());}
  QoS & lifespan(rmw_time_t time);
  QoS & liveliness(LivelinessPolicy policy);
  QoS & liveliness(rmw_qos_liveliness_policy_t policy)
  {
    return liveliness(static_cast<LivelinessPolicy>(policy));
  }
  QoS & liveliness_lease_duration(const Duration & duration)
  {
    return liveliness_lease_duration(duration.to_rmw_time());
  }
  QoS & liveliness_lease_duration(rmw_time_t time);
  QoS & avoid_ros_namespace_conventions(bool avoid);

  HistoryPolicy history() const {return static_cast<HistoryPolicy>(profile_.history);}
  size_t depth() const {return profile_.depth;}
  ReliabilityPolicy reliability() const
  {
    return static_cast<ReliabilityPolicy>(profile_.reliability);
  }
  DurabilityPolicy durability() const {return static_cast<DurabilityPolicy>(profile_.durability);}
  LivelinessPolicy liveliness() const {return static_cast<LivelinessPolicy>(profile_.liveliness);}
  Duration deadline() const;
  Duration lifespan() const;
  Duration liveliness_lease_duration() const;

private:
  rmw_qos_profile_t profile_;
};

#define RCLCPP_STAND_IN_PROFILE(name, profile) \
  class name : public QoS \
  { \
public: \
    explicit name( \
      const QoSInitialization & initialization = QoSInitialization::from_rmw(profile)) \
    : QoS(initialization, profile) {} \
  }

RCLCPP_STAND_IN_PROFILE(SensorDataQoS, rmw_qos_profile_sensor_data);
RCLCPP_STAND_IN_PROFILE(ParametersQoS, rmw_qos_profile_parameters);
RCLCPP_STAND_IN_PROFILE(ServicesQoS, rmw_qos_profile_services_default);
RCLCPP_STAND_IN_PROFILE(ParameterEventsQoS, rmw_qos_profile_parameter_events);
RCLCPP_STAND_IN_PROFILE(SystemDefaultsQoS, rmw_qos_profile_system_default);
RCLCPP_STAND_IN_PROFILE(BestAvailableQoS, rmw_qos_profile_best_available);

#undef RCLCPP_STAND_IN_PROFILE

class ClockQoS : public QoS
{
public:
  explicit ClockQoS(const QoSInitialization & initialization = KeepLast(1))
  : QoS(initialization, rmw_qos_profile_sensor_data) {}
};

}  // namespace rclcpp

#endif  // RCLCPP__QOS_HPP_
