"""What is calculated of several received values, in Python as the language means it."""

from __future__ import annotations

import ctypes
from types import SimpleNamespace

import pytest
from calculations import FLOATS, HEARD, REFUSED, Calculation, calculations, stored

from plastron_tui.diagnostics import Span
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.python.computed import Computing
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.targets.python import rclpy, rospy
from plastron_tui.targets.python.writing import Functions
from plastron_tui.targets.templates import render_template


def result(dialect: Dialect, calculation: Calculation) -> str | int | float:
    """Return what the expression of a new file comes to; `REFUSED` where it raises."""
    functions = Functions()
    distribution = "noetic" if dialect.ros_version == 1 else "jazzy"
    computing = Computing(
        Catalog(distribution),
        dialect.ros_version,
        Span(0, 0),
        lambda name: (name, None),
        dialect,
        functions,
    )
    text = computing.write(calculation.value, "received", HEARD)
    names: dict[str, object] = {"ctypes": ctypes}
    node = {"functions": functions}
    exec(render_template((dialect.library,), None, "functions.j2", {"node": node}), names)
    names["received"] = SimpleNamespace(
        **{
            name: [number] if name.endswith("s") else number
            for name, number in calculation.received.items()
        }
    )
    try:
        found = eval(text, names)
    except ValueError:
        assert computing.may_fail(calculation.value, HEARD)
        return REFUSED
    assert isinstance(found, (int, float))
    taken = calculation.value.type.name
    if taken not in FLOATS:
        assert isinstance(found, int)
        return found
    assert dialect.ros_version == 1 or isinstance(found, float)
    return stored(taken, found)


@pytest.mark.parametrize("dialect", [rospy.DIALECT, rclpy.DIALECT], ids=["rospy", "rclpy"])
def test_what_is_calculated_of_several_is_what_the_language_means(dialect: Dialect) -> None:
    found = list(calculations(300, 4))
    wrong = [
        (str(each.value), each.received, got, each.wanted)
        for each in found
        if (got := result(dialect, each)) != each.wanted
    ]
    assert wrong == []
    assert {REFUSED} < {each.wanted for each in found}
