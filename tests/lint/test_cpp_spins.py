"""Which programs in C++ spin their nodes, and which nodes others may spin."""

from __future__ import annotations

import pytest
from cpp_programs import SUB1, facts, ros1, ros2

EXECUTOR = "rclcpp::executors::SingleThreadedExecutor e;"

_MADE = "auto node = std::make_shared<Talker>(); rclcpp::shutdown();"
_MOTOR = "struct Motor { void spin_once() {} }; Motor motor_;"
_DERIVED = "Motor : public rclcpp::executors::SingleThreadedExecutor {"


@pytest.mark.parametrize(
    ("text", "is_idle"),
    [
        (ros2(main="auto node = std::make_shared<Talker>(); rclcpp::shutdown();"), True),
        (ros2(main="Talker node;"), True),
        (ros2(main="// todo"), False),
        (ros1(main=f"{SUB1} return 0;"), True),
        (ros1(main=f"{SUB1} ros::Rate r(10); while (ros::ok()) {{ r.sleep(); }}"), True),
        (ros2(main=f"{EXECUTOR} e.add_node(std::make_shared<Talker>());"), True),
        (ros2(main=f"{EXECUTOR} e.add_node(std::make_shared<Talker>()); e.spin();"), False),
        (ros2(main=f"{EXECUTOR} e.add_node(std::make_shared<Talker>()); run(e);"), False),
        (
            ros2(
                main="auto e = std::make_shared<rclcpp::executors::MultiThreadedExecutor>();"
                "auto node = std::make_shared<Talker>(); e->add_node(node);"
            ),
            True,
        ),
        (ros1(main=f"{SUB1} ros::AsyncSpinner s(2); ros::Duration(9).sleep();"), True),
        (ros1(main=f"{SUB1} ros::AsyncSpinner s(2); s.start();"), False),
        (ros2("motor_.spin_once();", main=_MADE, more=_MOTOR), True),
        (
            ros2("motor_->spin_once();", main=_MADE, more=_MOTOR.replace("Motor m", "Motor * m")),
            True,
        ),
        (ros2("other_.spin_once();", main=_MADE, more=_MOTOR), False),
        (ros2("spin_once();", main=_MADE, more=_MOTOR), False),
        (ros2("motor_.spin_once();", main=_MADE, more=_MOTOR.replace("Motor {", _DERIVED)), False),
        (ros2("motor_.spin_once();", main=f"{EXECUTOR} e.spin_once();", more=_MOTOR), False),
        (
            ros2(
                "motor_.spin_once();",
                main=_MADE,
                more=_MOTOR.replace("{}", "{ rclcpp::spin_some(node_); }"),
            ),
            False,
        ),
        (ros2(main="/* todo */ rclcpp::shutdown();"), False),
        (ros2(main="").replace("Talker() :", "Talker(int) :"), False),
        (ros2(), False),
        (ros1(), False),
        (ros1(main=f"{SUB1} while (ros::ok()) {{ ros::spinOnce(); }}"), False),
        (ros1(main=f"{SUB1} run_node(nh);"), False),
        (ros1(main="return 0;"), False),
    ],
)
def test_program_that_never_spins(text: str, is_idle: bool) -> None:
    assert (facts(text).idle is not None) is is_idle


@pytest.mark.parametrize(
    "main",
    [
        "auto robot = std::make_shared<Talker>(); run(robot);",
        "auto robot = std::make_shared<Talker>(); run(std::move(robot));",
        "auto robot = std::make_shared<Talker>(); run(*robot);",
        "auto robot = std::make_shared<Talker>(); Runner runner(robot);",
        "auto robot = std::make_shared<Talker>(); Runner runner{robot};",
        "Talker robot; run(robot);",
        "run(std::make_shared<Talker>());",
        "run(std::shared_ptr<Talker>(new Talker()));",
        "std::vector<rclcpp::Node::SharedPtr> robots{std::make_shared<Talker>()}; run(robots);",
    ],
)
def test_node_that_other_code_gets_may_be_spun_there(main: str) -> None:
    found = facts(ros2(main=main))
    assert found.idle is None
    assert not found.is_closed


@pytest.mark.parametrize(
    ("text", "is_closed"),
    [
        (ros2().replace("public rclcpp::Node", "public rclcpp::Node, public tools::Extra"), False),
        (ros2().replace("public rclcpp::Node", "public rclcpp::Node, public std::mutex"), True),
        (ros1(), True),
        (f"#include <driver/driver.h>\n{ros1()}", False),
    ],
)
def test_node_with_parts_that_are_not_read_is_not_closed(text: str, is_closed: bool) -> None:
    assert facts(text).is_closed is is_closed


def test_node_that_its_own_program_spins_is_closed() -> None:
    main = "auto robot = std::make_shared<Talker>(); rclcpp::spin(robot);"
    assert facts(ros2(main=main)).is_closed
    assert facts(ros2()).is_closed
