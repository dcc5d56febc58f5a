"""What services answer, clients ask and goals say changes in the lines that say it."""

from __future__ import annotations

import pytest
from patches import check, edit, refusal, sides

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import (
    ActionClient,
    Client,
    Message,
    Publication,
    Publisher,
    Request,
    Service,
    Subscription,
    Timer,
)
from plastron_tui.model.source import Add, EndpointKind, Update
from plastron_tui.model.values import MessageValue, Value
from plastron_tui.ros.interfaces import InterfaceName

K, AT = EndpointKind, Span(0, 0)
TRIGGER, SET_BOOL = InterfaceName("std_srvs", "Trigger"), InterfaceName("std_srvs", "SetBool")
STRING, INT = InterfaceName("std_msgs", "String"), InterfaceName("std_msgs", "Int32")

SERVER2 = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_srvs/srv/trigger.hpp>
 class N : public rclcpp::Node {
  public:
   N() : Node("n") {
     stop_ = create_service<std_srvs::srv::Trigger>("stop", std::bind(&N::stop, this, _1, _2));
   }
   void stop(const std::shared_ptr<std_srvs::srv::Trigger::Request> request,
             std::shared_ptr<std_srvs::srv::Trigger::Response> response) {
BODY
   }
   rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr stop_;
 };
"""
SERVER1 = """
 #include <ros/ros.h>
 #include <std_srvs/Trigger.h>
 bool stop(std_srvs::Trigger::Request& req, std_srvs::Trigger::Response& res) {
BODY
 }
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
   ros::ServiceServer server = nh.advertiseService("stop", stop);
   ros::spin();
 }
"""
# The answer becomes `success=False, message="no"`.
ANSWERS = {
    "both fields": (
        SERVER2,
        '-    response->success = true;\n+    response->success = false;\n'
        '-    response->message = "yes";\n+    response->message = "no";',
        [],
    ),
    "one that differs": (
        SERVER2,
        '-    response->success = true;\n+    response->success = false;\n'
        '     response->message = "no";',
        [],
    ),
    "one that is not said": (
        SERVER2,
        '     response->success = false;\n+    response->message = "no";',
        [],
    ),
    "a stub": (
        SERVER2,
        '     RCLCPP_INFO(get_logger(), "stop");\n-    (void)response;\n'
        '+    response->success = false;\n+    response->message = "no";',
        [],
    ),
    "one that is worked out": (
        SERVER2,
        "-    response->success = halt();\n+    response->success = false;\n"
        '     response->message = "no";',
        ["`stop` no longer sends `halt()`, which the node works out"],
    ),
    "code around it": (
        SERVER2,
        '     halt();  // now\n-    response->success = true;\n+    response->success = false;\n'
        '     response->message = "no";\n     tell();',
        [],
    ),
    "a function of ROS 1": (
        SERVER1,
        '-  res.success = true;\n+  res.success = false;\n   res.message = "no";\n'
        "   return true;",
        [],
    ),
    "a stub of ROS 1": (
        SERVER1,
        '   ROS_INFO("stop");\n+  res.success = false;\n+  res.message = "no";\n   return true;',
        [],
    ),
    "one that is left early": (
        SERVER1,
        "   if (!is_ready()) {\n     return false;\n   }\n+  res.success = false;\n"
        '+  res.message = "no";\n   return true;',
        [],
    ),
}  # fmt: skip


def answering(type_: InterfaceName, **fields: Value) -> Service:
    return Service("stop", type_, None, AT, MessageValue(type_, fields))


@pytest.mark.parametrize("name", ANSWERS)
def test_another_answer_is_filled_in(name: str) -> None:
    frame, body, expected = ANSWERS[name]
    patch = frame.replace("BODY", "\n".join(body.split("\n")))
    new = answering(TRIGGER, success=False, message="no")
    told = check(patch, Update(K.SERVICE, "stop", new, AT))
    assert [each.message for each in told] == expected


def test_a_function_that_answers_in_branches_is_called_no_longer() -> None:
    body = "     if (halt()) {\n       response->success = true;\n     }"
    new = answering(TRIGGER, success=False, message="no")
    before, _ = sides(SERVER2.replace("BODY", body))
    files, told = edit(before, Update(K.SERVICE, "stop", new, AT))
    assert files is not None
    assert b"response->success = true;" in files.main
    assert "nothing in the file calls `stop` (line 11) any more" in [each.message for each in told]


CLIENT2 = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_srvs/srv/set_bool.hpp>
 class N : public rclcpp::Node {
  public:
   N() : Node("n") {
     go_ = create_client<std_srvs::srv::SetBool>("go");
   }
   void ask() {
     auto request = std::make_shared<std_srvs::srv::SetBool::Request>();
-    request->data = true;
+    request->data = false;
     go_->async_send_request(request, [this](rclcpp::Client<std_srvs::srv::SetBool>::SharedFuture f) {
       RCLCPP_INFO(get_logger(), "%d", f.get()->success);
     });
   }
   rclcpp::Client<std_srvs::srv::SetBool>::SharedPtr go_;
 };
"""  # noqa: E501
CLIENT1 = """
 #include <ros/ros.h>
 #include <std_srvs/SetBool.h>
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
   ros::ServiceClient go = nh.serviceClient<std_srvs::SetBool>("go");
   std_srvs::SetBool srv;
-  srv.request.data = true;
+  srv.request.data = false;
   if (go.call(srv)) {
     ROS_INFO("%d", srv.response.success);
   }
 }
"""


@pytest.mark.parametrize("patch", [CLIENT1, CLIENT2])
def test_another_request_is_filled_in(patch: str) -> None:
    request = Request(MessageValue(SET_BOOL, {"data": False}))
    assert check(patch, Update(K.CLIENT, "go", Client("go", SET_BOOL, (request,), AT), AT)) == ()


GOAL2 = """
 #include <rclcpp/rclcpp.hpp>
 #include <rclcpp_action/rclcpp_action.hpp>
 #include <example_interfaces/action/fibonacci.hpp>
 using Fibonacci = example_interfaces::action::Fibonacci;
 class N : public rclcpp::Node {
  public:
   N() : Node("n") {
     count_ = rclcpp_action::create_client<Fibonacci>(this, "count");
   }
   void send() {
     auto goal = Fibonacci::Goal();
-    goal.order = 10;
+    goal.order = 5;
     count_->async_send_goal(goal, rclcpp_action::Client<Fibonacci>::SendGoalOptions());
   }
   rclcpp_action::Client<Fibonacci>::SharedPtr count_;
 };
"""
GOAL1 = """
 #include <ros/ros.h>
 #include <actionlib/client/simple_action_client.h>
 #include <actionlib_tutorials/FibonacciAction.h>
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   actionlib::SimpleActionClient<actionlib_tutorials::FibonacciAction> client("count", true);
   client.waitForServer();
   actionlib_tutorials::FibonacciGoal goal;
-  goal.order = 10;
+  goal.order = 5;
   client.sendGoal(goal);
 }
"""


@pytest.mark.parametrize(
    ("patch", "package"), [(GOAL1, "actionlib_tutorials"), (GOAL2, "example_interfaces")]
)
def test_another_goal_is_filled_in(patch: str, package: str) -> None:
    type_ = InterfaceName(package, "Fibonacci")
    new = ActionClient("count", type_, (MessageValue(type_, {"order": 5}),), AT)
    assert check(patch, Update(K.ACTION_CLIENT, "count", new, AT)) == ()


HEARD = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 std::string last;
 void hear(const std_msgs::StringConstPtr& m) { last = m->data; }
 void both(const std_msgs::StringConstPtr& a, const std_msgs::StringConstPtr& b) {}
 void tick(const ros::TimerEvent&) {}
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
   ros::Subscriber in = nh.subscribe<std_msgs::String>(
-      "in", 7, [](const std_msgs::StringConstPtr& m) { last = m->data; });
+      "in", 7, hear);
   ros::spin();
 }
"""


def test_a_lambda_gives_way_to_a_function() -> None:
    new = Subscription("in", STRING, "hear", AT)
    told = check(HEARD, Update(K.SUBSCRIPTION, "in", new, AT))
    lambda_ = "[](const std_msgs::StringConstPtr& m) { last = m->data; }"
    assert [(each.code, each.message) for each in told] == [
        ("written-anew", f"`{lambda_}` of `in` is not kept for `in`")
    ]


MISFITS = [
    (Add(Subscription("b", INT, "hear", AT)), "takes `std_msgs/String`, and would be called with"),
    (Add(Subscription("b", STRING, "both", AT)), "takes 2 arguments, and would be called with 1"),
    (Update(K.SUBSCRIPTION, "in", Subscription("in", INT, "hear", AT), AT), "takes `std_msgs/Str"),
    (Add(Timer("both", None, None, AT)), "takes 2 arguments, and would be called with 1"),
]


@pytest.mark.parametrize(("change", "expected"), MISFITS)
def test_a_function_that_takes_something_else_is_not_called(
    change: Add | Update, expected: str
) -> None:
    found = refusal(HEARD, change)
    assert found.startswith("invalid-function: `")
    assert expected in found


def test_a_function_that_cannot_do_with_the_new_type_is_told() -> None:
    text = HEARD.replace("-      ", "       ").replace('+      "in", 7, hear);\n', "")
    text = text.replace("[](const std_msgs::StringConstPtr& m) { last = m->data; }", "hear")
    before, _ = sides(text)
    files, told = edit(before, Update(K.SUBSCRIPTION, "in", Subscription("in", INT, None, AT), AT))
    assert files is not None
    message = "`hear` no longer gets `in`: it was written for `std_msgs/String`, and "
    assert told[0].message == f"{message}`std_msgs/Int32` has another `data`"


@pytest.mark.parametrize("rest", ["", 'Arm b("right");'])
def test_a_name_that_objects_share_is_told(rest: str) -> None:
    before, _ = sides(f"""
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class Arm {{
  public:
   explicit Arm(const std::string& side) {{
     out_ = nh_.advertise<std_msgs::String>(side + "/out", 5);
   }}
   ros::NodeHandle nh_;
   ros::Publisher out_;
 }};
 int main(int c, char** v) {{
   ros::init(c, v, "n");
   Arm a("left");
   {rest}
   ros::spin();
 }}
""")
    sent = Publication(Message("m", MessageValue(STRING, {}), AT), 10.0, AT)
    files, told = edit(before, Add(Publisher("x", STRING, (sent,), AT)))
    assert files is not None
    shared = "each object of `Arm` creates `x`, while line 6 gives each a name of its own"
    assert [each.message for each in told] == ([shared] if rest else [])


def test_a_stub_that_logs_what_the_new_type_has_not_is_written_anew() -> None:
    patch = """
 #include <rclcpp/rclcpp.hpp>
-#include <std_msgs/msg/string.hpp>
+#include <std_msgs/msg/int32.hpp>
 class N : public rclcpp::Node {
  public:
   N() : Node("n") {
-    in_ = create_subscription<std_msgs::msg::String>("in", 7, std::bind(&N::on_in, this, _1));
+    in_ = create_subscription<std_msgs::msg::Int32>("in", 7, std::bind(&N::on_in, this, _1));
   }
-  void on_in(const std_msgs::msg::String & msg) {
-    RCLCPP_INFO(get_logger(), "in: %s", msg.data.c_str());
+  void on_in(const std_msgs::msg::Int32 & msg) {
+    RCLCPP_INFO(get_logger(), "in: %s", to_yaml(msg).c_str());
   }
-  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr in_;
+  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr in_;
 };
"""
    new = Subscription("in", INT, None, AT)
    assert check(patch, Update(K.SUBSCRIPTION, "in", new, AT)) == ()


@pytest.mark.parametrize(("given", "is_kept"), [("msg.data", False), ("int(msg.data)", True)])
def test_a_number_in_a_format_is_not_another_number(given: str, is_kept: bool) -> None:
    text = f"""
 #include <ros/ros.h>
 #include <std_msgs/Int32.h>
 void hear(const std_msgs::Int32& msg) {{ ROS_INFO("%d", {given}); }}
 int main(int argc, char** argv) {{
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
   ros::Subscriber in = nh.subscribe("in", 7, hear);
 }}
"""
    real = InterfaceName("std_msgs", "Float64")
    files, _ = edit(
        sides(text)[0], Update(K.SUBSCRIPTION, "in", Subscription("in", real, None, AT), AT)
    )
    assert files is not None
    assert (f'"%d", {given}'.encode() in files.main) == is_kept
