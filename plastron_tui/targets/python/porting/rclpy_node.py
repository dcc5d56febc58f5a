"""From rospy to rclpy: what makes the node, and where it is there."""

from __future__ import annotations

from collections.abc import Sequence

from tree_sitter import Node

from plastron_tui.sources.python.analysis import NodeSite
from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.splices import Splice, line_end, line_start
from plastron_tui.sources.python.syntax import parts_of

from .call_graph import functions_that_reach
from .insertion_point import top_level
from .port_state import COMMENT, Mark, Work, first_of, walk
from .rewriting import begins_line, first_statement, put_before

_INIT = "rclpy.init"
_NO_SIGNALS = "signal_handler_options=SignalHandlerOptions.NO"
_SIGNALS = "from rclpy.signals import SignalHandlerOptions"
_LEVELS = frozenset(f"rospy.{level}" for level in ("DEBUG", "INFO", "WARN", "ERROR", "FATAL"))


def make_node(work: Work, node: str, starts: Sequence[str], *, own_signals: bool) -> None:
    """Make the node where it is there before all that needs it.

    Args:
        work: the file.
        node: the name of the node.
        starts: the statements behind the one that makes the node.
        own_signals: whether the file handles signals itself.
    """
    inits = [each for each in work.analysis.nodes if each.call is not None]
    sites = [site.call for site in work.analysis.sites]
    if not inits:
        first = first_of(sites)
        work.constants.append(f"{node} = None")
        if first is not None:
            work.mark(first, "the node", f"set `{node}` to the node, which no line of it makes")
        return
    is_global = any(init.scope.enclosing("function") is not None for init in inits)
    if is_global and not _module_sites(work, inits[0]):
        work.constants.append(f"{node} = None")
    for init in inits:
        lines = [f"{_INIT}({_NO_SIGNALS})" if own_signals else f"{_INIT}()"]
        if own_signals:
            work.imports.add(_SIGNALS)
        _place(work, init, node, lines, starts)


def _place(work: Work, init: NodeSite, node: str, lines: list[str], starts: Sequence[str]) -> None:
    """Write the lines that make and start the node, behind those that are given."""
    assert init.call is not None
    statement = statement_of(init.call)
    anchor = _anchors(work)[init.call.id]
    function = init.scope.enclosing("function")
    # A constant may not be there yet where the node is made earlier; one of the module is.
    found = init.scope.lookup(init.expression)
    is_inside = function is not None and anchor.start_byte >= function.start
    is_known = is_inside and found is not None and found[0] is work.analysis.scopes.module
    is_constant = is_known or anchor.id == statement.id
    is_constant = is_constant and init.expression.replace(".", "").isidentifier()
    name = None if is_constant else init.name
    is_literal = name is not None and init.expression in (f"'{name}'", f'"{name}"')
    written = init.expression if name is None or is_literal else work.string(name)
    lines.append(f"{node} = rclpy.create_node({written or work.string('node')})")
    options = _options(work, init, name, node, lines)
    lines += starts
    for option in options:
        remedy = _OPTIONS.get(option)
        work.marks.append(Mark(init.call, option, remedy, has_comment=True))
        lines.insert(1, f"{COMMENT}{option}")
    work.done.add(init.call.id)
    if function is not None and is_inside:
        body = function.node.child_by_field_name("body")
        assert body is not None
        put_before(work, first_statement(body), [f"global {node}"])
    if anchor.id == statement.id:
        _replace(work, statement, lines)
        return
    put_before(work, anchor, lines)
    if statement.type == "expression_statement":
        work.delete(statement)


def _replace(work: Work, statement: Node, lines: list[str]) -> None:
    """Write lines where a statement stands; in a line with others, comments have no place."""
    if not begins_line(work, statement):
        work.replace(statement, "; ".join(line for line in lines if line[0] != "#"))
        return
    work.done.update(each.id for each in walk(statement))
    text = work.analysis.syntax.text
    rest = text[statement.end_byte : line_end(text, statement.end_byte)].rstrip()
    if rest.lstrip().startswith(b"#"):
        # What is said of `init_node` goes with what makes the node.
        made = next(at for at, line in enumerate(lines) if "rclpy.create_node(" in line)
        lines[made] += rest.decode(work.analysis.syntax.encoding, "replace")
        work.cut(Splice(statement.end_byte, statement.end_byte + len(rest)))
    margin = text[line_start(text, statement.start_byte) : statement.start_byte]
    work.replace(statement, f"\n{margin.decode('ascii')}".join(lines))


_OPTIONS = {"anonymous": "ROS 2 makes no name unique: start the node under a name of its own"}


def _options(
    work: Work, init: NodeSite, known: str | None, node: str, lines: list[str]
) -> list[str]:
    """Return the options of `init_node` that have to be ported by hand.

    The name of an anonymous node ends in the number of its process, as it does in rospy.
    """
    assert init.call is not None
    options = []
    for each in parts_of(init.call.child_by_field_name("arguments"))[1:]:
        name, value = each.child_by_field_name("name"), each.child_by_field_name("value")
        option = work.slice(name) if name is not None else "options of the node"
        given = work.slice(value) if value is not None else ""
        if (option, given) == ("anonymous", "True") and init.expression:
            inside = known if known is not None else f"{{{init.expression}}}"
            named = f'f"{inside}_{{os.getpid()}}"'
            if known is not None or init.expression.replace(".", "").isidentifier():
                lines[1] = f"{node} = rclpy.create_node({named})"
                work.imports.add("import os")
                continue
        if (option, given) == ("disable_signals", "True"):
            lines[0] = f"{_INIT}({_NO_SIGNALS})"
            work.imports.add(_SIGNALS)
            continue
        level = set(work.qualified(value)) if value is not None else set()
        if option == "log_level" and len(level) == 1 and level <= _LEVELS:
            severity = level.pop().rpartition(".")[2]
            lines.append(f"{node}.get_logger().set_level(LoggingSeverity.{severity})")
            work.imports.add("from rclpy.logging import LoggingSeverity")
            continue
        if option not in ("name", "node_name") and given != "False":
            options.append(option)
    return options


def _anchors(work: Work) -> dict[int, Node]:
    """Return the statements before which the nodes are made, by the calls that make them."""
    if work.anchors is None:
        inits = [each for each in work.analysis.nodes if each.call is not None]
        can_move = len(inits) == 1 and inits[0].name is not None
        work.anchors = {
            init.call.id: _anchor(work, init) if can_move else statement_of(init.call)
            for init in inits
            if init.call is not None
        }
    return work.anchors


def _anchor(work: Work, init: NodeSite) -> Node:
    """Return the statement before which the node is made.

    It is that with `init_node`, unless what stands before that needs the node.
    """
    assert init.call is not None
    early = _module_sites(work, init)
    if early:
        return top_level(early[0])
    statement = statement_of(init.call)
    needing = _first_need(work, init, statement)
    if needing is None:
        return statement
    while (outer := needing.parent) is not None and not (
        outer.start_byte <= statement.start_byte and statement.end_byte <= outer.end_byte
    ):
        needing = outer
    return needing


_NEEDLESS = frozenset({"rospy.myargv", "rospy.Duration", "rospy.Duration.from_sec"})


def _first_need(work: Work, init: NodeSite, statement: Node) -> Node | None:
    """Return the first call before a statement, in its function, that may need the node."""
    calls = work.analysis.captures.get("call", [])
    callees = [(call, call.child_by_field_name("function")) for call in calls]
    of_ros = [
        call
        for call, callee in callees
        if callee is not None
        and any(name.startswith("rospy.") for name in set(work.qualified(callee)) - _NEEDLESS)
    ]
    of_ros += [site.call for site in work.analysis.sites]
    inits = [each.call for each in work.analysis.nodes if each.call is not None]
    of_ros = [call for call in of_ros if all(call.id != each.id for each in inits)]
    functions = functions_that_reach(work, of_ros)
    ids = {call.id for call in of_ros}
    function = init.scope.enclosing("function")
    found = [
        call
        for call, callee in callees
        if callee is not None
        and call.start_byte < statement.start_byte
        and work.scope(call).enclosing("function") is function
        and (call.id in ids or work.slice(callee).rpartition(".")[2] in functions)
    ]
    return first_of(found)


def has_node(work: Work, place: Node) -> bool:
    """Tell whether the node is made for sure where a place of the file is run.

    A function is taken to run behind it, where it does not make the node itself; so is a node
    that no line of the file makes.
    """
    function = work.scope(place).enclosing("function")
    anchors = list(_anchors(work).values())
    if function is None and work.scope(place).enclosing("lambda") is not None:
        return True
    if function is not None:
        anchors = [each for each in anchors if function.start <= each.start_byte < function.end]
        return all(each.start_byte <= place.start_byte for each in anchors)
    return any(
        work.scope(each).enclosing("function") is None and each.start_byte <= place.start_byte
        for each in anchors
    )


def _module_sites(work: Work, init: NodeSite) -> list[Node]:
    """Return the endpoints that the module makes itself, before the statement with `init_node`."""
    assert init.call is not None
    top = top_level(init.call)
    is_in_function = init.scope.enclosing("function") is not None
    return [
        site.call
        for site in work.analysis.sites
        if site.scope.enclosing("function") is None
        and top_level(site.call).id != top.id
        and (is_in_function or site.call.start_byte < top.start_byte)
    ]
