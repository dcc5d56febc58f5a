from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.model.endpoint_details import ParameterDetails, Range
from plastron_tui.model.kinds import EndpointKind, Publisher, Service, Subscription
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.runtime.action_topics import Endpoint, with_actions
from plastron_tui.runtime.describe import DescribedNode
from plastron_tui.runtime.private_parameters import private_parameters
from plastron_tui.runtime.program import to_program
from plastron_tui.session import Session

STRING = InterfaceName("std_msgs", "String")
SET_BOOL = InterfaceName("std_srvs", "SetBool")


def running(name: str, **endpoints: tuple[Endpoint, ...]) -> DescribedNode:
    return DescribedNode(name, {EndpointKind(key): found for key, found in endpoints.items()})


def test_a_graph_is_a_program() -> None:
    nodes = [
        running(
            "/talker",
            publishers=(("/chatter", STRING),),
            services=(("/arm/switch", SET_BOOL),),
        ),
        running(
            "/listener", subscriptions=(("/chatter", STRING),), clients=(("/arm/switch", SET_BOOL),)
        ),
    ]
    program = to_program(nodes, "rclpy")
    head = "".join(f"{line}\n" for line in program.splitlines() if line.startswith("//"))
    assert "not known" in head
    assert "`rclpy` stands for it" in head
    assert program == f"{head}\n" + (
        "create_node 'talker' as talker using rclpy\n"
        "create_message talker_chatter of message_type std_msgs/String and input none\n"
        "talker publish talker_chatter to '/chatter' of message_type std_msgs/String\n"
        "talker provides_service '/arm/switch' of service_type std_srvs/SetBool\n"
        "generate_node talker\n"
        "\n"
        "create_node 'listener' as listener using rclpy\n"
        "subscribe listener to '/chatter' of message_type std_msgs/String\n"
        "listener client_requests '/arm/switch' of service_type std_srvs/SetBool with input none\n"
        "generate_node listener\n"
    )
    assert Session(program.encode()).diagnostics == ()


def test_namespaces_keywords_and_unknown_types_still_make_a_program() -> None:
    nodes = [
        running("/arm/publish", publishers=(("/arm/to", STRING),)),
        running("/leg/publish", publishers=(("/leg/to", STRING), ("/leg/odd", None))),
        running("/publish_2", subscriptions=(("/leg/to", STRING),)),
        running("/only/odd", subscriptions=(("/leg/odd", None),)),
        running("/idle"),
    ]
    program = to_program(nodes)
    session = Session(program.encode())
    assert session.diagnostics == ()
    made = {node.name: (*node.of(Publisher), *node.of(Subscription)) for node in _nodes(session)}
    assert made == {
        "publish": ("/arm/to",),
        "leg_publish": ("/leg/to",),
        "publish_2": ("/leg/to",),
    }
    body = program.split("\n\n", 1)[1]
    comments = [line for line in body.splitlines() if line.startswith("//")]
    assert comments == [
        "// /arm/publish",
        "// /leg/publish",
        "// /leg/odd: its type is not known",
        "// /only/odd has no topic or service that a program can name",
        "// /leg/odd: its type is not known",
        "// /idle has no topic or service that a program can name",
    ]


def _nodes(session: Session) -> Iterable[Node]:
    return session.workspace.nodes.values()


def test_an_empty_graph_is_an_empty_program() -> None:
    program = to_program([])
    assert program == "// no node is running\n"
    assert Session(program.encode()).diagnostics == ()


def test_names_that_are_none_are_comments_that_do_nothing() -> None:
    bad = "/a'\ngenerate_node x\x1b[2J"
    nodes = [
        running(
            "/talker",
            publishers=(("/ok", STRING), (bad, STRING), ("/t", InterfaceName("a", "b\nc"))),
            services=((bad, SET_BOOL),),
        ),
        running(bad, subscriptions=(("/ok", STRING),)),
        running("/quiet", clients=((bad, SET_BOOL),)),
    ]
    program = to_program(nodes, "rospy")
    assert program.replace("\n", "").isprintable()
    session = Session(program.encode())
    assert session.diagnostics == ()
    assert [(node.name, *node.of(Publisher), *node.of(Service)) for node in _nodes(session)] == [
        ("talker", "/ok")
    ]
    shown = "/a'\\ngenerate_node x\\x1b[2J"
    assert program.count(f"// {shown}: no program can name it\n") == 2
    assert f"// {shown}: no program can name this node\n" in program


def test_parameters_and_actions_are_statements() -> None:
    fibonacci = InterfaceName("example_interfaces", "Fibonacci")
    node = DescribedNode(
        "/robot",
        {
            EndpointKind.ACTION_SERVER: (("/count", fibonacci),),
            EndpointKind.ACTION_CLIENT: (("/other", fibonacci),),
        },
        {
            "speed": ParameterDetails("float", 0.5, range=Range(0, 2), description='how "fast"'),
            "names": ParameterDetails("string_list", ("a", "b")),
            "odd": ParameterDetails("byte_list", None),
        },
    )
    assert to_program([node], "rclpy", 2).splitlines()[4:] == [
        "create_node 'robot' as robot using rclpy",
        "robot has_parameter 'speed' of parameter_type float with default 0.5 between 0 and 2"
        ' described_as "how \\"fast\\""',
        'robot has_parameter \'names\' of parameter_type string_list with default ["a", "b"]',
        "// odd: no statement gives a node this parameter",
        "robot provides_action '/count' of action_type example_interfaces/Fibonacci",
        "robot sends_goal to '/other' of action_type example_interfaces/Fibonacci with input none",
        "generate_node robot",
    ]


def _of_action(name: str, *parts: str) -> tuple[Endpoint, ...]:
    types = {
        "goal": InterfaceName("actionlib", "TestActionGoal"),
        "feedback": InterfaceName("actionlib", "TestActionFeedback"),
        "result": InterfaceName("actionlib", "TestActionResult"),
        "cancel": InterfaceName("actionlib_msgs", "GoalID"),
        "status": InterfaceName("actionlib_msgs", "GoalStatusArray"),
    }
    return tuple((f"{name}/{part}", types[part]) for part in parts)


def test_topics_of_an_action_are_the_action() -> None:
    told, asked = ("status", "feedback", "result"), ("goal", "cancel")
    chatter = ("/chatter", STRING)
    found = with_actions(
        {
            EndpointKind.PUBLISHER: (
                *_of_action("/do", *told),
                chatter,
                *_of_action("/a/b", *asked),
            ),
            EndpointKind.SUBSCRIPTION: (*_of_action("/do", *asked), *_of_action("/a/b", *told)),
        }
    )
    test = InterfaceName("actionlib", "Test")
    assert found == {
        EndpointKind.PUBLISHER: (chatter,),
        EndpointKind.SUBSCRIPTION: (),
        EndpointKind.ACTION_SERVER: (("/do", test),),
        EndpointKind.ACTION_CLIENT: (("/a/b", test),),
    }


def test_some_topics_of_an_action_are_topics() -> None:
    listener = {EndpointKind.SUBSCRIPTION: _of_action("/do", "status", "feedback", "result")}
    assert with_actions(listener) == listener


def test_private_parameters_are_those_below_a_node() -> None:
    tree = {
        "robot": {"speed": 0.5, "arm": {"reach": 2}, "names": ["a"], "gripper": {"mood": "x"}},
        "speed": 3,
    }
    found = private_parameters(tree, ["/robot", "/robot/gripper", "/gone"])
    assert found == {
        "/robot": {
            "~/speed": ParameterDetails("float", 0.5),
            "~/arm/reach": ParameterDetails("int", 2),
            "~/names": ParameterDetails("string_list", ("a",)),
        },
        "/robot/gripper": {"~/mood": ParameterDetails("string", "x")},
    }
