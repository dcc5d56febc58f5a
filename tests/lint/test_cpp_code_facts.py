"""What is known of the code of nodes in C++: what waits, is made again, is dropped, never spins."""

from __future__ import annotations

import pytest
from cpp_programs import PUB, SETUP, SLEPT, SPUN, SUB1, at, facts, ros1, ros2

from plastron_tui.model.code_facts import Wait

_GET = ros2(callback="ask();", ask="future.get();")


@pytest.mark.parametrize(
    ("text", "wait", "place", "is_endless"),
    [
        (_GET, Wait.SERVICE, "future.get()", True),
        (ros2(callback="ask();", ask="auto r = future.get();"), Wait.SERVICE, "future.get()", True),
        (ros2(callback="ask();", ask="future.wait();"), Wait.SERVICE, "future.wait()", True),
        (
            ros2(callback="ask();", ask="if (future.wait_for(5s) == std::future_status::ready) {}"),
            Wait.SERVICE,
            "future.wait_for(5s)",
            True,
        ),
        (
            ros2(callback="auto r = client_->async_send_request(nullptr).get();"),
            Wait.SERVICE,
            "client_->async_send_request(nullptr).get()",
            True,
        ),
        (
            ros2(callback="ask();", ask=f"{SPUN};"),
            Wait.SPIN,
            SPUN,
            True,
        ),
        (
            ros2(callback="rclcpp::spin_some(this->get_node_base_interface());"),
            Wait.SPIN,
            "rclcpp::spin_some(this->get_node_base_interface())",
            True,
        ),
        (
            ros2(callback="std::this_thread::sleep_for(2s);"),
            Wait.SLEEP,
            "std::this_thread::sleep_for(2s)",
            False,
        ),
        (ros2(callback="rclcpp::sleep_for(500ms);"), Wait.SLEEP, "rclcpp::sleep_for(500ms)", False),
        (
            ros2(callback="rclcpp::Rate rate(10); rate.sleep();"),
            Wait.SLEEP,
            "rate.sleep()",
            False,
        ),
        (
            ros2(setup=f"timer_ = create_wall_timer(1s, [this]() {{ {SLEPT}; }});"),
            Wait.SLEEP,
            SLEPT,
            False,
        ),
        (
            ros2(callback="ask();", ask="while (future.wait_for(0s) != ready) {}"),
            Wait.SERVICE,
            "future.wait_for(0s)",
            True,
        ),
        (
            ros2(
                main='auto n = rclcpp::Node::make_shared("n"); auto s = n->create_subscription<'
                'std_msgs::msg::String>("c", 1, [n](std_msgs::msg::String::SharedPtr) {'
                "rclcpp::spin_until_future_complete(n, asked); }); rclcpp::spin(n);"
            ),
            Wait.SPIN,
            "rclcpp::spin_until_future_complete(n, asked)",
            True,
        ),
        (
            ros2(callback="get_clock()->sleep_for(1s);"),
            Wait.SLEEP,
            "get_clock()->sleep_for(1s)",
            False,
        ),
        (
            ros2(callback="rclcpp::Rate(1.0).sleep();"),
            Wait.SLEEP,
            "rclcpp::Rate(1.0).sleep()",
            False,
        ),
        (ros1(callback="ros::Rate(10).sleep();"), Wait.SLEEP, "ros::Rate(10).sleep()", False),
        (ros1(callback="ros::Duration(1).sleep();"), Wait.SLEEP, "ros::Duration(1).sleep()", False),
        (ros1(callback="sleep(2);"), Wait.SLEEP, "sleep(2)", False),
        (
            ros2(callback="if (busy) return; goto end; end: sleep(2);"),
            Wait.SLEEP,
            "sleep(2)",
            False,
        ),
        (
            ros2(callback="switch (n) { case 1: return; case 2: sleep(2); }"),
            Wait.SLEEP,
            "sleep(2)",
            False,
        ),
    ],
)
def test_call_that_waits_in_a_callback_is_found(
    text: str, wait: Wait, place: str, is_endless: bool
) -> None:
    found = facts(text).blocking
    assert [each.wait for each in found] == [wait]
    assert at(text, found) == [place]
    assert found[0].is_endless is is_endless


_PLUGIN = """
#include "tools/plugin.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/trigger.hpp"
class Talker : public tools::Plugin {
public:
  Talker() : Plugin("talker") {
    server_ = node->create_service<std_srvs::srv::Trigger>(
      "a", std::bind(&Talker::serve, this, std::placeholders::_1, std::placeholders::_2));
  }
  void serve(std_srvs::srv::Trigger::Request::SharedPtr,
             std_srvs::srv::Trigger::Response::SharedPtr)
  {
    auto client = HOLDER->create_client<std_srvs::srv::Trigger>("b");
    auto future = client->async_send_request(nullptr);
    future.get();
  }
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr server_;
};
"""


@pytest.mark.parametrize(("holder", "count"), [("node", 1), ("other", 0), ("other()", 0)])
def test_one_member_of_a_base_that_is_not_read_is_one_node(holder: str, count: int) -> None:
    found = facts(_PLUGIN.replace("HOLDER", holder)).blocking
    assert [(each.callback, each.is_endless) for each in found] == [("serve", True)] * count


@pytest.mark.parametrize(
    "text",
    [
        # Nobody calls it from a callback.
        ros2(ask="future.get();"),
        # Others of the node may be called meanwhile.
        ros2(
            callback=f"{SLEPT};",
            setup=f"{SETUP} group_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);",
        ),
        # It never runs.
        ros2(callback="return; sleep(2);"),
        ros2(callback="if (msg) { return; } else { throw 1; } sleep(2);"),
        ros2(callback="if (false) { sleep(2); }"),
        ros2(callback="return; help();").replace(
            "  void ask()", "  void help() { sleep(2); }\n  void ask()"
        ),
        ros1(callback="while (true) { break; sleep(2); }"),
        # What is called so is the file's own.
        ros2(callback="sleep(2);").replace("class Talker", "void sleep(int) {}\nclass Talker"),
        # Another class has a method of the name, and this one inherits its own.
        ros2(callback="pause();").replace(
            "class Talker", f"struct Other {{ void pause() {{ {SLEPT}; }} }};\nclass Talker"
        ),
        # The answer comes by another group of callbacks.
        _GET.replace('Trigger>("go")', 'Trigger>("go", rclcpp::ServicesQoS(), group_)'),
        # What it asks for by may be ready.
        ros2(callback="ask();", ask="future.wait_for(0s);"),
        # Another thread waits.
        ros2(callback="std::thread([this]() { ask(); }).detach();", ask="future.get();"),
        ros2(callback="client_->async_send_request(nullptr, [](auto f) { f.get(); });"),
        # Other callbacks are called meanwhile.
        ros2(callback=SLEPT + ";", main="rclcpp::executors::MultiThreadedExecutor executor;"),
        ros1(callback="while (busy) { ros::spinOnce(); sleep(1); }"),
        ros2(
            callback="int tries = 0; while (!box.try_set(1)) { if (tries > 9) { log(); return; } "
            "rclcpp::sleep_for(50ms); tries++; }"
        ),
        ros2(
            callback="for (int i = 0; i < 5; i++) { if (m.try_lock()) return; sleep_for(100ms); }"
        ),
        # Another node spins.
        ros2(callback="rclcpp::spin_some(other_);"),
        ros1(callback="sleep(2);", main=f"{SUB1} ros::AsyncSpinner s(2); s.start(); ros::spin();"),
        ros1(main=f"{SUB1} ros::Rate r(9); while (ros::ok()) {{ ros::spinOnce(); r.sleep(); }}"),
    ],
)
def test_call_that_may_be_harmless_is_left(text: str) -> None:
    assert facts(text).blocking == ()


def test_length_of_a_sleep_is_known() -> None:
    text = ros2(callback="rclcpp::sleep_for(500ms);")
    assert [each.seconds for each in facts(text).blocking] == [0.5]


@pytest.mark.parametrize(
    ("text", "places"),
    [
        (ros2(callback=f"pub_ = {PUB};"), [PUB]),
        (ros2(callback=f"auto pub = {PUB}; pub->publish(*msg);"), [PUB]),
        (ros2(callback=f'if (msg->data == "go") {{ pub_ = {PUB}; }}'), [PUB]),
        (ros2(callback="ask();", ask=f"pub_ = {PUB};"), [PUB]),
        (
            ros2(
                main=f'auto n = rclcpp::Node::make_shared("n"); while (rclcpp::ok()) '
                f"{{ auto p = n->{PUB}; rclcpp::spin_some(n); }}"
            ),
            [f"n->{PUB}"],
        ),
        (
            ros1(callback='ros::NodeHandle n; auto p = n.advertise<std_msgs::String>("o", 1);'),
            ['n.advertise<std_msgs::String>("o", 1)'],
        ),
        (
            ros1(main='while (ros::ok()) { s = nh.subscribe("c", 1, heard); ros::spinOnce(); }'),
            ['nh.subscribe("c", 1, heard)'],
        ),
        (ros2(callback=f"try {{ pub_ = {PUB}; }} catch (...) {{}}"), [PUB]),
        (
            ros2(callback=f"if (msg->data.empty()) {{ ask(); }} else {{ pub_ = {PUB}; }}"),
            [PUB],
        ),
        # Made but once, or where nobody has made it yet.
        (ros2(callback=f"if (pub_) {{ ask(); }} else {{ pub_ = {PUB}; }}"), []),
        (ros2(callback=f"sub_ = nullptr; pub_ = {PUB};"), []),
        (
            ros1(main="ros::Timer t = nh.createTimer(ros::Duration(1.0), tick, true);").replace(
                "int main",
                "void tick(const ros::TimerEvent &) {"
                ' ros::NodeHandle n; pub = n.advertise<std_msgs::String>("o", 1); }\nint main',
            ),
            [],
        ),
        (ros2(setup=f"{SETUP} pub_ = {PUB};"), []),
        (ros2(callback=f"if (!pub_) {{ pub_ = {PUB}; }}"), []),
        (ros2(callback=f"if (pub_) return; pub_ = {PUB};"), []),
        (ros2(callback=f"static auto pub = {PUB}; pub->publish(*msg);"), []),
        (ros2(callback=f"pub_ = {PUB}; timer_->cancel();"), []),
        (ros2(callback="static tf2_ros::TransformBroadcaster sender(this);"), []),
        (ros1(callback='static ros::Publisher p = nh.advertise<std_msgs::String>("o", 1);'), []),
    ],
)
def test_endpoint_that_is_made_again_and_again(text: str, places: list[str]) -> None:
    assert at(text, facts(text).repeated) == places


_ONCE = 'std_msgs::String m; m.data = "x"; pub.publish(m);'


def _nodelet(method: str) -> str:
    return f"""\
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
class Leak : public nodelet::Nodelet {{
  void {method}() {{
    ros::Publisher pub = getNodeHandle().advertise<std_msgs::String>("out", 1);
    pub.publish(std_msgs::String());
  }}
}};
"""


_ADVERTISED = 'auto pub = nh.advertise<std_msgs::String>("out", 1);'


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (ros1(main=f"{_ADVERTISED} {_ONCE} ros::spin();"), 1),
        (ros2(setup=f"{SETUP} pub_ = {PUB}; std_msgs::msg::String m; pub_->publish(m);"), 1),
        # It is kept for who comes later, or time passes.
        (ros1(main=f"{_ADVERTISED.replace('1)', '1, true)')} {_ONCE} ros::spin();"), 0),
        (ros1(main=f"{_ADVERTISED} ros::Duration(1).sleep(); {_ONCE} ros::spin();"), 0),
        (ros1(main=f"{_ADVERTISED} while (ros::ok()) {{ {_ONCE} ros::spinOnce(); }}"), 0),
        (ros1(main=f"{_ADVERTISED} {_ONCE} pub.publish(m); ros::spin();"), 0),
        (ros2(setup=f"pub_ = {PUB}; Arm arm(this); pub_->publish(std_msgs::msg::String());"), 0),
        (
            ros2(
                setup=f"pub_ = {PUB}; auto arm = std::make_shared<Arm>(1);"
                " pub_->publish(std_msgs::msg::String());"
            ),
            0,
        ),
        (
            ros2(
                setup=f"pub_ = {PUB}; auto m = std::make_shared<std_msgs::msg::String>();"
                " pub_->publish(*m);"
            ),
            1,
        ),
        (ros2(setup=f"pub_ = {PUB}; std_msgs::msg::String m; pub_->publish(m);"), 1),
        (ros2(setup=f"{PUB}->publish(std_msgs::msg::String());"), 1),
        (ros2(setup=f"{PUB}->get_subscription_count();"), 0),
        (ros2(callback=f"{PUB}->publish(*msg);"), 0),
        (ros2(setup=f"while (rclcpp::ok()) {{ {PUB}->publish(std_msgs::msg::String()); }}"), 0),
        (_nodelet("onInit"), 1),
        (_nodelet("onReset"), 0),
    ],
)
def test_message_that_is_published_too_early(text: str, count: int) -> None:
    assert len(facts(text).early) == count


_BOUND = "std::bind(&Talker::heard, this, _1)"


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        (ros2(setup=SETUP.replace(_BOUND, "std::bind(&Talker::heard, this)")), [("heard", 0, 1)]),
        (ros2(setup=SETUP.replace("_1)", "_1, _2)")), [("heard", 2, 1)]),
        # g++ splices these lines, whatever blanks are behind the backslash.
        (ros2(setup=SETUP.replace("_1)", "\\ \n_1)")), []),
        (ros2(setup=SETUP.replace("_1)", "\\\t\r\n_1)")), []),
        (ros2(setup=SETUP.replace("_1)", "\\\n_1)")), []),
        (ros2(setup=SETUP.replace(_BOUND, "[]() {}")), [("lambda", 1, 0)]),
        (ros2(setup="timer_ = create_wall_timer(1s, [](int a, int b) {});"), [("lambda", 0, 2)]),
        (
            ros1().replace("heard(const std_msgs::String::ConstPtr & msg)", "heard()"),
            [("heard", 1, 0)],
        ),
        (ros2(), []),
        (ros2(setup=SETUP.replace(_BOUND, "[](std_msgs::msg::String::SharedPtr m) {}")), []),
        (ros2(setup="timer_ = create_wall_timer(1s, [this] { ask(); });"), []),
        (ros2(setup="timer_ = create_wall_timer(1s, std::bind(&Talker::ask, this));"), []),
        (ros2(setup="timer_ = create_wall_timer(1s, std::bind(&Other::ask, this));"), []),
        (ros1(), []),
    ],
)
def test_callback_that_does_not_take_what_it_gets(
    text: str, counts: list[tuple[str, int, int]]
) -> None:
    found = facts(text).arities
    assert [(each.callback, each.given, each.least) for each in found] == counts
