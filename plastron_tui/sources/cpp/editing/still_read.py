"""What only a function set that nothing calls any more, and other functions go on reading."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import Change
from plastron_tui.sources.left_behind import no_longer_set, taking

from ..analysis import Analysis
from ..scopes import CppFile, Function, Scope, Variable, scope_at
from .accesses import CLEARING, Access, Path, access
from .creation import variable_of
from .deletions import Deletions
from .leftovers import has_uses
from .uncalled import span_of
from .units import sites_of
from .uses import uses_of

_NAMES = frozenset({"identifier", "field_identifier"})
_LOOPS = frozenset({"while_statement", "for_statement", "do_statement", "for_range_loop"})
_EMPTY = re.compile(
    r'|0|0\.0*f?|false|nullptr|NULL|""|(?:std::)?nullopt|\{\}'
    r"|(?:\w+::)*[A-Z]\w*(?:\(\)|\{\})|[\w:<>, ]+\{\}"
)


class _Part(NamedTuple):
    """A part of a file that does not run any more."""

    file: CppFile
    start: int
    end: int

    def has(self, file: CppFile, offset: int) -> bool:
        """Tell whether a place is in it."""
        return file is self.file and self.start <= offset < self.end


def tell_still_read(
    before: Analysis, after: Analysis, changes: Sequence[Change], uncalled: Sequence[Function]
) -> Iterator[Diagnostic]:
    """Warn of what nothing sets any more, and who reads it all the same.

    Args:
        before: the files as they were.
        after: the files as they are.
        changes: what was asked for.
        uncalled: the functions that nothing calls any more.
    """
    gone = [_part_of(each.file, each.node) for each in _never_run(after, uncalled)]
    found = _set_in(after, gone)
    for variable, paths in _set_in(before, list(_lambdas(before, changes))).items():
        same = _found_again(after, variable)
        if same is not None:
            found[same] |= paths
    told = []
    for variable, paths in found.items():
        if not any(each.has(variable.file, variable.start) for each in gone):
            told.append((variable.name, list(_Uses(after, variable, gone).readers(paths))))
    note = no_longer_set(told, span_of(changes))
    if note is not None:
        yield note


def _part_of(file: CppFile, node: Node) -> _Part:
    return _Part(file, node.start_byte, node.end_byte)


def _never_run(analysis: Analysis, uncalled: Sequence[Function]) -> list[Function]:
    """Return functions that nothing calls, and those that only they call."""
    gone = list(uncalled)
    for function in gone:
        part = _part_of(function.file, function.node)
        names = {
            name
            for name, calls in analysis.unit.calls.items()
            if any(part.has(each.scope.file, each.node.start_byte) for each in calls)
        }
        for name in sorted(names & analysis.unit.functions.keys()):
            own = analysis.unit.functions_of(analysis.unit.class_of_function(function), name)
            defined = [each for each in own if each.scope is not None]
            if len(defined) != 1 or defined[0] in gone or defined[0].file.is_beside:
                continue
            left = Deletions()
            for each in gone:
                left.part(each.file, each.node.start_byte, each.node.end_byte)
            if not has_uses(analysis, own, left):
                gone.append(defined[0])
    return gone


def _lambdas(before: Analysis, changes: Sequence[Change]) -> Iterator[_Part]:
    """Yield the lambdas that the endpoints which change were given to call."""
    for change in taking(changes):
        for site in sites_of(before, change):
            at = site.shape.callback
            if at is not None and at < len(site.arguments):
                yield _part_of(site.place.file, site.arguments[at])


def _set_in(analysis: Analysis, parts: Sequence[_Part]) -> defaultdict[Variable, set[Path]]:
    """Return the variables of others that parts of files set, each with what of it they set."""
    found: defaultdict[Variable, set[Path]] = defaultdict(set)
    for part in parts:
        root = part.file.syntax.root
        pending = [root.named_descendant_for_byte_range(part.start, part.end)]
        while pending:
            node = pending.pop()
            if node is None:
                continue
            pending += node.named_children
            if node.type not in _NAMES:
                continue
            done = access(analysis, part.file, node)
            if not done.is_set:
                continue
            variable = _variable(analysis, part.file, node)
            if variable is not None and not part.has(variable.file, variable.start):
                found[variable].add(done.path)
    return found


def _variable(analysis: Analysis, file: CppFile, node: Node) -> Variable | None:
    scope, outer = scope_at(file, node.start_byte), node.parent
    if node.type == "field_identifier" and outer is not None and outer.type == "field_expression":
        return variable_of(analysis, outer, scope)
    return variable_of(analysis, node, scope)


def _found_again(after: Analysis, variable: Variable) -> Variable | None:
    """Return a variable of the files as they were, in the files as they are."""
    old = variable.scope
    key = old.file.name, old.kind, old.qualified, _function_name(old)
    for file in after.unit.files:
        for scope in file.scopes:
            if (file.name, scope.kind, scope.qualified, _function_name(scope)) == key:
                found = scope.variables.get(variable.name)
                if found:
                    return found[0]
    return None


def _function_name(scope: Scope) -> str:
    around = scope.enclosing("function")
    return "" if around is None else around.name


class _Uses:
    """The uses of a variable outside of what never runs."""

    def __init__(self, analysis: Analysis, variable: Variable, gone: Sequence[_Part]) -> None:
        self._analysis = analysis
        self._variable = variable
        self._gone = gone

    def readers(self, paths: set[Path]) -> Iterator[str]:
        """Yield who reads what nothing sets of some parts of the variable, and in which line."""
        set_: list[tuple[Scope, Access]] = []
        read: list[tuple[Scope, Node, Access]] = []
        for file, node, scope in uses_of(self._analysis, self._variable):
            is_captured = node.parent is not None and node.parent.type.startswith("lambda_capture")
            if is_captured or any(each.has(file, node.start_byte) for each in self._gone):
                continue
            done = access(self._analysis, file, node)
            if done.is_handed:
                set_.append((scope, done._replace(is_set=False)))
            elif done.is_set:
                set_.append((scope, done))
            elif done.method not in CLEARING:
                read.append((scope, node, done))
        first = [(scope, each) for scope, each in set_ if self._is_first(scope, each.whole)]
        values = {_value(scope.file, each) for scope, each in first} | {self._declared()}
        again = {
            each.path
            for scope, each in set_
            if (scope, each) not in first and not self._is_same(scope.file, each, values)
        }
        left = [path for path in paths if not any(path[: len(each)] == each for each in again)]
        told: dict[Function | None, str] = {}
        for scope, node, done in read:
            function = scope.around
            is_first = self._variable.kind != "local" and self._is_first(scope, node)
            if not is_first and function not in told and any(_reads(done, each) for each in left):
                told[function] = self._told(scope, node, function)
        yield from told.values()

    def _declared(self) -> str | None:
        value, file = self._variable.value, self._variable.file
        return None if value is None else "".join(file.syntax.word(value).split())

    def _is_same(self, file: CppFile, done: Access, values: set[str | None]) -> bool:
        """Whether something is set to nothing, or to what it is from the first on."""
        value = _value(file, done)
        return value is not None and (value in values or _EMPTY.fullmatch(value) is not None)

    def _is_first(self, scope: Scope, node: Node) -> bool:
        """Whether something is done once, before any callback is called."""
        current: Node | None = node
        while current is not None and current.type != "function_definition":
            if current.type in _LOOPS or current.type == "lambda_expression":
                return False
            current = current.parent
        function = scope.around
        if function is None or function is self._variable.scope.around:
            return True
        if function.name in (function.class_name, "onInit", "main"):
            return True
        callers = self._analysis.callers.of(function)
        makers = [each.scope.enclosing("function", "lambda") for each in callers]
        sites = self._analysis.sites
        is_called_back = any(function in each.callback.functions for each in sites)
        return (
            bool(makers)
            and not is_called_back
            and all(
                each is not None
                and each.function is not None
                and each.function.name in (function.class_name, "onInit")
                for each in makers
            )
        )

    def _told(self, scope: Scope, node: Node, function: Function | None) -> str:
        who = "" if function is None else f" by `{function.name}`"
        where = scope.file.place_of(node.start_point.row + 1)
        return f"{'waited for' if _is_wait(node) else 'read'}{who} in line {where}"


def _is_wait(node: Node) -> bool:
    """Whether a use of a variable keeps a function waiting for its value."""
    current, asked = node, False
    while (parent := current.parent) is not None and not current.type.endswith("_statement"):
        if parent.type == "unary_expression" and (parent.text or b"").startswith(b"!"):
            asked = True
        if parent.type == "binary_expression" and b"nullptr" in (parent.text or b""):
            asked = True
        if parent.type == "while_statement":
            condition = parent.child_by_field_name("condition")
            return asked and condition is not None and condition.id == current.id
        current = parent
    return False


def _value(file: CppFile, done: Access) -> str | None:
    """Return the text of what a variable is given, None where it does more."""
    outer = done.whole.parent
    if outer is None:
        return None
    if outer.type == "assignment_expression" and _sign(outer) == b"=":
        right = outer.child_by_field_name("right")
        return None if right is None else "".join(file.syntax.word(right).split())
    if outer.type == "field_initializer":
        given = outer.named_children[-1]
        return "".join(file.syntax.word(given).split()).strip("(){}")
    return None


def _sign(node: Node) -> bytes:
    sign = node.child_by_field_name("operator")
    return b"" if sign is None else sign.text or b""


def _reads(done: Access, part: Path) -> bool:
    """Whether an access takes a part of what a variable holds, or more, or less of it.

    What a method does with the other parts of its object is not known.
    """
    shorter = len(part) if done.method else min(len(done.path), len(part))
    return done.path[:shorter] == part[:shorter]
