"""From rclpy to rospy: what calls back stands behind the attributes of its callbacks.

rclpy calls back while it spins; rospy at once, from other threads.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.sources.python.place import LAST
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.splices import before_comments, line_end, line_start
from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work, walk
from .rewriting import begins_line

_AT_ONCE = "rospy calls back at once, in a thread of its own: set it before this line"
_FILLING = frozenset({"add", "append", "extend", "insert", "setdefault", "update"})


@dataclass(frozen=True, slots=True)
class _Step:
    """A statement of `__init__`.

    Attributes:
        node: the statement.
        calls_back: whether callbacks may run from here on.
        names: all names in it.
        sets: the names and attributes that it sets, those of the methods that it calls included.
        fills: the attributes that it adds something to.
        uses: the attributes that it names, those of the methods that it names included.
    """

    node: Node
    calls_back: bool
    names: frozenset[str]
    sets: frozenset[str]
    fills: frozenset[str]
    uses: frozenset[str]


def move_early_callbacks(work: Work) -> None:
    """Move what calls back too early in the constructors of a file, or mark it."""
    for owner in work.analysis.scopes.classes():
        for function in work.analysis.scopes.all:
            if function.name == "__init__" and function.parent is owner and function.self_name:
                _Constructor(work, owner, function).settle()


class _Constructor:
    """What a constructor does, step by step."""

    def __init__(self, work: Work, owner: Scope, function: Scope) -> None:
        self._work = work
        self._owner = owner
        self._methods = {
            each.name: each
            for each in work.analysis.scopes.all
            if each.kind == "function" and each.parent is owner and each is not function
        }
        self._starts = {
            site.call.id: site
            for site in work.analysis.sites
            if site.shape.callback is not None or site.shape.node is not None
        }
        body = function.node.child_by_field_name("body")
        self._steps = [self._step(each) for each in parts_of(body)]

    def settle(self) -> None:
        """Move or mark each step whose callbacks use what a later one sets."""
        needed = {
            index: found
            for index, step in enumerate(self._steps)
            if step.calls_back and (found := self._needed(index))
        }
        moved: dict[int, int] = {}
        last = max((at for at, _ in needed.values()), default=0)
        for index in sorted(needed, reverse=True):
            own, name = needed[index]
            places = [at for at in (last, own) if self._is_safe(index, at, moved)]
            if places:
                moved[index] = places[0]
            else:
                node = self._steps[index].node
                self._work.mark(node, f"calls back before self.{name} is set", _AT_ONCE)
        for run in _runs(moved):
            self._move(run, moved[run[0]])

    def _needed(self, index: int) -> tuple[int, str] | None:
        """Return the last step that sets what the callbacks of a step use, and what it sets."""
        steps = self._steps
        known = {name for step in steps[: index + 1] for name in step.sets}
        known |= {*self._owner.bindings, *self._methods}
        used = steps[index].uses - known
        missing = {name for name in used if name.partition(".")[2] not in known}
        later = [
            (at, name.partition(".")[2])
            for at in range(index + 1, len(steps))
            for name in sorted((steps[at].sets & missing) | (steps[at].fills & steps[index].uses))
        ]
        if not later:
            return None
        return later[-1][0], later[0][1]

    def _is_safe(self, index: int, at: int, moved: dict[int, int]) -> bool:
        """Tell whether a step may as well stand behind a later one."""
        step, text = self._steps[index], self._work.analysis.syntax.text
        node = step.node
        is_plain = node.type in ("expression_statement", "if_statement")
        if not is_plain or not begins_line(self._work, node):
            return False
        if text[node.end_byte : line_end(text, node.end_byte)].strip()[:1] not in (b"", b"#"):
            return False
        between = [self._steps[k] for k in range(index + 1, at + 1) if moved.get(k) != at]
        own = {name for name in step.names if "." in name or not name.startswith("self")}
        return not any(
            any(each.type in LAST for each in walk(other.node))
            or (other.sets | other.fills) & own
            or step.sets & (other.names | other.uses)
            for other in between
        )

    def _move(self, run: list[int], at: int) -> None:
        work, text = self._work, self._work.analysis.syntax.text
        first, last = self._steps[run[0]].node, self._steps[run[-1]].node
        start, end = line_start(text, first.start_byte), line_end(text, last.end_byte)
        ends_group = not text[end : line_end(text, end)].strip()
        if ends_group:
            # What is said of the group is above it.
            start = before_comments(text, start)
        follows_gap = not text[line_start(text, start - 1) : start].strip()
        target = line_end(text, self._steps[at].node.end_byte - 1)
        gone = line_end(text, end) if ends_group and follows_gap else end
        work.move(start, end, gone, target, "\n" if follows_gap else "")

    def _step(self, node: Node) -> _Step:
        called = set(self._closure(self._mentioned(node, calls_only=True), calls_only=True))
        named = set(self._closure(self._mentioned(node, calls_only=False), calls_only=False))
        parts = [node, *(each.node for each in called)]
        names = {
            self._work.slice(each)
            for each in walk(node)
            if each.type in ("identifier", "attribute")
        }
        sets = {name for each in parts for name in _set(self._work, each, is_local=each is node)}
        fills = {name for each in parts for name in _filled(self._work, each)}
        uses = {
            name for each in (node, *(it.node for it in named)) for name in _named(self._work, each)
        }
        calls_back = any(self._calls_back(each) for each in walk(node))
        found = (frozenset(each) for each in (names, sets, fills, uses))
        return _Step(node, calls_back, *found)

    def _calls_back(self, node: Node) -> bool:
        callee = node.child_by_field_name("function") if node.type == "call" else None
        if callee is None:
            return False
        return node.id in self._starts or self._work.slice(callee).endswith(".registerCallback")

    def _mentioned(self, node: Node, *, calls_only: bool) -> Iterator[Scope]:
        """Yield the methods of the class that a node names, or calls."""
        for each in walk(node):
            name = self._work.slice(each) if each.type == "attribute" else ""
            method = self._methods.get(name.removeprefix("self."))
            parent = each.parent
            callee = parent.child_by_field_name("function") if parent is not None else None
            if method is not None and (not calls_only or callee == each):
                yield method

    def _closure(self, methods: Iterable[Scope], *, calls_only: bool) -> list[Scope]:
        found: dict[int, Scope] = {}
        pending = list(methods)
        while pending:
            method = pending.pop()
            if found.setdefault(id(method), method) is method and method not in pending:
                more = self._mentioned(method.node, calls_only=calls_only)
                pending += [each for each in more if id(each) not in found]
        return list(found.values())


def _set(work: Work, place: Node, *, is_local: bool) -> Iterator[str]:
    """Yield the attributes that a node sets, and the names of its own function."""
    for each in walk(place):
        left = each.child_by_field_name("left") if each.type == "assignment" else None
        for target in walk(left) if left is not None else ():
            is_part = target.parent is not None and target.parent.type == "attribute"
            is_name = is_local and target.type == "identifier" and not is_part
            if is_name or (target.type == "attribute" and not is_part):
                yield work.slice(target)


def _filled(work: Work, place: Node) -> Iterator[str]:
    """Yield what a node adds to: `self.names.append(…)`, `self.table[key] = …`."""
    for each in walk(place):
        target = each.child_by_field_name("left") if each.type == "assignment" else None
        holder = target.child_by_field_name("value") if target is not None else None
        callee = each.child_by_field_name("function") if each.type == "call" else None
        part = callee.child_by_field_name("attribute") if callee is not None else None
        if callee is not None and part is not None and work.slice(part) in _FILLING:
            holder = callee.child_by_field_name("object")
        if holder is not None and holder.type == "attribute":
            yield work.slice(holder)


def _named(work: Work, place: Node) -> Iterator[str]:
    """Yield the attributes of the object that a node names."""
    for each in walk(place):
        if each.type == "attribute" and work.slice(each).startswith("self."):
            yield work.slice(each)


def _runs(moved: dict[int, int]) -> Iterator[list[int]]:
    """Yield what is moved, neighbours that go to one place together."""
    run: list[int] = []
    for index in sorted(moved):
        if run and (index != run[-1] + 1 or moved[index] != moved[run[0]]):
            yield run
            run = []
        run.append(index)
    if run:
        yield run
