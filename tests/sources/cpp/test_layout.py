"""Lines of C++ that are too long for the style of ROS 2, and how they are broken."""

from __future__ import annotations

import pytest

from plastron_tui.sources.cpp.layout import fit

LIMIT = 60
BROKEN = {
    "arguments": (
        '  out_ = create_publisher<std_msgs::msg::String>("outer", 10);',
        '  out_ = create_publisher<std_msgs::msg::String>(\n    "outer", 10);',
    ),
    "a condition, and its block": (
        "  if (is_ready_of_everything && is_wanted_by_anybody_at_all) {",
        "  if (\n    is_ready_of_everything && is_wanted_by_anybody_at_all)\n  {",
    ),
    "a value": (
        '  message.name = "words that are too long together for a line";',
        '  message.name =\n    "words that are too long together for a line";',
    ),
    "a call whose bracket is too late": (
        '  the_very_long_name_ = create_publisher<some::long_type::Name>("out", 10, a, b);',
        "  the_very_long_name_ =\n    create_publisher<some::long_type::Name>(\n"
        '    "out", 10, a, b);',
    ),
    "a calculation": (
        "  out.data = value(longest) / value(b) * value(more) - value(last) + value(rest) - c;",
        "  out.data = value(longest) / value(b) * value(more) -\n"
        "    value(last) + value(rest) - c;",
    ),
    "a calculation in brackets": (
        "  out.data = to(value(longest) / value(b) * value(more) - value(last) + value(rest) - c);",
        "  out.data = to(\n    value(longest) / value(b) * value(more) - value(last) +\n"
        "    value(rest) - c);",
    ),
    "a string": (
        '  log("words that go on and on, until there is no room for more");',
        '  log(\n    "words that go on and on, until there is no room for "\n    "more");',
    ),
    "a word that is too long": (
        f'  log("{"a" * 70}");',
        f'  log(\n    "{"a" * 52}"\n    "{"a" * 18}");',
    ),
    "an escape is not broken": (
        f'  log("{"a" * 51}\\377{"b" * 10}");',
        f'  log(\n    "{"a" * 51}"\n    "\\377{"b" * 10}");',
    ),
    "a declaration": (
        "  rclcpp::Publisher<some::long_type::Name>::SharedPtr the_publisher_;",
        "  rclcpp::Publisher<some::long_type::Name>::SharedPtr\n    the_publisher_;",
    ),
    "a chain of calls": (
        '  create("out", rclcpp::QoS(10).transient_local().deadline(seconds(0.5)));',
        '  create(\n    "out",\n    rclcpp::QoS(10).transient_local()\n'
        "    .deadline(seconds(0.5)));",
    ),
    "a method whose name is long": (
        "RobotNodeOfALongName::CallbackReturn RobotNodeOfALongName::go(int a)",
        "RobotNodeOfALongName::CallbackReturn\nRobotNodeOfALongName::go(int a)",
    ),
    "no index": (
        '  message.markers[2].name = "words that are too long for it";',
        '  message.markers[2].name =\n    "words that are too long for it";',
    ),
}


@pytest.mark.parametrize("case", BROKEN)
def test_how_a_line_is_broken(case: str) -> None:
    line, lines = BROKEN[case]
    assert fit(line, LIMIT) == lines
    # What fits is left as it is.
    assert fit(lines, LIMIT) == lines
    assert fit(line, 200) == line
