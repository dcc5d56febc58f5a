from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.language.expectations import expected_at
from plastron_tui.session import Session
from plastron_tui.studio.editor.candidate import Candidate
from plastron_tui.studio.editor.completer import goes_on
from plastron_tui.studio.editor.completion import candidates, detail_of
from plastron_tui.studio.editor.vocabulary import Vocabulary

PROGRAM = """\
create_node 'talker' as talker
create_node 'adder' as adder using rclpy
create_message hello of message_type String and input "hello"
create_message here of message_type Point and input 1,2,3
talker publish hello to 'chatter' of message_type String
subscribe talker to 'places' of message_type Point
adder provides_service 'add' of service_type AddTwoInts
"""


def offered(line: str, program: str = PROGRAM, path: Path | None = None) -> list[Candidate]:
    """What is offered at the end of a line below a program, or at its `|`."""
    before, _, after = line.partition("|")
    session = Session((program + before + after + "\n").encode(), path, environ={})
    known = Session(program.encode(), path, environ={})
    expected = expected_at(session.document, len((program + before).encode()))
    return candidates(expected, Vocabulary(known.program, known.workspace), session)


def texts(line: str) -> list[str]:
    return [candidate.text for candidate in offered(line)]


@pytest.mark.parametrize(
    ("line", "first"),
    [
        ("cre", ["create_node", "create_message"]),
        ("ta", ["talker"]),
        ("talker stop_r", ["stop_request"]),
        ("subscribe talker ", ["to"]),
        ("subscribe ", ["talker", "adder"]),
        ("talker publish ", ["hello", "here"]),
        ("talker publish he", ["hello", "here"]),
        ("talker publish here to ", ["'places'", "'chatter'"]),
        ("subscribe talker to 'pl", ["'places'"]),
        ("unsubscribe talker from ", ["'places'"]),
        ("talker stop_publishing to ", ["'chatter'"]),
        ("adder stop_service ", ["'add'"]),
        ("talker client_requests ", ["'add'"]),
        ("subscribe talker to 'chatter' of message_type ", ["String"]),
        ("talker publish here to 'new' of message_type ", ["Point"]),
        ("create_message m of message_type Twi", ["Twist", "TwistStamped"]),
        ("create_message m of message_type geometry_msgs/Tw", ["geometry_msgs/Twist"]),
        ("create_message m of message_type nav_msgs/", ["nav_msgs/Odometry", "nav_msgs/Path"]),
        ("talker provides_service 'x' of service_type SetB", ["SetBool"]),
        ("generate_node talker using rc", ["rclpy", "rclcpp"]),
        ("create_node 'listener' as ", ["listener"]),
        ("create_message m of message_type Twist and input ", ["linear", "angular", "none"]),
        ("create_message m of message_type Twist and input linear.", ["linear.x", "linear.y"]),
        ("create_message m of message_type Twist and input linear=(", ["x", "y", "z"]),
        ("create_message m of message_type Twist and input (1,2,3), (x=1, ", ["y", "z"]),
        ("create_message m of message_type Point and input x=1, ", ["y", "z"]),
        ("create_message m of message_type Polygon and input points=[(", ["x", "y", "z"]),
        ("create_message m of message_type Polygon and input points=[(x=1), (y=2, ", ["x", "z"]),
        ("create_message m of message_type PoseArray and input poses=[(position=(", ["x", "y"]),
        ("talker client_requests 's' of service_type SetBool with input ", ["True", "False"]),
        ("talker client_requests 's' of service_type SetBool with input data=", ["True", "False"]),
    ],
)
def test_offered(line: str, first: list[str]) -> None:
    assert texts(line)[: len(first)] == first


@pytest.mark.parametrize(
    ("line", "goes_on_"),
    [
        ("create_node", True),
        ("talker", True),
        ("talker publish", True),
        ("talker publish hello to 'c' of message_type", True),
        ("talker publish hello to 'c' of message_type String", False),
        ("talker publish hello to 'c' of message_type String at", True),
        ("create_message m of message_type String", True),
        ("create_message m of message_type String and input none", False),
        ("create_message m of message_type Twist and input linear.x=1", False),
        ("generate_node talker", False),
        ("generate_node talker using", True),
        ("generate_node talker using rclpy", False),
        ("oops oops", False),
        ("// talker", False),
    ],
)
def test_whether_a_sentence_goes_on(line: str, goes_on_: bool) -> None:
    assert goes_on(line.encode()) is goes_on_


@pytest.mark.parametrize(
    ("word", "type_"),
    [
        ("speed", "Twist"),
        ("camera", "Image"),
        ("laser", "LaserScan"),
        ("text", "String"),
        ("joystick", "Joy"),
        ("joys", "Joy"),
        ("position", "Odometry"),
        ("map", "OccupancyGrid"),
        ("battery", "BatteryState"),
        ("twist", "Twist"),
        ("str", "String"),
    ],
)
def test_a_word_of_purpose_finds_a_type_and_says_why(word: str, type_: str) -> None:
    first = offered(f"create_message m of message_type {word}")[0]
    assert first.text == type_
    assert bool(first.detail) is (word not in ("twist", "str"))


def test_types_begin_with_those_that_people_use() -> None:
    assert texts("create_message m of message_type ")[:5] == [
        *("String", "Twist", "LaserScan", "Image", "Odometry")
    ]
    assert texts("talker provides_service 's' of service_type ")[:2] == ["Trigger", "SetBool"]


ARM = """\
create_robot 'arm' as arm
arm has_link 'base' shaped sphere 0.1 painted blue
arm has_link 'hand'
arm has_joint 'turn' of joint_type continuous from 'base' to 'hand'
arm has_link 'lid'
arm has_joint 'open' of joint_type continuous from 'hand' to 'lid' mimicking 'turn'
"""


@pytest.mark.parametrize(
    ("line", "found"),
    [
        (
            "arm ",
            [
                *("has_link", "no_longer_has_link", "has_joint", "no_longer_has_joint"),
                "limits_joint",
            ],
        ),
        ("arm has_joint 'turn' mimicking ", ["'open'"]),
        ("arm has_joint 'open' mimicking ", ["none", "'turn'"]),
    ],
)
def test_offered_for_a_robot(line: str, found: list[str]) -> None:
    assert [each.text for each in offered(line, ARM)] == found


def test_no_colour_is_offered_to_what_has_one() -> None:
    lines = ("arm has_link 'base' painted no", "arm has_link 'hand' painted no")
    found = [[each.text for each in offered(line, ARM)] for line in lines]
    assert [texts.count("none") for texts in found] == [1, 0]


ROBOT = """\
create_node 'robot' as robot using rclpy
create_node 'old' as old using rospy
robot has_parameter 'speed' of parameter_type float with default 0.5
robot has_parameter 'frame' of parameter_type string with default "map"
robot has_parameter 'quiet' of parameter_type bool with default True
old has_parameter 'pace' of parameter_type int with default 5
subscribe robot to 'scan' of message_type sensor_msgs/LaserScan
subscribe robot to 'go' of message_type Bool
create_message stop of message_type Twist and input none
robot repeats blink at 2 hz
robot provides_action 'count' of action_type Fibonacci
"""
STOP = "robot publish stop to 'x' of message_type Twist "


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("old sends_goal to ", ["'count'"]),
        ("robot sends_goal to 'count' of action_type ", ["Fibonacci"]),
        ("robot sends_goal to 'c' of action_type Fibonacci with input ", ["order"]),
        ("robot stop_action ", ["'count'"]),
        ("robot has_parameter 'p' of parameter_type ", ["bool", "int", "float", "string"]),
        ("robot has_parameter 'p' of parameter_type bool with default ", ["True", "False"]),
        ("robot has_parameter 'p' of parameter_type bool_list with default [", ["True", "False"]),
        ("robot no_longer_has_parameter ", ["'speed'", "'frame'", "'quiet'"]),
        ("old no_longer_has_parameter ", ["'pace'"]),
        ("robot stop_repeating ", ["blink"]),
        (STOP, ["at", "once", "for_each", "with"]),
        (STOP + "at ", ["parameter 'speed'"]),
        (STOP + "at par", ["parameter 'speed'"]),
        (STOP + "at parameter ", ["'speed'"]),
        ("old repeats tick at ", ["parameter 'pace'"]),
        (STOP + "for_each ", ["'scan'", "'go'"]),
        (STOP + "for_each 'sc", ["'scan'"]),
        (STOP + "for_each 'go' when ", ["any", "all", "received.data"]),
        (STOP + "for_each 'scan' when any ", ["received.header", "received.ranges"]),
        (STOP + "for_each 'scan' when received.angle", ["received.angle_min"]),
        (STOP + "for_each 'scan' when received.header.", ["received.header.stamp"]),
        (STOP + "for_each 'scan' when any received.ranges ", ["<", "=", ">"]),
        (STOP + "for_each 'scan' when any received.ranges < 5 ", ["with"]),
        (STOP + "with qos ", ["system_default", "latched", "reliable", "sensor_data"]),
        ("subscribe robot to 'x' of message_type Imu with qos ", ["sensor_data", "reliable"]),
        (STOP + "with qos reliable, ", ["system_default", "volatile", "sensor_data"]),
        (STOP + "with qos depth 5, reliable, d", ["deadline"]),
        ("subscribe old to 'x' of message_type Bool with qos ", ["latched", "depth"]),
        ("create_message m of message_type Twist and input linear.x=par", ["parameter 'speed'"]),
        ("create_message m of message_type Twist and input linear.x=parameter ", ["'speed'"]),
        ("create_message m of message_type Twist and input linear.x=received.d", ["received.data"]),
        ("robot provides_service 'a' of service_type AddTwoInts answering ", ["sum", "none"]),
        (
            "robot provides_service 'a' of service_type AddTwoInts answering sum=received.",
            ["received.a", "received.b"],
        ),
        (
            "robot provides_service 'a' of service_type AddTwoInts answering received.a + ",
            ["received"],
        ),
        (
            "robot provides_service 'a' of service_type AddTwoInts answering received.a /received.",
            ["received.a", "received.b"],
        ),
        ("old renames ", ["parameter"]),
        ("robot renames parameter ", ["'speed'", "'frame'", "'quiet'"]),
        ("create_node 'arm' as arm ", ["managed", "using"]),
    ],
)
def test_offered_for_what_else_a_node_does(line: str, found: list[str]) -> None:
    texts = [candidate.text for candidate in offered(line, ROBOT)]
    places = [texts.index(text) for text in found]
    assert places == sorted(places)
    assert texts[0] == found[0]


@pytest.mark.parametrize(
    ("line", "missing"),
    [
        (STOP + "with qos reliable, ", "best_effort"),
        (STOP + "with qos latched, ", "transient_local"),
        ("subscribe old to 'x' of message_type Bool with qos ", "reliable"),
        (STOP + "for_each 'scan' when received.", "received.ranges"),
        (STOP + "for_each 'scan' when all received.", "received.angle_min"),
        (STOP + "at ", "parameter 'frame'"),
        (STOP + "at ", "parameter 'pace'"),
        (STOP + "once ", "at"),
        (STOP + "for_each 'scan' when any ", "with"),
        ("create_message m of message_type Twist and input linear.x=5 ", "parameter 'speed'"),
    ],
)
def test_what_would_be_wrong_is_not_offered(line: str, missing: str) -> None:
    assert missing not in [candidate.text for candidate in offered(line, ROBOT)]


def test_a_message_that_is_sent_for_a_topic_takes_what_arrives_there() -> None:
    sent = ROBOT + "robot publish m to 'y' of message_type Twist for_each 'go'\n"
    line = "create_message m of message_type Twist and input linear.x=received."
    assert [each.text for each in offered(line, sent)] == ["received.data"]


def test_words_of_quality_of_service_say_what_they_mean() -> None:
    assert all(each.detail for each in offered(STOP + "with qos ", ROBOT))


@pytest.mark.parametrize(
    "line",
    [
        "// cre",
        "create_node 'ta",
        "create_node 'talker' as ",
        'create_message m of message_type String and input "he',
        "talker publish hello to 'c' of message_type String at ",
        "subscribe talker oops ",
        "create_message m of message_type Nothing and input ",
    ],
)
def test_nothing_is_offered(line: str) -> None:
    assert [text for text in texts(line) if text != "none"] == []


def test_a_type_that_packages_share_is_offered_with_its_package() -> None:
    found = texts("create_message m of message_type ")
    assert len(found) == len(set(found))
    for text in found:
        session = Session(
            f"create_message m of message_type {text} and input none\n".encode(), environ={}
        )
        assert [problem for problem in session.diagnostics if "type" in problem.code] == []


def test_the_fields_of_a_type_are_said() -> None:
    line = "create_message m of message_type Poi"
    session = Session((PROGRAM + line).encode(), environ={})
    expected = expected_at(session.document, len(session.document.text))
    names = Vocabulary(session.program, session.workspace)
    found = next(entry for entry in candidates(expected, names, session) if entry.text == "Point")
    assert detail_of(found, expected, names, session) == "x: float64, y: float64, z: float64"


def test_files_that_can_be_loaded(tmp_path: Path) -> None:
    (tmp_path / "output").mkdir()
    (tmp_path / "output" / "talker_pub.py").touch()
    (tmp_path / "my-driver.py").touch()
    found = offered("load ", "", tmp_path / "a.plastron")
    assert [entry.text for entry in found] == ["talker_pub", "'my-driver.py'"]


BEST_EFFORT = """\
create_node 'robot' as robot using rclpy
create_node 'ears' as ears using rclpy
create_node 'old' as old using rospy
create_message m of message_type Bool and input True
robot publish m to 'lost' of message_type Bool with qos sensor_data
robot publish m to 'kept' of message_type Bool
robot publish m to 'both' of message_type Bool with qos best_effort
ears publish m to '/both' of message_type Bool
"""
WORDS = {
    "subscribe ears to 'lo": " of message_type Bool with qos sensor_data",
    "subscribe ears to 'ke": " of message_type Bool",
    "subscribe ears to 'bo": " of message_type Bool",
    "subscribe old to 'lo": " of message_type Bool",
    "ears publish m to 'lo": " of message_type Bool",
}


@pytest.mark.parametrize(("line", "after"), WORDS.items())
def test_a_topic_brings_along_what_lets_it_be_heard(line: str, after: str) -> None:
    assert offered(line, BEST_EFFORT)[0].after == after
