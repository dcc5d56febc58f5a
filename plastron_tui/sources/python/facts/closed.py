"""Whether all that creates the endpoints of a file's nodes is read with the file."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.imports import is_interface_module
from plastron_tui.sources.python.scopes import Scope

from .base_files import Base, read_bases

_KEEPS_TO_ITSELF = frozenset(
    {
        "add_node", "bool", "destroy_node", "getattr", "hasattr", "id", "isinstance", "len",
        "print", "remove_node", "repr", "setattr", "spin", "spin_once",
        "spin_until_future_complete", "str", "super", "type", "vars",
    }
)  # fmt: skip
"""What is called with a node and creates nothing on it: functions of Python and of rclpy."""

_KNOWN_MODULES = sys.stdlib_module_names | {
    *("Queue", "StringIO", "Tkinter", "cPickle", "commands", "httplib", "urllib2", "urlparse"),
    *("PIL", "cv2", "keras", "matplotlib", "numpy", "np", "pandas", "psutil", "pygame", "requests"),
    *("scipy", "serial", "simplejson", "six", "sklearn", "skimage", "tensorflow", "torch", "yaml"),
    *("RPi", "pexpect", "pynput", "smbus", "smbus2", "termcolor", "future", "past", "builtins"),
    *("bluepy", "bson", "cStringIO", "cv", "evdev", "flask", "imutils", "joblib", "mpl_toolkits"),
    *("networkx", "pyaudio", "pylab", "pymavlink", "pymongo", "pyquaternion", "pytesseract"),
    *("pyzbar", "rtree", "sfml", "shapely", "sympy", "thread", "tqdm", "wiringpi2", "xmlrpclib"),
    *("actionlib", "angles", "cv_bridge", "diagnostic_updater", "dynamic_reconfigure", "genpy"),
    *("image_geometry", "laser_geometry", "message_filters", "ros_numpy", "rosbag", "rosgraph"),
    *("roslib", "rospkg", "rospy", "rosservice", "rostopic", "sensor_msgs", "smach", "smach_ros"),
    *("tf", "tf2_geometry_msgs", "tf2_py", "tf2_ros", "tf_conversions", "transforms3d"),
    *("PyKDL", "std_msgs", "geometry_msgs"),
}
"""Modules that create no topic or service but those that are read, and those of their own."""

_HOLDING = frozenset(
    {
        "conditional_expression", "dictionary", "expression_list", "list", "list_splat",
        "named_expression", "pair", "parenthesized_expression", "set", "tuple",
    }
)  # fmt: skip
"""What is made of values, and has each of them."""

_NODE_NAME = re.compile(r"(?:self\.)?_?(?:\w*_)?node")
"""What people call a node that a function was given."""


def is_closed(analysis: Analysis) -> bool:
    """Tell whether no node of a file is handed to code of other files that may create more.

    So it is not where a class has a base that is not read, where a node is an argument of what the
    file does not define, where the node comes from another file, or where a part of the text does
    not parse.
    """
    if analysis.library.node_classes and not analysis.nodes:
        return False
    bases = read_bases(analysis)
    if analysis.syntax.errors or bases is None:
        return False
    if analysis.library.ros_version == 1 and not _calls_known_modules(analysis):
        return False
    return not hands_out(bases) and not any(True for _ in handed_out(analysis))


def hands_out(bases: Iterable[Base]) -> bool:
    """Tell whether a file with bases of nodes hands one to code that it does not define."""
    owners: dict[int, set[Scope]] = {}
    for base in bases:
        owners.setdefault(id(base.file), set()).add(base.owner)
    files = {id(base.file): base.file for base in bases}
    calls = (handed_out(file, frozenset(owners[key])) for key, file in files.items())
    return any(True for each in calls for _ in each)


def _calls_known_modules(analysis: Analysis) -> bool:
    """Tell whether nothing is called, or derived from, that is of a module that may do anything.

    A function of rospy needs no node to create an endpoint.
    """
    qualified = analysis.resolver.qualified
    for call in analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is not None and not _are_known(
            qualified(callee, analysis.scopes.at(call.start_byte))
        ):
            return False
    return all(
        _are_known(qualified(base, scope.parent or scope))
        for scope in analysis.scopes.classes()
        for base in scope.bases
    )


def _are_known(names: tuple[str, ...]) -> bool:
    return all(name.partition(".")[0] in _KNOWN_MODULES or _is_type(name) for name in names)


def _is_type(name: str) -> bool:
    """Tell whether a name is that of an interface type, or of something in one."""
    return is_interface_module(name) or any(part in ("msg", "srv") for part in name.split("."))


def handed_out(analysis: Analysis, owners: frozenset[Scope] = frozenset()) -> Iterator[Node]:
    """Yield the calls of what the file does not define that get a node.

    Args:
        analysis: the file.
        owners: classes of it that nodes of other files derive from.
    """
    scopes = analysis.scopes
    own = {scope.name for scope in scopes.all if scope.kind in ("function", "class")}
    sites = {site.call.id for site in (*analysis.sites, *analysis.disguised)}
    nodes = _Nodes(analysis, owners)
    for call in analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        name = analysis.syntax.called_name(call)
        if callee is None or call.id in sites or call.id in nodes.made:
            continue
        if name in _KEEPS_TO_ITSELF or name in own:
            continue
        arguments = Arguments.of(call, analysis.syntax)
        given = (*arguments.positional, *arguments.keywords.values())
        scope = scopes.at(call.start_byte)
        if any(nodes.is_in(each, scope) for each in given) and not _only_spins(
            analysis, callee, given, scope
        ):
            yield call


def _only_spins(analysis: Analysis, callee: Node, given: tuple[Node, ...], scope: Scope) -> bool:
    """Tell whether a call is `Thread(target=rclpy.spin, …)`, or hands a node to the file itself."""
    qualified = analysis.resolver.qualified
    names = [*qualified(callee, scope)]
    if not names:
        return False
    names += [name for each in given for name in qualified(each, scope)]
    return all(
        name.startswith("rclpy.") or name.partition(".")[0] in sys.stdlib_module_names
        for name in names
    )


class _Nodes:
    """The nodes of a file, wherever it names them.

    Attributes:
        made: the ids of the calls that make them.
    """

    def __init__(self, analysis: Analysis, owners: frozenset[Scope]) -> None:
        self._analysis = analysis
        self._owners = owners | {each.owner for each in analysis.nodes if each.owner is not None}
        self._classes = {owner.name for owner in self._owners}
        self.made = {node.call.id for node in analysis.nodes if node.call is not None}
        self._variables = set(self._named())
        for assignment in analysis.captures.get("assignment", []):
            left, right = (assignment.child_by_field_name(side) for side in ("left", "right"))
            if left and right and analysis.syntax.slice(right) in self._variables:
                self._variables.add(analysis.syntax.slice(left))

    def is_in(self, value: Node, scope: Scope) -> bool:
        """Tell whether an argument is a node, the class of one, or a list that has one."""
        pending = [value]
        while pending:
            node = pending.pop()
            text = self._analysis.syntax.slice(node)
            if node.type == "call":
                if self._makes(node):
                    return True
            elif node.type in ("identifier", "attribute"):
                if text in self._variables or text in self._classes or _NODE_NAME.fullmatch(text):
                    return True
                if self._is_self(text, scope):
                    return True
            elif node.type in _HOLDING:
                pending += node.named_children
        return False

    def _makes(self, call: Node) -> bool:
        return call.id in self.made or self._analysis.syntax.called_name(call) in self._classes

    def _is_self(self, text: str, scope: Scope) -> bool:
        method = scope.enclosing("function")
        while method is not None and method.parent is not None and method.parent.kind != "class":
            method = method.parent.enclosing("function")
        return method is not None and text == method.self_name and method.parent in self._owners

    def _named(self) -> Iterator[str]:
        """Yield the sources of what nodes, and lists of them, are assigned to."""
        for call in self._analysis.captures.get("call", []):
            if not self._makes(call):
                continue
            holder = call.parent
            while holder is not None and holder.type in _HOLDING - {"named_expression"}:
                holder = holder.parent
            field = {"assignment": "left", "as_pattern": "alias", "named_expression": "name"}
            name = field.get(holder.type, "") if holder is not None else ""
            target = holder.child_by_field_name(name) if holder is not None and name else None
            if target is not None:
                several = target.type in ("pattern_list", "tuple_pattern", "list_pattern")
                for each in target.named_children if several else [target]:
                    yield self._analysis.syntax.slice(each)
