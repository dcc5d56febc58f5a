"""Small texts of C++ and what is read from them."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.model.source import FileSet, SourceEndpoint, SourceUnit
from plastron_tui.sources import find_language

ROS1 = "#include <ros/ros.h>\n#include <std_msgs/String.h>\n"
ROS2 = '#include "rclcpp/rclcpp.hpp"\n#include "std_msgs/msg/string.hpp"\n'


def read(text: str, **others: str) -> SourceUnit:
    """Read a file with headers, which are `x.hpp` for the keyword `x`."""
    headers = tuple((f"{name}.hpp", each.encode()) for name, each in others.items())
    files = FileSet((("{}.cpp", text.encode()), *headers))
    source = find_language("cpp").read(Path("x.cpp"), files).source
    assert source is not None
    return source


def told(endpoint: SourceEndpoint) -> str:
    """Return what there is to say of an endpoint, in the order of a sentence."""
    name = endpoint.name
    if name is None and endpoint.default is not None:
        name = f"[{endpoint.default}]"
    type_ = None if endpoint.type is None else str(endpoint.type)
    parts = [endpoint.kind.word, name, type_, endpoint.callback]
    return " ".join(each for each in parts if each) + ("?" if endpoint.is_guess else "")


def endpoints(text: str, **others: str) -> list[str]:
    """Return what there is to say of the endpoints of a file."""
    return [told(each) for each in read(text, **others).endpoints]


def in_main(body: str, head: str = "") -> list[str]:
    """Return the endpoints of a `main` of ROS 1."""
    return endpoints(f"{ROS1}{head}\nint main() {{ ros::NodeHandle nh; {body} }}\n")


def in_node(body: str, members: str = "", head: str = "") -> list[str]:
    """Return the endpoints of a node of ROS 2, with members and what stands before it."""
    return endpoints(
        f"{ROS2}{head}\nclass A : public rclcpp::Node {{\n"
        f'public:\n  A() : Node("a") {{ {body} }}\n  {members}\n}};\n'
    )
