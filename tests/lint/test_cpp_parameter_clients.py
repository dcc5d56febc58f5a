"""Clients of parameters in C++ that are asked in a callback, and waited for there."""

from __future__ import annotations

import pytest
from cpp_programs import SETUP, at, facts, ros2

from plastron_tui.model.code_facts import Wait

_MEMBER = "std::shared_ptr<rclcpp::AsyncParametersClient> asked_;"
_ASYNC = "std::make_shared<rclcpp::AsyncParametersClient>"
_SYNC = _ASYNC.replace("Async", "Sync")
_INTERFACES = (
    "get_node_base_interface(), get_node_topics_interface(), get_node_graph_interface(), "
    'get_node_services_interface(), "arm"'
)
_GET = 'auto found = asked_->get_parameters({"speed"}); found.get();'
_SET = "asked_->set_parameters({}).wait();"
_ASKED = 'asked_->get_parameters({"speed"})'
_CALLED = "void ask_arm() { " + _GET + " }"
_SERVER = """rclcpp_action::create_server<demo::action::Move>(
  get_node_base_interface(), get_node_clock_interface(), get_node_logging_interface(),
  get_node_waitables_interface(), "move",
  [this](const rclcpp_action::GoalUUID &, std::shared_ptr<const demo::action::Move::Goal>) {
    ask_arm(); return rclcpp_action::GoalResponse::REJECT; }, cancel, accept);"""


def _node(made: str, callback: str, more: str = "", member: str = _MEMBER) -> str:
    return ros2(callback, setup=f"{SETUP}\n    {made}", more=f"{member}\n{more}")


@pytest.mark.parametrize(
    ("text", "places"),
    [
        (_node(f'asked_ = {_ASYNC}(this, "arm");', _GET), ["found.get()"]),
        (_node(f"asked_ = {_ASYNC}({_INTERFACES});", _GET), ["found.get()"]),
        (_node(f'asked_ = {_ASYNC}(this, "arm");', _SET), [_SET.rstrip(";")]),
        (_node(f'asked_ = {_ASYNC}(this, "arm");', "ask_arm();", _CALLED), ["found.get()"]),
        (_node(f'asked_ = {_ASYNC}(this, "arm"); {_SERVER}', "", _CALLED), ["found.get()"]),
        (_node("", f'auto asked_ = {_ASYNC}(this, "arm"); {_GET}'), ["found.get()"]),
        # Nobody waits, or not in a callback.
        (_node(f'asked_ = {_ASYNC}(this, "arm");', f"{_ASKED};"), []),
        (_node(f'asked_ = {_ASYNC}(this, "arm"); {_GET}', ""), []),
        (_node(f'asked_ = {_ASYNC}(this, "arm");', "std::thread([this] { ask_arm(); });",
               _CALLED), []),
        # Another group of callbacks, or another node, brings the answer.
        (_node(f'asked_ = {_ASYNC}(this, "arm", rclcpp::ParametersQoS(), group_);', _GET), []),
        (_node(f'asked_ = {_ASYNC}({_INTERFACES}, rclcpp::ParametersQoS(), group_);', _GET), []),
        (_node(f'asked_ = {_ASYNC}(helper_, "arm");', _GET), []),
        (_node(f'asked_ = {_ASYNC}(this, "arm"); asked_ = {_ASYNC}(helper_, "arm");', _GET), []),
        (_node("asked_ = made();", _GET), []),
        (_node("asked_ = std::make_shared<arm::Client>(this);", _GET, "",
               "std::shared_ptr<arm::Client> asked_;"), []),
    ],
)  # fmt: skip
def test_an_answer_of_a_client_of_parameters_never_comes(text: str, places: list[str]) -> None:
    found = facts(text).blocking
    assert at(text, found) == places
    assert all(each.wait is Wait.SERVICE and each.is_endless for each in found)


@pytest.mark.parametrize(
    ("made", "callback", "places"),
    [
        (f'asked_ = {_SYNC}(this, "arm");', f"auto found = {_ASKED};", [_ASKED]),
        (f'asked_ = {_SYNC}(helper_, "arm");', f"auto found = {_ASKED};", []),
        (f'asked_ = {_SYNC}(executor_, this, "arm");', f"auto found = {_ASKED};", []),
        (f'asked_ = {_SYNC}(this, "arm"); {_ASKED};', "", []),
        ("", "this->get_parameters({});", []),
    ],
)
def test_a_client_that_spins_its_node_throws(made: str, callback: str, places: list[str]) -> None:
    text = _node(made, callback, "", _MEMBER.replace("Async", "Sync"))
    found = facts(text).blocking
    assert at(text, found) == places
    assert all(each.wait is Wait.SPIN for each in found)
