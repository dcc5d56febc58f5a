"""Where what is added to nodes of rclcpp finds the node: held weakly, or made by a function."""

from __future__ import annotations

import pytest
from additions import publish
from patches import edit

from plastron_tui.model.source import FileSet
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName

WEAK = """
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class Layer {
public:
  void init(const rclcpp::Node::WeakPtr & parent) {
    node_ = parent;
    auto node = node_.lock();
    pub_ = node->create_publisher<std_msgs::msg::String>("state", 1);
  }
private:
  HELD node_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
};
"""


@pytest.mark.parametrize("held", ["rclcpp::Node::WeakPtr", "std::weak_ptr<rclcpp::Node>"])
def test_a_node_that_is_held_weakly_is_locked(held: str) -> None:
    text = WEAK.replace("HELD", held).encode()
    change = publish(
        "at",
        "geometry_msgs/PointStamped",
        rate=7.0,
        point=MessageValue(InterfaceName("geometry_msgs", "Point"), {"x": 1.5}),
    )
    files, told = edit(FileSet.single(".cpp", text), change)
    assert files is not None, told
    assert b"stamp = node_.lock()->now();" in files.main


FACTORY = """
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class Shop : public rclcpp::Node {
public:
  static std::shared_ptr<Shop> make() {
    auto shop = std::make_shared<Shop>();
    shop->pub_ = shop->create_publisher<std_msgs::msg::String>("state", 1);
    return shop;
  }
  Shop() : Node("shop") {}
private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
};
"""


def test_what_makes_an_object_gets_nothing_of_its_own() -> None:
    files, told = edit(FileSet.single(".cpp", FACTORY.encode()), publish("b"))
    assert files is not None, told
    assert b'Shop() : Node("shop")' in files.main
    made = files.main.partition(b"Shop() :")
    assert b'"b"' not in made[0] and b'"b"' in made[2]
