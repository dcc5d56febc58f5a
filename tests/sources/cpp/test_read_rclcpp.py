"""What creates an endpoint in rclcpp and its friends, and what its nodes are."""

from __future__ import annotations

import pytest
from reading import ROS2, endpoints, in_node, read

from plastron_tui.model.endpoint_details import ParameterDetails, Range, TimerDetails
from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos

S = "std_msgs::msg::String"
STRING = "std_msgs/String"

CALLS = [
    (f'create_publisher<{S}>("a", 1);', [f"publisher a {STRING}"]),
    (f'this->create_publisher<{S}>("a", 1);', [f"publisher a {STRING}"]),
    (f'rclcpp::create_publisher<{S}>(*this, "a", 1);', [f"publisher a {STRING}"]),
    (
        f'create_subscription<{S}>("a", 1, std::bind(&A::cb, this, _1));',
        [f"subscription a {STRING} cb"],
    ),
    (f'create_subscription<{S}>("a", 1, [](const {S}& m) {{}});', [f"subscription a {STRING}"]),
    ('create_generic_publisher("a", "std_msgs/msg/String", 1);', [f"publisher a {STRING}"]),
    ('create_service<std_srvs::srv::Empty>("a", f);', ["service a std_srvs/Empty f"]),
    ('create_client<std_srvs::srv::Empty>("a");', ["client a std_srvs/Empty"]),
    ("create_wall_timer(1s, std::bind(&A::tick, this));", ["timer tick"]),
    ('declare_parameter("a", 1);', ["parameter a"]),
    ('declare_parameters("n", {{"a", 1}, {"b", 2}});', ["parameter n.a", "parameter n.b"]),
    ('get_parameter("a").as_int();', ["parameter a"]),
    (
        'rclcpp_action::create_server<a_msgs::action::Foo>(this, "a", g, c, d);',
        ["action server a a_msgs/Foo"],
    ),
    (
        "rclcpp_action::create_client<a_msgs::action::Foo>(get_node_base_interface(),"
        ' get_node_graph_interface(), get_node_logging_interface(), waitables_interface, "a");',
        ["action client a a_msgs/Foo"],
    ),
    (
        f'std::make_shared<message_filters::Subscriber<{S}>>(this, "a");',
        [f"subscription a {STRING}"],
    ),
    (
        f'{S} m; rclcpp::wait_for_message<{S}>(m, shared_from_this(), "a", 1s);',
        [f"subscription a {STRING}"],
    ),
    (f'{S} m; rclcpp::wait_for_message(m, node, "a");', [f"subscription a {STRING}"]),
    (
        'get_node_parameters_interface()->declare_parameter("a", rclcpp::ParameterValue(1));',
        ["parameter a"],
    ),
    (
        "std::shared_ptr<rclcpp::node_interfaces::NodeParametersInterface> p;"
        ' p->declare_parameter("a", rclcpp::ParameterValue(1));',
        ["parameter a"],
    ),
    (
        'image_transport::create_publisher(this, "a");',
        ["publisher a sensor_msgs/Image"],
    ),
    (
        'auto arm = create_sub_node("arm"); arm->create_client<std_srvs::srv::Empty>("a");',
        ["client arm/a std_srvs/Empty"],
    ),
]


@pytest.mark.parametrize(("body", "expected"), CALLS)
def test_a_call_creates(body: str, expected: list[str]) -> None:
    assert in_node(body) == expected


TYPES = [
    ("using T = std_msgs::msg::String;", "T", STRING),
    ("typedef std_msgs::msg::String T;", "T", STRING),
    ("namespace m = std_msgs::msg; using T = m::String;", "T", STRING),
    ("using namespace std_msgs::msg;", "String", STRING),
    ("using std_msgs::msg::String;", "String", STRING),
    ("#define T std_msgs::msg::String\n", "T", STRING),
    ("using T = rclcpp::TypeAdapter<std::string, std_msgs::msg::String>;", "T", STRING),
    ("struct T {};", "T", None),
    ("", "Unknown", None),
]


@pytest.mark.parametrize(("head", "written", "type_"), TYPES)
def test_a_type_is_what_it_stands_for(head: str, written: str, type_: str | None) -> None:
    expected = "publisher a" if type_ is None else f"publisher a {type_}"
    assert in_node(f'create_publisher<{written}>("a", 1);', head=head) == [expected]


QOS = [
    ("7", DEFAULT._replace(depth=7)),
    ("rclcpp::QoS(7).best_effort()", DEFAULT._replace(depth=7, reliability="best_effort")),
    ("rclcpp::SensorDataQoS()", PROFILES["sensor_data"]),
    ("rclcpp::SystemDefaultsQoS()", PROFILES["system_default"]),
    ("rclcpp::QoS(rclcpp::KeepAll())", DEFAULT._replace(history="keep_all", depth=None)),
    ("q", DEFAULT._replace(depth=3, durability="transient_local")),
    ("rclcpp::QoS(1).deadline(500ms)", DEFAULT._replace(depth=1, deadline=0.5)),
    (
        "rclcpp::QoS(1).reliability(rclcpp::ReliabilityPolicy::BestEffort)",
        DEFAULT._replace(depth=1, reliability="best_effort"),
    ),
    ("unknown()", None),
]


@pytest.mark.parametrize(("written", "qos"), QOS)
def test_a_quality_of_service_is_read(written: str, qos: Qos | None) -> None:
    body = f'rclcpp::QoS q(3); q.transient_local(); create_publisher<{S}>("a", {written});'
    source = read(f'{ROS2}class A : public rclcpp::Node {{ A() : Node("a") {{ {body} }} }};')
    assert [each.qos for each in source.endpoints] == [qos]


PERIODS = [
    ("500ms", 0.5),
    ("std::chrono::milliseconds(20)", 0.02),
    ("std::chrono::duration<double>(1.0 / 4)", 0.25),
    ("std::chrono::duration<double, std::milli>(2.5)", 0.0025),
    ("1s / 4", 0.25),
    ("rclcpp::Rate(8).period()", 0.125),
    ("period", 2.0),
    ("unknown", None),
]


@pytest.mark.parametrize(("written", "seconds"), PERIODS)
def test_a_period_is_in_seconds(written: str, seconds: float | None) -> None:
    body = f"const auto period = std::chrono::seconds(2); create_wall_timer({written}, f);"
    source = read(f'{ROS2}class A : public rclcpp::Node {{ A() : Node("a") {{ {body} }} }};')
    (details,) = (each.details for each in source.endpoints)
    assert isinstance(details, TimerDetails)
    assert details.period == seconds


TICK, TOCK = "std::bind(&A::tick, this)", "std::bind(&A::tock, this)"
RECREATED = [
    (f"t_ = create_wall_timer(p, {TICK}); t_ = create_wall_timer(2s, {TICK});", ["tick 2.0"]),
    (f"t_ = create_wall_timer(1s, {TICK}); this->t_ = create_timer(p, {TICK});", ["tick 1.0"]),
    (
        "t_ = create_wall_timer(1s, [this]{f();}); t_ = create_timer(p, [this] {f();});",
        ["None 1.0"],
    ),
    (
        f"t_ = create_wall_timer(1s, {TICK}); u_ = create_timer(p, {TICK});",
        ["tick 1.0", "tick None"],
    ),
    (
        f"t_ = create_wall_timer(1s, {TICK}); t_ = create_timer(p, {TOCK});",
        ["tick 1.0", "tock None"],
    ),
    (
        f"l_[0] = create_wall_timer(1s, {TICK}); l_[1] = create_timer(p, {TICK});",
        ["tick 1.0", "tick None"],
    ),
    (
        f"m_[k] = create_wall_timer(1s, {TICK}); m_[j] = create_timer(p, {TICK});",
        ["tick 1.0", "tick None"],
    ),
]


@pytest.mark.parametrize(("body", "expected"), RECREATED)
def test_a_timer_that_is_created_again_is_one(body: str, expected: list[str]) -> None:
    members = (
        "rclcpp::TimerBase::SharedPtr t_, u_; std::vector<rclcpp::TimerBase::SharedPtr> l_; "
        "std::map<std::string, rclcpp::TimerBase::SharedPtr> m_; void tick() {} void tock() {}"
    )
    made, _, again = body.partition("; ")
    source = read(
        f'{ROS2}class A : public rclcpp::Node {{ A() : Node("a") {{ {made}; }}\n'
        f"void change() {{ {again} }} {members} }};"
    )
    found = [(each.callback, each.details) for each in source.endpoints]
    assert [f"{name} {getattr(details, 'period', None)}" for name, details in found] == expected


PARAMETERS = [
    ('declare_parameter("p", 1.5)', ParameterDetails("float", 1.5, "1.5")),
    ('declare_parameter<double>("p", 2)', ParameterDetails("float", 2.0, "2")),
    ('declare_parameter<std::string>("p")', ParameterDetails("string")),
    ('declare_parameter("p", rclcpp::PARAMETER_BOOL)', ParameterDetails("bool")),
    (
        'declare_parameter("p", std::vector<int64_t>{1, 2})',
        ParameterDetails("int_list", (1, 2), "std::vector<int64_t>{1, 2}"),
    ),
    ('get_parameter("p").as_double()', ParameterDetails("float")),
    (
        'declare_parameter("p", 1, d)',
        ParameterDetails("int", 1, "1", Range(0, 9, 3), "how many", True),
    ),
]


@pytest.mark.parametrize(("written", "expected"), PARAMETERS)
def test_a_parameter_is_described(written: str, expected: ParameterDetails) -> None:
    body = (
        'rcl_interfaces::msg::ParameterDescriptor d; d.description = "how many";'
        "d.read_only = true; d.integer_range.resize(1); d.integer_range[0].from_value = 0;"
        "d.integer_range[0].to_value = 9; d.integer_range[0].step = 3;"
    )
    text = f'{ROS2}class A : public rclcpp::Node {{ A() : Node("a") {{ {body} {written}; }} }};'
    assert [each.details for each in read(text).endpoints] == [expected]


def test_a_component_says_so() -> None:
    text = (
        f'{ROS2}class A : public rclcpp::Node {{ A(rclcpp::NodeOptions o) : Node("a", o) {{}} }};'
    )
    assert read(text).library == "rclcpp"
    assert read(f"{text}\nRCLCPP_COMPONENTS_REGISTER_NODE(A)\n").library == "component"


NODES = [
    ('class A : public rclcpp::Node { A() : Node("a") {} };', [("a", "A")]),
    ('auto n = rclcpp::Node::make_shared("a");', [("a", None)]),
    ('auto n = std::make_shared<rclcpp::Node>("a");', [("a", None)]),
    (
        "class A : public rclcpp::Node { A(std::string n) : Node(n) {} };"
        'void f() { std::make_shared<A>("a"); }',
        [("a", "A")],
    ),
    (
        "class A : public rclcpp::Node { A(std::string n) : Node(n) {} };"
        'class B : public A { B() : A("b") {} };',
        [(None, "A"), ("b", "B")],
    ),
]


@pytest.mark.parametrize(("text", "nodes"), NODES)
def test_a_node_has_the_name_that_its_file_gives(text: str, nodes: list[tuple[str, str]]) -> None:
    found = read(ROS2 + text).nodes
    assert [(node.name, node.class_name) for node in found] == nodes


def test_a_managed_node_makes_its_endpoints_in_transitions() -> None:
    text = (
        "#include <rclcpp_lifecycle/lifecycle_node.hpp>\n"
        "class A : public rclcpp_lifecycle::LifecycleNode {\n"
        f'  A() : LifecycleNode("a") {{ create_publisher<{S}>("b", 1); }}\n'
        f'  CallbackReturn on_configure(const State&) {{ create_publisher<{S}>("c", 1); set(); }}\n'
        f'  void set() {{ create_publisher<{S}>("d", 1); }}\n'
        "};"
    )
    (node,) = read(text).nodes
    assert node.is_managed
    found = {each.name: each.transition for each in node.endpoints}
    assert found == {"b": None, "c": "on_configure", "d": "on_configure"}


@pytest.mark.parametrize(
    "body",
    [
        "client->get_parameter(1);",
        "struct B { template<class T> void create_publisher(int); } b; b.create_publisher<C>(1);",
        'factory.create_client("a");',
    ],
)
def test_what_only_looks_like_one_is_none(body: str) -> None:
    assert in_node(body) == []


def test_a_class_that_is_declared_elsewhere_is_a_node_as_it_creates_what_has_a_type() -> None:
    text = f'void A::f() {{ create_publisher<{S}>("a", 1); declare_parameter("b", 1); }}'
    assert endpoints(ROS2 + text) == [f"publisher a {STRING}", "parameter b"]
    assert endpoints(ROS2 + 'void A::f() { declare_parameter("b", 1); }') == []


def test_a_function_that_makes_a_node_creates_for_it() -> None:
    text = (
        "class A : public Base { A() : Base() {} static std::shared_ptr<A> make(); };\n"
        "std::shared_ptr<A> A::make() { auto n = std::shared_ptr<A>(new A());\n"
        f'  n->create_publisher<{S}>("a", 1); return n; }}'
    )
    assert endpoints(ROS2 + text) == [f"publisher a {STRING}"]


def test_a_header_has_a_part_of_a_node() -> None:
    header = (
        "class A : public rclcpp::Node {\n"
        f'  void cb(const {S}& m);\n  std::string topic_ = "a";\n'
        f'  void f() {{ create_publisher<{S}>("b", 1); }}\n  A();\n}};\n'
    )
    text = (
        f'{ROS2}#include "a.hpp"\nA::A() : Node("n") {{\n'
        f"  create_subscription<{S}>(topic_, 1, std::bind(&A::cb, this, _1));\n}}\n"
    )
    (node,) = read(text, a=header).nodes
    assert [(each.name, each.file) for each in node.endpoints] == [("a", ""), ("b", "a.hpp")]
    assert endpoints(text, a=header)[0] == f"subscription a {STRING} cb"
