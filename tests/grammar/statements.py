"""Every statement of the language, with and without its optional clauses, as lists of words."""

from __future__ import annotations

STATEMENTS: dict[str, list[str]] = {
    "create_node_statement": [
        "create_node 'talker' as n1",
        "create_node 'talker' as n1 using rospy",
    ],
    "load_statement": [
        "load talker_pub as n1",
        "load 'nodes/talker_pub.py' as n1",
        "load talker_pub node 'talker' as n1",
    ],
    "create_message_statement": [
        "create_message m1 of message_type Empty and input none",
        'create_message m1 of message_type String and input "a b"',
        "create_message m1 of message_type geometry_msgs/Point and input 5 , -6.5 , 1e-3",
        "create_message m1 of message_type geometry_msgs/msg/Twist and input"
        " linear . x = 1.0 , angular = ( 0 , 0 , z = .5 )",
        "create_message m1 of message_type Scan and input ranges = [ 1.0 , 2.0 ] , to = True",
        'create_message m1 of message_type T and input [ ( 1 , "x" ) , ( ) ] , False',
    ],
    "subscribe_statement": [
        "subscribe n1 to 'chatter' of message_type String",
        "subscribe n1 to 'chatter' of message_type std_msgs/String calling on_chatter",
    ],
    "unsubscribe_statement": ["unsubscribe n1 from 'chatter'"],
    "publish_statement": [
        "n1 publish m1 to 'chatter' of message_type String",
        "n1 publish m1 to 'chatter' of message_type std_msgs/msg/String at 2.5 hz",
    ],
    "stop_publishing_statement": ["n1 stop_publishing to 'chatter'"],
    "client_requests_statement": [
        "n1 client_requests 'add' of service_type AddTwoInts with input a = 1 , b = 2",
        "n1 client_requests 'reset' of service_type std_srvs/srv/Empty with input none",
    ],
    "stop_request_statement": ["n1 stop_request 'add'"],
    "provides_service_statement": [
        "n1 provides_service 'add' of service_type AddTwoInts",
        "n1 provides_service 'add' of service_type AddTwoInts calling _handle_add",
    ],
    "stop_service_statement": ["n1 stop_service 'add'"],
    "rename_statement": [
        "n1 renames topic 'scan' to 'front/scan'",
        "n1 renames parameter '~rate' to 'rate'",
    ],
    "generate_node_statement": ["generate_node n1", "generate_node n1 using rclpy"],
}
