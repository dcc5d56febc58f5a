"""What the reader says of a parameter beside its name: type, default, range, description."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.endpoint_details import ParameterDetails, Range, merged
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python import read_python

RCLPY = """\
import math
import os
import numpy as np
import rclpy
from rcl_interfaces.msg import (
    FloatingPointRange, IntegerRange, ParameterDescriptor, ParameterType)
from rclpy.node import Node
from rclpy.parameter import Parameter

LIMIT = 2.5
NEGATIVE = -1.5
ON = True
GAINS = [1.0, 0.5]
GROWING = [1]
GROWING.append(2)
TWICE = 1
TWICE = 2


def size():
    return 3


class Arm(Node):
    STEP = 0.25

    def __init__(self, depth=7):
        super().__init__('arm')
        self.off = False
        {call}


def wanted():
    return os.environ['HOME']
"""
ROSPY = """\
{shebang}
import math
import rospy
from dataclasses import dataclass

LIMIT = 2.5


@dataclass
class Config:
    rate: float = 10.0


def main(config: Config, speed=0.5):
    {call}


rospy.init_node('arm')
"""


def parameters(text: str) -> list[ParameterDetails]:
    source = read_python(Path("x.py"), one(text.encode())).source
    assert source is not None
    found = [each.details for each in source.endpoints if each.kind is EndpointKind.PARAMETER]
    assert all(isinstance(each, ParameterDetails) for each in found)
    return found


def of_rclpy(call: str) -> ParameterDetails:
    return parameters(RCLPY.replace("{call}", call))[0]


def of_rospy(call: str, shebang: str = "#!/usr/bin/env python3") -> ParameterDetails:
    return parameters(ROSPY.format(call=call, shebang=shebang))[0]


DEFAULTS = [
    ("1", "int", 1),
    ("1.0", "float", 1.0),
    ("-1", "int", -1),
    ("+0.5", "float", 0.5),
    ("1_000", "int", 1000),
    ("0x1F", "int", 31),
    ("1e-3", "float", 0.001),
    ("True", "bool", True),
    ("not True", "bool", False),
    ("'a'", "string", "a"),
    ("'a' + 'b'", "string", "ab"),
    ("'%s/x' % 'a'", "string", "a/x"),
    ("f'{wanted()}/x'", "string", None),
    ("wanted() + '/x'", "string", None),
    ("os.path.join(wanted(), 'x')", "string", None),
    ("b'a'", None, None),
    ("[1, 2]", "int_list", (1, 2)),
    ("(1.0, 2.0)", "float_list", (1.0, 2.0)),
    ("[True]", "bool_list", (True,)),
    ("['a', 'b']", "string_list", ("a", "b")),
    ("[]", None, ()),
    ("[1, 2.0]", None, (1, 2.0)),
    ("['a', wanted()]", None, None),
    ("[0.0] * 3", "float_list", (0.0, 0.0, 0.0)),
    ("[0.0] * 10 ** 9", "float_list", None),
    ("2 * 3", "int", 6),
    ("1 / 4", "float", 0.25),
    ("7 // 2", "int", 3),
    ("2 ** 3", "int", 8),
    ("9 ** 9 ** 9", None, None),
    ("1 / 0", "float", None),
    ("math.pi / 2", "float", 1.5707963267948966),
    ("np.deg2rad(180)", "float", 3.141592653589793),
    ("math.inf", "float", None),
    ("float('nan')", "float", None),
    ("float(3)", "float", 3.0),
    ("int(3.9)", "int", 3),
    ("str(1)", "string", None),
    ("LIMIT", "float", 2.5),
    ("NEGATIVE", "float", -1.5),
    ("-LIMIT * 2", "float", -5.0),
    ("ON", "bool", True),
    ("GAINS", "float_list", (1.0, 0.5)),
    ("GROWING", "int_list", None),
    ("TWICE", None, None),
    ("size()", "int", 3),
    ("self.STEP", "float", 0.25),
    ("Arm.STEP", "float", 0.25),
    ("self.off", "bool", False),
    ("1 if wanted() else 2", "int", None),
    ("1 if wanted() else 1", "int", 1),
    ("1 if wanted() else 'a'", None, None),
    ("{'a': 1}", None, None),
    ("wanted()", None, None),
    ("unknown", None, None),
]


@pytest.mark.parametrize(("default", "type_", "value"), DEFAULTS)
def test_a_default_is_worked_out_where_it_is_sure(default, type_, value):
    found = of_rclpy(f"self.declare_parameter('x', {default})")
    assert (found.type, found.default, type(found.default)) == (type_, value, type(value))
    assert (found.default_expression, found.is_guess) == (default, False)


GUESSES = [
    (of_rclpy, "self.declare_parameter('x', depth)", "int", 7),
    (of_rclpy, "self.declare_parameter('x', depth * 2.0)", "float", 14.0),
    (of_rclpy, "self.declare_parameter('x', os.getenv('X', 'a'))", "string", "a"),
    (of_rospy, "rospy.get_param('~x', speed)", "float", 0.5),
    (of_rospy, "rospy.get_param('~x', rospy.get_param('~y', 3))", "int", 3),
    (of_rospy, "rospy.get_param('~x', config.rate)", "float", 10.0),
]


@pytest.mark.parametrize(("read", "call", "type_", "value"), GUESSES)
def test_what_something_else_may_decide_is_a_guess(read, call, type_, value):
    found = read(call)
    assert (found.type, found.default, found.is_guess) == (type_, value, True)


@pytest.mark.parametrize(
    ("shebang", "is_guess"),
    [
        ("#!/usr/bin/env python3", False),
        ("from __future__ import division", False),
        ("#!/usr/bin/env python", True),
        ("", True),
    ],
)
def test_a_quotient_of_integers_is_a_guess_where_python_2_may_run(shebang, is_guess):
    found = of_rospy("rospy.get_param('~x', 1 / 4)", shebang)
    assert (found.default, found.is_guess) == (0.25, is_guess)
    assert not of_rospy("rospy.get_param('~x', 1.0 / 4)", shebang).is_guess


CALLS = [
    (of_rospy, "rospy.get_param('~x')", None, None),
    (of_rospy, "rospy.get_param('~x', None)", None, None),
    (of_rospy, "rospy.get_param('~x', default=LIMIT)", "float", 2.5),
    (of_rospy, "rospy.get_param_cached('~x', 1)", "int", 1),
    (of_rospy, "rospy.set_param('~x', 1.5)", "float", None),
    (of_rospy, "rospy.has_param('~x')", None, None),
    (of_rospy, "rospy.get_param('~x', rospy.get_name())", "string", None),
    (of_rclpy, "self.declare_parameter('x')", None, None),
    (of_rclpy, "self.declare_parameter('x', None)", None, None),
    (of_rclpy, "self.declare_parameter(name='x', value=1)", "int", 1),
    (of_rclpy, "self.declare_parameter('x', Parameter.Type.DOUBLE)", "float", None),
    (of_rclpy, "self.declare_parameter('x', rclpy.Parameter.Type.BOOL)", "bool", None),
    (of_rclpy, "self.declare_parameter('x', Parameter.Type.STRING_ARRAY)", "string_list", None),
    (of_rclpy, "self.declare_parameter('x', Parameter.Type.BYTE_ARRAY)", "byte_list", None),
    (of_rclpy, "self.declare_parameter('x', Parameter.Type.NOT_SET)", None, None),
    (of_rclpy, "self.get_parameter('x')", None, None),
    (of_rclpy, "self.get_parameter('x').value", None, None),
    (of_rclpy, "self.get_parameter('x').get_parameter_value().double_value", "float", None),
    (of_rclpy, "self.get_parameter('x').get_parameter_value().string_array_value",
     "string_list", None),
    (of_rclpy, "self.declare_parameter('x', 1).get_parameter_value().integer_value", "int", 1),
    (of_rclpy, "self.get_parameter_or('x', Parameter('x', Parameter.Type.DOUBLE, 0.5))",
     "float", 0.5),
    (of_rclpy, "self.get_parameter_or('x', Parameter('x', value=3))", "int", 3),
    (of_rclpy, "self.get_parameter_or('x', wanted())", None, None),
    (of_rclpy, "self.has_parameter('x')", None, None),
    (of_rclpy, "self.declare_parameters('', [('x', 1)])", "int", 1),
    (of_rclpy, "self.declare_parameters('a', [('x', Parameter.Type.INTEGER)])", "int", None),
    (of_rclpy, "self.declare_parameters('', [('x',)])", None, None),
    (of_rclpy, "self.declare_parameters('', GAINS)", None, None),
]  # fmt: skip


@pytest.mark.parametrize(("read", "call", "type_", "value"), CALLS)
def test_each_call_says_what_it_says(read, call, type_, value):
    found = read(call)
    assert (found.type, found.default) == (type_, value)


RANGE = "FloatingPointRange(from_value=0.0, to_value=LIMIT, step=0.5)"
DESCRIPTORS = [
    ("ParameterDescriptor()", ParameterDetails("float")),
    ("ParameterDescriptor(description='how ' 'fast')",
     ParameterDetails("float", description="how fast")),
    (f"ParameterDescriptor(floating_point_range=[{RANGE}])",
     ParameterDetails("float", range=Range(0.0, 2.5, 0.5))),
    (f"ParameterDescriptor(floating_point_range=({RANGE},))",
     ParameterDetails("float", range=Range(0.0, 2.5, 0.5))),
    ("ParameterDescriptor(read_only=True)", ParameterDetails("float", is_read_only=True)),
    ("ParameterDescriptor(read_only=not ON)", ParameterDetails("float")),
    ("ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0)])",
     ParameterDetails("float")),
    ("ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0,"
     " to_value=float(wanted()))])", ParameterDetails("float")),
    (f"ParameterDescriptor(floating_point_range=[{RANGE}, {RANGE}])", ParameterDetails("float")),
    ("wanted()", ParameterDetails("float")),
    ("ParameterDescriptor(**wanted())", ParameterDetails("float")),
]  # fmt: skip


@pytest.mark.parametrize(("descriptor", "expected"), DESCRIPTORS)
@pytest.mark.parametrize(
    "call",
    [
        "self.declare_parameter('x', 1.0, {})",
        "self.declare_parameter('x', descriptor={}, value=1.0)",
        "self.declare_parameters('', [('y', 2.0), ('x', 1.0, {})])",
        "described = {}; self.declare_parameter('x', 1.0, described)",
    ],
)
def test_a_descriptor_says_what_it_is_given(call, descriptor, expected):
    found = parameters(RCLPY.replace("{call}", call.format(descriptor)))[-1]
    assert found == expected._replace(default=1.0, default_expression="1.0")


@pytest.mark.parametrize(
    ("descriptor", "type_"),
    [
        ("ParameterDescriptor(type=ParameterType.PARAMETER_STRING)", "string"),
        ("ParameterDescriptor(type=ParameterType.PARAMETER_DOUBLE_ARRAY)", "float_list"),
        ("ParameterDescriptor(type=Parameter.Type.BOOL.value)", "bool"),
        ("ParameterDescriptor(integer_range=[IntegerRange(from_value=1, to_value=5)])", "int"),
        (f"ParameterDescriptor(floating_point_range=[{RANGE}])", "float"),
        ("ParameterDescriptor(type=wanted())", None),
    ],
)
def test_a_descriptor_says_the_type_that_no_default_says(descriptor, type_):
    assert of_rclpy(f"self.declare_parameter('x', descriptor={descriptor})").type == type_


FIELDS = [
    ("d.description = 'a'", "a"),
    ("d.description = 'a'\n        d.description = 'b'", None),
    ("if wanted():\n            d.description = 'a'", None),
    ("self.declare_parameter('y')\n        d.description = 'a'", "a"),
]


@pytest.mark.parametrize(("lines", "description"), FIELDS)
def test_a_field_of_a_descriptor_is_what_is_set_for_sure(lines, description):
    call = f"d = ParameterDescriptor()\n        {lines}\n        self.declare_parameter('x', 1, d)"
    found = parameters(RCLPY.replace("{call}", call))[-1]
    assert found.description == description


def test_a_field_that_is_set_later_is_not_said():
    call = (
        "d = ParameterDescriptor(description='a')\n        self.declare_parameter('x', 1, d)\n"
        "        d.description = 'b'\n        self.declare_parameter('y', 1, d)"
    )
    assert [each.description for each in parameters(RCLPY.replace("{call}", call))] == [None, "b"]


MERGED = [
    ([], ParameterDetails()),
    ([ParameterDetails("int", 1, "1"), ParameterDetails()], ParameterDetails("int", 1, "1")),
    ([ParameterDetails(), ParameterDetails("float")], ParameterDetails("float")),
    ([ParameterDetails("int", 1, "1"), ParameterDetails("int", 2, "2")],
     ParameterDetails("int", None, "1")),
    ([ParameterDetails("int", 1, "1"), ParameterDetails("float", 1.0, "1.0")],
     ParameterDetails(None, None, "1")),
    # What is not known, such as the last good value, is no other default.
    ([ParameterDetails("int", 1, "1"), ParameterDetails(None, None, "x")],
     ParameterDetails("int", 1, "1")),
    ([ParameterDetails(range=Range(0, 1)), ParameterDetails(is_read_only=True)],
     ParameterDetails(range=Range(0, 1), is_read_only=True)),
]  # fmt: skip


@pytest.mark.parametrize(("said", "expected"), MERGED)
def test_calls_of_one_parameter_are_put_together_where_they_agree(said, expected):
    assert merged(said) == expected
    assert merged(said[::-1])._replace(default_expression="") == expected._replace(
        default_expression=""
    )


def test_a_node_has_each_parameter_once():
    text = RCLPY.replace(
        "{call}",
        "self.declare_parameter('x', 1.0)\n        self.declare_parameter('y')\n"
        "        self.get_parameter('x').value\n        self.get_parameter(wanted())\n"
        "        self.get_parameter('y').get_parameter_value().string_value",
    )
    source = read_python(Path("x.py"), one(text.encode())).source
    assert source is not None
    assert source.nodes[0].parameters == {
        "x": ParameterDetails("float", 1.0, "1.0"),
        "y": ParameterDetails("string"),
    }
