"""What asks a service or an action goes with its client, where it does no more than ask."""

from __future__ import annotations

import pytest
from patches import check, edit, refusal, sides

from plastron_tui.model.source import EndpointKind, Remove

K = EndpointKind

REMOVALS = [
    (
        "the client of main that asks once and returns",
        K.CLIENT,
        "add",
        """
 #include <ros/ros.h>
-#include <roscpp_tutorials/TwoInts.h>
 #include <cstdlib>

 int main(int argc, char **argv)
 {
   ros::init(argc, argv, "asks");
   ros::NodeHandle n;
-  ros::ServiceClient client = n.serviceClient<roscpp_tutorials::TwoInts>("add");
-  roscpp_tutorials::TwoInts srv;
-  srv.request.a = atoll(argv[1]);
-  srv.request.b = atoll(argv[2]);
-  if (client.call(srv))
-  {
-    ROS_INFO("Sum: %ld", (long int)srv.response.sum);
-  }
-  else
-  {
-    ROS_ERROR("nobody added");
-    return 1;
-  }

   return 0;
 }
""",
    ),
    (
        "a member that is called in the callback of a timer, which goes on with other work",
        K.CLIENT,
        "reset",
        """
 #include <ros/ros.h>
-#include <std_srvs/Empty.h>
 class Robot {
  public:
   Robot() {
-    client_ = nh_.serviceClient<std_srvs::Empty>("reset");
-    client_.waitForExistence();
     timer_ = nh_.createTimer(ros::Duration(1.0), &Robot::tick, this);
   }
   void tick(const ros::TimerEvent&) {
     steps_++;
-    std_srvs::Empty empty;
-    if (!client_.call(empty)) {
-      ROS_WARN("no answer");
-    }
   }
   ros::NodeHandle nh_;
-  ros::ServiceClient client_;
   ros::Timer timer_;
   int steps_ = 0;
 };
""",
    ),
    (
        "a timer that does nothing but call, with its lambda",
        K.CLIENT,
        "set",
        """
 #include <ros/ros.h>
-#include <std_srvs/SetBool.h>
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
-  ros::ServiceClient set = nh.serviceClient<std_srvs::SetBool>("set");
-  ros::Timer timer = nh.createTimer(ros::Duration(1), [&](const ros::TimerEvent&) {
-    std_srvs::SetBool asked;
-    asked.request.data = true;
-    if (set.call(asked)) ROS_INFO("done");
-  });
   ros::spin();
 }
""",
    ),
    (
        "a lambda that does more loses what it has captured of the client",
        K.CLIENT,
        "set",
        """
 #include <ros/ros.h>
-#include <std_srvs/SetBool.h>
 int steps = 0;
 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
-  ros::ServiceClient set = nh.serviceClient<std_srvs::SetBool>("set");
-  ros::Timer timer = nh.createTimer(ros::Duration(1), [&nh, &set](const ros::TimerEvent&) {
-    std_srvs::SetBool asked;
-    set.call(asked);
+  ros::Timer timer = nh.createTimer(ros::Duration(1), [&nh](const ros::TimerEvent&) {
     steps += nh.ok();
   });
   ros::spin();
 }
""",
    ),
    (
        "waiting for a service in a loop, asking, and waiting for the answer",
        K.CLIENT,
        "toggle",
        """
-#include <chrono>
 #include <memory>

 #include "rclcpp/rclcpp.hpp"
-#include "std_srvs/srv/set_bool.hpp"

-using namespace std::chrono_literals;
-
 int main(int argc, char ** argv)
 {
   rclcpp::init(argc, argv);
   auto node = rclcpp::Node::make_shared("n");
-  auto client = node->create_client<std_srvs::srv::SetBool>("toggle");
-
-  auto request = std::make_shared<std_srvs::srv::SetBool::Request>();
-  request->data = true;
-
-  while (!client->wait_for_service(1s)) {
-    if (!rclcpp::ok()) {
-      RCLCPP_ERROR(node->get_logger(), "interrupted");
-      return 0;
-    }
-    RCLCPP_INFO(node->get_logger(), "waiting");
-  }
-
-  auto result = client->async_send_request(request);
-  if (rclcpp::spin_until_future_complete(node, result) ==
-    rclcpp::FutureReturnCode::SUCCESS)
-  {
-    RCLCPP_INFO(node->get_logger(), "%d", result.get()->success);
-  } else {
-    RCLCPP_ERROR(node->get_logger(), "no answer");
-  }

   rclcpp::shutdown();
   return 0;
 }
""",
    ),
    (
        "a method that hears the answer and only logs it",
        K.CLIENT,
        "toggle",
        """
 #include <rclcpp/rclcpp.hpp>
-#include <std_srvs/srv/set_bool.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
-    client_ = create_client<std_srvs::srv::SetBool>("toggle");
     step();
   }
   void step() {
     count_++;
-    auto request = std::make_shared<std_srvs::srv::SetBool::Request>();
-    request->data = true;
-    client_->async_send_request(
-      request, std::bind(&A::on_answer, this, std::placeholders::_1));
   }
-  void on_answer(rclcpp::Client<std_srvs::srv::SetBool>::SharedFuture future) {
-    RCLCPP_INFO(get_logger(), "%d", future.get()->success);
-  }
-  rclcpp::Client<std_srvs::srv::SetBool>::SharedPtr client_;
   int count_ = 0;
 };
""",
    ),
    (
        "an answer that is kept for a line of the log",
        K.CLIENT,
        "toggle",
        """
 #include <ros/ros.h>
-#include <std_srvs/Trigger.h>
 int main(int c, char ** v) {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
-  ros::ServiceClient client = nh.serviceClient<std_srvs::Trigger>("toggle");
-  std_srvs::Trigger asked;
-  bool was_heard = client.call(asked);
-  if (was_heard && asked.response.success)
-    ROS_INFO("yes");
   ros::spin();
 }
""",
    ),
    (
        "a goal of an action with what is logged of it",
        K.ACTION_CLIENT,
        "look",
        """
-#include <actionlib/client/simple_action_client.h>
 #include <ros/ros.h>
-#include <tf2_msgs/LookupTransformAction.h>
-typedef actionlib::SimpleActionClient<tf2_msgs::LookupTransformAction> Client;
 int main(int c, char ** v) {
   ros::init(c, v, "n");
-  Client ac("look", true);
-  ROS_INFO("waiting");
-  ac.waitForServer();
-  tf2_msgs::LookupTransformGoal goal;
-  goal.target_frame = "map";
-  ac.sendGoal(goal);
-  bool is_done = ac.waitForResult(ros::Duration(30.0));
-  if (is_done)
-  {
-    actionlib::SimpleClientGoalState state = ac.getState();
-    ROS_INFO("%s", state.toString().c_str());
-  }
-  else
-    ROS_INFO("too late");
   return 0;
 }
""".replace('-  ROS_INFO("waiting");\n', '   ROS_INFO("waiting");\n'),
    ),
]


@pytest.mark.parametrize(
    ("kind", "name", "patch"), [each[1:] for each in REMOVALS], ids=[each[0] for each in REMOVALS]
)
def test_what_only_asks_goes_with_the_client(kind: EndpointKind, name: str, patch: str) -> None:
    check(patch, Remove(kind, name))


ASKING = """
 #include <ros/ros.h>
 #include <std_srvs/SetBool.h>
 int moved = 0;
 void move();
 bool f(ros::NodeHandle & nh) {{
   ros::ServiceClient client = nh.serviceClient<std_srvs::SetBool>("set");
   std_srvs::SetBool asked;
   int kept = 0;
   {}
   ROS_INFO("end");
   return kept;
 }}
"""
USED = {
    "what is done where an answer came": "if (client.call(asked)) { move(); }",
    "what is counted": "if (client.call(asked)) { moved++; }",
    "what the function returns": "return client.call(asked);",
    "what is left where an answer came": "if (client.call(asked)) { return true; }",
    "a value that is used": "if (client.call(asked)) { kept = asked.response.success; }",
    "a variable of the file": "moved = client.call(asked); if (moved) move();",
    "what answers is read": "client.call(asked); if (asked.response.success) move();",
    "who else gets it": "use(client);",
    "what a condition asks besides": 'if (moved++ > 0 && client.call(asked)) { ROS_INFO("?"); }',
    "an object that works": "if (client.call(asked)) { Robot robot; robot.move(); }",
    "an object that ends": "Guard guard(client);",
    "a method that nobody knows": "client.anything();",
    "an answer apart": "std_srvs::SetBool::Response r; client.call(asked.request, r); use(r);",
    "what throws where an answer came": "if (client.call(asked)) { throw 1; }",
}


@pytest.mark.parametrize("statement", USED.values(), ids=USED)
def test_what_does_more_than_to_ask_holds_the_client(statement: str) -> None:
    told = refusal(ASKING.format(statement), Remove(K.CLIENT, "set"))
    assert told.startswith("endpoint-in-use: the client `set` is used in line")


SERVED = {
    "only asked": "client.call(asked);",
    "request and response": "client.call(asked.request, asked.response);",
    "asked with what is set": "asked.request.data = moved > 0; client.call(asked);",
    "printed": "if (client.call(asked)) std::cout << asked.response.success << std::endl;",
    "left where no answer came": 'if (!client.call(asked)) { ROS_ERROR("?"); return false; }',
    "thrown where no answer came": "if (!client.call(asked)) { throw 1; }",
    "looked for": (
        "while (!client.exists() && ros::ok()) { ros::Duration(1.0).sleep(); } client.call(asked);"
    ),
}


@pytest.mark.parametrize("statement", SERVED.values(), ids=SERVED)
def test_what_only_asks_is_gone(statement: str) -> None:
    before, _ = sides(ASKING.format(statement))
    files, told = edit(before, Remove(K.CLIENT, "set"))
    assert files is not None, told
    body = files.main.decode().partition("NodeHandle & /*nh*/) {\n")[2]
    assert body == '  int kept = 0;\n  ROS_INFO("end");\n  return kept;\n}\n'


WITHOUT_CLIENT = {
    'ros::service::call("set", asked);': "",
    'if (ros::service::call("set", asked)) { ROS_INFO("yes"); }': "",
    'if (!ros::service::call("set", asked)) move();': "does more than to create it",
    'ASSERT_TRUE(ros::service::call("set", asked));': "does more than to create it",
    'ros::service::call("set", asked); use(asked.response);': "is used in line",
}


@pytest.mark.parametrize(("statement", "why"), WITHOUT_CLIENT.items())
def test_a_call_without_a_client_is_held_to_the_same(statement: str, why: str) -> None:
    text = "\n".join(x for x in ASKING.format(statement).split("\n") if "serviceClient" not in x)
    before, _ = sides(text)
    files, told = edit(before, Remove(K.CLIENT, "set"))
    assert (files is None) is bool(why)
    assert why in "".join(each.message for each in told)
    assert files is None or b"asked" not in files.main


HIDDEN = {
    "the branch that is not read": (
        "#ifdef OLD\n   if (on(pub_)) {\n#else\n   if (on(1)) {\n#endif\n   }\n"
    ),
    "a macro with arguments": "#define SEND(x) pub_.publish(x)\n",
    "a macro over two lines": "#define SEND \\\n  pub_.publish(last_);\n",
    "a macro that stands alone": "   CHECK_THAT(pub_.getNumSubscribers() > 0)\n",
}
NEVER = {
    "what is never compiled": "#if 0\n   pub_.publish(1);\n#endif\n",
    "a comment": "   // pub_ sends\n   /* pub_ */\n",
    "a text of a branch": '#ifdef A\n   f("pub_",\n#else\n   f("",\n#endif\n   1);\n',
}
CLASS = """
#include <ros/ros.h>
#include <std_msgs/Int32.h>
class A {{
  void f() {{
{}  }}
  void init() {{ pub_ = nh_.advertise<std_msgs::Int32>("a", 1); }}
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  std_msgs::Int32 last_;
}};
"""


def _plain(text: str) -> str:
    return "".join(f" {line}" for line in text.splitlines(keepends=True))


@pytest.mark.parametrize("code", HIDDEN.values(), ids=HIDDEN)
def test_what_is_not_parsed_uses_it_too(code: str) -> None:
    told = refusal(_plain(CLASS.format(code)), Remove(K.PUBLISHER, "a"))
    assert told.startswith("endpoint-in-use: the publisher `a` is used in line")


@pytest.mark.parametrize("code", NEVER.values(), ids=NEVER)
def test_what_is_no_code_holds_nothing(code: str) -> None:
    before, _ = sides(_plain(CLASS.format(code)))
    files, told = edit(before, Remove(K.PUBLISHER, "a"))
    assert files is not None, told
