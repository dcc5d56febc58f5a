"""Statements with several mistakes: each independent one is told, once."""

from __future__ import annotations

from functools import cache
from itertools import combinations
from pathlib import Path

import pytest
from cases import check_each
from workspaces import LIBRARIES, FakeReader, catalog, endpoint, marked, source

from plastron_tui.language import DECLARATIONS, Document, lower
from plastron_tui.model.context import FoundDefinition, LoadedDefinition, Setting
from plastron_tui.model.interpreter import interpret
from plastron_tui.model.launches import LaunchSource, LoadedLaunch
from plastron_tui.model.package_source import LoadedPackage, PackageSource
from plastron_tui.model.robots import LoadedRobot, RobotSource
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.launch import Format, LaunchFile
from plastron_tui.ros.robots.description import Description, Link

BEFORE = """\
create_node 'node' as n
create_node 'other' as o
create_node 'idle' as i
create_message m of message_type String and input "hi"
o publish m to 'text' of message_type String
subscribe n to 'heard' of message_type String calling hear
n publish m to 'sent' of message_type String
n provides_service 'given' of service_type Trigger calling give
n has_parameter 'speed' of parameter_type float with default 1
n has_parameter 'names' of parameter_type string_list with default ["a"]
n repeats tick at 1 hz
n provides_action 'acts' of action_type Fibonacci calling act
n sends_goal to 'done' of action_type Fibonacci with input none
load driver as t
create_message_type Own with int32 x
create_package 'rover' as rover
create_launch 'bringup' as bringup
create_robot 'bot' as b
b has_link 'base'
create_robot 'whole' as whole
whole has_link 'base'
b has_link 'arm'
b has_link 'old'
b has_link 'limb'
b has_link 'free'
b has_joint 'turn' of joint_type revolute from 'base' to 'arm' with axis 0, 0, 1
b has_joint 'hold' of joint_type fixed from 'arm' to 'old'
b limits_joint 'turn' between -1 and 1 rad with effort 1 and velocity 1
b has_joint 'lift' of joint_type revolute from 'base' to 'limb' with axis 0, 0, 1
"""

SLOTS: dict[str, dict[str, list[str]]] = {
    # Each slot: what is right first, then what is wrong, each alone.
    "create_node {} as {} using {}": {
        "'new'": ["'a b'", "'node'"],
        "k": ["n", "_k"],
        "rospy": ["rospi"],
    },
    "load {} as {}": {"driver": ["'nowhere.py'"], "k": ["n", "_k"]},
    "create_message {} of message_type {} and input {}": {
        "k": ["n", "_k"],
        "String": ["Sting"],
        '"a"': [],
    },
    "create_message {} of message_type Point and input {}, {}": {
        "k": ["n", "_k"],
        "x=1": ["q=1"],
        "z=1": ['z="s"', "w=1"],
    },
    "create_message k of message_type Twist and input {}, {}": {
        "linear.x=1": ["linear.q=1", "linear=(q=1)"],
        "angular.z=1": ["angular.z.y=1", "angular.z=True", "angular=1"],
    },
    "create_message k of message_type Int32MultiArray and input data=[{}, {}]": {
        "1": ["True"],
        "2": ['"a"'],
    },
    "generate_node {} using {}": {"n": ["x", "i"], "rospy": ["rospi"]},
    "subscribe {} to {} of message_type {} calling {}": {
        "n": ["x"],
        "'a'": ["'a b'", "'heard'"],
        "String": ["Sting"],
        "f": ["class", "give"],
    },
    "subscribe n to 'text' of message_type {} calling {}": {
        "String": ["Int32"],
        "f": ["class", "give"],
    },
    "{} provides_service {} of service_type {} calling {}": {
        "n": ["x"],
        "'a'": ["'a b'", "'given'"],
        "SetBool": ["Sting"],
        "f": ["class", "hear"],
    },
    "{} client_requests {} of service_type {} with input none": {
        "n": ["x"],
        "'a'": ["'a b'"],
        "Trigger": ["Sting"],
    },
    "{} client_requests {} of service_type SetBool with input {}": {
        "n": ["x"],
        "'a'": ["'a b'"],
        "True": ["1"],
    },
    "{} publish {} to {} of message_type {} at {} hz": {
        "n": ["x"],
        "m": ["y"],
        "'a'": ["'a b'", "'sent'"],
        "String": ["Sting", "Int32"],
        "1": ["0"],
    },
    "{} client_requests {} of service_type SetBool with input True at {} hz": {
        "n": ["x"],
        "'a'": ["'a b'"],
        "1": ["0", "parameter 'sped'", "parameter 'names'"],
    },
    "{} publish m to {} of message_type String at parameter {} hz": {
        "n": ["x"],
        "'a'": ["'a b'", "'sent'"],
        "'speed'": ["'sped'", "'names'"],
    },
    "{} publish m to {} of message_type String for_each {} with qos {}": {
        "n": ["x"],
        "'a'": ["'a b'"],
        "'heard'": ["'herd'"],
        "depth 5": ["dept 5", "depth"],
    },
    "{} publish m to {} of message_type String for_each 'heard' when {}": {
        "n": ["x"],
        "'a'": ["'a b'"],
        'received.data = "a"': [
            "received.dat = 1",
            "received.data < 1",
            "any received.data = 1",
        ],
    },
    "subscribe {} to {} of message_type {} with qos {}": {
        "n": ["x"],
        "'a'": ["'a b'", "'heard'"],
        "String": ["Sting"],
        "latched": ["lached", "depth -1"],
    },
    "{} provides_service {} of service_type {} answering {} calling f": {
        "n": ["x"],
        "'a'": ["'a b'", "'given'"],
        "Trigger": ["Sting"],
        'message="a"': [],
    },
    "n provides_service {} of service_type SetBool answering {}, {}": {
        "'a'": ["'a b'", "'given'"],
        "success=received.data": ["success=1", "succes=True"],
        'message="a"': ["message=1", 'massage="a"'],
    },
    "{} provides_action {} of action_type {} calling {}": {
        "n": ["x"],
        "'a'": ["'a b'", "'acts'"],
        "Fibonacci": ["Fibonaci"],
        "f": ["class", "hear"],
    },
    "{} sends_goal to {} of action_type {} with input none": {
        "n": ["x"],
        "'a'": ["'a b'"],
        "Fibonacci": ["Fibonaci"],
    },
    "{} sends_goal to {} of action_type Fibonacci with input {}": {
        "n": ["x"],
        "'a'": ["'a b'"],
        "order=1": ["order=True", "odder=1"],
    },
    "{} has_parameter {} of parameter_type {} with default 1": {
        "n": ["x"],
        "'a'": ["'a b'", "'speed'"],
        "float": ["flot"],
    },
    "{} has_parameter {} of parameter_type int with default {}": {
        "n": ["x"],
        "'a'": ["'a b'", "'speed'"],
        "1": ["True", "1.5", "[1]"],
    },
    "{} has_parameter {} of parameter_type int with default 1 between {}": {
        "n": ["x"],
        "'a'": ["'a b'", "'speed'"],
        "0 and 2": ["2 and 0", "0.5 and 2"],
    },
    "{} repeats {} at {} hz": {
        "n": ["x"],
        "f": ["class", "tick", "hear"],
        "1": ["0", "-1", "parameter 'sped'", "parameter 'names'"],
    },
    "create_node {} as {} managed using rclpy": {
        "'new'": ["'a b'", "'node'"],
        "k": ["n", "_k"],
    },
    "{} renames {} {} to {}": {
        "t": ["x"],
        "topic": ["thing"],
        "'scan'": ["'nope'"],
        "'c'": ["'c d'"],
    },
    "create_message_type {} with {} {}": {
        "New": ["string", "Own"],
        "float64": ["flot64"],
        "a": ["class"],
    },
    "create_service_type {} with int32 {} returning {} b": {
        "New": ["string", "Own"],
        "a": ["class"],
        "int32": ["int31"],
    },
    "create_action_type {} with none returning int32 {} reporting uint8 {}": {
        "New": ["string"],
        "a": ["class"],
        "B = 5": ["B = 500"],
    },
    "load_type {} as {}": {"'a.msg'": [], "k": ["n"]},
    "{} has_field {}": {"Own": ["Ownn"], '"int32 y"': []},
    "generate_type {}": {"Own": ["Ownn"]},
    "drop_type {}": {"Own": ["Ownn"]},
    "create_package {} as {} maintained_by {} licensed_under {}": {
        "'new'": ["'rover'", "'a b'"],
        "k": ["n", "_k"],
        '"A <a@b.org>"': ['"A"', '"A <a>"'],
        '"MIT"': ['"MITT"'],
    },
    "create_package {} as k described_as {}": {"'new'": ["'a b'"], '"a"': ['"a\\nb"']},
    "{} contains {}": {"rover": ["rovr"], "n": ["m", "nn"]},
    "{} contains {} as {}": {"rover": ["rovr"], "n": ["m"], "'run'": ["'a b'"]},
    "generate_package {}": {"rover": ["rovr"]},
    "load_package {} as {}": {"'src/p'": [], "k": ["n"]},
    "create_launch {} as {}": {"'new'": ["'bringup'"], "k": ["n", "_k"]},
    "load_launch {} as {}": {"'a.launch'": [], "k": ["n"]},
    "{} has_argument 'a'": {"bringup": ["bringp"]},
    "{} starts t": {"bringup": ["bringp"]},
    "{} includes 'p/a.launch'": {"bringup": ["bringp"]},
    "generate_launch {}": {"bringup": ["bringp"]},
    "create_robot {} as {}": {"'new'": ["'bot'", "'a b'"], "k": ["n", "_k"]},
    "load_robot {} as {}": {"'a.urdf'": [], "k": ["n"]},
    "{} has_link {} shaped sphere {} weighing {} painted {}": {
        "b": ["x"],
        "'new'": ["'base'", "'a b'"],
        "0.1": ["-1", "0", '"a"'],
        "2": ["0", "1e99"],
        "red": ["rde"],
    },
    "b has_link {} shaped {} 1, 1, 1 at {} turned 0, 0, 90 {}": {
        "'new'": ["'base'"],
        "box": ["bx", "sphere"],
        "0, 0, 1": [],
        "deg": ["degrees", "m"],
    },
    "b has_link 'new' shaped box {}, 1, {} at 0, 0, {}": {
        "1": ["0"],
        "2": ["-2", "wide=3"],
        "0.5": ["1e9"],
    },
    "{} has_joint {} of joint_type {} from {} to {} with axis {}": {
        "b": ["x"],
        "'j'": ["'turn'", "'a b'"],
        "continuous": ["turning"],
        "'arm'": ["'amr'"],
        "'free'": ["'odl'"],
        "0, 0, 1": ["0, 0, 0"],
    },
    "b has_joint 'j' of joint_type continuous from 'arm' to {} turned 0, 0, 1 {} mimicking {}": {
        "'free'": ["'arm'"],
        "rad": ["m"],
        "'turn'": ["'trun'", "'hold'", "'j'"],
    },
    "{} limits_joint {} between {} deg with effort {} and velocity {}": {
        "b": ["x"],
        "'lift'": ["'turn'", "'litf'", "'hold'"],
        "-1 and 10": ["10 and -1", "9 and 9"],
        "5": ["-5"],
        "6": ["-6"],
    },
    "generate_robot {}": {"whole": ["x"]},
}

FOLLOWING = {
    # What needs what is wrong itself.
    frozenset({"x", "'heard'"}), frozenset({"x", "'given'"}), frozenset({"x", "'sent'"}),
    frozenset({"y", "'sent'"}), frozenset({"y", "Int32"}), frozenset({"x", "give"}),
    frozenset({"x", "hear"}), frozenset({"x", "'nope'"}), frozenset({"thing", "'nope'"}),
    # What a node has is not known of one that is not there.
    *(
        frozenset({"x", each})
        for each in (
            "parameter 'sped'", "parameter 'names'", "'sped'", "'names'", "'herd'", "'acts'",
            "'speed'", "tick", "'base'", "'turn'", "'amr'", "'odl'", "'litf'", "'hold'",
            "received.dat = 1", "received.data < 1", "any received.data = 1",
        )
    ),
}  # fmt: skip


@cache
def _mistakes(line: str) -> list[str]:
    """Return the texts that are marked in a line behind a program without mistakes.

    What has one mistake is asked for with each of the other ones that may stand beside it.
    """
    driver = source(endpoint(EndpointKind.SUBSCRIPTION, "scan", "sensor_msgs/LaserScan"))
    found = LoadedDefinition(FoundDefinition(Path("a.msg"), b"", "p", InterfaceKind.MESSAGE))
    setting = Setting(
        "rospy",
        LIBRARIES,
        catalog,
        FakeReader({"driver": driver}),
        read_definition=lambda _: found,
        read_package=lambda *_: LoadedPackage(PackageSource(Path("p"), "p", 1, "catkin")),
        read_robot=lambda *_: LoadedRobot(
            RobotSource(Path("a.urdf"), b"", Description("a", {"a": Link("a")}))
        ),
        read_launch=lambda _: LoadedLaunch(
            LaunchSource(Path("a.launch"), b"<launch/>", Format.ROS1_XML, LaunchFile(()))
        ),
    )
    text = BEFORE + line + "\n"
    found = interpret(lower(Document(text.encode())), setting).diagnostics
    return [marked(text, each) for each in found]


def _cases() -> list[tuple[str, str, str]]:
    cases: list[tuple[str, str, str]] = []
    for sentence, slots in SLOTS.items():
        for one, two in combinations(slots, 2):
            for a in slots[one]:
                for b in slots[two]:
                    line = sentence.format(*({one: a, two: b}.get(each, each) for each in slots))
                    first, second = (
                        sentence.format(*({slot: bad}.get(each, each) for each in slots))
                        for slot, bad in ((one, a), (two, b))
                    )
                    if frozenset({a, b}) not in FOLLOWING:
                        cases.append((line, first, second))
    return cases


CASES = _cases()


def check_two(line: str, first: str, second: str) -> None:
    alone = [_mistakes(first), _mistakes(second)]
    assert [len(found) for found in alone] == [1, 1]
    assert _mistakes(line) == alone[0] + alone[1]


# In parts, so that all workers have some of it.
@pytest.mark.parametrize("part", range(8))
def test_two_mistakes_are_told_as_each_alone(part: int) -> None:
    check_each(CASES[part::8], check_two)


def test_every_sentence_is_right_without_the_mistakes() -> None:
    for sentence, slots in SLOTS.items():
        assert _mistakes(sentence.format(*slots)) == [], sentence


def test_every_statement_with_several_slots_is_in_the_table() -> None:
    words = {word for sentence in SLOTS for word in sentence.split()}
    for declaration in DECLARATIONS.values():
        assert declaration.keyword in words or declaration.undoes is not None
