"""What must hold in somebody's file before what is computed there is sent."""

from __future__ import annotations

from plastron_tui.model.kinds.ranges import Interval
from plastron_tui.sources.python.layout import fit
from plastron_tui.sources.python.messages import Conditions


def test_what_is_calculated_gets_its_name_where_all_is_there() -> None:
    conditions = Conditions(lambda wanted: wanted)
    conditions.require("msg.is_on")
    conditions.element("msg.data", 1)
    conditions.element("msg.data", 3)
    conditions.element("msg.data", 0)
    text = conditions.number(
        f"read() * msg.data[3] / {conditions.divisor('msg.x')}", Interval(0, 9)
    )
    assert conditions.around([f"send({text})"]) == [
        "if len(msg.data) > 3 and msg.x != 0:",
        "\tnumber = read() * msg.data[3] / msg.x",
        "\tif msg.is_on and 0 <= number <= 9:",
        "\t\tsend(number)",
    ]


def test_a_long_condition_has_its_parts_below_each_other() -> None:
    long = (
        "if len(message.data) > 3 and message.data[2] + message.data[3] <= 2 and message.x[1] != 0:"
    )
    assert fit(long) == (
        "if (\n    len(message.data) > 3\n    and message.data[2] + message.data[3] <= 2\n"
        "    and message.x[1] != 0\n):"
    )
    last = f"if is_on and is_there({', '.join(['argument'] * 9)}):"
    assert fit(last).startswith("if is_on and is_there(\n")
