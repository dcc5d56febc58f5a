"""Giving a message that a file makes other values, in the lines that set its fields."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.kinds import Parameter, Timer
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import Field, Interface

from .. import literals
from ..computed import Computing
from ..scopes import CppFile, Scope, Variable
from .accesses import access
from .adding import Addition, put_in_body
from .computing import checked_computing, computing_for
from .deletions import Deletions
from .interfaces import Interfaces
from .manner import identifiers
from .place import beside, node_in_methods, sites_of_node
from .refusals import RefusedError
from .replacing import NotInPlaceError, Replacement
from .statements import is_inside, only_sets, statement_of
from .units import labels_of
from .uses import uses_of

STAMP = "header.stamp"
"""The time at which a message is sent, which nobody calls a value of it."""
_BLANKS = re.compile(r"\s+")
# What makes a value of a type of the standard library from what it is given.
_MAKING = re.compile(r"(?:std::)?(?:string|vector<[\w: ]+>)|(?:\w+::)*[A-Z]\w*")


@dataclass(frozen=True, slots=True)
class Filled:
    """A message of a file that is to have other values.

    Attributes:
        variable: what holds it.
        file: the file that fills it.
        block: the statements in which it is filled.
        after: the statement behind which it can be filled, None for the start of the block.
        holder: what stands before a field of it: `message.`, `request->`, `call.request.`.
        used: the parts of the file that use it once it is filled.
        is_retyped: whether it is of another type now.
    """

    variable: Variable
    file: CppFile
    block: Node
    after: Node | None
    holder: str
    used: tuple[Node, ...] = ()
    is_retyped: bool = False


class Said(NamedTuple):
    """What sets a field: the statement, the expression, and the scope of these."""

    statement: Node
    given: Node
    scope: Scope


@dataclass(frozen=True, slots=True)
class Values:
    """What a message is to have.

    Attributes:
        interface: its type.
        fields: the fields of its part of that.
        value: the values.
        received: what holds what they are computed of.
        heard: the fields of that.
        is_stamped: whether it gets the time at which it is sent where nothing says one.
    """

    interface: Interface
    fields: Sequence[Field]
    value: MessageValue
    received: str = ""
    heard: Sequence[Field] = ()
    is_stamped: bool = False


def addition_at(update: Replacement) -> Addition:
    """Return what writes new code for an endpoint in the manner of the files.

    Raises:
        NotInPlaceError: the files have no place for it.
    """
    analysis, site, change = update.analysis, update.site, update.change
    place = beside(analysis, site)
    endpoint, type_ = change.endpoint, change.endpoint.type or site.endpoint.type
    if place is None or type_ is None or isinstance(endpoint, Parameter | Timer):
        raise NotInPlaceError
    added = Addition(
        analysis,
        change.kind,
        endpoint._replace(type=type_),
        place,
        Interfaces(update.catalog, analysis.ros_version),
        sites_of_node(analysis, change.node),
        identifiers(analysis),
        labels_of(analysis).get(site, ""),
    )
    added.settings = update.settings
    return added


class Refilling(NamedTuple):
    """How a message gets other values.

    Attributes:
        filled: the message.
        added: what writes new code.
        values: what it is to have.
        wanted: the expressions of its fields, by their paths.
        said: what sets its fields now.
    """

    filled: Filled
    added: Addition
    values: Values
    wanted: dict[str, str]
    said: dict[str, Said]


def prepare(update: Replacement, filled: Filled, values: Values) -> Refilling:
    """Find out how a message can be filled anew.

    Raises:
        NotInPlaceError: it is filled in another way than field by field.
    """
    added = addition_at(update)
    wanted = expressions(added, filled.holder, values, filled.block)
    return Refilling(filled, added, values, wanted, _said(update, filled))


def refill(update: Replacement, refilling: Refilling) -> list[str]:
    """Write other values where a message is filled; return those that go, and were worked out.

    A line that gives a field the value which it shall have stays as it is.
    """
    filled, added, values, wanted, said = refilling
    lost: list[str] = []
    gone = Deletions()
    anchor = filled.after
    for path, (statement, given, scope) in said.items():
        is_stamp = path == STAMP and values.is_stamped and path not in wanted
        if path not in wanted and not is_stamp:
            gone.statement(filled.file, statement)
        else:
            anchor = statement
        if is_stamp or (path in wanted and _is_same(update, given, scope, wanted[path])):
            continue
        if path in wanted:
            update.put(filled.file, given, wanted[path])
        if path != STAMP and is_worked_out(given, filled.file):
            lost.append(filled.file.syntax.slice(given))
    update.plan.splices[filled.file.name] += gone.splices(filled.file)
    lines = [
        f"{filled.holder}{path} = {text};" for path, text in wanted.items() if path not in said
    ]
    if values.is_stamped and STAMP not in {*wanted, *said}:
        lines.append(stamp(added, filled.holder))
    _insert(filled, added, anchor, lines)
    take_over(update, added)
    return lost


def stamp(added: Addition, holder: str) -> str:
    """Write what gives a message the time at which it is sent."""
    node = node_in_methods(added.analysis, added.place)
    now = f"{node}now()" if node is not None else "rclcpp::Clock(RCL_ROS_TIME).now()"
    return f"{holder}{STAMP} = {now if added.is_ros2 else 'ros::Time::now()'};"


def take_over(update: Replacement, added: Addition) -> None:
    """Let a change do what was written for it."""
    for name, splices in added.plan.splices.items():
        update.plan.splices[name] += splices
    update.plan.added += added.plan.added


def expressions(added: Addition, holder: str, values: Values, near: Node) -> dict[str, str]:
    """Return the expressions that the fields shall have, by their paths.

    Raises:
        NotInPlaceError: they are not set by one expression each, or only under a condition.
    """
    before = len(added.lines)
    try:
        computing, conditions = computing_for(added, added.span)
        lines = _lines(added, holder, values, computing)
        if conditions:
            checked = checked_computing(added, added.span)
            # Functions that Plastron writes take what they hear by reference.
            bare = values.received.removesuffix(".")
            lines = _lines(added, holder, replace(values, received=bare), checked)
            if bare.endswith("->"):
                raise NotInPlaceError
            if not _is_caught(near) or checked.functions - added.analysis.unit.functions.keys():
                raise NotInPlaceError
    except RefusedError:
        raise NotInPlaceError from None
    if len(added.lines) > before or any(added.plan.splices.values()):
        raise NotInPlaceError
    found: dict[str, str] = {}
    setting = re.compile(re.escape(holder) + r"([\w.\[\]]+) = (.*);", re.DOTALL)
    for line in lines:
        parts = setting.fullmatch(line)
        if parts is None or parts[1] in found:
            raise NotInPlaceError
        found[parts[1]] = parts[2]
    return found


def _lines(added: Addition, holder: str, values: Values, computing: Computing) -> list[str]:
    interface, fields, value = values.interface, values.fields, values.value
    given = computing, added.span, values.received, values.heard
    return added.interfaces.fill(interface, fields, value, holder, *given)


def _is_caught(node: Node) -> bool:
    """Tell whether something is done where an exception is caught."""
    inner: Node | None = node
    while inner is not None and inner.type not in ("function_definition", "lambda_expression"):
        if inner.type == "try_statement":
            return True
        inner = inner.parent
    return False


def _said(update: Replacement, filled: Filled) -> dict[str, Said]:
    """Return what sets the fields; nothing else may be done with the message before it is sent."""
    analysis, variable = update.analysis, filled.variable
    prefix = _BLANKS.sub("", filled.holder)[len(variable.name) :].lstrip(".->")
    found: dict[str, Said] = {}
    for file, node, scope in uses_of(analysis, variable):
        if any(is_inside(node, each) for each in filled.used):
            continue
        statement = statement_of(node)
        text = "" if statement is None else _BLANKS.sub("", file.syntax.word(statement))
        if text.startswith(("(void)", "static_cast<void>(")):
            continue
        done = access(analysis, file, node)
        path = ".".join(done.path)
        own = f"{path}." if path else ""
        if not done.is_set and not done.is_handed:
            if filled.is_retyped:
                raise NotInPlaceError
            continue
        is_plain = statement is not None and only_sets(statement, node)
        if statement is None or not is_plain or not own.startswith(prefix):
            raise NotInPlaceError
        assignment = statement.named_children[0]
        left = assignment.child_by_field_name("left")
        given = assignment.child_by_field_name("right")
        if left is None or given is None or statement.parent != filled.block:
            raise NotInPlaceError
        written = _BLANKS.sub("", file.syntax.word(left))
        if not written.startswith(filled.holder) or _operator(assignment) != b"=":
            raise NotInPlaceError
        whole = written.removeprefix(filled.holder)
        if whole in found:
            raise NotInPlaceError
        found[whole] = Said(statement, given, scope)
    return found


def _operator(assignment: Node) -> bytes:
    sign = assignment.child_by_field_name("operator")
    return b"=" if sign is None else sign.text or b""


def _is_same(update: Replacement, given: Node, scope: Scope, wanted: str) -> bool:
    """Tell whether an expression of the file is worth what is to be written."""
    text = scope.file.syntax.slice(given)
    if _BLANKS.sub("", text) == _BLANKS.sub("", wanted):
        return True
    known = update.analysis.evaluator.fold(given, scope)
    if known is None or known.is_default or known.is_guess:
        return False
    return _plain(known.value) == wanted or str(known.value) == wanted


def _plain(value: object) -> str | None:
    return literals.scalar(value) if isinstance(value, bool | int | float | str) else None


def is_worked_out(node: Node, file: CppFile) -> bool:
    """Tell whether an expression uses what the node works out, and not only constants."""
    pending = [node]
    while pending:
        each = pending.pop()
        called = each.child_by_field_name("function") if each.type == "call_expression" else None
        if called is not None:
            if not _MAKING.fullmatch(file.syntax.word(called)):
                return True
            pending += [inner for inner in each.named_children if inner != called]
            continue
        if each.type in ("identifier", "field_expression"):
            return True
        pending += each.named_children
    return False


def _insert(filled: Filled, added: Addition, anchor: Node | None, lines: list[str]) -> None:
    if not lines:
        return
    if anchor is not None:
        added.put_behind(filled.file, anchor, lines, is_part=True)
        return
    statements, owner = filled.block.named_children, filled.block.parent
    if statements and statements[-1].type == "return_statement":
        added.put_above(filled.file, statements[-1], lines)
    elif owner is not None:
        put_in_body(added, filled.file, owner, filled.block, lines, is_end=True)
