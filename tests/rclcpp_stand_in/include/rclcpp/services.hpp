// Services and their clients, of the stand-in: see rclcpp.hpp.

#ifndef RCLCPP__SERVICES_HPP_
#define RCLCPP__SERVICES_HPP_

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>

#include "rcl/client.h"
#include "rcl/service.h"
#include "rclcpp/node_base.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_typesupport_cpp/service_type_support.hpp"

namespace rclcpp
{

class ServiceBase : public stand_in::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServiceBase)

  ServiceBase(
    stand_in::NodeBase node, const std::string & name, const rosidl_service_type_support_t * type,
    const QoS & qos, CallbackGroup::SharedPtr group);
  ~ServiceBase() override;

  const char * get_service_name() {return rcl_service_get_service_name(&service_);}

  void add_to(rcl_wait_set_t * wait_set) override;
  bool is_ready(const rcl_wait_set_t * wait_set) const override;
  void handle() override;

protected:
  using Request = std::shared_ptr<rmw_request_id_t>;

  virtual std::shared_ptr<void> create_request() = 0;
  // Return the response, nothing where it is sent later.
  virtual std::shared_ptr<void> respond(Request id, const std::shared_ptr<void> & request) = 0;
  void send_any_response(rmw_request_id_t & id, void * response);

private:
  rcl_service_t service_;
};

template<class ServiceT>
class Service : public ServiceBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Service<ServiceT>)

  template<class CallbackT>
  Service(
    stand_in::NodeBase node, const std::string & name, CallbackT && callback, const QoS & qos,
    CallbackGroup::SharedPtr group)
  : ServiceBase(
      node, name, rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(), qos, group),
    callback_(adapted(std::forward<CallbackT>(callback))) {}

  void send_response(rmw_request_id_t & id, typename ServiceT::Response & response)
  {
    send_any_response(id, &response);
  }

private:
  using RequestT = std::shared_ptr<typename ServiceT::Request>;
  using ResponseT = std::shared_ptr<typename ServiceT::Response>;
  using Handler = std::function<ResponseT(Request, RequestT)>;

  // A callback takes request and response, before them the id; or the id and the request alone.
  template<class CallbackT>
  static Handler adapted(CallbackT && callback)
  {
    using F = std::decay_t<CallbackT>;
    if constexpr (std::is_invocable_v<F &, RequestT, ResponseT>) {
      return [f = F(std::forward<CallbackT>(callback))](Request, RequestT request) mutable {
               auto response = std::make_shared<typename ServiceT::Response>();
               f(request, response);
               return response;
             };
    } else if constexpr (std::is_invocable_v<F &, Request, RequestT, ResponseT>) {
      return [f = F(std::forward<CallbackT>(callback))](Request id, RequestT request) mutable {
               auto response = std::make_shared<typename ServiceT::Response>();
               f(id, request, response);
               return response;
             };
    } else {
      static_assert(
        std::is_invocable_v<F &, Request, RequestT>, "the callback takes no such request");
      return [f = F(std::forward<CallbackT>(callback))](Request id, RequestT request) mutable {
               f(id, request);
               return ResponseT();
             };
    }
  }

  std::shared_ptr<void> create_request() override
  {
    return std::make_shared<typename ServiceT::Request>();
  }
  std::shared_ptr<void> respond(Request id, const std::shared_ptr<void> & request) override
  {
    return callback_(id, std::static_pointer_cast<typename ServiceT::Request>(request));
  }

  Handler callback_;
};

class ClientBase : public stand_in::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientBase)

  ClientBase(
    stand_in::NodeBase node, const std::string & name, const rosidl_service_type_support_t * type,
    const QoS & qos, CallbackGroup::SharedPtr group);
  ~ClientBase() override;

  const char * get_service_name() const {return rcl_client_get_service_name(&client_);}
  bool service_is_ready() const;
  template<class Rep = int64_t, class Period = std::milli>
  bool wait_for_service(
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait_for(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

  void add_to(rcl_wait_set_t * wait_set) override;
  bool is_ready(const rcl_wait_set_t * wait_set) const override;
  void handle() override;

protected:
  bool wait_for(std::chrono::nanoseconds timeout) const;
  // Return the number of the request, which its response has too.
  int64_t send(const void * request);
  virtual std::shared_ptr<void> create_response() = 0;
  virtual void handle_response(int64_t number, const std::shared_ptr<void> & response) = 0;

private:
  rcl_client_t client_;
};

template<class ServiceT>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client<ServiceT>)

  using SharedRequest = std::shared_ptr<typename ServiceT::Request>;
  using SharedResponse = std::shared_ptr<typename ServiceT::Response>;
  using Promise = std::promise<SharedResponse>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using CallbackType = std::function<void (SharedFuture)>;

  template<class FutureT>
  struct Sent
  {
    FutureT future;
    int64_t request_id;

    operator FutureT &() {return future;}
    auto get() {return future.get();}
    bool valid() const noexcept {return future.valid();}
    void wait() const {future.wait();}
    template<class Rep, class Period>
    std::future_status wait_for(const std::chrono::duration<Rep, Period> & timeout) const
    {
      return future.wait_for(timeout);
    }
  };

  struct FutureAndRequestId : Sent<Future>
  {
    SharedFuture share() noexcept {return this->future.share();}
  };
  using SharedFutureAndRequestId = Sent<SharedFuture>;

  Client(
    stand_in::NodeBase node, const std::string & name, const QoS & qos,
    CallbackGroup::SharedPtr group)
  : ClientBase(
      node, name, rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(), qos,
      group) {}

  FutureAndRequestId async_send_request(SharedRequest request)
  {
    std::lock_guard<std::mutex> lock(mutex_);
    const int64_t number = send(request.get());
    Pending & pending = pending_[number];
    return {{pending.promise.get_future(), number}};
  }
  template<
    class CallbackT,
    std::enable_if_t<std::is_invocable_v<CallbackT &, SharedFuture>> * = nullptr>
  SharedFutureAndRequestId async_send_request(SharedRequest request, CallbackT && callback)
  {
    std::lock_guard<std::mutex> lock(mutex_);
    const int64_t number = send(request.get());
    Pending & pending = pending_[number];
    pending.future = pending.promise.get_future();
    pending.callback = std::forward<CallbackT>(callback);
    return {pending.future, number};
  }

  // Forget a request, so that its response is not heard; tell whether it was waited for.
  bool remove_pending_request(int64_t number)
  {
    std::lock_guard<std::mutex> lock(mutex_);
    return pending_.erase(number) != 0;
  }
  template<class FutureT>
  bool remove_pending_request(const Sent<FutureT> & sent)
  {
    return remove_pending_request(sent.request_id);
  }
  size_t prune_pending_requests()
  {
    std::lock_guard<std::mutex> lock(mutex_);
    const size_t count = pending_.size();
    pending_.clear();
    return count;
  }

private:
  struct Pending
  {
    Promise promise;
    SharedFuture future;
    CallbackType callback;
  };

  std::shared_ptr<void> create_response() override
  {
    return std::make_shared<typename ServiceT::Response>();
  }
  void handle_response(int64_t number, const std::shared_ptr<void> & response) override
  {
    std::unique_lock<std::mutex> lock(mutex_);
    auto node = pending_.extract(number);
    lock.unlock();
    if (!node.empty()) {
      Pending & pending = node.mapped();
      pending.promise.set_value(std::static_pointer_cast<typename ServiceT::Response>(response));
      if (pending.callback) {
        pending.callback(pending.future);
      }
    }
  }

  std::mutex mutex_;
  std::map<int64_t, Pending> pending_;
};

}  // namespace rclcpp

#endif  // RCLCPP__SERVICES_HPP_
