"""What a parameter may be set to, so that all that is calculated of it fits its fields."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.model.kinds import Parameter
from plastron_tui.model.kinds.ranges import Interval, limits_of, range_of_calculated
from plastron_tui.model.values import calculated
from plastron_tui.session import Session

NODE = "create_node 'n' as n\nn has_parameter 'p' of parameter_type {} with default {}\n"
SEND = (
    "create_message m of message_type std_msgs/{0} and input {1}\n"
    "n publish m to 't' of message_type std_msgs/{0} at {2} hz\n"
)

# The parameter, the message, its value, the rate, and what the parameter may be set to.
LIMITS = [
    ("int", "3", "Int64", "parameter 'p'", "1", None),
    ("int", "3", "UInt8", "parameter 'p'", "1", (0, 255)),
    ("int", "3", "UInt8", "parameter 'p' * 10 - 5", "1", (1, 26)),
    ("int", "-3", "UInt8", "parameter 'p' * -2 + 1", "1", (-127, 0)),
    ("int", "3", "UInt8", "parameter 'p' * 0 + 7", "1", None),
    ("int", "3", "Float32", "parameter 'p'", "1", None),
    ("int", "3", "UInt8", "parameter 'p'", "parameter 'p'", (1, 255)),
    ("int", "3 between -1 and 5", "UInt8", "parameter 'p'", "1", (0, 5)),
    ("float", "0.5", "Float32", "parameter 'p'", "1", None),
    ("float", "0.5 between 0 and 2", "Float32", "parameter 'p'", "1", (0.0, 2.0)),
    ("float", "0.5", "Float32", "parameter 'p'", "parameter 'p'", (0.001, 1e6)),
    ("string", '"a"', "String", "parameter 'p'", "1", None),
]


@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize(("type_", "default", "message", "value", "rate", "limits"), LIMITS)
def test_the_range_of_a_parameter(
    version: int,
    type_: str,
    default: str,
    message: str,
    value: str,
    rate: str,
    limits: tuple[float, float] | None,
) -> None:
    text = NODE.format(type_, default) + SEND.format(message, value, rate)
    library = "rospy" if version == 1 else "rclpy"
    session = Session(text.replace("as n\n", f"as n using {library}\n").encode())
    assert not session.diagnostics
    [node] = session.workspace.nodes.values()
    [parameter] = node.of(Parameter).values()
    assert limits_of(node, parameter, version) == limits


# What is wrong, and the code that says so.
WRONG = [
    ("int", "300", "UInt8", "parameter 'p'", "value-out-of-range"),
    ("int", "30", "UInt8", "parameter 'p' * 10", "value-out-of-range"),
    ("float", "1e39", "Float32", "parameter 'p'", "value-out-of-range"),
    ("int_list", "[1, 300]", "UInt8MultiArray", "data=parameter 'p'", "value-out-of-range"),
    ("int_list", "[]", "UInt8MultiArray", "data=parameter 'p'", "parameter-type-mismatch"),
    ("float", "1", "Int32", "parameter 'p'", "computed-type-mismatch"),
    ("int", "1", "Int32", "parameter 'p' / 2", "computed-type-mismatch"),
]


@pytest.mark.parametrize(("type_", "default", "message", "value", "code"), WRONG)
def test_what_can_never_be_sent(
    type_: str, default: str, message: str, value: str, code: str
) -> None:
    text = NODE.format(type_, default) + SEND.format(message, value, "1")
    session = Session(text.replace("as n\n", "as n using rclpy\n").encode())
    assert session.diagnostics[0].code == code


def test_a_list_of_any_length_goes_into_no_array_of_a_fixed_one() -> None:
    text = (
        "create_node 'n' as n\nsubscribe n to 'a' of message_type {0}\n"
        "create_message m of message_type sensor_msgs/Imu and input "
        "orientation_covariance=received.{1}\n"
        "n publish m to 'b' of message_type sensor_msgs/Imu for_each 'a'\n"
    )
    for type_, field, codes in (
        ("std_msgs/Float64MultiArray", "data", ["computed-type-mismatch"]),
        ("geometry_msgs/PoseWithCovariance", "covariance", ["computed-type-mismatch"]),
        ("sensor_msgs/Imu", "angular_velocity_covariance", []),
    ):
        session = Session(text.format(type_, field).encode())
        assert [found.code for found in session.diagnostics] == codes


def test_a_rate_is_never_zero() -> None:
    text = NODE.format("float", "1 between 0 and 5") + SEND.format("Int32", "1", "parameter 'p'")
    assert [found.code for found in Session(text.encode()).diagnostics] == ["invalid-rate"]


steps = st.lists(
    st.tuples(st.sampled_from("+-*"), st.integers(-50, 50))
    | st.tuples(st.just("/"), st.integers(1, 50)),
    max_size=4,
)


@given(st.integers(-1000, 1000), steps)
def test_calculated_as_python_does(number: int, found: list[tuple[str, int]]) -> None:
    text = f"{number}" + "".join(f" {operator} {other}" for operator, other in found)
    assert calculated(number, found) == pytest.approx(eval(text))


between = st.tuples(st.integers(-50, 50), st.integers(0, 9), st.integers(0, 9))
uncertain_steps = st.lists(st.tuples(st.sampled_from("+-*/"), between), max_size=4)


@given(between, uncertain_steps)
def test_all_between_is_in_the_range(
    first: tuple[int, int, int], found: list[tuple[str, tuple[int, int, int]]]
) -> None:
    def range_of(given: tuple[int, int, int]) -> Interval:
        least, more, rest = given
        return Interval(least, least + more + rest)

    ranges = [(operator, range_of(given)) for operator, given in found]
    steps = [(operator, least + more) for operator, (least, more, _) in found]
    range_ = range_of_calculated(range_of(first), ranges)
    is_whole = all(operator != "/" for operator, _ in found)
    assert isinstance(range_.least, int) == isinstance(range_.most, int) == is_whole
    if ("/", 0) not in steps:
        value = calculated(first[0] + first[1], steps)
        assert range_.least - 1e-6 <= value <= range_.most + 1e-6


FLOAT64 = Interval(-1.8e308, 1.8e308)
GREAT = Interval(-(2**63), 2**63 - 1)
WIDE = [
    (FLOAT64, [("*", FLOAT64)], False),
    (FLOAT64, [("-", FLOAT64), ("*", Interval(0.0, 0.0))], False),
    (GREAT, [("*", GREAT)] * 20, True),
    (GREAT, [("*", GREAT)] * 20 + [("*", FLOAT64)], False),
    (GREAT, [("/", GREAT)], False),
]


@pytest.mark.parametrize(("first", "found", "is_whole"), WIDE)
def test_what_no_number_can_be_is_in_no_way_of_a_range(
    first: Interval, found: list[tuple[str, Interval]], is_whole: bool
) -> None:
    least, most = range_of_calculated(first, found)
    assert isinstance(least, int) == is_whole
    assert least < 0 < most
    assert is_whole or (least, most) == (-math.inf, math.inf)
