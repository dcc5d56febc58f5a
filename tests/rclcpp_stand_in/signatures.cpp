// Each signature of the stand-in of rclcpp, used as nodes use it: this compiles with rclcpp too.
//
// The address of a function is taken where it has one type in both, else it is called. What takes
// defaults is called with and without them. Nothing here is run.

#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/floating_point_range.hpp"
#include "rcl_interfaces/msg/integer_range.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/header.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"

using rcl_interfaces::msg::ListParametersResult;
using rcl_interfaces::msg::ParameterDescriptor;
using rcl_interfaces::msg::SetParametersResult;
using std_msgs::msg::String;
using std_srvs::srv::SetBool;
using std::chrono::nanoseconds;
using namespace std::chrono_literals;  // NOLINT(build/namespaces)

template<class Expected, class Actual>
constexpr bool is_same = std::is_same_v<Expected, Actual>;

template<class FunctionT>
constexpr bool is_there(FunctionT function)
{
  return function != nullptr;
}

template<class T>
void use(const T &) {}

#define TAKE(type, function) static_assert(is_there<type>(&function))
#define SAME(type, ...) static_assert(is_same<type, decltype(__VA_ARGS__)>)

template<class T>
void has_pointers()
{
  static_assert(is_same<std::shared_ptr<T>, typename T::SharedPtr>);
  static_assert(is_same<std::shared_ptr<const T>, typename T::ConstSharedPtr>);
  static_assert(is_same<std::weak_ptr<T>, typename T::WeakPtr>);
}

void begin_and_end(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  SAME(bool, rclcpp::ok());
  SAME(bool, rclcpp::shutdown());
  SAME(bool, rclcpp::shutdown(nullptr, "why"));
  rclcpp::on_shutdown([]() {});
  SAME(bool, rclcpp::sleep_for(10ms));
  TAKE(
    std::vector<std::string>(*)(int, char const * const *), rclcpp::remove_ros_arguments);
  has_pointers<rclcpp::Context>();
  rclcpp::Context::SharedPtr context = rclcpp::contexts::get_global_default_context();
  SAME(bool, context->is_valid());
}

void times(rclcpp::Node & node)
{
  using rclcpp::Duration;
  using rclcpp::Time;
  const Duration one(1, 500u);
  const Duration all[] = {
    Duration(nanoseconds(5)), 10ms, 2s, Duration::from_seconds(0.5),
    Duration::from_nanoseconds(7), builtin_interfaces::msg::Duration(), Duration::max()};
  const builtin_interfaces::msg::Duration length = one + all[0] - all[1] * 2.0;
  use(length);
  SAME(int64_t, one.nanoseconds());
  SAME(double, one.seconds());
  SAME(std::chrono::milliseconds, one.to_chrono<std::chrono::milliseconds>());
  SAME(rmw_time_t, one.to_rmw_time());
  SAME(bool, one == one || one != one || one < one || one <= one || one > one || one >= one);

  Time now = node.now();
  now = node.get_clock()->now();
  const Time others[] = {
    Time(1, 2u), Time(3, 4u, RCL_ROS_TIME), Time(5), Time(), Time(int64_t{6}, RCL_STEADY_TIME),
    builtin_interfaces::msg::Time()};
  SAME(Duration, now - others[0]);
  SAME(Time, now - one);
  SAME(Time, now + one);
  SAME(int64_t, now.nanoseconds());
  SAME(double, now.seconds());
  SAME(rcl_clock_type_t, now.get_clock_type());
  SAME(bool, now == now || now != now || now < now || now <= now || now > now || now >= now);
  std_msgs::msg::Header header;
  header.stamp = node.now();
  header.stamp = node.get_clock()->now() + one;

  has_pointers<rclcpp::Clock>();
  rclcpp::Clock clock;
  const rclcpp::Clock::SharedPtr steady = std::make_shared<rclcpp::Clock>(RCL_STEADY_TIME);
  SAME(rcl_clock_type_t, steady->get_clock_type());
  SAME(rcl_clock_t *, steady->get_clock_handle());
  rclcpp::Rate rate(10.0);
  rclcpp::Rate other(Duration(1, 0), steady);
  rclcpp::WallRate wall(10);
  rclcpp::WallRate slow(1s);
  SAME(bool, rate.sleep() && other.sleep() && wall.sleep() && slow.sleep());
  SAME(nanoseconds, rate.period());
}

void qualities()
{
  using rclcpp::QoS;
  const QoS all[] = {
    10, QoS(10), QoS(rclcpp::KeepLast(10)), QoS(rclcpp::KeepAll()),
    QoS(rclcpp::QoSInitialization::from_rmw(rmw_qos_profile_sensor_data)),
    QoS(rclcpp::KeepLast(1), rmw_qos_profile_default),
    rclcpp::SensorDataQoS(), rclcpp::SensorDataQoS(rclcpp::KeepLast(1)), rclcpp::ParametersQoS(),
    rclcpp::ServicesQoS(), rclcpp::ParameterEventsQoS(), rclcpp::SystemDefaultsQoS(),
    rclcpp::BestAvailableQoS(), rclcpp::ClockQoS(),
    QoS(10).history(rclcpp::HistoryPolicy::KeepLast).keep_last(5).keep_all(),
    QoS(10).reliability(rclcpp::ReliabilityPolicy::BestEffort).reliable().best_effort(),
    QoS(10).reliability_best_available().durability_best_available(),
    QoS(10).durability(rclcpp::DurabilityPolicy::TransientLocal).durability_volatile(),
    QoS(10).transient_local().deadline(100ms).lifespan(rclcpp::Duration::from_seconds(1.5)),
    QoS(10).liveliness(rclcpp::LivelinessPolicy::ManualByTopic).liveliness_lease_duration(1s),
    QoS(10).history(RMW_QOS_POLICY_HISTORY_KEEP_LAST),
    QoS(10).liveliness(RMW_QOS_POLICY_LIVELINESS_AUTOMATIC),
    QoS(10).reliability(RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT),
    QoS(10).durability(RMW_QOS_POLICY_DURABILITY_VOLATILE).deadline(rmw_time_t{1, 2}),
    QoS(10).lifespan(rmw_time_t{1, 2}).liveliness_lease_duration(rmw_time_t{1, 2}),
    rclcpp::SensorDataQoS().reliable(), QoS(10).avoid_ros_namespace_conventions(true)};
  const QoS & one = all[0];
  SAME(rclcpp::HistoryPolicy, one.history());
  SAME(rclcpp::ReliabilityPolicy, one.reliability());
  SAME(rclcpp::DurabilityPolicy, one.durability());
  SAME(rclcpp::LivelinessPolicy, one.liveliness());
  SAME(size_t, one.depth());
  SAME(rclcpp::Duration, one.deadline());
  SAME(rclcpp::Duration, one.lifespan());
  SAME(rclcpp::Duration, one.liveliness_lease_duration());
  SAME(const rmw_qos_profile_t &, one.get_rmw_qos_profile());
  static_assert(rclcpp::HistoryPolicy::KeepAll != rclcpp::HistoryPolicy::SystemDefault);
  static_assert(rclcpp::ReliabilityPolicy::SystemDefault != rclcpp::ReliabilityPolicy::Reliable);
  static_assert(rclcpp::DurabilityPolicy::SystemDefault != rclcpp::DurabilityPolicy::Volatile);
  static_assert(rclcpp::LivelinessPolicy::SystemDefault != rclcpp::LivelinessPolicy::Automatic);
}

#define LOG_AT(severity) \
  RCLCPP_ ## severity(logger, "text"); \
  RCLCPP_ ## severity(logger, "%s: %d", name.c_str(), 1); \
  RCLCPP_ ## severity(node.get_logger(), "%.3f", 0.5); \
  RCLCPP_ ## severity ## _ONCE(logger, "once %d", 1); \
  RCLCPP_ ## severity ## _EXPRESSION(logger, name.empty(), "%d", 1); \
  RCLCPP_ ## severity ## _THROTTLE(logger, *node.get_clock(), 1000, "%d", 1); \
  RCLCPP_ ## severity ## _SKIPFIRST(logger, "%d", 1); \
  RCLCPP_ ## severity ## _SKIPFIRST_THROTTLE(logger, *node.get_clock(), 1000, "%d", 1); \
  RCLCPP_ ## severity ## _STREAM(logger, "a stream of " << name << 1); \
  RCLCPP_ ## severity ## _STREAM_ONCE(logger, name); \
  RCLCPP_ ## severity ## _STREAM_THROTTLE(logger, *node.get_clock(), 1000, "s" << 1)

void logs(rclcpp::Node & node)
{
  const std::string name = "name";
  rclcpp::Logger logger = rclcpp::get_logger("logger");
  LOG_AT(DEBUG);
  LOG_AT(INFO);
  LOG_AT(WARN);
  LOG_AT(ERROR);
  LOG_AT(FATAL);
  SAME(rclcpp::Logger, logger.get_child("child"));
  SAME(const char *, logger.get_name());
  logger.set_level(rclcpp::Logger::Level::Debug);
}

void parameters(rclcpp::Node & node)
{
  ParameterDescriptor descriptor;
  rcl_interfaces::msg::FloatingPointRange range;
  descriptor.floating_point_range.push_back(range);
  descriptor.integer_range.resize(1);
  SAME(double, node.declare_parameter("a", 1.5));
  SAME(double, node.declare_parameter<double>("a", 1.5, descriptor));
  SAME(int64_t, node.declare_parameter("b", 1));
  SAME(int64_t, node.declare_parameter<int>("b", 1));
  SAME(int64_t, node.declare_parameter<int64_t>("b", 1, descriptor, true));
  SAME(bool, node.declare_parameter("c", true));
  SAME(std::string, node.declare_parameter("d", "text"));
  SAME(std::string, node.declare_parameter<std::string>("d", "text", descriptor));
  SAME(std::vector<double>, node.declare_parameter("e", std::vector<double>{1.0}));
  SAME(std::vector<int64_t>, node.declare_parameter("f", std::vector<int64_t>{1}));
  SAME(std::vector<bool>, node.declare_parameter("g", std::vector<bool>{true}));
  SAME(std::vector<std::string>, node.declare_parameter("h", std::vector<std::string>{"i"}));
  SAME(std::vector<uint8_t>, node.declare_parameter("j", std::vector<uint8_t>{1}));
  SAME(std::string, node.declare_parameter<std::string>("d"));
  SAME(std::vector<double>, node.declare_parameter<std::vector<double>>("e", descriptor));
  const rclcpp::ParameterValue one_more(1);
  SAME(const rclcpp::ParameterValue &, node.declare_parameter("k", one_more, descriptor));
  SAME(const rclcpp::ParameterValue &, node.declare_parameter("k", rclcpp::PARAMETER_STRING));

  using rclcpp::Node;
  TAKE(void (Node::*)(const std::string &), Node::undeclare_parameter);
  TAKE(bool (Node::*)(const std::string &) const, Node::has_parameter);
  TAKE(SetParametersResult(Node::*)(const rclcpp::Parameter &), Node::set_parameter);
  TAKE(
    std::vector<SetParametersResult>(Node::*)(const std::vector<rclcpp::Parameter> &),
    Node::set_parameters);
  TAKE(
    SetParametersResult(Node::*)(const std::vector<rclcpp::Parameter> &),
    Node::set_parameters_atomically);
  TAKE(
    std::vector<rclcpp::Parameter>(Node::*)(const std::vector<std::string> &) const,
    Node::get_parameters);
  TAKE(ParameterDescriptor(Node::*)(const std::string &) const, Node::describe_parameter);
  TAKE(
    ListParametersResult(Node::*)(const std::vector<std::string> &, uint64_t) const,
    Node::list_parameters);

  double number = 0;
  int whole = 0;
  std::string text;
  std::vector<double> numbers;
  rclcpp::Parameter parameter = node.get_parameter("a");
  SAME(bool, node.get_parameter("a", parameter));
  SAME(bool, node.get_parameter("a", number));
  SAME(bool, node.get_parameter("b", whole));
  SAME(bool, node.get_parameter("d", text));
  SAME(bool, node.get_parameter("e", numbers));
  node.get_parameter("b", whole);
  SAME(bool, node.get_parameter_or("a", number, 1.0));
  SAME(std::string, node.get_parameter_or<std::string>("d", "text"));

  const rclcpp::Parameter all[] = {
    rclcpp::Parameter(), rclcpp::Parameter("a"), rclcpp::Parameter("a", 1.5),
    rclcpp::Parameter("b", 1), rclcpp::Parameter("c", true), rclcpp::Parameter("d", "text"),
    rclcpp::Parameter("e", std::vector<double>{1.0}),
    rclcpp::Parameter("f", rclcpp::ParameterValue(std::vector<int64_t>{1}))};
  const rclcpp::Parameter & one = all[0];
  SAME(bool, one == all[1] || one != all[1]);
  SAME(const std::string &, one.get_name());
  SAME(rclcpp::ParameterType, one.get_type());
  SAME(std::string, one.get_type_name());
  SAME(std::string, one.value_to_string());
  SAME(double, one.get_value<double>());
  SAME(int64_t, one.get_value<int>());
  SAME(std::string, one.get_value<std::string>());
  SAME(std::vector<std::string>, one.get_value<std::vector<std::string>>());
  SAME(bool, one.as_bool());
  SAME(int64_t, one.as_int());
  SAME(double, one.as_double());
  SAME(const std::string &, one.as_string());
  SAME(const std::vector<uint8_t> &, one.as_byte_array());
  SAME(const std::vector<bool> &, one.as_bool_array());
  SAME(const std::vector<int64_t> &, one.as_integer_array());
  SAME(const std::vector<double> &, one.as_double_array());
  SAME(const std::vector<std::string> &, one.as_string_array());
  SAME(rcl_interfaces::msg::Parameter, one.to_parameter_msg());
  SAME(rcl_interfaces::msg::ParameterValue, one.get_value_message());
  SAME(const rclcpp::ParameterValue &, one.get_parameter_value());
  SAME(
    rclcpp::Parameter, rclcpp::Parameter::from_parameter_msg(rcl_interfaces::msg::Parameter()));
  const rclcpp::ParameterValue & value = one.get_parameter_value();
  SAME(const double &, value.get<double>());
  SAME(const int64_t &, value.get<rclcpp::PARAMETER_INTEGER>());
  SAME(rcl_interfaces::msg::ParameterValue, value.to_value_msg());
  SAME(std::string, rclcpp::to_string(value));
  SAME(std::string, rclcpp::to_string(rclcpp::PARAMETER_NOT_SET));

  Node::OnSetParametersCallbackHandle::SharedPtr asked = node.add_on_set_parameters_callback(
    [](const std::vector<rclcpp::Parameter> &) {
      SetParametersResult result;
      result.successful = true;
      return result;
    });
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr same = asked;
  Node::PostSetParametersCallbackHandle::SharedPtr told = node.add_post_set_parameters_callback(
    [](const std::vector<rclcpp::Parameter> &) {});
  node.remove_on_set_parameters_callback(asked.get());
  node.remove_post_set_parameters_callback(told.get());
}

template<class ExceptionT>
void is_exception()
{
  static_assert(std::is_base_of_v<std::runtime_error, ExceptionT>);
}

void exceptions()
{
  using namespace rclcpp::exceptions;  // NOLINT(build/namespaces)
  is_exception<RCLError>();
  is_exception<InvalidParametersException>();
  is_exception<InvalidParameterValueException>();
  is_exception<InvalidParameterTypeException>();
  is_exception<UninitializedStaticallyTypedParameterException>();
  is_exception<ParameterAlreadyDeclaredException>();
  is_exception<ParameterNotDeclaredException>();
  is_exception<ParameterImmutableException>();
  is_exception<ParameterUninitializedException>();
  is_exception<rclcpp::ParameterTypeException>();
}

void options()
{
  rclcpp::NodeOptions options;
  options.arguments({"--ros-args", "-p", "a:=1"}).use_global_arguments(false)
  .append_parameter_override("a", 1).append_parameter_override("d", "text")
  .parameter_overrides({{"e", 1.5}}).enable_rosout(true).use_intra_process_comms(true)
  .start_parameter_services(true).start_parameter_event_publisher(true)
  .allow_undeclared_parameters(true).automatically_declare_parameters_from_overrides(true);
  SAME(const std::vector<std::string> &, std::as_const(options).arguments());
  SAME(std::vector<rclcpp::Parameter> &, options.parameter_overrides());
  SAME(bool, options.use_global_arguments() && options.enable_rosout());
  SAME(bool, options.use_intra_process_comms() && options.start_parameter_services());
  SAME(bool, options.start_parameter_event_publisher() && options.allow_undeclared_parameters());
  SAME(bool, options.automatically_declare_parameters_from_overrides());
}

class Example : public rclcpp::Node
{
public:
  Example()
  : Node("example") {}
  explicit Example(const rclcpp::NodeOptions & options)
  : Node("example", "/space", options) {}

  void handle_string(const String & message) {publisher_->publish(message);}
  void handle_pointer(const String::SharedPtr message) {publisher_->publish(*message);}
  void handle_const_pointer(const String::ConstSharedPtr message) {publisher_->publish(*message);}
  void handle_unique(String::UniquePtr message) {publisher_->publish(std::move(message));}
  void handle_request(
    const std::shared_ptr<SetBool::Request> request, std::shared_ptr<SetBool::Response> response)
  {
    response->success = request->data;
  }

  void topics()
  {
    using std::placeholders::_1;
    has_pointers<rclcpp::Publisher<String>>();
    has_pointers<rclcpp::Subscription<String>>();
    publisher_ = create_publisher<String>("chatter", 10);
    publisher_ = create_publisher<String>("chatter", rclcpp::QoS(10), rclcpp::PublisherOptions());
    publisher_->publish(String());
    publisher_->publish(std::make_unique<String>());
    SAME(size_t, publisher_->get_subscription_count());
    SAME(const char *, publisher_->get_topic_name());
    SAME(rclcpp::QoS, publisher_->get_actual_qos());
    SAME(bool, publisher_->assert_liveliness());
    rclcpp::PublisherBase::SharedPtr publisher = publisher_;
    publisher_ = rclcpp::create_publisher<String>(*this, "chatter", 10);
    publisher_ = rclcpp::create_publisher<String>(shared_from_this(), "chatter", rclcpp::QoS(10));

    rclcpp::SubscriptionOptions options;
    options.callback_group = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    options.ignore_local_publications = true;
    rclcpp::Subscription<String>::SharedPtr all[] = {
      create_subscription<String>("chatter", 10, [](const String &) {}),
      create_subscription<String>("chatter", 10, [](String::SharedPtr) {}, options),
      create_subscription<String>("chatter", 10, [](String::ConstSharedPtr) {}),
      create_subscription<String>("chatter", 10, [](const String::ConstSharedPtr &) {}),
      create_subscription<String>("chatter", 10, [](String::UniquePtr) {}),
      create_subscription<String>("chatter", 10, std::bind(&Example::handle_string, this, _1)),
      create_subscription<String>("chatter", 10, std::bind(&Example::handle_pointer, this, _1)),
      create_subscription<String>(
        "chatter", 10, std::bind(&Example::handle_const_pointer, this, _1)),
      create_subscription<String>("chatter", 10, std::bind(&Example::handle_unique, this, _1)),
      rclcpp::create_subscription<String>(*this, "chatter", 10, [](const String &) {})};
    SAME(size_t, all[0]->get_publisher_count());
    SAME(const char *, all[0]->get_topic_name());
    SAME(rclcpp::QoS, all[0]->get_actual_qos());
    rclcpp::SubscriptionBase::SharedPtr subscription = all[0];
  }

  void services()
  {
    using std::placeholders::_1;
    using std::placeholders::_2;
    using Request = std::shared_ptr<SetBool::Request>;
    using Response = std::shared_ptr<SetBool::Response>;
    has_pointers<rclcpp::Service<SetBool>>();
    rclcpp::Service<SetBool>::SharedPtr all[] = {
      create_service<SetBool>("switch", std::bind(&Example::handle_request, this, _1, _2)),
      create_service<SetBool>("switch", [](const Request, Response) {}, rclcpp::ServicesQoS()),
      create_service<SetBool>(
        "switch", [](const SetBool::Request::SharedPtr, SetBool::Response::SharedPtr) {}),
      create_service<SetBool>(
        "switch", [](const std::shared_ptr<rmw_request_id_t>, const Request, Response) {}),
      create_service<SetBool>(
        "switch", [this](const std::shared_ptr<rmw_request_id_t> id, const Request) {
          SetBool::Response response;
          service_->send_response(*id, response);
        })};
    service_ = all[0];
    SAME(const char *, service_->get_service_name());
    rclcpp::ServiceBase::SharedPtr service = service_;
  }

  void clients()
  {
    using Client = rclcpp::Client<SetBool>;
    has_pointers<Client>();
    Client::SharedPtr client = create_client<SetBool>("switch");
    client = create_client<SetBool>("switch", rclcpp::ServicesQoS(), nullptr);
    SAME(bool, client->service_is_ready());
    SAME(bool, client->wait_for_service());
    SAME(bool, client->wait_for_service(1s));
    SAME(const char *, client->get_service_name());
    auto request = std::make_shared<SetBool::Request>();
    auto sent = client->async_send_request(request);
    static_assert(is_same<Client::FutureAndRequestId, decltype(sent)>);
    SAME(int64_t, sent.request_id);
    SAME(std::shared_ptr<SetBool::Response>, sent.get());
    SAME(std::future_status, sent.wait_for(1s));
    SAME(bool, client->remove_pending_request(sent.request_id));
    SAME(bool, client->remove_pending_request(sent));
    SAME(size_t, client->prune_pending_requests());
    auto called = client->async_send_request(
      request, [](Client::SharedFuture future) {future.get();});
    static_assert(is_same<Client::SharedFutureAndRequestId, decltype(called)>);
    std::shared_future<std::shared_ptr<SetBool::Response>> shared = called.future;
    shared = sent.share();
    const auto node = shared_from_this();
    use<rclcpp::FutureReturnCode>(rclcpp::spin_until_future_complete(node, sent));
    use<rclcpp::FutureReturnCode>(rclcpp::spin_until_future_complete(node, shared, 1s));
    use<rclcpp::FutureReturnCode>(
      rclcpp::spin_until_future_complete(get_node_base_interface(), sent.future, 100ms));
    static_assert(rclcpp::FutureReturnCode::SUCCESS != rclcpp::FutureReturnCode::TIMEOUT);
    static_assert(rclcpp::FutureReturnCode::SUCCESS != rclcpp::FutureReturnCode::INTERRUPTED);
    rclcpp::ClientBase::SharedPtr base = client;
  }

  void timers()
  {
    has_pointers<rclcpp::TimerBase>();
    const auto group = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    rclcpp::TimerBase::SharedPtr all[] = {
      create_wall_timer(100ms, []() {}),
      create_wall_timer(1s, [this]() {topics();}, group, false),
      create_wall_timer(nanoseconds(5), std::bind(&Example::services, this)),
      create_wall_timer(std::chrono::duration<double>(0.5), [](rclcpp::TimerBase & timer) {
          timer.cancel();
        }),
      create_timer(100ms, []() {}), create_timer(1s, []() {}, group),
      rclcpp::create_timer(this, get_clock(), 1s, []() {}),
      rclcpp::create_timer(
        shared_from_this(), get_clock(), rclcpp::Duration::from_seconds(0.5),
        std::bind(&Example::services, this))};
    rclcpp::TimerBase & one = *all[0];
    one.cancel();
    one.reset();
    SAME(bool, one.is_canceled() && one.is_ready() && one.is_steady());
    SAME(nanoseconds, one.time_until_trigger());
  }

private:
  rclcpp::Publisher<String>::SharedPtr publisher_;
  rclcpp::Service<SetBool>::SharedPtr service_;
};

void nodes()
{
  using rclcpp::Node;
  has_pointers<Node>();
  Node::SharedPtr node = std::make_shared<Node>("name", "/space");
  node = std::make_shared<Example>(rclcpp::NodeOptions());
  node = Node::make_shared("name");
  const Node::UniquePtr alone = Node::make_unique("name", "/space", rclcpp::NodeOptions());
  TAKE(const char * (Node::*)() const, Node::get_name);
  TAKE(const char * (Node::*)() const, Node::get_namespace);
  TAKE(const char * (Node::*)() const, Node::get_fully_qualified_name);
  TAKE(rclcpp::Logger(Node::*)() const, Node::get_logger);
  TAKE(rclcpp::Time(Node::*)() const, Node::now);
  TAKE(rclcpp::Clock::SharedPtr(Node::*)(), Node::get_clock);
  TAKE(rclcpp::Clock::ConstSharedPtr(Node::*)() const, Node::get_clock);
  TAKE(size_t(Node::*)(const std::string &) const, Node::count_publishers);
  TAKE(size_t(Node::*)(const std::string &) const, Node::count_subscribers);
  SAME(const rclcpp::NodeOptions &, node->get_node_options());
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base = node->get_node_base_interface();
  SAME(const char *, std::as_const(*base).get_name());
  const rclcpp::CallbackGroup::SharedPtr group = node->create_callback_group(
    rclcpp::CallbackGroupType::Reentrant);
  SAME(const rclcpp::CallbackGroupType &, group->type());
}

void executors(const Example::SharedPtr & node)
{
  rclcpp::spin(node);
  rclcpp::spin(node->get_node_base_interface());
  rclcpp::spin_some(node);
  rclcpp::spin_some(node->get_node_base_interface());
  std::promise<int> promise;
  const std::shared_future<int> future = promise.get_future().share();
  rclcpp::executors::SingleThreadedExecutor single;
  rclcpp::executors::MultiThreadedExecutor multi;
  rclcpp::executors::SingleThreadedExecutor other{rclcpp::ExecutorOptions()};
  rclcpp::executors::MultiThreadedExecutor many(rclcpp::ExecutorOptions(), 4);
  SAME(size_t, many.get_number_of_threads());
  for (rclcpp::Executor * executor : {static_cast<rclcpp::Executor *>(&single),
      static_cast<rclcpp::Executor *>(&multi)})
  {
    executor->add_node(node);
    executor->add_node(node->get_node_base_interface());
    executor->spin();
    executor->spin_some();
    executor->spin_once(10ms);
    executor->spin_once();
    SAME(rclcpp::FutureReturnCode, executor->spin_until_future_complete(future));
    SAME(rclcpp::FutureReturnCode, executor->spin_until_future_complete(future, 1s));
    executor->cancel();
    executor->remove_node(node);
  }
}

int main(int argc, char ** argv)
{
  begin_and_end(argc, argv);
  Example example;
  times(example);
  qualities();
  logs(example);
  parameters(example);
  exceptions();
  options();
  nodes();
  executors(std::make_shared<Example>());
  return 0;
}
