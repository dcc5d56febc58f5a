"""Statements that do nothing but use what goes: ask a service, wait for it, tell what came.

They may declare what is asked with, wait, log, leave where nothing came, and set what nothing
else reads. What a function of the files does, or an object of another class, is more than that.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from ..analysis import Analysis
from ..scopes import CppFile, Scope, Variable, scope_at
from .deletions import Deletions
from .leftovers import logs

_READING = frozenset(
    {"get", "c_str", "str", "size", "empty", "valid", "to_string", "toString", "getText", "data"}
    | {"length", "count", "seconds", "toSec", "now", "get_clock", "get_logger", "what", "begin"}
    | {"end", "at", "front", "back", "ok", "isValid", "exists", "sleep", "getState", "has_value"}
    | {"value", "wait_for", "wait_until", "wait"}
)
_FILLING = frozenset({"push_back", "emplace_back", "resize", "reserve"})
_CALLED = frozenset(
    {"make_shared", "make_unique", "ok", "isShuttingDown", "seconds", "milliseconds", "duration"}
    | {"to_string", "to_yaml", "atoi", "atol", "atoll", "atof", "stoi", "stol", "stod", "move"}
    | {"spin_until_future_complete", "get_logger", "static_cast", "size", "get", "sleep_for"}
    | {"now", "sleep", "bind", "get_clock", "get_name", "getName"}
)
_SERVING = frozenset(
    {"call", "async_send_request", "prune_pending_requests", "remove_pending_request"}
    | {"waitForExistence", "wait_for_service", "service_is_ready", "getService"}
    | {"sendGoal", "sendGoalAndWait", "async_send_goal", "async_get_result", "getResult"}
    | {"waitForServer", "waitForResult", "isServerConnected", "stopTrackingGoal"}
    | {"wait_for_action_server", "action_server_is_ready", "cancelGoal", "cancelAllGoals"}
    | {"cancelGoalsAtAndBeforeTime", "async_cancel_goal", "async_cancel_all_goals"}
    | {"publish", "sendTransform", "getNumSubscribers", "get_subscription_count", "getTopic"}
    | {"getNumPublishers", "get_publisher_count", "get_topic_name", "get_service_name"}
    | {"is_activated", "isLatched", "setSucceeded", "setAborted", "setPreempted", "isActive"}
    | {"isPreemptRequested", "isNewGoalAvailable", "acceptNewGoal", "publishFeedback"}
    | {"is_canceling", "canceled", "succeed", "abort", "publish_feedback", "get_goal", "is_active"}
    | {"get_goal_id", "get_status", "execute", "start", "shutdown", "reset", "cancel", "stop"}
    | {"on_activate", "on_deactivate", "isNull", "getErrorCode", "setRejected", "setCanceled"}
)
"""Methods of endpoints, and of what comes of them, that are of no use without them."""

_LEAVING = frozenset({"shutdown", "exit", "requestShutdown"})
_OTHER_WORK = frozenset(
    {"assignment_expression", "update_expression", "new_expression", "delete_expression"}
    | {"throw_expression", "co_await_expression"}
)
_PRINTS = re.compile(
    r"(?:std::)?(?:cout|cerr|clog)\s*<<|(?:std::)?f?printf\s*\(|(?:std::)?puts\s*\("
)
_NEGATED = re.compile(r"\(*\s*!(?!=)|.*!=|.*==\s*(?:false|nullptr|NULL)\b", re.DOTALL)
_LOOPS = ("while_statement", "do_statement", "for_statement", "for_range_loop")


class DependentStatements:
    """What is known of the statements that serve what goes.

    Attributes:
        going: the variables that go: the endpoint's, and those that hold what came of it.
        ending: the variables of timers that may be ended, for they go too.
        asking: the calls that go, by the ids of their nodes.
        is_alone: whether whole functions are looked at, which set nothing but what is their own
            to constants.
    """

    def __init__(self, analysis: Analysis, gone: Deletions) -> None:
        self._analysis = analysis
        self._gone = gone
        self.going: set[Variable] = set()
        self.ending: set[Variable] = set()
        self.asking: set[int] = set()
        self.is_alone = False

    def serves(self, file: CppFile, node: Node, *, leaves: bool = False) -> bool:
        """Tell whether a statement does nothing but serve what goes.

        Args:
            file: the file that has it.
            node: the statement.
            leaves: whether it may leave its function, for it runs where nothing came.
        """
        if node.type == "comment" or self._gone.covers(file, node.start_byte):
            return True
        match node.type:
            case "compound_statement":
                return all(self.serves(file, x, leaves=leaves) for x in node.named_children)
            case "expression_statement":
                return self._is_serving_expression(file, node, leaves=leaves)
            case "declaration":
                return self.is_idle(file, node) and not self._hands_on(file, node)
            case "return_statement" | "throw_statement":
                return leaves and self.is_idle(file, node)
            case "break_statement" | "continue_statement":
                return leaves
            case "if_statement":
                return self._is_serving_if(file, node, leaves=leaves)
            case _ if node.type in _LOOPS:
                return self._is_serving_loop(file, node)
            case _:
                return False

    def _is_serving_if(self, file: CppFile, node: Node, *, leaves: bool) -> bool:
        condition = node.child_by_field_name("condition")
        body = node.child_by_field_name("consequence")
        other = node.child_by_field_name("alternative")
        if condition is None or body is None or not self.is_idle(file, condition):
            return False
        is_negated = _NEGATED.match(file.syntax.word(condition)) is not None
        if not self.serves(file, body, leaves=leaves or is_negated):
            return False
        if other is None:
            return True
        leaves = leaves or not is_negated
        return all(self.serves(file, each, leaves=leaves) for each in other.named_children)

    def _is_serving_loop(self, file: CppFile, node: Node) -> bool:
        body = node.child_by_field_name("body")
        heads = [each for each in node.named_children if body is None or each.id != body.id]
        is_counting = node.type == "for_statement"
        for each in heads:
            if not self.is_idle(file, each, counts=is_counting):
                return False
        return body is None or self.serves(file, body, leaves=True)

    def _is_serving_expression(self, file: CppFile, node: Node, *, leaves: bool) -> bool:
        inner = node.named_children[0] if node.named_child_count else None
        if inner is None or is_telling(file, node):
            return inner is None or self.is_idle(file, inner, prints=True)
        if inner.type == "call_expression" and leaves:
            callee = inner.child_by_field_name("function")
            if callee is not None and _last_name(file, callee) in _LEAVING:
                return True
        if inner.type == "call_expression" and self._ends_timer(file, inner):
            return True
        if inner.type == "assignment_expression":
            left, right = (inner.child_by_field_name(each) for each in ("left", "right"))
            root = None if left is None else self.root(file, left)
            if root is None or right is None:
                return False
            if self.is_alone and not (root.kind in ("local", "parameter") and _is_literal(right)):
                return False
            return self.is_idle(file, right)
        return self.is_idle(file, inner)

    def _ends_timer(self, file: CppFile, call: Node) -> bool:
        callee = call.child_by_field_name("function")
        if callee is None or callee.type != "field_expression":
            return False
        name = _last_name(file, callee)
        root = self.root(file, callee)
        return name in ("stop", "cancel", "reset") and root is not None and root in self.ending

    def is_work(self, file: CppFile, node: Node) -> bool:
        """Tell whether a statement does something that is of use without what goes."""
        if node.type == "declaration":
            return not self.is_idle(file, node)
        inner = node.named_children[0] if node.named_child_count else None
        if node.type == "expression_statement" and inner is not None:
            return inner.type != "call_expression" or not self._ends_timer(file, inner)
        return inner is not None

    def is_idle(
        self, file: CppFile, node: Node, *, counts: bool = False, prints: bool = False
    ) -> bool:
        """Tell whether an expression or a declaration has no effect but on what goes."""
        pending = [node]
        while pending:
            each = pending.pop()
            if each.type == "lambda_expression":
                body = each.child_by_field_name("body")
                if body is None or not self.serves(file, body, leaves=True):
                    return False
                continue
            if each.type in _OTHER_WORK and not counts:
                return False
            is_call = each.type == "call_expression" and not (prints and each.id == node.id)
            if is_call and not self._is_idle_call(file, each):
                return False
            pending += each.named_children
        return True

    def _is_idle_call(self, file: CppFile, call: Node) -> bool:
        callee = call.child_by_field_name("function")
        if callee is None or call.id in self.asking:
            return callee is not None
        name = _last_name(file, callee)
        if callee.type == "field_expression":
            root = self.root(file, callee)
            is_filling = name in _FILLING and root is not None and root.kind == "local"
            is_serving = name in _SERVING and root is not None and root in self.going
            return name in _READING or is_filling or is_serving
        if name in self._analysis.unit.functions:
            return False
        if name in _CALLED or callee.type == "primitive_type":
            return True
        # What has an upper case letter in front makes an object; a macro is written in no others.
        is_type = name[:1].isupper() and not name.isupper()
        return is_type and not self._names_going(file, call)

    def _hands_on(self, file: CppFile, declaration: Node) -> bool:
        """Tell whether a declaration gives a constructor what goes."""
        return any(
            not (each.type == "init_declarator" and _is_assigned(each))
            and self._names_going(file, each)
            for each in declaration.children_by_field_name("declarator")
        )

    def _names_going(self, file: CppFile, node: Node) -> bool:
        return any(each in self.going for each in self.named_in(file, node))

    def root(self, file: CppFile, node: Node) -> Variable | None:
        """Return the variable that an expression begins with: `a` of `a->b.c()[0]`."""
        inner: Node | None = node
        while inner is not None:
            scope = scope_at(file, inner.start_byte)
            match inner.type:
                case "identifier":
                    name = file.syntax.word(inner)
                    return self._analysis.unit.lookup(name, scope, inner.start_byte)
                case "field_expression":
                    holder = inner.child_by_field_name("argument")
                    if holder is not None and holder.type == "this":
                        return self._analysis.receivers.member(inner, scope)
                    inner = holder
                case "call_expression":
                    inner = inner.child_by_field_name("function")
                case "subscript_expression" | "pointer_expression":
                    inner = inner.child_by_field_name("argument")
                case "parenthesized_expression":
                    inner = inner.named_children[0] if inner.named_child_count else None
                case _:
                    return None
        return None

    def named_in(self, file: CppFile, node: Node) -> Iterator[Variable]:
        """Yield the variables that a statement names and does not declare itself."""
        pending = [node]
        while pending:
            each = pending.pop()
            pending += each.named_children
            if each.type not in ("identifier", "type_identifier"):
                continue
            scope: Scope = scope_at(file, each.start_byte)
            found = self._analysis.unit.lookup(file.syntax.word(each), scope, each.start_byte)
            if found is None or found.declarator is None:
                continue
            is_own = found.file is file and (
                node.start_byte <= found.declarator.start_byte < node.end_byte
            )
            if not is_own:
                yield found

    def given_in(self, file: CppFile, statement: Node) -> Iterator[Variable]:
        """Yield the variables that a statement gives to methods of what goes: `x`, `&x`, `*x`.

        Of `x.request` that is `x`.
        """
        pending = [statement]
        while pending:
            each = pending.pop()
            pending += each.named_children
            callee = each.child_by_field_name("function")
            listed = each.child_by_field_name("arguments")
            if each.type != "call_expression" or callee is None or listed is None:
                continue
            holder = self.root(file, callee) if callee.type == "field_expression" else None
            if each.id not in self.asking and (holder is None or holder not in self.going):
                continue
            for given in listed.named_children:
                inner = given
                if inner.type == "call_expression":
                    # `std::move(message)`
                    of = inner.child_by_field_name("arguments")
                    inner = of.named_children[0] if of is not None and of.named_children else inner
                part = _last_name(file, inner) if inner.type == "field_expression" else ""
                is_whole = part in ("", "request", "response")
                root = self.root(file, inner) if is_whole else None
                if root is not None:
                    yield root

    def holders(self, file: CppFile, node: Node) -> Iterator[Variable]:
        """Yield the variables that a statement gives what comes of something that goes."""
        if node.type == "declaration":
            for listed in scope_at(file, node.start_byte).variables.values():
                yield from (each for each in listed if each.node.id == node.id)
        pending = [node]
        while pending:
            each = pending.pop()
            pending += each.named_children
            if each.type == "assignment_expression":
                left = each.child_by_field_name("left")
                root = None if left is None else self.root(file, left)
                if root is not None and root not in self.going:
                    yield root


def is_telling(file: CppFile, node: Node) -> bool:
    """Tell whether a statement does nothing but log or print."""
    text = file.syntax.word(node).strip()
    return logs(text) or _PRINTS.match(text) is not None


def _is_assigned(declarator: Node) -> bool:
    value = declarator.child_by_field_name("value")
    return value is not None and value.type not in ("argument_list", "initializer_list")


def _is_literal(node: Node) -> bool:
    inner = node.child_by_field_name("argument") if node.type == "unary_expression" else node
    return inner is not None and (inner.type.endswith("literal") or inner.type in ("true", "false"))


def _last_name(file: CppFile, callee: Node) -> str:
    """Return the last name of what is called, without template arguments."""
    if callee.type == "field_expression":
        field = callee.child_by_field_name("field")
        callee = callee if field is None else field
    return file.syntax.word(callee).partition("<")[0].rpartition("::")[2].strip()
