"""Every statement of the language, with and without its optional clauses, as lists of words."""

from __future__ import annotations

import re

# A statement is whole where it ends, and may end at each `·`.
_MARKED: dict[str, list[str]] = {
    "create_node_statement": [
        "create_node 'talker' as n1",
        "create_node 'talker' as n1 · using rospy",
        "create_node 'talker' as n1 · managed",
        "create_node 'talker' as n1 · using rclpy · managed",
    ],
    "load_statement": [
        "load talker_pub as n1",
        "load 'nodes/talker_pub.py' as n1",
        "load talker_pub node 'talker' as n1",
    ],
    "create_message_statement": [
        "create_message m1 of message_type Empty and input none",
        'create_message m1 of message_type String and input "a b"',
        "create_message m1 of message_type geometry_msgs/Point and input 5 · , -6.5 · , 1e-3",
        "create_message m1 of message_type geometry_msgs/msg/Twist and input linear . x"
        " = 1.0 · , angular = ( 0 , 0 , z = .5 )",
        "create_message m1 of message_type Scan and input ranges = [ 1.0 , 2.0 ] · , to = True",
        'create_message m1 of message_type T and input [ ( 1 , "x" ) , ( ) ] · , False',
        "create_message m1 of message_type T and input parameter 'speed' · , x ="
        " parameter 'a' · * 2",
        "create_message m1 of message_type T and input received . a · , b = received . a"
        " · . b · [ 1 ]",
        "create_message m1 of message_type T and input a = received . x · - 1 · / 2 · ,"
        " received . y · + -3",
        "create_message m1 of message_type T and input a = received . x · * parameter 'p' · -"
        " received . y [ 1 ] · / 2 · , b = parameter 'p' · + received . y . z",
        "create_message m1 of message_type T and input parameter = 5 · , received = received . to",
        "create_message m1 of message_type T and input received . x · = ( received . x [ 0 ] * 5 )",
    ],
    "subscribe_statement": [
        "subscribe n1 to 'chatter' of message_type String",
        "subscribe n1 to 'chatter' of message_type std_msgs/String · calling on_chatter",
        "subscribe n1 to 'chatter' of message_type String · with qos best_effort",
        "subscribe n1 to 'chatter' of message_type String · calling qos · with qos depth"
        " · 5 · , reliable",
    ],
    "unsubscribe_statement": [
        "unsubscribe n1 from 'chatter'",
    ],
    "publish_statement": [
        "n1 publish m1 to 'chatter' of message_type String",
        "n1 publish m1 to 'chatter' of message_type std_msgs/msg/String · at 2.5 hz",
        "n1 publish m1 to 'chatter' of message_type String · at parameter 'rate' hz",
        "n1 publish once to 'chatter' of message_type String · once",
        "n1 publish m1 to 'chatter' of message_type String · with qos latched · once",
        "n1 publish m1 to 'chatter' of message_type String · for_each 'scan' · with qos"
        " sensor_data",
        "n1 publish m1 to 'chatter' of message_type String · for_each 'a' · when received . x > 5",
        "n1 publish m1 to 'a' of message_type T · for_each 'b' · when any received . x < 0.5",
        "n1 publish m1 to 'a' of message_type T · for_each 'b' · when received . any [ 1 ] = True",
        "n1 publish m1 to 'a' of message_type T · for_each 'b' · when all received . s = \"x\"",
    ],
    "stop_publishing_statement": [
        "n1 stop_publishing to 'chatter'",
    ],
    "client_requests_statement": [
        "n1 client_requests 'add' of service_type AddTwoInts with input a = 1 · , b = 2",
        "n1 client_requests 'reset' of service_type std_srvs/srv/Empty with input none",
        "n1 client_requests 'reset' of service_type std_srvs/srv/Empty with input none · at 1 hz",
        "n1 client_requests 'add' of service_type AddTwoInts with input at = 1 · , 2 · at .5 hz",
    ],
    "stop_request_statement": [
        "n1 stop_request 'add'",
    ],
    "provides_service_statement": [
        "n1 provides_service 'add' of service_type AddTwoInts",
        "n1 provides_service 'add' of service_type AddTwoInts · calling _handle_add",
        "n1 provides_service 'add' of service_type AddTwoInts · answering none",
        "n1 provides_service 'add' of service_type T · answering sum = received . a · +"
        " 1 · calling f",
    ],
    "stop_service_statement": [
        "n1 stop_service 'add'",
    ],
    "has_parameter_statement": [
        "n1 has_parameter 'speed' of parameter_type float with default 0.5",
        "n1 has_parameter 'speed' of parameter_type float with default 0.5 · between 0 and 1",
        'n1 has_parameter \'names\' of parameter_type string_list with default [ "a" , "b" ]',
        "n1 has_parameter 'on' of parameter_type bool with default True · described_as \"a b\"",
    ],
    "no_longer_has_parameter_statement": [
        "n1 no_longer_has_parameter 'speed'",
    ],
    "repeats_statement": [
        "n1 repeats blink at 2 hz",
        "repeats repeats repeats at parameter 'rate' hz",
    ],
    "stop_repeating_statement": [
        "n1 stop_repeating blink",
    ],
    "provides_action_statement": [
        "n1 provides_action 'count' of action_type Fibonacci",
        "n1 provides_action 'count' of action_type a/action/Fibonacci · calling execute",
    ],
    "stop_action_statement": [
        "n1 stop_action 'count'",
    ],
    "sends_goal_statement": [
        "n1 sends_goal to 'count' of action_type Fibonacci with input order = 5",
        "n1 sends_goal to 'count' of action_type Fibonacci with input none",
    ],
    "stop_goal_statement": [
        "n1 stop_goal to 'count'",
    ],
    "rename_statement": [
        "n1 renames topic 'scan' to 'front/scan'",
        "n1 renames parameter '~rate' to 'rate'",
    ],
    "generate_node_statement": [
        "generate_node n1",
        "generate_node n1 · using rclpy",
    ],
    "create_message_type_statement": [
        "create_message_type A with none",
        'create_message_type p/A with float64 x · , string<= 10 y · default "a"',
        "create_message_type A with p/B [ <= 3 ] x · , int32 [ 2 ] y · , uint8 OK · = 1",
    ],
    "create_service_type_statement": [
        "create_service_type A with none returning none",
        "create_service_type A with bool x , bool with returning bool returning · default True",
    ],
    "create_action_type_statement": [
        "create_action_type A with none returning none reporting none",
        "create_action_type A with int32 a returning int32 b reporting int32 c · , int32 d · = 5",
    ],
    "load_type_statement": [
        "load_type 'msg/A.msg' as A",
    ],
    "has_field_statement": [
        'A has_field "float64 x"',
        'A has_field "float64 x" · in response',
    ],
    "no_longer_has_field_statement": [
        "A no_longer_has_field 'x'",
        "A no_longer_has_field 'x' · in goal",
    ],
    "drop_type_statement": [
        "drop_type A",
    ],
    "generate_type_statement": [
        "generate_type A",
    ],
    "create_package_statement": [
        "create_package 'demo' as p1",
        'create_package \'demo\' as p1 · described_as "a b" · maintained_by "A <a@b.org>" ·'
        ' licensed_under "MIT"',
        'create_package \'demo\' as p1 · licensed_under "MIT" · described_as "a b"',
    ],
    "load_package_statement": [
        "load_package 'src/demo' as p1",
    ],
    "contains_statement": [
        "p1 contains n1",
        "contains contains contains · as 'talk'",
    ],
    "no_longer_contains_statement": [
        "p1 no_longer_contains n1",
        "p1 no_longer_contains 'talk'",
    ],
    "generate_package_statement": [
        "generate_package p1",
    ],
    "create_launch_statement": [
        "create_launch 'bringup' as l1",
    ],
    "load_launch_statement": [
        "load_launch 'launch/a.launch.xml' as l1",
    ],
    "has_argument_statement": [
        "l1 has_argument 'rate'",
        "l1 has_argument 'rate' · with default 5",
    ],
    "no_longer_has_argument_statement": [
        "l1 no_longer_has_argument 'rate'",
    ],
    "starts_statement": [
        "l1 starts n1",
        "starts starts starts · as 'a' · in 'b' · inside 'c' · with parameters 'd.yaml'",
        "l1 starts 'p/n' · remapping 'a' to 'b' · , 'c' to 'd' · setting 'e' = 5 · , 'f' = [ 1 ]",
        "l1 starts n1 · with parameters 'd.yaml' · setting 'e' = True · as 'a' · remapping 'a' to"
        " 'b'",
    ],
    "no_longer_starts_statement": [
        "l1 no_longer_starts 'n1'",
    ],
    "includes_statement": [
        "l1 includes 'p/a.launch.xml'",
        "includes includes 'p/a.launch.xml'",
    ],
    "no_longer_includes_statement": [
        "l1 no_longer_includes 'p/a.launch.xml'",
    ],
    "generate_launch_statement": [
        "generate_launch l1",
    ],
    "create_robot_statement": [
        "create_robot 'rover' as r1",
    ],
    "load_robot_statement": [
        "load_robot 'urdf/rover.urdf' as r1",
    ],
    "has_link_statement": [
        "r1 has_link 'base'",
        "r1 has_link 'base' · shaped box x = 0.4 · , 0.3 · , 0.1 · weighing 5 · painted blue"
        " · at 0 , -1e-3 , .5 · turned 0 , 0 , 90 deg",
        'r1 has_link \'base\' · painted "#3060ff" · shaped mesh "package://a/b.stl" · turned 0 , 1'
        " , 0 rad",
        "r1 has_link 'base' · painted none · weighing 1",
        "shaped has_link 'base' · painted painted · weighing 1 · shaped shaped 1",
    ],
    "no_longer_has_link_statement": [
        "r1 no_longer_has_link 'base'",
    ],
    "has_joint_statement": [
        "r1 has_joint 'j' · of joint_type fixed · from 'a' to 'b'",
        "r1 has_joint 'j' · mimicking none · from 'a' to 'b' · of joint_type fixed",
        "r1 has_joint 'j' · of joint_type revolute · from 'a' to 'b' · with axis 0 , 1 , 0"
        " · mimicking 'k' · times -2 · turned 0 , 0 , 1 rad · at 1 , 2 , 3",
        "axis has_joint 'j' · of joint_type mimicking · from 'a' to 'b' · at 0 , 0 , 1"
        " · mimicking 'k'",
    ],
    "no_longer_has_joint_statement": [
        "r1 no_longer_has_joint 'j'",
    ],
    "limits_joint_statement": [
        "r1 limits_joint 'j' · between -90 and 90 deg · with effort 20 and velocity 1.5"
        " · with damping 0.1 and friction 0",
        "r1 limits_joint 'j' · with damping 1 and friction 0 · with effort 1 and velocity 2"
        " · between 0 and 1 m",
    ],
    "generate_robot_statement": [
        "generate_robot r1",
    ],
}

STATEMENTS = {kind: [text.replace(" ·", "") for text in texts] for kind, texts in _MARKED.items()}

ENDINGS = {
    (text.replace(" ·", ""), text[: mark.start()].replace(" ·", ""))
    for texts in _MARKED.values()
    for text in texts
    for mark in re.finditer(" ·", text)
}
"""Each statement with what is left of it that is whole too."""
