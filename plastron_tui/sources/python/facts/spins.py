"""Programs that have callbacks, and end, or go on, without ever calling them.

rclpy calls a callback only while something spins the node. rospy calls them in threads of its own,
for as long as the main thread does anything.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.analysis import Analysis, NodeSite, Site
from plastron_tui.sources.python.base_classes import inherited_sites
from plastron_tui.sources.python.functions import function_uses
from plastron_tui.sources.python.references import Use, references, variable_of
from plastron_tui.sources.python.scopes import BindingKind, Scope
from plastron_tui.sources.python.syntax import parts_of

from .base_files import Base, read_bases
from .call_graph import CallGraph
from .called_back import is_certain, running_scope
from .closed import handed_out, hands_out
from .imported_nodes import imported_idle, is_harmless
from .own_names import is_own_name

_CALLED = frozenset(
    {
        EndpointKind.SUBSCRIPTION,
        EndpointKind.SERVICE,
        EndpointKind.TIMER,
        EndpointKind.ACTION_SERVER,
    }
)
_FILTER = "message_filters.Subscriber"
_SPINNING = re.compile(rb"[Ss]pin|[Nn]avigator")
_GOING_ON = re.compile(rb"[Ss]pin|[Nn]avigator|Thread|Process|Executor")
_STAYING = re.compile(
    r"spin|sleep|wait(?!_?for_?(service|message|server|transform))|loop|exec_?$|show|run|start$"
    r"|^join$|serve|input|pause|listen(?!er)|select$|^read|recv|accept$|get_?key|getch|communicate"
    r"|Thread|Process|pool|^map$|poll$|block",
    re.IGNORECASE,
)
_LIBRARIES = sys.stdlib_module_names | {
    "actionlib", "cv2", "cv_bridge", "dynamic_reconfigure", "message_filters", "moveit_commander",
    "numpy", "roslib", "rospkg", "rospy", "scipy", "tf", "tf2_geometry_msgs", "tf2_ros",
    "tf_conversions", "yaml",
}  # fmt: skip
"""Modules whose functions do what their name says."""

_QUICK = re.compile(r"(get|make|create|set|load|is|has|to|from|parse|init|setup|compute|calc)_")
"""How functions are called that come to an end, as objects do that are made."""


def idle(analysis: Analysis, graph: CallGraph) -> Span | None:
    """Return what makes the node of a program that never calls its callbacks, None for others."""
    if not analysis.nodes and not analysis.sites:
        return _imported(analysis)
    if analysis.syntax.errors or not any(_is_called(analysis, node) for node in analysis.nodes):
        return None
    if analysis.library.node_classes:
        return _unspun(analysis)
    return _ended(analysis, graph)


def _is_called(analysis: Analysis, node: NodeSite) -> bool:
    """Tell whether a node has callbacks."""
    return any(
        _has_callback(site, analysis)
        and (node.owner is None or site.owner is None or site.owner is node.owner)
        for site in analysis.first_sites()
    ) or (
        node.owner is not None
        and any(_has_callback(site, file) for file, site in inherited_sites(analysis, node.owner))
    )


def _has_callback(site: Site, file: Analysis) -> bool:
    """Tell whether a call site has something called, itself or by a filter of messages."""
    if site.endpoint.kind not in _CALLED or site.shape.gives_message or not is_certain(site, file):
        return False
    is_filtered = _FILTER in site.shape.callees and any(
        True for _ in file.resolver.calls_of("registerCallback")
    )
    return site.shape.callback is not None or is_filtered


def _unspun(analysis: Analysis) -> Span | None:
    """Return what makes the node of rclpy that nothing spins."""
    is_said = _says(analysis, _SPINNING)
    bases = read_bases(analysis)
    if (is_said and len(analysis.nodes) < 2) or bases is None:
        return None
    if any(_says(base.file, _SPINNING) for base in bases) or hands_out(bases):
        return None
    made = list(_made(analysis))
    if not made:
        return None
    if is_said:
        return next((_span(each) for each in made if _is_left_out(analysis, each)), None)
    is_spun = any(_may_spin(analysis, each) for each in handed_out(analysis))
    return None if is_spun or _hands_on_executor(analysis) else _span(made[0])


def _imported(analysis: Analysis) -> Span | None:
    """Return what makes a node of a class of another file, in a program that spins nothing."""
    if analysis.syntax.errors or not analysis.library.node_classes:
        return None
    if _says(analysis, _SPINNING) or not _starts_ros(analysis) or _hands_on_executor(analysis):
        return None
    made = imported_idle(analysis, _is_idle_class)
    return None if made is None else _span(made)


def _is_idle_class(base: Base) -> bool:
    """Tell whether a class of nodes has callbacks, and does not call them itself."""
    file = base.file
    node = next((each for each in file.nodes if each.owner is base.owner), None)
    bases = read_bases(file)
    if node is None or bases is None or file.syntax.errors or not _is_called(file, node):
        return False
    family = [base.owner, *file.resolver.classes.bases(base.owner), *(each.owner for each in bases)]
    return not any(_GOING_ON.search(each.node.text or b"") for each in family)


def _is_left_out(analysis: Analysis, made: Node) -> bool:
    """Tell whether nothing is done with a node that could spin it, though others are spun."""
    parent = made.parent
    target = parent.child_by_field_name("left") if parent is not None else None
    if parent is None or parent.type != "assignment" or target is None:
        return False
    instance = analysis.resolver.instance(made, analysis.scopes.at(made.start_byte))
    owner = None if instance is None else instance.scope
    is_named = target.type == "identifier" and owner is not None
    if not is_named or owner is None or _SPINNING.search(owner.node.text or b""):
        return False
    node = next((each for each in analysis.nodes if each.owner is owner), None)
    variable = variable_of(target, analysis)
    if node is None or variable is None or not _is_called(analysis, node):
        return False
    return all(
        each.use in (Use.BINDING, Use.NOTHING) or is_harmless(each.node, analysis, is_added=False)
        for each in references(variable, analysis)
    )


def _may_spin(analysis: Analysis, call: Node) -> bool:
    """Tell whether what gets a node may be there to spin it: what gets `self` only helps it."""
    if any(running_scope(analysis, each).enclosing("class") is None for each in _loops(analysis)):
        return True
    owners = {node.owner for node in analysis.nodes if node.owner is not None}
    return running_scope(analysis, call).enclosing("class") not in owners


def _made(analysis: Analysis) -> Iterator[Node]:
    """Yield the calls that make nodes, in a file that starts ROS as well."""
    owners = {node.owner for node in analysis.nodes if node.owner is not None}
    made = {node.call.id for node in analysis.nodes if node.call is not None}
    calls = [(each, running_scope(analysis, each)) for each in analysis.captures.get("call", [])]
    if not _starts_ros(analysis):
        return
    for call, scope in calls:
        if scope.enclosing("class") is not None:
            continue
        instance = analysis.resolver.instance(call, scope)
        is_own = instance is not None and instance.scope is not None and instance.scope in owners
        if (is_own or call.id in made) and not _is_for_others(analysis, call, scope):
            yield call


def _starts_ros(analysis: Analysis) -> bool:
    calls = analysis.captures.get("call", [])
    callees = ((each, each.child_by_field_name("function")) for each in calls)
    qualified = analysis.resolver.qualified
    return any(
        "rclpy.init" in qualified(callee, running_scope(analysis, call)) for call, callee in callees
    )


def _is_for_others(analysis: Analysis, made: Node, scope: Scope) -> bool:
    """Tell whether a node is what a function returns which only other files call."""
    is_returned = made.parent is not None and made.parent.type == "return_statement"
    return is_returned and not function_uses(analysis, scope)


def _span(node: Node) -> Span:
    return Span(node.start_byte, node.end_byte)


def _says(analysis: Analysis, pattern: re.Pattern[bytes]) -> bool:
    """Tell whether the code of a file has a name with a pattern; strings and comments are none.

    Nor is what only names a function, and does not call it, `executor.spin`, or a name of the
    file's own, whose value the file says as well.
    """
    root = analysis.syntax.root
    for found in pattern.finditer(analysis.syntax.text):
        node = root.descendant_for_byte_range(found.start(), found.end())
        if node is not None and node.type == "identifier" and not is_own_name(node, analysis):
            parent = node.parent
            if parent is None or parent.type not in ("dotted_name", "aliased_import"):
                whole = parent if parent is not None and parent.type == "attribute" else node
                around = whole.parent
                if around is None or around.type != "expression_statement":
                    return True
    return False


def _hands_on_executor(analysis: Analysis) -> bool:
    """Tell whether an executor is an argument, or an attribute that other files may have spin."""
    for call in analysis.captures.get("call", []):
        if not analysis.syntax.called_name(call).endswith("Executor"):
            continue
        parent = call.parent
        target = parent.child_by_field_name("left") if parent is not None else None
        if target is None or target.type != "identifier":
            return True
        name = target.text
        for other in analysis.captures.get("call", []):
            given = parts_of(other.child_by_field_name("arguments"))
            if any(each.text == name for each in given):
                return True
    return False


def _ended(analysis: Analysis, graph: CallGraph) -> Span | None:
    """Return what makes the node of a program of rospy that ends at once."""
    made: Node | None = None
    reached = _from_the_start(analysis, graph)
    # A class that starts ROS may be there for other files, which go on.
    surely = {
        each
        for scope in analysis.scopes.all
        if scope.kind == "module" or (scope.name == "main" and scope.kind == "function")
        for each in graph.reached(scope)
    }
    for scope in reached:
        for call in graph.calls(scope):
            names = analysis.resolver.qualified(call.child_by_field_name("function"), scope)
            if "rospy.init_node" in names:
                made = call if made is None and scope in surely else made
            elif graph.callee(call) is None and _may_stay(analysis, call, names):
                return None
    if made is None or any(_in_scopes(analysis, loop, reached) for loop in _loops(analysis)):
        return None
    owner = running_scope(analysis, made).enclosing("class")
    return None if owner is not None and _serves_others(owner, analysis) else _span(made)


def _serves_others(owner: Scope, analysis: Analysis) -> bool:
    """Tell whether a class has methods that nothing in its file calls or hands over."""
    return any(
        binding.owner is not None
        and not name.startswith("__")
        and not function_uses(analysis, binding.owner)
        for name, bindings in owner.bindings.items()
        for binding in bindings
        if binding.kind is BindingKind.FUNCTION
    )


def _from_the_start(analysis: Analysis, graph: CallGraph) -> set[Scope]:
    """Return the functions that may run as the program starts, and the module itself."""
    by_name: dict[str, list[Scope]] = {}
    for scope in analysis.scopes.all:
        if scope.kind == "function":
            by_name.setdefault(scope.name, []).append(scope)
    pending = [scope for scope in analysis.scopes.all if scope.kind in ("module", "class")]
    pending += by_name.get("main", [])
    found: set[Scope] = set()
    while pending:
        scope = pending.pop()
        if scope in found:
            continue
        found.update(reached := graph.reached(scope))
        for each in reached:
            for call in graph.calls(each):
                # Whoever has a method of the name may be meant.
                pending += by_name.get(analysis.syntax.called_name(call), ())
    return found


def _may_stay(analysis: Analysis, call: Node, names: tuple[str, ...]) -> bool:
    """Tell whether a call may go on until somebody ends the program."""
    name = analysis.syntax.called_name(call)
    if not name:
        callee = call.child_by_field_name("function")
        return callee is None or callee.type != "attribute"
    # A method of the file may be called as that of the library is.
    is_own = not any("." in each for each in names)
    if is_own and any(scope.name == name for scope in analysis.scopes.all):
        return False
    is_foreign = any(
        each.partition(".")[0] not in _LIBRARIES and not _is_message(each) for each in names
    )
    if is_foreign and not (name[0].isupper() or _QUICK.match(name)):
        return True
    callee = call.child_by_field_name("function")
    holder = callee.child_by_field_name("object") if callee is not None else None
    if (
        name == "join"
        and holder is not None
        and (holder.text or b"").endswith((b"path", b"'", b'"'))
    ):
        return False
    return _STAYING.search(name) is not None


def _is_message(name: str) -> bool:
    return any(part in ("msg", "srv", "cfg") for part in name.split("."))


def _loops(analysis: Analysis) -> Iterator[Node]:
    yield from analysis.captures.get("while", [])


def _in_scopes(analysis: Analysis, node: Node, scopes: set[Scope]) -> bool:
    return running_scope(analysis, node) in scopes
