"""Node files in C++ of at most 4 MB that something grows from."""

from __future__ import annotations

from pathlib import Path

import pytest
from limited import Attacker, make_project
from machine import mostly_long

ROS1 = "#include <ros/ros.h>\n#include <std_msgs/String.h>\n"
ROS2 = "#include <rclcpp/rclcpp.hpp>\n"
MAIN = ROS1 + "int main() { ros::NodeHandle n; std::string t;\n"
NODE = ROS2 + 'class A : public rclcpp::Node { A() : Node("a") {\n'
PUBLISH = "n.advertise<std_msgs::String>(t, 1);\n"
CREATE = 'create_publisher<a::msg::B>("p", q);\n'

NODES = {
    "stars": ROS1 + "*" * 3_000_000,
    "parentheses": ROS1 + "int x = " + "(" * 500_000 + "1" + ")" * 500_000 + ";",
    "braces": ROS1 + "void f()" + "{" * 500_000,
    "templates": ROS1 + "A<" * 200_000 + "int" + ">" * 200_000 + " x;",
    "sums": MAIN + "t = " + " + ".join(['"a"'] * 300_000) + ";" + PUBLISH + "}",
    "doubled text": MAIN
    + 'std::string t0 = "a";'
    + "".join(f"std::string t{i} = t{i - 1} + t{i - 1};\n" for i in range(1, 3_000))
    + "t = t2999;"
    + PUBLISH
    + "}",
    "conditionals": "#if X\n" * 100_000 + ROS1 + "#endif\n" * 100_000,
    "branches": ROS1 + "#if X\nint a;\n#else\nint b(\n" * 20_000 + "#endif\n" * 20_000,
    "comments": ROS1 + "/*" * 1_000_000,
    "raw strings": ROS1 + 'R"(' * 500_000,
    "quotes": ROS1 + '"' * 1_000_000,
    "macros": ROS1 + "A_B(\n" * 300_000,
    "macros in macros": "".join(f"#define A{i} A{i - 1} A{i - 1}\n" for i in range(1, 3_000))
    + '#define A0 "a"\n'
    + MAIN
    + "t = A2999;"
    + PUBLISH
    + "}",
    "aliases": ROS1 + "using A = B<A>; using B = A<B>;" + MAIN + "n.advertise<A>(t, 1); }",
    "bases": ROS2
    + "".join(
        f'class N{i} : public N{i - 1} {{ N{i}() : N{i - 1}("a") {{}} }};\n'
        for i in range(1, 3_000)
    ),
    "publishers": MAIN + PUBLISH * 30_000 + "}",
    "one variable": MAIN + ('t = "a";' + PUBLISH) * 20_000 + "}",
    "members": ROS1 + "class A {" + "int a;\n" * 400_000 + "};",
    "callers": ROS1
    + "".join(
        f"void f{i}(ros::NodeHandle& n, std::string t) {{ {PUBLISH}"
        f'  f{i + 1}(n, t + "a"); f{i + 1}(n, t + "b"); }}\n'
        for i in range(1_000)
    ),
    "overloads": ROS1
    + "".join(
        f"void f(ros::NodeHandle& n, std::string t) {{ f(n, t + {i}); {PUBLISH} }}\n"
        for i in range(800)
    )
    + 'int main() { ros::NodeHandle n; f(n, "a"); }',
    "calls": MAIN + "f(1,2);" * 500_000 + "}",
    "fields": ROS1
    + "struct C {"
    + "".join(f'std::string m{i} = "x";' for i in range(5_000))
    + '}; int main() { ros::NodeHandle n; C c{"a"};'
    + "".join(f"n.advertise<std_msgs::String>(c.m{i}, 1);" for i in range(3_900))
    + "}",
    "handles": ROS1
    + "int main() { ros::NodeHandle n0; std::string t;"
    + "".join(f'ros::NodeHandle n{i}(n{i - 1}, "a");\n' for i in range(1, 10_000))
    + "n9999.advertise<std_msgs::String>(t, 1); }",
    "profile": NODE + "rclcpp::QoS q(1);" + ("q.reliable();" + CREATE) * 10_000 + "} };",
    "methods of a profile": NODE
    + "auto q = rclcpp::QoS(1)"
    + ".reliable()" * 100_000
    + f";{CREATE}}} }};",
    "descriptors": NODE
    + "rcl_interfaces::msg::ParameterDescriptor d;"
    + 'd.description = "x"; declare_parameter("p", 1, d);\n' * 10_000
    + "} };",
    "goals": NODE
    + 'x = rclcpp_action::create_client<a::action::B>(this, "x"); o.result_callback = f;\n' * 10_000
    + "} };",
}  # fmt: skip

_QUICK = {"braces", "doubled text"}


@pytest.mark.parametrize("name", mostly_long(NODES, _QUICK))
def test_a_node_ends_with_a_diagnostic(attacker: Attacker, tmp_path: Path, name: str) -> None:
    folder = tmp_path / "project"
    make_project(folder)
    (folder / "known.cpp").write_text(NODES[name])
    attacker.run(folder, "inspect", "known.cpp").check()
