"""Defects of the warehouse lift, in C++."""

from __future__ import annotations

from seed_table import seeds_of

HEADER = "lift_driver/include/lift_driver/lift_component.hpp"
LIFT = "lift_driver/src/lift_component.cpp"
PLANNER = "lift_driver/src/planner.cpp"
SCALE = "lift_driver/src/scale.cpp"
LOGGER = "lift_driver/scripts/pallet_logger.py"
LAUNCH = "lift_driver/launch/lift.launch.py"
PLAIN = "lift_driver/launch/plain.launch.xml"
CONFIG = "lift_driver/config/lift.yaml"
CMAKE = "lift_driver/CMakeLists.txt"
XML = "lift_driver/package.xml"
TYPES_CMAKE = "lift_msgs/CMakeLists.txt"
TYPES_XML = "lift_msgs/package.xml"
STATUS = "lift_msgs/msg/LiftStatus.msg"
PALLET = "lift_msgs/msg/Pallet.msg"
MOVE = "lift_msgs/srv/MoveTo.srv"

STATUS_PUB = (LIFT, "create_publisher<lift_msgs")
STATUS_SUB = (PLANNER, "create_subscription<lift_msgs")
STATUS_NAME = (PLANNER, '      "lift/status"')
PALLET_SUB = (PLANNER, "create_subscription<Pallet>")
PALLET_PUB = (LOGGER, "create_publisher(Pallet")
MODE_PUB = (PLANNER, "create_publisher<std_msgs")
MODE_SUB = (SCALE, "create_subscription<std_msgs")
WEIGHT_SUB = (PLANNER, "create_subscription<std_msgs")
WEIGHT_PUB = (SCALE, "create_publisher<Weight>")
LIFT_AT = ((LAUNCH, "            ComposableNode("), (LAUNCH, "name='lift'"), (LAUNCH, "plugin="))

# A seed a line or two is read as a table.
# fmt: off
seed = seeds_of("warehouse")

GRAPH = (
    seed("RG101", (SCALE, "typedef std_msgs::msg::Float64 Weight", "typedef std_msgs::msg::Float32 Weight"), (SCALE, "float64.hpp", "float32.hpp"), at=(WEIGHT_PUB, WEIGHT_SUB, (PLANNER, '"scale/weight"'))),
    seed("RG101", (PLANNER, "create_publisher<std_msgs::msg::String>", "§create_publisher<std_msgs::msg::Float64>"), at=(MODE_SUB, (SCALE, '"scale/mode"'))),
    seed("RG101", (LOGGER, "create_subscription(LiftStatus,", "§create_subscription(Pallet,"), at=(STATUS_PUB,), also="RM201"),
    seed("RG102", (LOGGER, "'pallets', qos)", "'pallets', 10)"), at=(PALLET_PUB, PALLET_SUB, (PLANNER, "kPalletTopic, rclcpp"))),
    seed("RG102", (PLANNER, ".reliable().transient_local()", ".reliable()"), at=(MODE_PUB, MODE_SUB, (SCALE, '"scale/mode"'))),
    seed("RG102", (PLANNER, "rclcpp::QoS(rclcpp::KeepLast(5)).best_effort()", "10"), at=(WEIGHT_PUB, WEIGHT_SUB, (PLANNER, '"scale/weight"'))),
    seed("RG102", (LIFT, '"lift/status", 10', '"lift/status", rclcpp::SensorDataQoS()'), at=(STATUS_PUB, STATUS_SUB, STATUS_NAME, (LOGGER, "create_subscription(LiftStatus"))),
    seed("RG102", (SCALE, '"scale/temperature", 10', '"scale/temperature", rclcpp::QoS(10).best_effort()'), at=((SCALE, "create_publisher<sensor_msgs"), (LOGGER, "create_subscription(Temperature"))),
    seed("RG102", (LIFT, '  status_pub_ = this->create_publisher<lift_msgs::msg::LiftStatus>("lift/status", 10)', '  rclcpp::QoS qos(rclcpp::KeepLast(1));\n  qos.reliability(RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT);\n  status_pub_ = this->create_publisher<lift_msgs::msg::LiftStatus>("lift/status", qos)'), at=(STATUS_PUB, STATUS_SUB, STATUS_NAME, (LOGGER, "create_subscription(LiftStatus"))),
    seed("RG103", (PLAIN, 'exec="scale" name="scale"', '§exec="scale" name="planner"'), at=((PLAIN, 'exec="planner"'),)),
    seed("RG103", (LAUNCH, "executable='scale', parameters", "executable='scale', name='lift', parameters"), at=((LAUNCH, "executable='scale'"), (LAUNCH, "                name='lift',"), (LAUNCH, "            ComposableNode(")), also="RP301 RP302"),
    seed("RG103", (LAUNCH, "        container,\n", "        container,\n        §Node(package='lift_driver', executable='scale'),\n"), at=((LAUNCH, "executable='scale', parameters"),)),
    seed("RG104", (PLANNER, 'kPalletTopic[] = "pallets"', 'kPalletTopic[] = "palets"'), at=(PALLET_SUB, PALLET_PUB, (PLANNER, "kPalletTopic[]"), (PLANNER, "      kPalletTopic,"))),
    seed("RG104", (PLANNER, 'create_client<MoveTo>("lift/move_to")', 'create_client<MoveTo>("lift/moveto")'), at=((PLANNER, "create_client<"), (LIFT, "create_service<MoveTo>"))),
    seed("RG104", (SCALE, '"scale/mode"', '"scale/mod"'), at=(MODE_SUB, MODE_PUB, (SCALE, '"scale/mod"'))),
    seed("RG104", (LOGGER, "'scale/temperature'", "'scale/temprature'"), at=((LOGGER, "create_subscription(Temperature"), (SCALE, "create_publisher<sensor_msgs"))),
    seed("RG105", (PLAIN, 'remap from="goal"', 'remap from="goals"')),
    seed("RG105", (LAUNCH, "('joint_states', '/arm/joint_states')", "('joint_state', '/arm/joint_states')")),
    seed("RG105", (LAUNCH, "executable='scale', parameters", "executable='scale', remappings=[('weight', 'scale/weight')], parameters")),
    seed("RG106", (LAUNCH, "executable='scale', parameters", "executable='scale', namespace='dock', parameters"), at=((LAUNCH, "executable='scale'"), WEIGHT_PUB, WEIGHT_SUB, MODE_SUB, MODE_PUB, (PLANNER, '"scale/weight"'), (SCALE, '"scale/mode"'), (SCALE, "create_publisher<sensor_msgs"), (LOGGER, "create_subscription(Temperature")), also="RP302 RP301"),
    seed("RG106", (PLAIN, 'exec="lift_node" name="lift"', '§exec="lift_node" name="lift" namespace="dock"'), at=(STATUS_PUB, STATUS_SUB, (PLANNER, "create_client<"), (LIFT, "create_service<MoveTo"), STATUS_NAME)),
    seed("RG106", (LAUNCH, "                name='lift',\n", "                name='lift',\n                §namespace='robot1',\n"), at=(*LIFT_AT, STATUS_PUB, STATUS_SUB, (PLANNER, "create_client<"), (LIFT, "create_service<MoveTo"), STATUS_NAME), also="RP302 RP301"),
    seed("RG106", (PLANNER, '"scale/weight", rclcpp', '"/scale/weight", rclcpp'), (PLAIN, 'exec="scale" name="scale"', '§exec="scale" name="scale" namespace="dock"'), at=(WEIGHT_PUB, (PLANNER, '"/scale/weight"'), WEIGHT_SUB, MODE_SUB, MODE_PUB, (SCALE, '"scale/mode"'))),
    seed("RG107", (LOGGER, "'pallets', qos", "'loads', qos"), at=(PALLET_SUB, (PLANNER, "kPalletTopic, rclcpp"))),
    seed("RG107", (SCALE, 'create_publisher<Weight>("scale/weight"', 'create_publisher<Weight>("mass"'), at=(WEIGHT_SUB, (PLANNER, '"scale/weight"'))),
    seed("RG108", (LOGGER, "        self.create_subscription(Temperature, 'scale/temperature', self.on_temperature, 10)\n", ""), at=((SCALE, "create_publisher<sensor_msgs"),)),
    seed("RG108", (PLANNER, '"scale/mode", rclcpp', '"scale/state", rclcpp'), at=((PLANNER, '"scale/state"'),)),
    seed("RG109", (PLANNER, 'create_client<MoveTo>("lift/move_to")', 'create_client<MoveTo>("elevator/go")'), at=((PLANNER, "create_client<"),)),
    seed("RG109", (LIFT, 'create_service<MoveTo>("lift/move_to"', 'create_service<MoveTo>("~/go"'), at=((PLANNER, "create_client<"),)),
    seed("RG110", (PLANNER, 'create_client<MoveTo>("lift/move_to")', 'create_client<MoveTo>("elevator/go")'), at=((LIFT, "create_service<MoveTo>"),)),
    seed("RG110", (LIFT, '  timer_ = this', '  §reset_srv_ = create_service<std_srvs::srv::Trigger>("lift/reset", [](const std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr r) { r->success = true; });\n  timer_ = this'), (HEADER, "::SharedPtr home_srv_;", "::SharedPtr home_srv_, reset_srv_;")),
)

MESSAGES = (
    seed("RM201", (LIFT, "status.height = height_", "status.hight = height_")),
    seed("RM201", (LIFT, "request->height <= max", "request->z <= max")),
    seed("RM201", (PLANNER, "pallet.weight > weight", "pallet.mass > weight")),
    seed("RM201", (PLANNER, "goal.pose.position = pallet", "goal.position = pallet")),
    seed("RM201", (PLANNER, "height_ = status->height", "height_ = status->position")),
    seed("RM201", (PLANNER, "response->reason.c_str()", "response->message.c_str()")),
    seed("RM201", (LIFT, "LiftStatus::IDLE :", "LiftStatus::STOPPED :")),
    seed("RM201", (PLANNER, "weight_ = msg->data", "weight_ = msg->value")),
    seed("RM201", (PLANNER, "mode->data =", "mode->text =")),
    seed("RM201", (LIFT, "msg->position.empty()", "msg->positions.empty()")),
    seed("RM201", (SCALE, "temperature.temperature =", "temperature.celsius =")),
    seed("RM201", (LIFT, 'response->message = "going', 'response->reason = "going')),
    seed("RM202", (PLANNER, 'goal.header.frame_id = "map"', "goal.header.frame_id = 7.5")),
    seed("RM202", (LIFT, 'response->reason = "too high"', "response->reason = nullptr")),
    seed("RM202", (SCALE, "temperature.temperature = 21.0", 'temperature.temperature = "21"')),
    seed("RM202", (LOGGER, "id=str(self.count)", "id=7")),
    seed("RM203", (LOGGER, "weight=12.0", "weight=12")),
    seed("RM204", (LOGGER, "Pallet(id=str(self.count), weight=12.0)", "Pallet(str(self.count), 12.0)")),
    seed("RM205", (PLANNER, "    goal.header.stamp = get_clock()->now();\n", ""), at=((PLANNER, "PoseStamped goal;"), (PLANNER, "goal_pub_->publish(goal)"))),
    seed("RM205", (LIFT, "  status.header.stamp = this->now();\n", ""), at=((LIFT, "auto status ="), (LIFT, "status_pub_->publish"))),
    seed("RM205", (SCALE, '    stamp(temperature, now(), "scale");\n', '    temperature.header.frame_id = "scale";\n'), at=((SCALE, "Temperature temperature;"), (SCALE, "temperature_pub_->publish"))),
    seed("RM205", (PLANNER, "    goal.header.stamp = get_clock()->now();\n    goal.pose.position = pallet.position;\n    goal.pose.orientation.w = 1.0;\n    goal_pub_->publish(goal);", "    goal.pose.position = pallet.position;\n    §goal_pub_->publish(goal);\n    goal.header.stamp = get_clock()->now();"), at=((PLANNER, "PoseStamped goal;"),)),
    seed("RM206", (PLANNER, '    goal.header.frame_id = "map";\n', ""), at=((PLANNER, "PoseStamped goal;"), (PLANNER, "goal_pub_->publish(goal)"))),
    seed("RM206", (SCALE, '    stamp(temperature, now(), "scale");\n', '    temperature.header.stamp = now();\n'), at=((SCALE, "Temperature temperature;"), (SCALE, "temperature_pub_->publish"))),
    seed("RM206", (PLANNER, '    geometry_msgs::msg::PoseStamped goal;\n    goal.header.frame_id = "map";\n', "    auto goal = geometry_msgs::msg::PoseStamped();\n"), at=((PLANNER, "auto goal ="), (PLANNER, "goal_pub_->publish(goal)"))),
)

PARAMETERS = (
    seed("RP301", (CONFIG, "max_height:", "max_hight:")),
    seed("RP301", (CONFIG, "weight_limit:", "weightLimit:")),
    seed("RP301", (CONFIG, "samples:", "sample_count:")),
    seed("RP301", (PLAIN, 'name="weight_limit"', 'name="limit"')),
    seed("RP301", (PLANNER, 'declare_parameter("robot_name"', 'declare_parameter("name"'), (PLANNER, 'get_parameter("robot_name")', 'get_parameter("name")'), at=((CONFIG, "robot_name"),)),
    seed("RP302", (CONFIG, "/lift:\n", "/lift_component:\n")),
    seed("RP302", (CONFIG, "/planner:\n", "/planer:\n")),
    seed("RP302", (CONFIG, "/scale:\n", "/dock/scale:\n")),
    seed("RP302", (LAUNCH, "name='planner'", "name='route_planner'"), at=((CONFIG, "/planner:"), (LAUNCH, "name='route_planner'"))),
    seed("RP303", (CONFIG, "max_height: 2.8", "max_height: 3")),
    seed("RP303", (CONFIG, "motor_id: 7", "motor_id: seven")),
    seed("RP303", (CONFIG, "[0.1, 1.2, 2.3]", "[0, 1, 2]")),
    seed("RP303", (CONFIG, "brake: true", "brake: 1")),
    seed("RP303", (PLAIN, 'value="250.0"', 'value="250"')),
    seed("RP303", (CONFIG, "robot_name: lifty", "robot_name: 12")),
    seed("RP303", (PLAIN, '<let name="offset" value="0.25"/>', '<let name="offset" value="1"/>'), at=((PLAIN, '<param name="offset"'), (PLAIN, '<let name="offset"'))),
    seed("RP303", (CONFIG, "samples: 16", "samples: 16.5")),
    seed("RP304", (LIFT, 'get_parameter("brake")', 'get_parameter("brakes")')),
    seed("RP304", (PLANNER, 'get_parameter("robot_name")', 'get_parameter("robot")')),
    seed("RP304", (SCALE, '    declare_parameter("offset", 0.0);\n', ""), at=((SCALE, 'get_parameter("offset")'),), also="RP301"),
)

CODE = (
    seed("RC401", (PLANNER, "    client_->async_send_request(request, [this](rclcpp::Client<MoveTo>::SharedFuture future) {\n      const auto response = future.get();\n      if (!response->accepted) {\n        RCLCPP_WARN(get_logger(), \"refused: %s\", response->reason.c_str());\n      }\n    });",
         "    auto future = client_->async_send_request(request);\n    §rclcpp::spin_until_future_complete(get_node_base_interface(), future);")),
    seed("RC401", (PLANNER, "    client_->async_send_request(request, [this](rclcpp::Client<MoveTo>::SharedFuture future) {\n      const auto response = future.get();\n", "    {\n      auto future = client_->async_send_request(request);\n      §const auto response = future.get();\n"), (PLANNER, "response->reason.c_str());\n      }\n    });", "response->reason.c_str());\n      }\n    }")),
    seed("RC401", (PLANNER, "    mode_pub_->publish(std::move(mode));\n", "    mode_pub_->publish(std::move(mode));\n    auto request = std::make_shared<MoveTo::Request>();\n    §client_->async_send_request(request).future.wait();\n")),
    seed("RC401", (PLANNER, "    mode_pub_->publish(std::move(mode));\n", "    mode_pub_->publish(std::move(mode));\n    auto answer = client_->async_send_request(std::make_shared<MoveTo::Request>());\n    §while (answer.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready) {\n    }\n")),
    seed("RC401", (PLANNER, "    weight_ = msg->data;\n", "    weight_ = msg->data;\n    §rclcpp::spin_some(shared_from_this());\n")),
    seed("RC402", (LIFT, "  target_ = request->height;\n", "  target_ = request->height;\n  §std::this_thread::sleep_for(2s);\n")),
    seed("RC402", (SCALE, "    Weight weight;\n", "    §rclcpp::sleep_for(500ms);\n    Weight weight;\n")),
    seed("RC402", (PLANNER, "    weight_ = msg->data;\n", "    weight_ = msg->data;\n    rclcpp::Rate rate(2.0);\n    §rate.sleep();\n")),
    seed("RC402", (SCALE, "{ mode_ = msg->data; });", "{ mode_ = msg->data; §usleep(300000); });")),
    seed("RC402", (PLANNER, "    move(pallet.position.z);\n", "    move(pallet.position.z);\n    §std::this_thread::sleep_for(std::chrono::seconds(1));\n")),
    seed("RC403", (LIFT, "std::bind(&LiftComponent::on_joints, this, _1)", "std::bind(&LiftComponent::on_timer, this, _1)"), at=((LIFT, "std::bind(&LiftComponent::on_timer, this, _1)"), (LIFT, "create_subscription<"))),
    seed("RC403", (LIFT, "std::bind(&LiftComponent::on_timer, this)", "std::bind(&LiftComponent::on_move, this)"), at=((LIFT, "timer_ ="),)),
    seed("RC403", (SCALE, "[this](const std_msgs::msg::String::SharedPtr msg) { mode_ = msg->data; }", '[this]() { mode_ = "idle"; }'), at=((SCALE, "[this]() { mode_"), MODE_SUB)),
    seed("RC404", (PLANNER, "    weight_ = msg->data;\n", '    weight_ = msg->data;\n    §auto pub = create_publisher<std_msgs::msg::Float64>("weight_seen", 10);\n    pub->publish(*msg);\n'), also="RC408 RC406"),
    seed("RC404", (LIFT, "  auto status = lift_msgs", '  §status_pub_ = create_publisher<lift_msgs::msg::LiftStatus>("lift/status", 10);\n  auto status = lift_msgs')),
    seed("RC404", (PLANNER, "    auto request = std::make_shared", '    §client_ = create_client<MoveTo>("lift/move_to");\n    auto request = std::make_shared')),
    seed("RC405", (PLANNER, "  rclcpp::spin(node);\n", ""), at=((PLANNER, "int main"), (PLANNER, "auto node ="), (PLANNER, "class Planner"))),
    seed("RC405", (SCALE, "  executor.spin();\n", ""), at=((SCALE, "int main"), (SCALE, "auto scale ="), (SCALE, "executor.add_node"), (SCALE, "class Scale"), (SCALE, "executor;"))),
    seed("RC405", (SCALE, "  executor.spin();\n", "  while (rclcpp::ok()) {\n    rclcpp::sleep_for(1s);\n  }\n"), at=((SCALE, "int main"), (SCALE, "auto scale ="), (SCALE, "executor.add_node"), (SCALE, "class Scale"), (SCALE, "executor;"), (SCALE, "while (rclcpp"))),
    seed("RC406", (LIFT, "  joint_sub_ = create_subscription", "  create_subscription")),
    seed("RC406", (LIFT, "  timer_ = this->create_wall_timer", "  auto timer = this->create_wall_timer")),
    seed("RC406", (PLANNER, "    status_sub_ = this->create", "    this->create")),
    seed("RC406", (LIFT, "  home_srv_ = create_service", "  auto home = create_service")),
    seed("RC406", (SCALE, "    timer_ = create_wall_timer", "    rclcpp::TimerBase::SharedPtr timer_ = create_wall_timer")),
    seed("RC406", (PLANNER, "    weight_sub_ = create_subscription", "    auto weight_sub_ = create_subscription")),
    seed("RC406", (LIFT, "  move_srv_ = create_service<MoveTo>", "  const auto move_srv = create_service<MoveTo>")),
    seed("RC406", (PLANNER, "    timer_ = rclcpp::create_timer", "    rclcpp::create_timer")),
    seed("RC406", (SCALE, "    mode_sub_ = create_subscription", "    (void)create_subscription")),
    seed("RC406", (PLANNER, "    pallet_sub_ = create_subscription<Pallet>", "    §rclcpp::Subscription<Pallet>::SharedPtr sub = create_subscription<Pallet>")),
    seed("RC406", (PLANNER, "    client_ = create_client", "    §create_service<MoveTo>(\"planner/move\", [](const MoveTo::Request::SharedPtr, MoveTo::Response::SharedPtr) {});\n    client_ = create_client")),
    seed("RC408", (SCALE, "    timer_ = create_wall", '    auto hello = create_publisher<std_msgs::msg::String>("scale/ready", 1);\n    std_msgs::msg::String text;\n    text.data = "ready";\n    §hello->publish(text);\n    timer_ = create_wall'), also="RC406"),
    seed("RC408", (PLANNER, "    client_ = create", '    §create_publisher<std_msgs::msg::String>("planner/hello", 1)->publish(std_msgs::msg::String());\n    client_ = create'), also="RC406"),
)

PACKAGES = (
    seed("RK501", (XML, "  <depend>sensor_msgs</depend>\n", ""), at=((XML, "<name>"), (HEADER, '#include "sensor_msgs'), (SCALE, '#include "sensor_msgs'), (LOGGER, "from sensor_msgs"), (CMAKE, "find_package(sensor"))),
    seed("RK501", (XML, "  <depend>lift_msgs</depend>\n", ""), at=((XML, "<name>"), (HEADER, '#include "lift_msgs/msg'), (PLANNER, "#include <lift_msgs/msg/lift_status"), (LOGGER, "from lift_msgs"), (CMAKE, "find_package(lift"))),
    seed("RK501", (XML, "  <depend>std_srvs</depend>\n", "  <exec_depend>std_srvs</exec_depend>\n"), at=((XML, "<name>"), (XML, "std_srvs"), (HEADER, '#include "std_srvs'), (CMAKE, "find_package(std_srvs"))),
    seed("RK501", (PLANNER, "#include <rclcpp/rclcpp.hpp>", "#include <nav_msgs/msg/path.hpp>\n#include <rclcpp/rclcpp.hpp>")),
    seed("RK502", (XML, "  <depend>std_srvs</depend>\n", "  <depend>std_srvs</depend>\n  §<depend>nav_msgs</depend>\n")),
    seed("RK502", (XML, "  <depend>std_srvs</depend>\n", "  <depend>std_srvs</depend>\n  §<build_depend>visualization_msgs</build_depend>\n")),
    seed("RK502", (TYPES_XML, "  <depend>std_msgs</depend>\n", "  <depend>std_msgs</depend>\n  §<depend>sensor_msgs</depend>\n")),
    seed("RK503", (CMAKE, "install(TARGETS planner scale ", "install(TARGETS planner "), at=((CMAKE, "add_executable(scale"), (SCALE, "int main"), (CMAKE, "install(TARGETS planner")), also="RK506"),
    seed("RK503", (CMAKE, "install(PROGRAMS scripts/pallet_logger.py DESTINATION lib/${PROJECT_NAME})\n", ""), at=((LOGGER, "class PalletLogger"), (LOGGER, "def main"), (LOGGER, "import rclpy\n"), (LOGGER, "if __name__"), (LOGGER, "#!/usr"), (CMAKE, "project(")), also="RK506"),
    seed("RK503", (CMAKE, "install(TARGETS planner scale DESTINATION lib/${PROJECT_NAME})", "install(TARGETS planner scale DESTINATION bin)"), at=((CMAKE, "add_executable(scale"), (CMAKE, "add_executable(planner"), (SCALE, "int main"), (PLANNER, "int main"), (CMAKE, "install(TARGETS planner")), also="RK506"),
    seed("RK503", (CMAKE, "install(TARGETS planner scale DESTINATION lib/${PROJECT_NAME})\n", ""), at=((CMAKE, "add_executable(scale"), (CMAKE, "add_executable(planner"), (SCALE, "int main"), (PLANNER, "int main")), also="RK506"),
    seed("RK504", (CMAKE, "install(PROGRAMS scripts", "install(FILES scripts"), at=((CMAKE, "install(FILES"), (LOGGER, "#!/usr"))),
    seed("RK504", (LOGGER, "#!/usr/bin/env python3\n", ""), at=((LOGGER, "import rclpy\n"), (CMAKE, "install(PROGRAMS"))),
    seed("RK504", (LOGGER, "#!/usr/bin/env python3\n", "#!/usr/bin/env python3\r\n"), at=((LOGGER, "#!/usr"), (CMAKE, "install(PROGRAMS"))),
    seed("RK504", (LOGGER, "#!/usr/bin/env python3\n", "\n#!/usr/bin/env python3\n"), at=((LOGGER, "#!/usr"), (LOGGER, "\n#!/usr"), (CMAKE, "install(PROGRAMS"))),
    seed("RK504", (LOGGER, "#!/usr/bin/env python3\n", "# Copyright 2026 Jonas\n#!/usr/bin/env python3\n"), at=((LOGGER, "#!/usr"), (LOGGER, "# Copyright"), (CMAKE, "install(PROGRAMS"))),
    seed("RK504", (CMAKE, "install(PROGRAMS scripts/pallet_logger.py DESTINATION", "install(DIRECTORY scripts/ DESTINATION"), at=((CMAKE, "install(DIRECTORY scripts/"), (LOGGER, "#!/usr"))),
    seed("RK504", (LOGGER, "#!/usr/bin/env python3", "# !/usr/bin/env python3"), at=((LOGGER, "# !/usr"), (CMAKE, "install(PROGRAMS"))),
    seed("RK504", (LOGGER, "#!/usr/bin/env python3", '"""Logs pallets."""'), at=((LOGGER, '"""Logs'), (CMAKE, "install(PROGRAMS"))),
    seed("RK506", (LAUNCH, "executable='planner'", "executable='planner_node'")),
    seed("RK506", (PLAIN, 'exec="lift_node"', 'exec="lift_component"')),
    seed("RK506", (LAUNCH, "'lift_driver::LiftComponent'", "'lift_driver::Lift'"), at=(LIFT_AT[0], LIFT_AT[2])),
    seed("RK506", (LAUNCH, "executable='pallet_logger.py'", "executable='pallet_logger'")),
    seed("RK506", (CMAKE, "add_executable(scale src", "add_executable(scale_node src"), (CMAKE, "ament_target_dependencies(scale rclcpp", "ament_target_dependencies(scale_node rclcpp"), (CMAKE, "install(TARGETS planner scale ", "install(TARGETS planner scale_node "), at=((LAUNCH, "executable='scale'"), (PLAIN, 'exec="scale"'))),
    seed("RK506", (LAUNCH, "package='lift_driver', executable='scale'", "package='lift_msgs', executable='scale'")),
    seed("RK507", (TYPES_CMAKE, '  "msg/Pallet.msg"\n', ""), at=((PALLET, "string id"), (TYPES_CMAKE, "rosidl_generate_interfaces("))),
    seed("RK507", (TYPES_CMAKE, "srv/MoveTo.srv", "srv/MoveTO.srv"), at=((TYPES_CMAKE, "srv/MoveTO.srv"), (MOVE, "float64 height"), (TYPES_CMAKE, "rosidl_generate"))),
    seed("RK507", (TYPES_CMAKE, "  DEPENDENCIES geometry_msgs std_msgs\n", "  §DEPENDENCIES std_msgs\n"), at=((TYPES_CMAKE, "rosidl_generate"), (PALLET, "geometry_msgs/Point"))),
    seed("RK507", (TYPES_XML, "  <member_of_group>rosidl_interface_packages</member_of_group>\n", ""), at=((TYPES_XML, "<name>"), (TYPES_CMAKE, "rosidl_generate"))),
    seed("RK508", (STATUS, "float64 height", "float64 position"), at=((STATUS, "position"), (LIFT, "status.height ="), (PLANNER, "status->height"), (LOGGER, "status.height > 2.0"), (LOGGER, "= status.height")), also="RM201"),
    seed("RK508", (PALLET, "string id", "uint32 id"), at=((PALLET, "id"), (LOGGER, "id=str")), also="RM202"),
    seed("RK508", (MOVE, "string reason\n", ""), at=((MOVE, "float64 height"), (MOVE, "bool accepted"), (LIFT, "response->reason"), (PLANNER, "response->reason")), also="RM201"),
    seed("RK508", (PALLET, "geometry_msgs/Point position", "geometry_msgs/Pose pose"), at=((PALLET, "pose"), (PLANNER, "goal.pose.position = pallet"), (PLANNER, "move(pallet.position.z)"), (LOGGER, "pallet.position.z")), also="RM201"),
)

SEEDS = GRAPH + MESSAGES + PARAMETERS + CODE + PACKAGES
