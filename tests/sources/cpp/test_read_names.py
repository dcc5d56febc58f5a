"""Which names the reader of C++ takes from the files, and which it leaves unknown."""

from __future__ import annotations

import pytest
from reading import ROS1, in_main, read

from plastron_tui.model.kinds import EndpointKind

USE = "nh.advertise<std_msgs::String>(t, 1);"

CONSTANTS = [
    ('"a"', "a"),
    ('"a" "b"', "ab"),
    ('"a\\x2f\\142"', "a/b"),
    ('R"(a)"', "a"),
    ('std::string("a") + "/" + "b"', "a/b"),
    ('"j" + std::to_string(1 + 2)', "j3"),
    ("MACRO", "m"),
    ('MACRO "/x"', "m/x"),
    ('"x/" MACRO', "x/m"),
    ("kName", "k"),
    ("space::NAME", "n"),
    ("Topics::IN", "i"),
    ("Topics::OUT", "o"),
    ("name()", "f"),
    ('in("a")', "in/a"),
    ("std::string{kName}", "k"),
    ('x ? "a" : "b"', None),
    ("unknown", None),
    ("ros::this_node::getName()", None),
]

HEAD = """
#define MACRO "m"
constexpr char kName[] = "k";
namespace space { const std::string NAME = "n"; }
struct Topics { static constexpr auto IN = "i"; static const std::string OUT; };
const std::string Topics::OUT = "o";
std::string name() { return "f"; }
std::string in(const std::string& name) { return "in/" + name; }
"""


@pytest.mark.parametrize(("written", "name"), CONSTANTS)
def test_a_constant_is_known(written: str, name: str | None) -> None:
    source = read(
        f"{ROS1}{HEAD}int main() {{ ros::NodeHandle nh;"
        f" nh.advertise<std_msgs::String>({written}, 1); }}"
    )
    assert [each.name for each in source.endpoints] == [name]


VARIABLES = [
    ('std::string t = "a";', ["a"]),
    ('std::string t; t = "a";', ["a"]),
    ('std::string t("a"), u = t + "b"; t = u;', None),
    ('std::string t = "a"; if (x) t = "b";', None),
    ('std::string t = "a"; t += x;', None),
    ('std::string t = "a"; t.append("b");', None),
    ('std::string t = "a"; std::getline(in, t);', None),
    ('std::string t = "a"; in >> t;', None),
    ('std::string t = "a"; change(t);', None),
    ('std::string t = "a"; look(t);', ["a"]),
    ('std::string t; nh.param<std::string>("p", t, "d");', ["[d]"]),
    ('std::string t = "d"; nh.getParam("p", t);', ["[d]"]),
    ('std::string t; nh.getParam("p", t);', None),
    ('auto t = nh.param<std::string>("p", "d");', ["[d]"]),
    ('int n = 1; n++; auto t = "a" + std::to_string(n);', None),
]


@pytest.mark.parametrize(("made", "names"), VARIABLES)
def test_a_variable_has_the_one_value_that_it_gets(made: str, names: list[str] | None) -> None:
    head = "void change(std::string& t); void look(const std::string& t);"
    found = [each for each in in_main(made + USE, head) if each.startswith("publisher")]
    expected = [""] if names is None else [f" {name}" for name in names]
    assert found == [f"publisher{name} std_msgs/String" for name in expected]


FIELDS = [
    ('Limits l{"a", 2};', "a"),
    ('Limits l = {"a"};', "a"),
    ('Limits l{.depth = 2, .name = "a"};', "a"),
    ("Limits l{.depth = 2};", "d"),
    ("Limits l;", "d"),
    ('Limits l{"a"}; l.name = "b";', None),
    ('Made l{"a"};', None),
]


@pytest.mark.parametrize(("made", "name"), FIELDS)
def test_a_member_is_what_braces_give_it(made: str, name: str | None) -> None:
    head = (
        'struct Limits { std::string name = "d"; int depth = 1; };\n'
        'struct Made { Made(const char* n); std::string name = "d"; };\n'
    )
    made += " nh.advertise<std_msgs::String>(l.name, 1);"
    source = read(f"{ROS1}{head}int main() {{ ros::NodeHandle nh; {made} }}")
    assert [each.name for each in source.endpoints] == [name]


FLOW = [
    (f't = "a"; {USE} t = "b"; {USE}', ["a", "b"]),
    (f't = "a"; if (x) {{ t = "b"; {USE} }} {USE}', ["b", None]),
    (f't = "a"; if (x) {{ {USE} }} else {{ t = "b"; }}', ["a"]),
    (f't = "a"; while (x) {{ {USE} t = "b"; }}', [None]),
    (f'while (x) {{ t = "a"; {USE} t = "b"; }}', ["a"]),
    (f't = "a"; t = t + "/b"; {USE}', ["a/b"]),
    (f't = "a"; auto f = [&]() {{ {USE} }}; t = "b";', [None]),
    (f'nh.param("p", t, std::string("a")); {USE} t = "b"; {USE}', [None, "b"]),
    (f't = "a"; if (x) t = "b"; {USE}', [None]),
]


@pytest.mark.parametrize(("body", "names"), FLOW)
def test_a_line_sees_the_value_that_a_variable_has_there(body: str, names: list[str]) -> None:
    source = read(f"{ROS1}int main() {{ ros::NodeHandle nh; std::string t; {body} }}")
    found = [each.name for each in source.endpoints if each.kind is EndpointKind.PUBLISHER]
    assert found == names


CALLED = [
    ('make(nh, "a"); make(nh, "b");', ["a", "b"]),
    ('make(nh, "a");', ["a"]),
    ("make(nh, unknown);", [None]),
    ('for (auto t : {"a", "b"}) make(nh, t);', [None]),
    ("", [None]),
]


@pytest.mark.parametrize(("calls", "names"), CALLED)
def test_a_function_creates_what_its_calls_say(calls: str, names: list[str | None]) -> None:
    source = read(
        f"{ROS1}void make(ros::NodeHandle& nh, const std::string& t) {{ {USE} }}\n"
        f"int main() {{ ros::NodeHandle nh; {calls} }}"
    )
    assert [each.name for each in source.endpoints] == names


OVERLOADS = """
using Heard = std::function<void(int)>;
void make(const std::string& a, Heard heard, int depth = 1) {
  nh.advertise<std_msgs::String>(a + "/heard", depth);
}
void make(const std::string& a, int depth, Heard heard) {
  nh.advertise<std_msgs::String>(a, depth);
}
void make(int number, int depth, Heard heard) {
  nh.advertise<std_msgs::String>(std::to_string(number), depth);
}
"""


def test_a_call_is_that_of_the_overload_that_takes_its_literals() -> None:
    head = f"{ROS1}ros::NodeHandle nh;\n{OVERLOADS}"
    source = read(head + 'int main() { make("a", 1, [](int x) {}); }')
    assert [each.name for each in source.endpoints] == [None, "a", None]
    called = 'int main() { make("a", [](int x) {}); make(7, 1, [](int x) {}); }'
    assert [each.name for each in read(head + called).endpoints] == ["a/heard", None, "7"]


def test_a_number_is_no_function() -> None:
    functions = (
        f"void keep(const std::string& t, std::function<void()> heard) {{ {USE} }}\n"
        f"void keep(const std::string& t, int depth) {{ {USE} }}\n"
    )
    source = read(f'{ROS1}ros::NodeHandle nh;\n{functions}int main() {{ keep("a", 2); }}')
    assert [each.name for each in source.endpoints] == [None, "a"]


OF_HEADER = [
    ("", []),
    ('make(nh, "a");', ["a"]),
    ("inner(nh);", ["b"]),
    ("auto f = &inner;", ["b"]),
]


@pytest.mark.parametrize(("body", "names"), OF_HEADER)
def test_a_function_of_a_header_is_of_the_node_that_runs_it(body: str, names: list[str]) -> None:
    header = (
        f"void make(ros::NodeHandle& nh, const std::string& t) {{ {USE} }}\n"
        'inline void inner(ros::NodeHandle& nh) { make(nh, "b"); }\n'
    )
    text = f'{ROS1}#include "tools.hpp"\nint main() {{ ros::NodeHandle nh; {body} }}'
    assert [each.name for each in read(text, tools=header).endpoints] == names


def test_a_template_creates_what_its_calls_say() -> None:
    source = read(
        f"{ROS1}ros::NodeHandle nh;\n"
        "template<class T> void make(const char* t) { nh.advertise<T>(t, 1); }\n"
        'int main() { make<std_msgs::String>("a"); make<std_msgs::Int8>("b"); }'
    )
    found = [(each.name, str(each.type)) for each in source.endpoints]
    assert found == [("a", "std_msgs/String"), ("b", "std_msgs/Int8")]


LOOPS = [
    ('for (auto t : {"a", "b"})', ["a", "b"]),
    ('std::vector<std::string> v = {"a", "b"}; for (const auto& t : v)', ["a", "b"]),
    ("for (auto t : unknown)", [None]),
]


@pytest.mark.parametrize(("loop", "names"), LOOPS)
def test_a_loop_creates_one_a_turn(loop: str, names: list[str | None]) -> None:
    text = f"{ROS1}int main() {{ ros::NodeHandle nh; {loop} {{ {USE} }} }}"
    assert [each.name for each in read(text).endpoints] == names


def test_what_a_caller_elsewhere_may_give_is_a_guess() -> None:
    text = (
        f"{ROS1}struct A {{ A(ros::NodeHandle nh, ros::NodeHandle pnh) {{\n"
        '  nh.advertise<std_msgs::String>("a", 1); pnh.advertise<std_msgs::String>("b", 1); } };'
    )
    assert [(each.name, each.is_guess) for each in read(text).endpoints] == [
        ("a", True),
        ("~/b", True),
    ]
    known = text + 'int main() { A a(ros::NodeHandle(), ros::NodeHandle("n")); }'
    assert [(each.name, each.is_guess) for each in read(known).endpoints] == [
        ("a", False),
        ("n/b", False),
    ]
