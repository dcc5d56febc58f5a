"""Handles of C++ that nobody keeps."""

from __future__ import annotations

import pytest
from cpp_programs import SETUP, SUB1, at, facts, ros1, ros2


@pytest.mark.parametrize(
    ("text", "places"),
    [
        (ros2(setup=SETUP.replace("sub_ = ", "")), ["create_subscription"]),
        (ros2(setup=SETUP.replace("sub_ = ", "auto sub = ")), ["create_subscription"]),
        (ros2(setup="create_wall_timer(1s, [this]() { ask(); });"), ["create_wall_timer"]),
        (ros2(setup="auto timer_ = this->create_wall_timer(1s, [] {});"), ["this->create"]),
        (ros1(main='nh.subscribe("chatter", 10, heard); ros::spin();'), ["nh.subscribe"]),
        (ros1(main=f"{{ {SUB1} }} ros::spin();"), ["nh.subscribe"]),
        (ros1(main=f"{{ {SUB1} ros::spin(); }}"), []),
        (ros2(setup="(void)create_wall_timer(1s, []() {});"), ["create_wall_timer"]),
        (ros2(setup="auto t = create_wall_timer(1s, [] {}); (void)t;"), ["create_wall_timer"]),
        (ros2(setup="auto t = create_wall_timer(1s, [] {}); (void)keep(t);"), []),
        (ros2(setup="add_on_set_parameters_callback(check);"), ["add_on_set"]),
        (ros2(setup="this->add_pre_set_parameters_callback(check);"), ["this->add_pre"]),
        (ros2(setup="auto h = add_post_set_parameters_callback(check);"), ["add_post"]),
        (ros2(setup="handle_ = add_on_set_parameters_callback(check);"), []),
        (ros2(setup="keep(add_on_set_parameters_callback(check));"), []),
        (ros2(setup="other_->add_on_set_parameters_callback(check);"), []),
        (
            ros2(
                setup="get_node_parameters_interface()->add_on_set_parameters_callback(check);",
                more="int add_on_set_parameters_callback(int);",
            ),
            [],
        ),
        (
            ros2(
                setup='events_->add_parameter_callback("a", check);',
                more="std::shared_ptr<rclcpp::ParameterEventHandler> events_;",
            ),
            ["events_->add"],
        ),
        (
            ros2(
                setup='seen_ = events_->add_parameter_callback("a", check);',
                more="std::shared_ptr<rclcpp::ParameterEventHandler> events_;",
            ),
            [],
        ),
        (
            ros2(
                setup='events_->add_parameter_callback("a", check);',
                more="std::shared_ptr<Keeper> events_;",
            ),
            [],
        ),
        (ros1(main='nh.advertise<std_msgs::String>("out", 1); ros::spin();'), ["nh.advertise"]),
        (ros2(), []),
        (
            ros2(
                setup=SETUP.replace("sub_ = ", "auto sub = ")
                + " timer_ = create_wall_timer(1s, [=]() { sub->get_topic_name(); });"
            ),
            [],
        ),
        (ros2(setup=SETUP.replace("sub_ = ", "auto sub = ") + " sub_ = sub;"), []),
        (ros2(setup=SETUP.replace("sub_ = ", "auto sub = ") + " keep(std::move(sub));"), []),
        (
            ros2(
                main='auto n = rclcpp::Node::make_shared("n"); auto s = n->create_subscription<'
                'std_msgs::msg::String>("c", 1, [](std_msgs::msg::String::SharedPtr) {});'
                "rclcpp::spin(n);"
            ),
            [],
        ),
    ],
)
def test_endpoint_that_nobody_keeps(text: str, places: list[str]) -> None:
    found = at(text, facts(text).dropped)
    assert len(found) == len(places)
    assert all(each.startswith(start) for each, start in zip(found, places, strict=True))
