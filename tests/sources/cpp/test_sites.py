"""What an editor of C++ asks of a call site: where what it creates is kept, and what it calls."""

from __future__ import annotations

import pytest
from reading import ROS2

from plastron_tui.sources.cpp.holders import holder_of, statement_of
from plastron_tui.sources.cpp.reader import analyze
from plastron_tui.sources.cpp.structure import outline
from plastron_tui.sources.cpp.syntax import parse
from plastron_tui.sources.cpp.unit import Unit

HEADER = """
class A : public rclcpp::Node {
  A();
  void cb(const std_msgs::msg::String& m);
  rclcpp::PublisherBase::SharedPtr pub_;
  std::vector<rclcpp::PublisherBase::SharedPtr> all_;
};
"""
CALL = 'create_publisher<std_msgs::msg::String>("a", 1)'


@pytest.mark.parametrize(
    ("body", "holder", "file", "statement"),
    [
        (f"pub_ = {CALL};", "pub_", "a.hpp", f"pub_ = {CALL};"),
        (f"this->pub_ = {CALL};", "pub_", "a.hpp", f"this->pub_ = {CALL};"),
        (f"auto p = {CALL};", "p", "", f"auto p = {CALL};"),
        (f"all_.push_back({CALL});", "all_", "a.hpp", f"all_.push_back({CALL});"),
        (f"all_[0] = {CALL};", "all_", "a.hpp", f"all_[0] = {CALL};"),
        (f"use({CALL});", None, "", f"use({CALL});"),
        (f"{CALL}->publish(m);", None, "", f"{CALL}->publish(m);"),
    ],
)
def test_what_is_created_is_kept(body: str, holder: str | None, file: str, statement: str) -> None:
    text = f'{ROS2}#include "a.hpp"\nA::A() : Node("n") {{ {body} }}\n'
    files = [outline("", parse(text.encode())), outline("a.hpp", parse(HEADER.encode()))]
    analysis = analyze(Unit(files), 2)
    (site,) = analysis.sites
    found = holder_of(analysis, site)
    assert (found.name if found is not None else None) == holder
    assert found is None or found.file.name == file
    assert site.file.syntax.slice(statement_of(site)) == statement


def test_a_callback_is_known_where_it_is_declared_and_defined() -> None:
    text = (
        f'{ROS2}#include "a.hpp"\nA::A() : Node("n") {{\n'
        '  create_subscription<std_msgs::msg::String>("a", 1, std::bind(&A::cb, this, _1));\n}\n'
        "void A::cb(const std_msgs::msg::String& m) {}\n"
    )
    files = [outline("", parse(text.encode())), outline("a.hpp", parse(HEADER.encode()))]
    (site,) = analyze(Unit(files), 2).sites
    found = [(each.file.name, each.scope is not None) for each in site.callback.functions]
    assert found == [("", True), ("a.hpp", False)]
