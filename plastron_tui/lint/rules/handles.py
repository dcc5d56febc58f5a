"""What is wrong with handles that C++ destroys where nobody keeps them."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Code, Diagnostic
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import SourceTree
from plastron_tui.model.code_facts import Dropped

_LISTENER = """\
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

class Listener : public rclcpp::Node
{{
public:
  Listener()
  : Node("listener")
  {{
    {kept}create_subscription<std_msgs::msg::String>(
      "chatter", 10, [this](std_msgs::msg::String::ConstSharedPtr msg) {{
        RCLCPP_INFO(get_logger(), "%s", msg->data.c_str());
      }});
  }}

private:
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Listener>());
  rclcpp::shutdown();
}}
"""


@rule(
    "RC406",
    "dropped-handle",
    "Nobody keeps the handle of an endpoint, or of a parameter callback, in C++: it ends at once.",
    why="In rclcpp and roscpp a subscription, a service, a timer or a publisher lives as long as "
    "what its creation returns: the node keeps none of them. Without a variable that lasts, it is "
    "destroyed at the end of the statement, or of the function, without a word, and its callback "
    "is never called. So it is with parameter callbacks of rclcpp: a node, or a "
    "`ParameterEventHandler`, only has a weak pointer to what adding them returns. Not told where "
    "a variable is handed on, nor where the function that has it may go on while the node runs. "
    "rclpy and rospy keep the endpoints of a node themselves.",
    bad={"listener.cpp": _LISTENER.format(kept="")},
    good={"listener.cpp": _LISTENER.format(kept="sub_ = ")},
)
def dropped_handle(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find endpoints that end as soon as they are made."""
    for unit in tree.built:
        for each in () if unit.is_test else unit.code.dropped:
            yield Diagnostic(
                code,
                f"nobody keeps the {_role(each)}: it ends at once",
                each.span,
                unit.file(each.file),
                help="keep it in a member of the class, or in a variable of `main`",
            )


def _role(fact: Dropped) -> str:
    if fact.kind is None:
        return "handle of the parameter callback"
    return fact.kind.name.lower().replace("_", " ")
