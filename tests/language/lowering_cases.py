"""Statements, and the slots that each becomes."""

from __future__ import annotations

import math

from plastron_tui.language.inputs import Nothing

CASES: dict[str, tuple[object, ...]] = {
    "create_node 'talker' as n": ("CreateNode", "talker", "n", False, None),
    "create_node 'talker' as n using rclpy": ("CreateNode", "talker", "n", False, "rclpy"),
    "create_node 'talker' as n managed": ("CreateNode", "talker", "n", True, None),
    "create_node 'talker' as n using rclpy managed": ("CreateNode", "talker", "n", True, "rclpy"),
    "load talker_pub as n": ("Load", "talker_pub", None, "n"),
    "load two node 'a' as n": ("Load", "two", "a", "n"),
    "load 'a b/c.py' as n": ("Load", "a b/c.py", None, "n"),
    "create_message m of message_type Point and input 1, .5": (
        "CreateMessage",
        "m",
        "Point",
        ("1", "0.5"),
    ),
    "create_message m of message_type a/B and input none": ("CreateMessage", "m", "a/B", ()),
    "create_message m of message_type a/msg/B and input x=1": (
        "CreateMessage",
        "m",
        "a/msg/B",
        (("x", "=", "1"),),
    ),
    "subscribe n to '/a/b' of message_type String": (
        "Subscribe",
        "n",
        "/a/b",
        "String",
        None,
        None,
    ),
    "subscribe n to 'a' of message_type String calling f with qos depth 5, reliable": (
        *("Subscribe", "n", "a", "String", "depth 5 reliable None", "f"),
    ),
    "subscribe n to '~a' of message_type String calling _f": (
        "Subscribe",
        "n",
        "~a",
        "String",
        None,
        "_f",
    ),
    "unsubscribe n from 'a'": ("Unsubscribe", "n", "a"),
    "n publish m to 'a' of message_type String": (
        *("Publish", "n", "m", "a", "String", None, False, None, None, None),
    ),
    "n publish m to 'a' of message_type String at parameter 'r' hz": (
        *("Publish", "n", "m", "a", "String", "parameter r", False, None, None, None),
    ),
    "n publish m to 'a' of message_type String with qos latched once": (
        *("Publish", "n", "m", "a", "String", None, True, None, None, "latched None"),
    ),
    "n publish m to 'a' of message_type String for_each 'b' with qos depth 2": (
        *("Publish", "n", "m", "a", "String", None, False, "b", None, "depth 2"),
    ),
    "n publish m to 'a' of message_type String for_each 'b' when any received.x.y < 0.5": (
        *("Publish", "n", "m", "a", "String", None, False, "b"),
        *(("any", "received x.y", "<", "0.5"), None),
    ),
    "n publish m to 'a' of message_type String for_each 'b' when received.any[1] = \"x\"": (
        *("Publish", "n", "m", "a", "String", None, False, "b"),
        *((None, "received any[1]", "=", "'x'"), None),
    ),
    "n publish m to 'a' of message_type String at 2.5 hz": (
        "Publish",
        "n",
        "m",
        "a",
        "String",
        2.5,
        False,
        None,
        None,
        None,
    ),
    "n stop_publishing to 'a'": ("StopPublishing", "n", "a"),
    "n client_requests 's' of service_type T with input 1, True": (
        "ClientRequests",
        "n",
        "s",
        "T",
        ("1", "True"),
        None,
    ),
    "n client_requests 's' of service_type T with input at=1, 2 at parameter 'r' hz": (
        *("ClientRequests", "n", "s", "T", (("at", "=", "1"), "2"), "parameter r"),
    ),
    "n client_requests 's' of service_type T with input none": (
        "ClientRequests",
        "n",
        "s",
        "T",
        (),
        None,
    ),
    "n client_requests 's' of service_type T with input none at 2 hz": (
        *("ClientRequests", "n", "s", "T", (), 2),
    ),
    "n stop_request 's'": ("StopRequest", "n", "s"),
    "n provides_service 's' of service_type T": ("ProvidesService", "n", "s", "T", None, None),
    "n provides_service 's' of service_type T answering none": (
        *("ProvidesService", "n", "s", "T", (), None),
    ),
    "n provides_service 's' of service_type T calling f answering a=received.b + 1, 2": (
        *("ProvidesService", "n", "s", "T", (("a", "=", "received b + 1"), "2"), "f"),
    ),
    "n provides_service 's' of service_type T calling f": (
        "ProvidesService",
        "n",
        "s",
        "T",
        None,
        "f",
    ),
    "n stop_service 's'": ("StopService", "n", "s"),
    "n provides_action 'a' of action_type T": ("ProvidesAction", "n", "a", "T", None),
    "n provides_action 'a' of action_type p/action/T calling f": (
        *("ProvidesAction", "n", "a", "p/action/T", "f"),
    ),
    "n stop_action 'a'": ("StopAction", "n", "a"),
    "n sends_goal to 'a' of action_type T with input x=parameter 'p' * 2": (
        *("SendsGoal", "n", "a", "T", (("x", "=", "parameter p * 2"),)),
    ),
    "n sends_goal to 'a' of action_type T with input none": ("SendsGoal", "n", "a", "T", ()),
    "n stop_goal to 'a'": ("StopGoal", "n", "a"),
    "n has_parameter 'p' of parameter_type float with default -0.5": (
        *("HasParameter", "n", "p", "float", "-0.5", None, None, None),
    ),
    "n has_parameter 'p' of parameter_type int with default 1 between -1 and +2": (
        *("HasParameter", "n", "p", "int", "1", -1, 2, None),
    ),
    "n has_parameter 'p' of parameter_type int_list with default [1] described_as \"x\"": (
        *("HasParameter", "n", "p", "int_list", ["list", "1"], None, None, "x"),
    ),
    "n has_parameter 'p' of parameter_type int with default 1 described_as \"x\" between 0 and 2": (
        *("HasParameter", "n", "p", "int", "1", 0, 2, "x"),
    ),
    "n no_longer_has_parameter 'p'": ("NoLongerHasParameter", "n", "p"),
    "n repeats f at 2 hz": ("Repeats", "n", "f", 2),
    "repeats repeats _f at parameter 'r' hz": ("Repeats", "repeats", "_f", "parameter r"),
    "n stop_repeating f": ("StopRepeating", "n", "f"),
    "n renames topic 's' to 'a/s'": ("Rename", "n", "topic", "s", "a/s"),
    "generate_node n": ("GenerateNode", "n", None),
    "generate_node n using rospy": ("GenerateNode", "n", "rospy"),
    "create_message_type A with none": ("CreateMessageType", "A", ()),
    'create_message_type p/A with string <= 10 x default "a", p/B[<=3] y, uint8 OK = 1': (
        *("CreateMessageType", "p/A"),
        (
            ("string<=10", "x", "default", "'a'"),
            ("p/B[<=3]", "y", "", None),
            ("uint8", "OK", "=", "1"),
        ),
    ),
    "create_service_type A with bool with returning int32[2] returning": (
        *("CreateServiceType", "A", (("bool", "with", "", None),)),
        (("int32[2]", "returning", "", None),),
    ),
    "create_action_type A with none returning bool a reporting none": (
        *("CreateActionType", "A", (), (("bool", "a", "", None),), ()),
    ),
    "load_type 'msg/A.msg' as A": ("LoadType", "msg/A.msg", "A"),
    'A has_field "x"': ("HasField", "A", "x", None),
    'A has_field "x" in response': ("HasField", "A", "x", "response"),
    "A no_longer_has_field 'x'": ("NoLongerHasField", "A", "x", None),
    "A no_longer_has_field 'x' in goal": ("NoLongerHasField", "A", "x", "goal"),
    "drop_type A": ("DropType", "A"),
    "generate_type A": ("GenerateType", "A"),
    "create_package 'p' as p": ("CreatePackage", "p", "p", None, None, None),
    "create_package 'p' as p described_as \"d\"": ("CreatePackage", "p", "p", "d", None, None),
    'create_package \'p\' as p licensed_under "MIT" maintained_by "<a@b.c>"': (
        *("CreatePackage", "p", "p", None, "<a@b.c>", "MIT"),
    ),
    'create_package \'p\' as p licensed_under "MIT" described_as "d"': (
        *("CreatePackage", "p", "p", "d", None, "MIT"),
    ),
    "load_package 'src/p' as p": ("LoadPackage", "src/p", "p"),
    "p contains n": ("Contains", "p", "n", None),
    "contains contains contains as 'n'": ("Contains", "contains", "contains", "n"),
    "p no_longer_contains n": ("NoLongerContains", "p", "n"),
    "p no_longer_contains 'n'": ("NoLongerContains", "p", "'n'"),
    "generate_package p": ("GeneratePackage", "p"),
    "create_launch 'l' as l": ("CreateLaunch", "l", "l"),
    "load_launch 'a/l.launch' as l": ("LoadLaunch", "a/l.launch", "l"),
    "l has_argument 'a'": ("HasArgument", "l", "a", None),
    "l has_argument 'a' with default [1]": ("HasArgument", "l", "a", ["list", "1"]),
    "l no_longer_has_argument 'a'": ("NoLongerHasArgument", "l", "a"),
    "l starts n": ("Starts", "l", "n", *(None,) * 6),
    "l starts 'p/n' as 'm'": ("Starts", "l", "'p/n'", "m", *(None,) * 5),
    "l starts starts in 's' inside 'c'": (
        *("Starts", "l", "starts", None, "s", "c", None, None, None),
    ),
    "l starts n inside 'c'": ("Starts", "l", "n", None, None, "c", None, None, None),
    "l starts n with parameters 'f.yaml' remapping 'a' to 'b', 'c' to 'd'": (
        *("Starts", "l", "n", None, None, None, (("a", "b"), ("c", "d")), None, "f.yaml"),
    ),
    "l starts n setting 'a' = 5, 'b' = [True] as 'm'": (
        *("Starts", "l", "n", "m", None, None, None),
        *((("a", "5"), ("b", ["list", "True"])), None),
    ),
    "l starts n with parameters 'f.yaml'": ("Starts", "l", "n", *(None,) * 5, "f.yaml"),
    "l no_longer_starts 'n'": ("NoLongerStarts", "l", "n"),
    "l includes 'p/a.launch'": ("Includes", "l", "p/a.launch"),
    "l no_longer_includes 'p/a.launch'": ("NoLongerIncludes", "l", "p/a.launch"),
    "generate_launch l": ("GenerateLaunch", "l"),
    "create_robot 'a' as r": ("CreateRobot", "a", "r"),
    "load_robot 'urdf/a.urdf' as r": ("LoadRobot", "urdf/a.urdf", "r", None),
    "load_robot 'a.xacro' as r setting 'a' = 5, 'b' = \"c\"": (
        "LoadRobot",
        "a.xacro",
        "r",
        (("a", "5"), ("b", "'c'")),
    ),
    "r has_link 'a'": ("HasLink", "r", "a", *(None,) * 7),
    "r has_link 'a' shaped box 1, y=.5, -2": (
        *("HasLink", "r", "a", "box", ("1", ("y", "=", "0.5"), "-2"), *(None,) * 5),
    ),
    "r has_link 'a' weighing 1e-3": ("HasLink", "r", "a", None, None, 0.001, *(None,) * 4),
    "r has_link 'a' painted blue": ("HasLink", "r", "a", *(None,) * 3, "blue", *(None,) * 3),
    "r has_link 'a' painted \"#3060ff\"": (
        *("HasLink", "r", "a", *(None,) * 3, "#3060ff", *(None,) * 3),
    ),
    "r has_link 'a' painted none": (
        *("HasLink", "r", "a", *(None,) * 3, Nothing.NONE, *(None,) * 3),
    ),
    "r has_link 'a' at 0, -0.5, 1e999": (
        *("HasLink", "r", "a", *(None,) * 4, (0, -0.5, math.inf), None, None),
    ),
    "shaped has_link 'a' turned 0, 0, 90 deg at 1, 2, 3 painted painted weighing 5": (
        *("HasLink", "shaped", "a", None, None, 5, "painted", (1, 2, 3), (0, 0, 90), "deg"),
    ),
    "r no_longer_has_link 'a'": ("NoLongerHasLink", "r", "a"),
    "r has_joint 'j'": ("HasJoint", "r", "j", *(None,) * 9),
    "r has_joint 'j' from 'a' to 'b' of joint_type fixed": (
        *("HasJoint", "r", "j", "fixed", "a", "b", *(None,) * 6),
    ),
    "r has_joint 'none' mimicking none": (
        *("HasJoint", "r", "none", *(None,) * 7, Nothing.NONE, None),
    ),
    "r has_joint 'j' of joint_type fixed from 'a' to 'b'": (
        *("HasJoint", "r", "j", "fixed", "a", "b", *(None,) * 6),
    ),
    "r has_joint 'j' of joint_type fixed from 'a' to 'b' at 1, 2, 3": (
        *("HasJoint", "r", "j", "fixed", "a", "b", (1, 2, 3), *(None,) * 5),
    ),
    "r has_joint 'j' of joint_type fixed from 'a' to 'b' turned 1, 2, 3 rad": (
        *("HasJoint", "r", "j", "fixed", "a", "b", None, (1, 2, 3), "rad", *(None,) * 3),
    ),
    "r has_joint 'j' of joint_type axis from 'a' to 'b' mimicking 'k' with axis 0, 0, 1": (
        *("HasJoint", "r", "j", "axis", "a", "b", None, None, None, (0, 0, 1), "k", None),
    ),
    "r has_joint 'j' of joint_type fixed from 'a' to 'b' mimicking 'k' times -2.5": (
        *("HasJoint", "r", "j", "fixed", "a", "b", *(None,) * 4, "k", -2.5),
    ),
    "r no_longer_has_joint 'j'": ("NoLongerHasJoint", "r", "j"),
    "r limits_joint 'j'": ("LimitsJoint", "r", "j", *(None,) * 7),
    "r limits_joint 'j' between -90 and 9.5 deg": (
        *("LimitsJoint", "r", "j", -90, 9.5, "deg", *(None,) * 4),
    ),
    "r limits_joint 'j' with effort 1 and velocity 2": (
        *("LimitsJoint", "r", "j", None, None, None, 1, 2, None, None),
    ),
    "r limits_joint 'j' with damping 1 and friction 2": (
        *("LimitsJoint", "r", "j", *(None,) * 5, 1, 2),
    ),
    "r limits_joint 'j' with damping 1 and friction 2 between 0 and 1 m with effort 3 and"
    " velocity 4": ("LimitsJoint", "r", "j", 0, 1, "m", 3, 4, 1, 2),
    "generate_robot r": ("GenerateRobot", "r"),
}
