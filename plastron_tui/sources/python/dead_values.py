"""Values of local variables that nothing reads once other statements are gone."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from typing import NamedTuple

from tree_sitter import Node

from .analysis import Analysis
from .emptied_blocks import leaves_pass
from .purity import FILLING, is_fresh, is_pure
from .references import identifiers, is_member, statement_of
from .scopes import BindingKind, Scope
from .splices import Splice
from .syntax import holders, nodes_in, parts_of
from .unused_locals import is_of_its_own

_VALUES = frozenset({BindingKind.VALUE, BindingKind.UNKNOWN, BindingKind.PARAMETER})
# What these read, no name tells.
_READS_ALL = re.compile(rb"\b(eval|exec|locals|vars)\s*\(")
# What adds these changes no list.
_NUMBERS = frozenset({"integer", "float"})
_BRANCHES = frozenset({"elif_clause", "else_clause"})
_HANDLERS = frozenset({"except_clause", "except_group_clause"})

Names = frozenset[str]
"""The variables whose values may be read further on."""

_NONE: Names = frozenset()


def dead_values(analysis: Analysis, gone: Sequence[Splice]) -> list[Node]:
    """Return the statements that give a local a value which only what is gone read.

    A variable may be read before that, or have another value by then: `x = 1; f(x); x += 1`.
    """
    ranges = [(splice.start, splice.end) for splice in gone]
    found = []
    for function in _functions(analysis, ranges):
        kept = {each.id for each in _Flow(analysis, function, (), ()).dead()}
        while True:
            dead = _Flow(analysis, function, ranges, kept).dead()
            bad = [each for each in dead if leaves_pass(analysis, [each], ranges)]
            bad = bad or (dead if leaves_pass(analysis, dead, ranges) else [])
            if not bad:
                break
            kept |= {each.id for each in bad}
        found += dead
    return found


def dead_targets(analysis: Analysis, gone: Sequence[Splice]) -> list[Splice]:
    """Return what leaves out the names of `a = b = 0` that only what is gone used."""
    ranges = [(splice.start, splice.end) for splice in gone]
    found: list[Splice] = []
    for function in _functions(analysis, ranges):
        start, end = function.node.start_byte, function.node.end_byte
        for inner in analysis.captures.get("assignment", []):
            if not start <= inner.start_byte < end:
                continue
            target, value = inner.child_by_field_name("left"), inner.child_by_field_name("right")
            is_chained = inner.parent is not None and inner.parent.type == "assignment"
            if target is None or value is None or is_chained:
                continue
            links = [(target, value)]
            while value.type == "assignment" and target is not None:
                target, after = (value.child_by_field_name(each) for each in ("left", "right"))
                if target is None or after is None:
                    break
                links, value = [*links, (target, after)], after
            dead = [each for each in links if _is_left_alone(analysis, function, each[0], ranges)]
            if len(dead) < len(links):
                found += [Splice(each.start_byte, after.start_byte) for each, after in dead]
    return found


def _is_left_alone(
    analysis: Analysis, function: Scope, target: Node, ranges: Sequence[tuple[int, int]]
) -> bool:
    """Whether a name is of one function, and what is gone had all of its other uses."""
    name = analysis.syntax.slice(target)
    if target.type != "identifier" or name not in function.bindings:
        return False
    uses = [each for each in identifiers(name, analysis) if not is_member(each)]
    uses = [each for each in uses if analysis.scopes.at(each.start_byte).is_within(function)]
    left = [each for each in uses if not any(s <= each.start_byte < e for s, e in ranges)]
    return len(uses) > 1 and left == [target]


def _functions(analysis: Analysis, ranges: Sequence[tuple[int, int]]) -> list[Scope]:
    """Return the functions that parts of a file are in."""
    found = {}
    for start, _ in ranges:
        function = analysis.scopes.at(start).enclosing("function")
        if function is None or function.node.type != "function_definition":
            continue
        if not _READS_ALL.search(function.node.text or b""):
            found[function.node.id] = function
    return [found[key] for key in sorted(found, key=lambda key: found[key].start)]


class _Ends(NamedTuple):
    """What is live where a `break`, a `continue` or an exception leads to."""

    broken: Names = _NONE
    continued: Names = _NONE
    failed: Names = _NONE


class _Flow:
    """Which values are read, from the end of a function to its start.

    What a statement reads to work out a value that nobody reads does not count.
    """

    def __init__(
        self,
        analysis: Analysis,
        function: Scope,
        ranges: Sequence[tuple[int, int]],
        kept: Collection[int],
    ) -> None:
        self._analysis, self._function = analysis, function
        self._ranges, self._kept = ranges, kept
        self._dead: dict[int, Node | None] = {}
        self._names = {name for name in function.bindings if self._is_local(name)}
        self._fresh = {name for name in self._names if self._is_made(name)}
        self._own = {name for name in self._fresh if self._is_own(name)}

    def dead(self) -> list[Node]:
        """Return the statements that only give values which nobody reads."""
        self._block(self._function.node.child_by_field_name("body"), _NONE, _Ends())
        return [each for each in self._dead.values() if each is not None]

    def _is_local(self, name: str) -> bool:
        """Whether a variable has values alone, and no function inside uses it."""
        function = self._function
        if any(each.kind not in _VALUES for each in function.bindings[name]):
            return False
        start, end = function.node.start_byte, function.node.end_byte
        inside = [
            self._analysis.scopes.at(each.start_byte)
            for each in identifiers(name, self._analysis)
            if start <= each.start_byte < end and not is_member(each)
        ]
        return all(_running(each) is function for each in inside if each.is_within(function))

    def _is_own(self, name: str) -> bool:
        """Whether nothing but `publish` gets the object that a variable has."""
        filling = []
        for node in identifiers(name, self._analysis):
            inside = self._function.start <= node.start_byte < self._function.end
            if not inside or is_member(node) or self._is_gone(node):
                continue
            parent = node.parent
            is_target = parent is not None and parent.child_by_field_name("left") == node
            if not (is_target or self._is_sent(parent) or self._fills(node)):
                return False
            filling.append(statement_of(node))
        return is_of_its_own(self._analysis, filling)

    def _is_made(self, name: str) -> bool:
        """Whether nothing else has any of the objects that a variable gets."""
        return all(
            each.node.type == "augmented_assignment"
            or (
                each.kind is not BindingKind.PARAMETER
                and each.value is not None
                and is_fresh(self._analysis, each.value)
            )
            for each in self._function.bindings[name]
        )

    def _is_sent(self, arguments: Node | None) -> bool:
        call = arguments.parent if arguments and arguments.type == "argument_list" else None
        return call is not None and self._analysis.syntax.called_name(call) == "publish"

    def _fills(self, node: Node) -> bool:
        """Whether a variable is filled: `node.a.b = …`, `node.a.append(…)`."""
        current, parent = node, node.parent
        while parent is not None and node in holders(parent):
            current, parent = parent, parent.parent
        if parent is None or current is node:
            return False
        return parent.child_by_field_name("left") == current or _is_filling(parent)

    def _is_gone(self, node: Node) -> bool:
        return any(start <= node.start_byte < end for start, end in self._ranges)

    def _reads(self, node: Node | None) -> Names:
        """Return the variables that a part of the file mentions."""
        if node is None:
            return _NONE
        inside = nodes_in(node, [(node.start_byte, node.end_byte)])
        names = {
            self._analysis.syntax.slice(each)
            for each in inside
            if each.type == "identifier" and not is_member(each) and not self._is_gone(each)
        }
        return frozenset(names & self._names)

    def _block(self, block: Node | None, live: Names, ends: _Ends) -> Names:
        for statement in reversed(parts_of(block)):
            live = self._statement(statement, live, ends) | ends.failed
        return live

    def _statement(self, statement: Node, live: Names, ends: _Ends) -> Names:
        start, end = statement.start_byte, statement.end_byte
        if any(first <= start and end <= last for first, last in self._ranges):
            return live
        match statement.type:
            case "expression_statement":
                return self._assigned(statement, live)
            case "return_statement" | "raise_statement":
                return self._reads(statement)
            case "break_statement":
                return ends.broken
            case "continue_statement":
                return ends.continued
            case "if_statement":
                return self._condition(statement, live, ends)
            case "for_statement" | "while_statement":
                return self._loop(statement, live, ends)
            case "try_statement":
                return self._try(statement, live, ends)
            case "with_statement":
                failed = ends._replace(failed=ends.failed | live)
                block = statement.child_by_field_name("body")
                items = self._reads(next(iter(parts_of(statement)), None))
                return self._block(block, live, failed) | items
        # Of what else there is in a language nothing is known but what it mentions.
        return live | self._reads(statement) | ends.broken | ends.continued

    def _assigned(self, statement: Node, live: Names) -> Names:
        """Return what is live before a statement that may give a value."""
        inner = parts_of(statement)[0]
        target, value = inner.child_by_field_name("left"), inner.child_by_field_name("right")
        if _is_filling(inner):
            target, value = (inner.child_by_field_name(each) for each in ("function", "arguments"))
        is_left = target is not None and not self._is_gone(target)
        if target is None or value is None or value.type == "assignment" or not is_left:
            return live | self._reads(statement)
        held = holders(target)
        root = held[-1] if held else target
        name = self._analysis.syntax.slice(root) if root.type == "identifier" else ""
        is_added = inner.type == "augmented_assignment"
        names = self._own if held or is_added else self._names
        if is_added and value.type in _NUMBERS and not held:
            names = self._fresh
        is_own = name in names
        is_dead = is_own and name not in live and statement.id not in self._kept
        is_dead = is_dead and is_pure(self._analysis, value) and is_pure(self._analysis, target)
        self._dead[statement.id] = statement if is_dead else None
        if is_dead:
            return live
        if inner.type == "assignment" and not held and is_own:
            return (live - {name}) | self._reads(value)
        return live | self._reads(statement)

    def _condition(self, statement: Node, live: Names, ends: _Ends) -> Names:
        branches = [each for each in parts_of(statement) if each.type in _BRANCHES]
        has_else = any(each.type == "else_clause" for each in branches)
        found = _NONE if has_else else live
        for branch in (statement, *branches):
            found |= self._reads(branch.child_by_field_name("condition"))
            found |= self._block(_body(branch), live, ends)
        return found

    def _loop(self, loop: Node, live: Names, ends: _Ends) -> Names:
        over = self._reads(loop.child_by_field_name("right"))
        asked = self._reads(loop.child_by_field_name("condition"))
        other = next((each for each in parts_of(loop) if each.type == "else_clause"), None)
        behind = live | (self._block(_body(other), live, ends) if other is not None else _NONE)
        head = behind | asked
        while True:
            inside = ends._replace(broken=live, continued=head)
            more = head | self._block(loop.child_by_field_name("body"), head, inside)
            if more == head:
                return head | over
            head = more

    def _try(self, statement: Node, live: Names, ends: _Ends) -> Names:
        clauses = parts_of(statement)
        last = next((each for each in clauses if each.type == "finally_clause"), None)
        if last is not None:
            # What leaves the statement in any way passes here.
            ways = live | ends.broken | ends.continued | ends.failed
            live = self._block(_body(last), ways, ends)
            ends = _Ends(live, live, live)
        handled = ends.failed
        for each in clauses:
            if each.type in _HANDLERS:
                handled |= self._reads(each) - self._reads(_body(each))
                handled |= self._block(_body(each), live, ends)
        other = next((each for each in clauses if each.type == "else_clause"), None)
        behind = self._block(_body(other), live, ends) if other is not None else live
        inside = ends._replace(failed=handled | ends.failed)
        return self._block(statement.child_by_field_name("body"), behind, inside) | handled


def _running(scope: Scope) -> Scope:
    """Return the scope whose code runs where a comprehension is."""
    while scope.kind == "comprehension" and scope.parent is not None:
        scope = scope.parent
    return scope


def _body(clause: Node | None) -> Node | None:
    return next((each for each in parts_of(clause) if each.type == "block"), None)


def _is_filling(call: Node) -> bool:
    """Whether a call fills a list: `a.append(b)`."""
    callee = call.child_by_field_name("function") if call.type == "call" else None
    name = callee.child_by_field_name("attribute") if callee is not None else None
    return name is not None and (name.text or b"").decode("utf-8", "replace") in FILLING
