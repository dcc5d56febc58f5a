"""Programs made by chance in which statements meet: none of them raises."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from robot_lines import ROBOT, ROBOT_LINES
from workspaces import LIBRARIES, FakeReader, catalog, endpoint, source

from plastron_tui.language import DECLARATIONS, Document, lower
from plastron_tui.model.context import Setting
from plastron_tui.model.interpreter import interpret
from plastron_tui.model.robots import LoadedRobot, RobotSource
from plastron_tui.model.source import EndpointKind

NODES = st.sampled_from(["n", "o", "t", "x"])
MESSAGES = st.sampled_from(["m", "k", "n"])
NAMES = st.sampled_from(["'a'", "'b'", "'~a'", "'scan'", "'a b'", "''"])
TYPES = st.sampled_from(
    ["String", "Twist", "Float32", "sensor_msgs/LaserScan", "Trigger", "AddTwoInts", "Fibonacci"]
)
FUNCTIONS = st.sampled_from(["f", "g", "class"])
SOURCES = st.sampled_from(
    [
        *("received.data", "received.ranges", "received.ranges[0]", "received.ranges[-1]"),
        *("received.header.stamp", "received.linear.x", "received.order", "received.a"),
        *("parameter 'a'", "parameter 'b'", "parameter '~a'"),
    ]
)
NUMBERS = st.sampled_from(["0", "1", "-1", "0.5", "1e999", "9" * 30])
LITERALS = NUMBERS | st.sampled_from(["True", '"a"'])
COMPUTED = SOURCES | st.builds("{} {} {}".format, SOURCES, st.sampled_from("+-*/"), NUMBERS)
VALUES = LITERALS | COMPUTED | st.builds("[{}, {}]".format, LITERALS, COMPUTED)
FIELDS = st.sampled_from(["", "data=", "linear.x=", "a=", "sum=", "order=", "ranges=", "message="])
INPUTS = st.just("none") | st.lists(st.builds("{}{}".format, FIELDS, VALUES), min_size=1).map(
    ", ".join
)
RATES = (NUMBERS | st.sampled_from(["parameter 'a'", "parameter 'b'"])).map(" at {} hz".format)
QOS = st.lists(
    st.sampled_from(["reliable", "best_effort", "latched", "depth 5", "depth", "deadline 0.5"]),
    min_size=1,
    max_size=3,
).map(lambda words: f" with qos {', '.join(words)}")
CONDITIONS = st.builds(
    " when {}{} {} {}".format,
    st.sampled_from(["", "any ", "all "]),
    SOURCES.filter(lambda text: text.startswith("received")),
    st.sampled_from("<>="),
    LITERALS,
)
SENT = (
    RATES
    | st.sampled_from(["", " once"])
    | st.builds(" for_each {}{}".format, NAMES, st.just("") | CONDITIONS)
)
PARAMETER_TYPES = st.sampled_from(["int", "float", "bool", "string", "int_list", "flot"])
LIMITS = st.just("") | st.builds(" between {} and {}".format, NUMBERS, NUMBERS)
WHATS = st.sampled_from(["topic", "service", "action", "parameter", "thing"])
CALLING = st.just("") | FUNCTIONS.map(" calling {}".format)
USING = st.sampled_from(["", " using rospy", " using rclpy", " managed"])
MAYBE_QOS = st.just("") | QOS
OWN = st.sampled_from(["A", "B", "Twist", "p/A", "n"])
TYPE_VARIABLES = st.sampled_from(["A", "B", "n"])
PACKAGES = st.sampled_from(["p", "q", "n"])
LAUNCHES = st.sampled_from(["l", "r", "n"])
ITEMS = st.sampled_from(["n", "o", "l", "m", "p", "A", "x"])
FIELD_TYPES = st.sampled_from(
    ["float64", "string<=10", "int32[]", "A", "B[<=3]", "geometry_msgs/Point", "flot", "uint8[2]"]
)
MEMBERS = st.just("none") | st.lists(
    st.builds(
        "{} {}{}".format,
        FIELD_TYPES,
        st.sampled_from(["a", "b", "A", "class", "x_"]),
        st.just("") | st.builds(" {} {}".format, st.sampled_from(["=", "default"]), VALUES),
    ),
    min_size=1,
    max_size=3,
).map(", ".join)
SECTIONS = st.sampled_from(["", "", " in request", " in result", " in n"])
EXECUTABLES = st.just("") | NAMES.map(" as {}".format)
STARTED = st.sampled_from(["n", "o", "m", "'p/n'", "'x'", "''"])
PLACES = st.sampled_from(["", " in 'a'", " in 'a b'", " inside 'c'"])
REMAPS = st.just("") | st.builds(" remapping {} to {}".format, NAMES, NAMES)
SETTINGS = st.just("") | st.builds(" setting {} = {}".format, NAMES, VALUES)
FILES = st.sampled_from(["'a.msg'", "'a.launch'", "'p/a.launch.xml'", "'..'", "''"])
LINES = st.one_of(
    st.builds("create_message_type {} with {}".format, OWN, MEMBERS),
    st.builds("create_service_type {} with {} returning {}".format, OWN, MEMBERS, MEMBERS),
    st.builds(
        "create_action_type {} with {} returning {} reporting {}".format,
        *(OWN, MEMBERS, MEMBERS, MEMBERS),
    ),
    st.builds("load_type {} as {}".format, FILES, st.sampled_from(["A", "n"])),
    st.builds('{} has_field "{} a"{}'.format, TYPE_VARIABLES, FIELD_TYPES, SECTIONS),
    st.builds("{} no_longer_has_field {}{}".format, TYPE_VARIABLES, NAMES, SECTIONS),
    st.builds("drop_type {}".format, TYPE_VARIABLES),
    st.builds("generate_type {}".format, TYPE_VARIABLES),
    st.builds(
        "create_package {} as {}{}{}".format,
        *(NAMES, PACKAGES, st.sampled_from(["", ' licensed_under "MIT"'])),
        st.sampled_from(["", ' maintained_by "A <a@b.org>"', ' maintained_by "a"']),
    ),
    st.builds("load_package {} as {}".format, FILES, PACKAGES),
    st.builds("{} contains {}{}".format, PACKAGES, ITEMS, EXECUTABLES),
    st.builds("{} no_longer_contains {}".format, PACKAGES, ITEMS | NAMES),
    st.builds("generate_package {}".format, PACKAGES),
    st.builds("create_launch {} as {}".format, NAMES, LAUNCHES),
    st.builds("load_launch {} as {}".format, FILES, LAUNCHES),
    st.builds("{} has_argument {} with default {}".format, LAUNCHES, NAMES, VALUES),
    st.builds("{} no_longer_has_argument {}".format, LAUNCHES, NAMES),
    st.builds(
        "{} starts {}{}{}{}{}".format,
        *(LAUNCHES, STARTED, EXECUTABLES, PLACES, REMAPS, SETTINGS),
    ),
    st.builds("{} no_longer_starts {}".format, LAUNCHES, NAMES),
    st.builds("{} includes {}".format, LAUNCHES, FILES),
    st.builds("{} no_longer_includes {}".format, LAUNCHES, FILES),
    st.builds("generate_launch {}".format, LAUNCHES),
    st.builds("create_node {} as {}{}".format, NAMES, NODES, USING),
    st.builds("load driver as {}".format, NODES),
    st.builds("create_message {} of message_type {} and input {}".format, MESSAGES, TYPES, INPUTS),
    st.builds(
        "subscribe {} to {} of message_type {}{}{}".format, NODES, NAMES, TYPES, MAYBE_QOS, CALLING
    ),
    st.builds("unsubscribe {} from {}".format, NODES, NAMES),
    st.builds(
        "{} publish {} to {} of message_type {}{}{}".format,
        *(NODES, MESSAGES, NAMES, TYPES, SENT, MAYBE_QOS),
    ),
    st.builds("{} stop_publishing to {}".format, NODES, NAMES),
    st.builds(
        "{} client_requests {} of service_type {} with input {}{}".format,
        *(NODES, NAMES, TYPES, INPUTS, st.just("") | RATES),
    ),
    st.builds("{} stop_request {}".format, NODES, NAMES),
    st.builds(
        "{} provides_service {} of service_type {}{}{}".format,
        *(NODES, NAMES, TYPES, st.just("") | INPUTS.map(" answering {}".format), CALLING),
    ),
    st.builds("{} stop_service {}".format, NODES, NAMES),
    st.builds("{} provides_action {} of action_type {}{}".format, NODES, NAMES, TYPES, CALLING),
    st.builds("{} stop_action {}".format, NODES, NAMES),
    st.builds(
        "{} sends_goal to {} of action_type {} with input {}".format, NODES, NAMES, TYPES, INPUTS
    ),
    st.builds("{} stop_goal to {}".format, NODES, NAMES),
    st.builds(
        "{} has_parameter {} of parameter_type {} with default {}{}".format,
        *(NODES, NAMES, PARAMETER_TYPES, VALUES, LIMITS),
    ),
    st.builds("{} no_longer_has_parameter {}".format, NODES, NAMES),
    st.builds("{} repeats {}{}".format, NODES, FUNCTIONS, RATES),
    st.builds("{} stop_repeating {}".format, NODES, FUNCTIONS),
    st.builds("{} renames {} {} to {}".format, NODES, WHATS, NAMES, NAMES),
    st.builds("generate_node {}".format, NODES),
    *ROBOT_LINES,
)
BEFORE = """\
create_node 'node' as n
n has_parameter 'a' of parameter_type float with default 1
subscribe n to 'scan' of message_type sensor_msgs/LaserScan
create_message m of message_type Float32 and input received.ranges[0]
load driver as t
create_robot 'rover' as v
v has_link 'a' shaped sphere 1 weighing 1
load_robot 'a.urdf' as w
"""


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@settings(max_examples=examples(200), deadline=None)
@given(lines=st.lists(LINES, min_size=1, max_size=12))
def test_no_program_raises(library: str, lines: list[str]) -> None:
    driver = source(
        endpoint(EndpointKind.SUBSCRIPTION, "scan", "sensor_msgs/LaserScan"),
        endpoint(EndpointKind.PARAMETER, "~/a"),
        endpoint(EndpointKind.TIMER, None, None, "f"),
        library=library,
    )
    setting = Setting(
        library,
        LIBRARIES,
        catalog,
        FakeReader({"driver": driver}),
        read_robot=lambda *_: LoadedRobot(RobotSource(Path("a.urdf"), b"", ROBOT)),
    )
    text = (BEFORE + "\n".join(lines) + "\n").encode()
    program = lower(Document(text))
    assert len(program.statements) == text.count(b"\n")
    for found in interpret(program, setting).diagnostics:
        assert found.span is not None
        assert 0 <= found.span.start <= found.span.end <= len(text)


def test_every_statement_is_among_the_lines() -> None:
    words = set(re.findall(r"\w+", repr(LINES)))
    assert {declaration.keyword for declaration in DECLARATIONS.values()} <= words
