"""From rospy to rclpy: parameters, which a node of ROS 2 declares before it reads them."""

from __future__ import annotations

from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.syntax import parts_of

from .kinds import LIST, kind_of
from .port_state import Work
from .rclpy_node import has_node

_CALLS = ("rospy.get_param", "rospy.has_param", "rospy.set_param")
_OF_ALL = frozenset({"robot_description", "use_sim_time", "run_id", "rosdistro"})
"""Parameters that a launch of ROS 1 sets for all nodes, by relative names as well."""

_DESCRIPTOR = "from rcl_interfaces.msg import ParameterDescriptor"

_DECLARE = """\
def {declare}(name, default=None):
    \"\"\"Declare a parameter once; it may be of any type, as in rospy.\"\"\"
    if not {node}.has_parameter(name):
        any_type = ParameterDescriptor(dynamic_typing=True)
        {node}.declare_parameter(name, default, any_type)
"""
_GET = """\
def {get}(name, *default):
    \"\"\"Return a parameter; one that is not set is a KeyError.\"\"\"
    {declare}(name, *default)
    value = {node}.get_parameter(name).value
    if value is None and not default:
        raise KeyError(name)
    return value
"""
_HAS = """\
def {has}(name):
    \"\"\"Tell whether a parameter is set.\"\"\"
    {declare}(name)
    return {node}.get_parameter(name).value is not None
"""
_SET = """\
def {set}(name, value):
    \"\"\"Set a parameter.\"\"\"
    {declare}(name)
    {node}.set_parameters([Parameter(name, value=value)])
"""


@dataclass(frozen=True, slots=True)
class _Use:
    """A call that reads or sets the parameter of a name; `name` is as ROS 2 writes it."""

    call: Node
    callee: Node
    function: str
    given: Node
    name: str
    value: Node | None


def port_parameters(work: Work, node: str) -> None:
    """Rewrite what reads and sets the node's own parameters, by functions that declare them.

    ROS 2 has no parameters of all nodes, so that absolute names stay, and so do relative names
    that are set, which other nodes read.
    """
    uses = [
        use
        for call in reversed(work.analysis.captures.get("call", []))
        if not work.is_gone(call) and (use := _use(work, call)) is not None
    ]
    # What is declared with a default is there for ROS 2, though nobody has set it.
    defaults = {
        use.name for use in uses if use.function == "rospy.get_param" and use.value is not None
    }
    ported = [use for use in uses if use.function != "rospy.has_param" or use.name not in defaults]
    if not ported:
        return
    names = {word: work.free_name(f"{word}_param") for word in ("declare", "get", "has", "set")}
    for use in ported:
        word = use.function.removeprefix("rospy.").removesuffix("_param")
        quote = work.slice(use.given)[-1]
        work.replace(use.callee, names[word])
        work.done.add(use.call.id)
        work.replace(use.given, f"{quote}{use.name}{quote}")
    functions = {use.function for use in ported}
    helpers = [_DECLARE]
    helpers += [
        text for name, text in zip(_CALLS, (_GET, _HAS, _SET), strict=True) if name in functions
    ]
    work.helpers += [each.format(node=node, **names) for each in helpers]
    work.imports.add(_DESCRIPTOR)
    if "rospy.set_param" in functions:
        work.imports.add("from rclpy.parameter import Parameter")


def _use(work: Work, call: Node) -> _Use | None:
    """Return what a call does with a parameter, None where it has to stay."""
    callee = call.child_by_field_name("function")
    names = set(work.qualified(callee)) if callee is not None else set()
    function = next((each for each in _CALLS if names == {each}), None)
    if callee is None or function is None or not has_node(work, call):
        return None
    arguments = Arguments.of(call, work.analysis.syntax)
    listed = parts_of(call.child_by_field_name("arguments"))
    given = arguments.get(Argument(0, "param_name"))
    word = "default" if function == "rospy.get_param" else "param_value"
    value = arguments.get(Argument(1, word))
    if arguments.is_open or given is None or len(listed) != 1 + (value is not None):
        return None
    if any(each.type == "keyword_argument" for each in listed):
        return None
    name = _name(work.slice(given)) if given.type == "string" else None
    if name is None or (function == "rospy.set_param" and "~" not in work.slice(given)):
        return None
    if value is not None and not _is_parameter(work, value):
        return None
    return _Use(call, callee, function, given, name, value)


def _name(source: str) -> str | None:
    """Return the name that ROS 2 has for that in a literal, None for one of all nodes."""
    if source[0] not in "\"'" or source[:3] in ('"""', "'" * 3):
        return None
    name = source[1:-1].removeprefix("~").removeprefix("/")
    is_global = source[1:2] == "/"
    is_name = (
        name not in _OF_ALL and bool(name) and all(part.isidentifier() for part in name.split("/"))
    )
    return name.replace("/", ".") if is_name and not is_global else None


def _is_parameter(work: Work, value: Node) -> bool:
    """Tell whether ROS 2 may have a parameter of a value: one of no dictionary, and no mixture."""
    if value.type in ("list", "tuple"):
        kinds = {kind_of(work, each) for each in parts_of(value)}
        return len(kinds) == 1 and kinds <= {"str", "int", "float", "bool"}
    return kind_of(work, value) not in ("dict", LIST)
