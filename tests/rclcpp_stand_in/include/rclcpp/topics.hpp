// Publishers and subscriptions of the stand-in: see rclcpp.hpp.

#ifndef RCLCPP__TOPICS_HPP_
#define RCLCPP__TOPICS_HPP_

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rcl/publisher.h"
#include "rcl/subscription.h"
#include "rclcpp/node_base.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{

struct PublisherOptions
{
  CallbackGroup::SharedPtr callback_group;
};

struct SubscriptionOptions
{
  CallbackGroup::SharedPtr callback_group;
  bool ignore_local_publications = false;
};

class PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(PublisherBase)

  PublisherBase(
    stand_in::NodeBase node, const std::string & topic, const rosidl_message_type_support_t * type,
    const QoS & qos);
  virtual ~PublisherBase();
  PublisherBase(const PublisherBase &) = delete;
  PublisherBase & operator=(const PublisherBase &) = delete;

  const char * get_topic_name() const {return rcl_publisher_get_topic_name(&publisher_);}
  size_t get_subscription_count() const;
  QoS get_actual_qos() const;
  bool assert_liveliness() const;

protected:
  void publish_message(const void * message);

private:
  stand_in::NodeBase node_;
  rcl_publisher_t publisher_;
};

template<class MessageT>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher<MessageT>)

  Publisher(stand_in::NodeBase node, const std::string & topic, const QoS & qos)
  : PublisherBase(
      node, topic, rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>(), qos) {}

  void publish(const MessageT & message) {publish_message(&message);}
  void publish(std::unique_ptr<MessageT> message) {publish_message(message.get());}
};

class SubscriptionBase : public stand_in::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SubscriptionBase)

  SubscriptionBase(
    stand_in::NodeBase node, const std::string & topic, const rosidl_message_type_support_t * type,
    const QoS & qos, const SubscriptionOptions & options);
  ~SubscriptionBase() override;

  const char * get_topic_name() const {return rcl_subscription_get_topic_name(&subscription_);}
  size_t get_publisher_count() const;
  QoS get_actual_qos() const;

  void add_to(rcl_wait_set_t * wait_set) override;
  bool is_ready(const rcl_wait_set_t * wait_set) const override;
  void handle() override;

protected:
  virtual std::shared_ptr<void> create_message() = 0;
  virtual void handle_message(const std::shared_ptr<void> & message) = 0;

private:
  rcl_subscription_t subscription_;
};

template<class MessageT>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription<MessageT>)

  template<class CallbackT>
  Subscription(
    stand_in::NodeBase node, const std::string & topic, const QoS & qos, CallbackT && callback,
    const SubscriptionOptions & options)
  : SubscriptionBase(
      node, topic, rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>(), qos,
      options),
    callback_(adapted(std::forward<CallbackT>(callback))) {}

private:
  using Handler = std::function<void (std::shared_ptr<MessageT>)>;

  // A callback takes a message by reference, or as one of the pointers.
  template<class CallbackT>
  static Handler adapted(CallbackT && callback)
  {
    using F = std::decay_t<CallbackT> &;
    if constexpr (std::is_invocable_v<F, const MessageT &>) {
      return [f = std::decay_t<CallbackT>(std::forward<CallbackT>(callback))](
        std::shared_ptr<MessageT> message) mutable {f(*message);};
    } else if constexpr (std::is_invocable_v<F, std::shared_ptr<MessageT>>) {
      return Handler(std::forward<CallbackT>(callback));
    } else {
      static_assert(
        std::is_invocable_v<F, std::unique_ptr<MessageT>>, "the callback takes no such message");
      return [f = std::decay_t<CallbackT>(std::forward<CallbackT>(callback))](
        std::shared_ptr<MessageT> message) mutable {
               f(std::make_unique<MessageT>(std::move(*message)));
             };
    }
  }

  std::shared_ptr<void> create_message() override {return std::make_shared<MessageT>();}
  void handle_message(const std::shared_ptr<void> & message) override
  {
    callback_(std::static_pointer_cast<MessageT>(message));
  }

  Handler callback_;
};

}  // namespace rclcpp

#endif  // RCLCPP__TOPICS_HPP_
