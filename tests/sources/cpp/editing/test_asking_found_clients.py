"""Requests that a program sends through a client that the file has."""

from __future__ import annotations

import pytest
from patches import edit, sides

from plastron_tui.model.kinds import Client, Request
from plastron_tui.model.source import Add, FileSet
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName

ROSCPP = """
 #include <ros/ros.h>
 #include <std_srvs/SetBool.h>

 class Asker {
  public:
   Asker() { client_ = nh_.serviceClient<std_srvs::SetBool>("go"); }

  private:
   ros::NodeHandle nh_;
   ros::ServiceClient client_;
 };
"""
RCLCPP = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_srvs/srv/set_bool.hpp>

 class Asker : public rclcpp::Node {
  public:
   Asker() : Node("asker") { client_ = create_client<std_srvs::srv::SetBool>("go"); }

  private:
   rclcpp::Client<std_srvs::srv::SetBool>::SharedPtr client_;
 };
"""
SET_BOOL = InterfaceName("std_srvs", "SetBool")
REQUEST = Request(MessageValue(SET_BOOL, {"data": True}))


@pytest.mark.parametrize(
    ("node", "asks", "creates"),
    [(ROSCPP, b"client_.call(call)", b"serviceClient<"),
     (RCLCPP, b"client_->async_send_request(", b"create_client<")],
)  # fmt: skip
def test_a_client_of_the_file_is_asked(node: str, asks: bytes, creates: bytes) -> None:
    before: FileSet = sides(node)[0]
    files, told = edit(before, Add(Client("go", SET_BOOL, (REQUEST,))))
    assert files is not None, told
    assert asks in files.main and files.main.count(creates) == 1
