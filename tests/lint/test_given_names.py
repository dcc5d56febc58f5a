"""Names of topics, services and actions that parameters or the name of the node give."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import (
    LISTENER,
    PACKAGE_XML,
    code_of,
    found_in,
    in_python,
    node_of,
    package_of,
)

from plastron_tui.model.source import FileSet, SourceEndpoint
from plastron_tui.sources.cpp.reader import read_cpp
from plastron_tui.sources.python.reader import read_python


def _endpoints(suffix: str, text: str) -> list[SourceEndpoint]:
    read = read_python if suffix == ".py" else read_cpp
    source = read(Path(f"/ws/talker{suffix}"), FileSet.single(suffix, text.encode())).source
    assert source is not None
    found = (each for node in source.nodes for each in node.endpoints)
    return [each for each in found if each.kind.facts.interface is not None]


_RCLPY = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('topic', 'chatter')
        {}
    def later(self):
        {}
"""
_PUB = "self.pub = self.create_publisher(String, {}, 1)"
_VALUE = "self.get_parameter('topic').value"
_IN_RCLPY = {
    "at_once": (_PUB.format(_VALUE), "pass", "topic"),
    "as_a_text": (_PUB.format(f"str({_VALUE})"), "pass", "topic"),
    "in_brackets": (_PUB.format(f"({_VALUE})"), "pass", "topic"),
    "of_a_message": (
        _PUB.format("self.get_parameter('topic').get_parameter_value().string_value"),
        "pass",
        "topic",
    ),
    "of_a_local": (f"topic = {_VALUE}; {_PUB.format('topic')}", "pass", "topic"),
    "of_an_attribute": (f"self.topic = {_VALUE}", _PUB.format("self.topic"), "topic"),
    "where_it_is_declared": (
        _PUB.format("self.declare_parameter('other', 'x').value"),
        "pass",
        "other",
    ),
    "with_more": (_PUB.format(f"{_VALUE} + '/raw'"), "pass", None),
    "in_a_text": (_PUB.format(f"f'{{{_VALUE}}}/raw'"), "pass", None),
    "or_another": (_PUB.format(f"{_VALUE} or 'x'"), "pass", None),
    "changed": (f"self.topic = {_VALUE}; self.topic = 'x'", _PUB.format("self.topic"), None),
    "of_a_name_not_known": (_PUB.format("self.get_parameter(name()).value"), "pass", None),
    "literal": (_PUB.format("'chatter'"), "pass", None),
}


@pytest.mark.parametrize(("made", "later", "parameter"), _IN_RCLPY.values(), ids=_IN_RCLPY)
def test_a_parameter_of_rclpy_gives_a_name(made: str, later: str, parameter: str | None) -> None:
    assert [each.given_by for each in _endpoints(".py", _RCLPY.format(made, later))] == [parameter]


def _chain(definition: str, call: str, first: str, count: int) -> str:
    """Return functions of which each calls the one before several times, with what it gets."""
    made = [definition.format(0, first)]
    made += [definition.format(n, call.format(n - 1) * 16) for n in range(1, count)]
    return "".join(made)


def test_callers_of_callers_of_python_have_an_end() -> None:
    first = "rospy.Publisher(t, String, queue_size=1)"
    text = "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('talker')\n"
    text += _chain("def f{}(t):\n    {}\n", "f{}(t); ", first, 9)
    assert [each.given_by for each in _endpoints(".py", text)] == [None]


def test_callers_of_callers_of_cpp_have_an_end() -> None:
    first = "nh->create_publisher<std_msgs::msg::String>(t, 10);"
    text = "#include <rclcpp/rclcpp.hpp>\n#include <std_msgs/msg/string.hpp>\n"
    text += "std::shared_ptr<rclcpp::Node> nh;\n"
    text += _chain("void f{}(std::string t) {{ {} }}\n", "f{}(t); ", first, 9)
    assert {each.given_by for each in _endpoints(".cpp", text)} <= {None}


_ROSPY = "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('talker')\n{}\n"
_IN_ROSPY = {
    "private": ("rospy.Publisher(rospy.get_param('~topic', 'a'), String)", "~/topic"),
    "of_a_local": (
        "t = rospy.get_param('~topic', 'a')\nrospy.Publisher(t, String)",
        "~/topic",
    ),
    "of_a_call": (
        "def make(name): return rospy.Publisher(name, String)\n"
        "make(rospy.get_param('~topic', 'a'))",
        "~/topic",
    ),
    "shared": ("rospy.Publisher(rospy.get_param('/topic', 'a'), String)", None),
    "of_the_namespace": ("rospy.Publisher(rospy.get_param('topic', 'a'), String)", None),
    "of_the_node": ("rospy.Publisher(rospy.get_name(), String)", "~"),
    "below_the_node": ("rospy.Publisher(rospy.get_name() + '/x', String)", None),
}


@pytest.mark.parametrize(("made", "parameter"), _IN_ROSPY.values(), ids=_IN_ROSPY)
def test_a_parameter_of_rospy_gives_a_name(made: str, parameter: str | None) -> None:
    assert [each.given_by for each in _endpoints(".py", _ROSPY.format(made))] == [parameter]


_RCLCPP = """\
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class Talker : public rclcpp::Node {{
public:
  Talker() : Node("talker") {{
    {}
    pub_ = create_publisher<std_msgs::msg::String>({}, 10);
  }}
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
  std::string topic_;
}};
"""
_GET = 'get_parameter("topic")'
_IN_RCLCPP = {
    "at_once": ("", f"{_GET}.as_string()", "topic"),
    "of_a_type": ("", f"{_GET}.get_value<std::string>()", "topic"),
    "where_it_is_declared": ("", 'declare_parameter<std::string>("topic", "a")', "topic"),
    "of_a_local": (f"auto topic = {_GET}.as_string();", "topic", "topic"),
    "of_a_parameter_that_is_held": (f"auto held = {_GET};", "held.as_string()", "topic"),
    "read_into_a_local": ('std::string t = "a"; get_parameter("topic", t);', "t", "topic"),
    "of_a_member": (f"topic_ = {_GET}.as_string();", "topic_", "topic"),
    "with_more": ("", f'{_GET}.as_string() + "/raw"', None),
    "changed": (f'topic_ = {_GET}.as_string(); topic_ += "/raw";', "topic_", None),
    "in_a_sub_node": (
        f"auto topic = {_GET}.as_string(); auto sub = create_sub_node(\"arm\");"
        "sub->create_publisher<std_msgs::msg::String>(topic, 10);",
        '"a"',
        None,
    ),
}  # fmt: skip


@pytest.mark.parametrize(("before", "name", "parameter"), _IN_RCLCPP.values(), ids=_IN_RCLCPP)
def test_a_parameter_of_rclcpp_gives_a_name(before: str, name: str, parameter: str | None) -> None:
    found = _endpoints(".cpp", _RCLCPP.format(before, name))
    assert found[0].given_by == parameter


_ROSCPP = """\
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <actionlib/server/simple_action_server.h>
#include <demo/DoAction.h>
class Server {{
public:
  Server(std::string name) : server_(nh_, name, false), name_(name) {{}}
  ros::NodeHandle nh_;
  actionlib::SimpleActionServer<demo::DoAction> server_;
  std::string name_;
}};
int main(int argc, char** argv) {{
  ros::init(argc, argv, "talker");
  ros::NodeHandle nh, pnh("~");
  std::string t;
  {}
}}
"""
_ADVERTISE = "nh.advertise<std_msgs::String>(t, 1);"
_IN_ROSCPP = {
    "read_into": ('pnh.param<std::string>("topic", t, "a"); ' + _ADVERTISE, "~/topic"),
    "given_back": (
        'nh.advertise<std_msgs::String>(pnh.param<std::string>("topic", "a"), 1);',
        "~/topic",
    ),
    "private_by_its_name": (
        'ros::param::param<std::string>("~topic", t, "a"); ' + _ADVERTISE,
        "~/topic",
    ),
    "of_the_namespace": ('nh.param<std::string>("topic", t, "a"); ' + _ADVERTISE, None),
    "within_the_node": (
        'pnh.param<std::string>("topic", t, "a"); pnh.advertise<std_msgs::String>(t, 1);',
        None,
    ),
    "of_the_node": ("Server server(ros::this_node::getName());", "~"),
    "of_the_node_that_is_held": ("t = ros::this_node::getName(); Server server(t);", "~"),
    "of_another": ("Server server(name_of(argv));", None),
}  # fmt: skip


@pytest.mark.parametrize(("made", "parameter"), _IN_ROSCPP.values(), ids=_IN_ROSCPP)
def test_a_parameter_of_roscpp_gives_a_name(made: str, parameter: str | None) -> None:
    found = _endpoints(".cpp", _ROSCPP.format(made))
    assert {each.given_by for each in found} - {None} == {parameter} - {None}


_SERVERS = {
    "of_its_own_handle": ('Server() : nh_("~"), as_(nh_, "fix", false)', "Server s;", "~/fix"),
    "named_by_main": (
        'Server(const std::string name) : nh_("~"), as_(nh_, name, false)',
        'Server s("fix");',
        "~/fix",
    ),
    "not_named": (
        'Server(const std::string name) : nh_("~"), as_(nh_, name, false)',
        "Server s(argv[1]);",
        None,
    ),
}


@pytest.mark.parametrize(("constructor", "made", "name"), _SERVERS.values(), ids=_SERVERS)
def test_a_handle_is_no_name_of_a_server(constructor: str, made: str, name: str | None) -> None:
    text = (
        "#include <ros/ros.h>\n#include <actionlib/server/simple_action_server.h>\n"
        f"#include <demo/DoAction.h>\nclass Server {{ public: {constructor} {{}}\n"
        "ros::NodeHandle nh_; actionlib::SimpleActionServer<demo::DoAction> as_; };\n"
        f'int main(int argc, char** argv) {{ ros::init(argc, argv, "n"); {made} }}\n'
    )
    assert [each.name for each in _endpoints(".cpp", text)] == [name]


_NAMED = code_of(LISTENER, before="self.declare_parameter('topic', 'chater')", topic="{}").replace(
    "'{}'", "self.get_parameter('topic').value"
)
_TOLD = [("RG104", "listener.py", 10)]


def _launch(*words: str) -> str:
    return in_python(node_of("talker"), node_of("listener", *words))


_YAML = "/**:\n  ros__parameters:\n    {}: chatter\n"
_STARTED: dict[str, tuple[dict[str, str | bytes], list[tuple[str, str, int]]]] = {
    "with_the_default": (package_of(listener=_NAMED, x_py=_launch()), _TOLD),
    "by_hand": (package_of(listener=_NAMED), _TOLD),
    "with_the_right_value": (
        package_of(listener=_NAMED, x_py=_launch("parameters=[{'topic': 'chatter'}]")),
        [],
    ),
    "with_another_slip": (
        package_of(listener=_NAMED, x_py=_launch("parameters=[{'topic': 'chattter'}]")),
        _TOLD,
    ),
    "with_another_parameter": (
        package_of(listener=_NAMED, x_py=_launch("parameters=[{'rate': 5}]")),
        _TOLD,
    ),
    "with_a_value_not_known": (
        package_of(listener=_NAMED, x_py=_launch("parameters=[{'topic': topic_of()}]")),
        [],
    ),
    "with_an_argument_not_known": (
        package_of(
            listener=_NAMED,
            x_py=in_python("DeclareLaunchArgument('n', default_value=topic_of())")
            .replace("),\n])", "),\n    LogInfo(msg='x'),\n    " + node_of("talker") + ",\n    "
                     + node_of("listener") + ",\n])"),
        ),
        _TOLD,
    ),
    "with_a_number": (
        package_of(listener=_NAMED, x_py=_launch("parameters=[{'topic': 5}]")),
        [],
    ),
    "with_a_file_not_known": (
        package_of(listener=_NAMED, x_py=_launch("parameters=[file_of()]")),
        [],
    ),
    "on_the_command_line": (
        package_of(
            listener=_NAMED,
            x_py=_launch("arguments=['--ros-args', '-p', 'topic:=chatter']"),
        ),
        [],
    ),
    "set_for_all": (
        package_of(
            listener=_NAMED,
            x_py=in_python(
                "SetParameter('topic', topic_of())", node_of("talker"), node_of("listener")
            ),
        ),
        [],
    ),
    "known_in_one_of_two_files": (
        package_of(
            listener=_NAMED,
            x_py=_launch(),
            y_py=_launch("parameters=[{'topic': topic_of()}]"),
        ),
        [],
    ),
    "by_hand_with_a_file": (
        package_of(listener=_NAMED) | {"demo/config/p.yaml": _YAML.format("topic")},
        [],
    ),
    "by_hand_with_a_file_of_others": (
        package_of(listener=_NAMED) | {"demo/config/p.yaml": _YAML.format("rate")},
        _TOLD,
    ),
}  # fmt: skip


@pytest.mark.parametrize(("files", "expected"), _STARTED.values(), ids=_STARTED)
def test_a_name_is_what_a_parameter_is_for_sure(
    tmp_path: Path, files: dict[str, str | bytes], expected: list[tuple[str, str, int]]
) -> None:
    assert found_in(tmp_path, files, "RG104") == expected


_XML_1 = PACKAGE_XML.replace("ament_python", "catkin")
_TALKER_1 = (
    "#!/usr/bin/env python3\nimport rospy\nfrom std_msgs.msg import String\n"
    "rospy.init_node('talker')\npub = rospy.Publisher('chatter', String, queue_size=1)\n"
    "rospy.spin()\n"
)
_LISTENER_1 = (
    "#!/usr/bin/env python3\nimport rospy\nfrom std_msgs.msg import String\n"
    "rospy.init_node('listener')\n"
    "rospy.Subscriber(rospy.get_param('~topic', 'chater'), String, print)\nrospy.spin()\n"
)
_STARTED_1 = {
    "with_the_default": ("", "", "", True),
    "with_the_right_value": ("", "", '<param name="topic" value="chatter"/>', False),
    "with_another_slip": ("", "", '<param name="topic" value="chattter"/>', True),
    "on_the_command_line": ("", 'args="_topic:=chatter"', "", False),
    "by_an_element_not_known": ("", "", '<param if="$(arg x)" name="topic" value="y"/>', False),
    "by_a_text": ("", "", "<rosparam>topic: chatter</rosparam>", False),
    "by_a_file": ("", "", '<rosparam file="$(find demo)/p.yaml"/>', False),
    "from_outside": ('<param name="listener/topic" value="chatter"/>', "", "", False),
    "by_a_file_from_outside": ('<rosparam file="$(find demo)/p.yaml"/>', "", "", False),
    "of_another_name_from_outside": ('<param name="rate" value="5"/>', "", "", True),
}


@pytest.mark.parametrize(
    ("before", "words", "within", "is_told"), _STARTED_1.values(), ids=_STARTED_1
)
def test_a_launch_file_of_ros_1_gives_a_name(
    tmp_path: Path, before: str, words: str, within: str, is_told: bool
) -> None:
    launch = (
        f'<launch>{before}<node pkg="demo" type="talker.py" name="talker"/>'
        f'<node pkg="demo" type="listener.py" name="listener" {words}>{within}</node></launch>'
    )
    files: dict[str, str | bytes] = {
        "demo/package.xml": _XML_1,
        "demo/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        "demo/scripts/talker.py": _TALKER_1,
        "demo/scripts/listener.py": _LISTENER_1,
        "demo/launch/x.launch": launch,
    }
    told = [("RG104", "listener.py", 5)] if is_told else []
    assert found_in(tmp_path, files, "RG104") == told
