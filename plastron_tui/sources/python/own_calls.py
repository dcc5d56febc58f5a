"""Nodes that Plastron wrote to call services: one call more, and what lets them go on."""

from __future__ import annotations

from tree_sitter import Node

from .addition import Addition
from .conventions import leading_space, method_naming
from .function_place import method_place
from .functions import function_uses
from .generated import is_asking_function, is_own_helper
from .references import identifiers, statement_of
from .scopes import Scope
from .splices import line_end
from .syntax import parts_of

# The functions of the templates that start what is asked once.
_STARTING = frozenset({"main", "work", "on_activate"})


def call_in_own_method(added: Addition, requests: list[str]) -> bool:
    """Call a service as a node that Plastron wrote calls its others; False where none does."""
    owner = added.place.owner
    if owner is None or "." not in added.variable:
        return False
    methods = {scope.name: scope for scope in added.analysis.scopes.all if scope.parent is owner}
    helper = methods.get("call")
    if helper is None or not is_own_helper(helper):
        return False
    if (caller := methods.get("call_services")) is not None:
        return _call_in(added, caller, [f"{{self}}.call({{client}}, {each})" for each in requests])
    lines = [line for each in requests for line in _asking(added, methods, each)]
    asking = [each for each in methods.values() if is_asking_function(added.analysis, each)]
    asking.sort(key=lambda scope: scope.start)
    starts = [(each, _started_in(added, each)) for each in asking]
    started = [(each, start) for each, start in starts if start is not None]
    for scope, _ in started:
        if _mentions(added, scope, added.variable.rpartition(".")[2]):
            return _call_in(added, scope, lines)
    if not started:
        return False
    name = _call_in_new(added, helper, asking[-1], lines)
    _start(added, name, *max(started, key=lambda each: each[1].start_byte))
    return True


def _asking(added: Addition, methods: dict[str, Scope], request: str) -> list[str]:
    """Return the lines of a template that wait for a service and call it."""
    wait = "await " if _is_async(methods["call"]) else ""
    call = f"{wait}{{self}}.call({{client}}, {request})"
    if "is_served" in methods:
        return [f"if {wait}{{self}}.is_served({{client}}):", f"\t{call}"]
    if "wait_until_served" not in methods:
        return [call]
    waited = "{client}"
    if added.is_rclpy:
        waited = f"{added.writer.conventions.string(added.name)}, {waited}.service_is_ready"
    waiting = f"{wait}{{self}}.wait_until_served({waited})"
    # A managed node may be deactivated while it waits.
    return [f"if {waiting}:", f"\t{call}"] if "end_tasks" in methods else [waiting, call]


def _is_async(function: Scope) -> bool:
    return function.node.children[0].type == "async"


def _started_in(added: Addition, function: Scope) -> Node | None:
    """Return the statement that has a method called once, as the node starts."""
    mentions = function_uses(added.analysis, function)
    statement = statement_of(mentions[0]) if len(mentions) == 1 else None
    call = next(iter(parts_of(statement)), None) if statement is not None else None
    is_alone = statement is not None and statement.start_point.row == statement.end_point.row
    if statement is None or call is None or call.type not in ("call", "await") or not is_alone:
        return None
    around = added.analysis.scopes.at(statement.start_byte).enclosing("function")
    return statement if around is not None and around.name in _STARTING else None


def _mentions(added: Addition, function: Scope, name: str) -> bool:
    """Whether a function mentions an attribute."""
    node = function.node
    found = identifiers(name, added.analysis)
    return any(node.start_byte <= each.start_byte < node.end_byte for each in found)


def _filled(added: Addition, self_name: str, lines: list[str]) -> list[str]:
    """Write a method's names of the node and of the client into lines."""
    client = f"{self_name}.{added.variable.rpartition('.')[2]}"
    return [line.replace("{self}", self_name).replace("{client}", client) for line in lines]


def _call_in(added: Addition, function: Scope, lines: list[str]) -> bool:
    """Call a service at the end of a function; False where it has no block of lines."""
    block = function.node.child_by_field_name("body")
    is_on_one_line = block is None or block.start_point.row == function.node.start_point.row
    if block is None or is_on_one_line or block.has_error or not block.named_children:
        return False
    last = block.named_children[-1]
    added.writer.lines(
        line_end(added.analysis.syntax.text, last.end_byte),
        leading_space(added.analysis, block),
        _filled(added, next(iter(function.bindings)), lines),
    )
    return True


def _call_in_new(added: Addition, helper: Scope, above: Scope, lines: list[str]) -> str:
    """Call a service in a method of its own, below another one; return its name."""
    self_name = added.place.self_name
    name = added.free_name(method_naming(added.analysis, "call").name(added.name))
    head = f"{'async ' if _is_async(helper) else ''}def {name}({self_name}):"
    body = [f'"""Call {added.label}."""', *_filled(added, self_name, lines)]
    place = method_place(added.analysis, added.place, [above])
    added.writer.function(place, [head, *("\t" + line for line in body)])
    return name


def _start(added: Addition, name: str, model: Scope, start: Node) -> None:
    """Start a method as another one is, right behind that."""
    analysis = added.analysis
    (mention,) = function_uses(analysis, model)
    text = analysis.syntax.between(start.start_byte, mention.start_byte) + name
    text += analysis.syntax.between(mention.end_byte, start.end_byte)
    offset = line_end(analysis.syntax.text, start.end_byte)
    added.writer.lines(offset, leading_space(analysis, start), [text])


def keep_running(added: Addition) -> None:
    """Let a node that Plastron wrote to do something, and then to end, go on instead."""
    text = added.analysis.syntax.text
    statement = None if b"spin(" in text else _last_of_work(added)
    if statement is None:
        return
    scope = added.analysis.scopes.at(statement.start_byte)
    spin = added.imports.library(added.dialect.library, "spin", scope)
    line = f"{spin}({'node' if added.is_rclpy else ''})"
    indent = leading_space(added.analysis, statement)
    added.writer.lines(line_end(text, statement.end_byte), indent, [line])


def _last_of_work(added: Addition) -> Node | None:
    """Return the statement of `main` after which a node that Plastron wrote has nothing to do."""
    text = added.analysis.syntax.text
    is_kept = b"is_shutdown" in text or b"rclpy.ok" in text
    for call in added.analysis.captures.get("call", []):
        statement, written = call.parent, added.analysis.syntax.slice(call)
        if statement is None or statement.type != "expression_statement":
            continue
        if written == "node.call_services()" and not is_kept:
            return statement
        if written == "rclpy.spin_until_future_complete(node, work)":
            return statement
        around = statement.parent.parent if statement.parent is not None else None
        if written == "worker.join(0.1)" and around is not None:
            return around if around.type == "while_statement" else None
    return None
