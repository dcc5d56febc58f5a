// The services that show the parameters of a node of the stand-in, and let them be set.

#include <memory>
#include <string>
#include <vector>

#include "parameters.hpp"
#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"

namespace rclcpp::stand_in
{

template<class ServiceT, class HandlerT>
void Parameters::serve(const std::string & name, HandlerT && handler)
{
  using Request = std::shared_ptr<typename ServiceT::Request>;
  using Response = std::shared_ptr<typename ServiceT::Response>;
  const auto answer = [handler](Request request, Response response) {handler(*request, *response);};
  const auto service = std::make_shared<Service<ServiceT>>(
    node_, std::string(node_->get_name()) + "/" + name, answer, ParametersQoS(), nullptr);
  node_->add(service);
  services_.push_back(service);
}

void Parameters::serve()
{
  using namespace rcl_interfaces::srv;  // NOLINT(build/namespaces)
  serve<GetParameters>(
    "get_parameters", [this](const auto & request, auto & response) {
      for (const std::string & name : request.names) {
        Parameter found;
        if (!get(name, found) && !allows_undeclared_) {
          // Whoever asks for one that is not there gets none at all.
          response.values.clear();
          return;
        }
        response.values.push_back(found.get_value_message());
      }
    });
  serve<GetParameterTypes>(
    "get_parameter_types", [this](const auto & request, auto & response) {
      for (const std::string & name : request.names) {
        Parameter found;
        get(name, found);
        response.types.push_back(found.get_type());
      }
    });
  serve<SetParameters>(
    "set_parameters", [this](const auto & request, auto & response) {
      for (const auto & each : request.parameters) {
        response.results.push_back(set({Parameter::from_parameter_msg(each)}));
      }
    });
  serve<SetParametersAtomically>(
    "set_parameters_atomically", [this](const auto & request, auto & response) {
      std::vector<Parameter> parameters;
      for (const auto & each : request.parameters) {
        parameters.push_back(Parameter::from_parameter_msg(each));
      }
      response.result = set(parameters);
    });
  serve<DescribeParameters>(
    "describe_parameters", [this](const auto & request, auto & response) {
      for (const std::string & name : request.names) {
        if (!has(name) && !allows_undeclared_) {
          response.descriptors.clear();
          return;
        }
        response.descriptors.push_back(describe(name));
      }
    });
  serve<ListParameters>(
    "list_parameters", [this](const auto & request, auto & response) {
      response.result = list(request.prefixes, request.depth);
    });
}

}  // namespace rclcpp::stand_in
