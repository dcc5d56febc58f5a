"""Taking out the code that only serves an endpoint: what is asked, waited for, and answered."""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from ..analysis import Analysis, Site
from ..scopes import CppFile, Function, Scope, Variable, statements_in
from .creation import delete_declarator, holder_of
from .deletions import Deletions
from .dependent_statements import DependentStatements
from .leftovers import functions_of, has_uses, remove_function
from .statements import is_inside, only_calls, only_sets, statement_of
from .uses import uses_of
from .visibility import access_of

_FILLING = frozenset(
    {"push_back", "emplace_back", "resize", "assign", "insert", "reserve", "clear", "fromSec"}
)
_ANSWERS = ("response", "Response")


class DependentCode:
    """The code that serves what goes.

    Attributes:
        used: where what goes is used in another way, as file and line.
    """

    def __init__(self, analysis: Analysis, gone: Deletions) -> None:
        self._analysis = analysis
        self._gone = gone
        self._serving = DependentStatements(analysis, gone)
        self._captures: list[tuple[CppFile, Node]] = []
        self._ended: list[tuple[Site, CppFile, Node]] = []
        self._named: list[str] = []
        self.used: list[tuple[CppFile, int]] = []

    def begin(self, variable: Variable) -> None:
        """Note a variable that goes with what it holds."""
        self._serving.going.add(variable)

    def take(self, file: CppFile, node: Node) -> bool:
        """Take out the statement around a use of what goes, where it does no more than that."""
        outer = node.parent
        if outer is not None and outer.type.startswith("lambda_capture"):
            self._captures.append((file, node))
            return True
        statement = statement_of(node)
        if statement is None or len(statement.children_by_field_name("declarator")) > 1:
            return False
        timers = list(self.timers_of(file, node))
        self._serving.ending = {each for _, each in timers}
        if not self._serving.serves(file, statement):
            return False
        self._ended += [
            (site, file, statement) for site, each in timers if _names(file, statement, each)
        ]
        self._take_statement(file, statement)
        return True

    def take_call(self, site: Site) -> bool:
        """Take out a call that asks without a client, with the statement that it is in."""
        statement = statement_of(site.call.node)
        if statement is None or site.call.receiver is not None:
            return False
        self._serving.asking.add(site.call.node.id)
        if not self._serving.serves(site.file, statement):
            return False
        self._take_statement(site.file, statement)
        return True

    def _take_statement(self, file: CppFile, statement: Node) -> None:
        held = list(dict.fromkeys(self._serving.holders(file, statement)))
        given = list(dict.fromkeys(self._serving.given_in(file, statement)))
        self._named += _words(file, statement, self._analysis)
        self._gone.statement(file, statement)
        for each in held:
            self._hold(each)
        is_apart = self._analysis.ros_version == 1 and len(given) == 2
        for at, each in enumerate(given):
            if each not in self._serving.going:
                self._take_given(each, is_answer=is_apart and at == 1)

    def _hold(self, variable: Variable) -> None:
        """Take out what holds something that came of what goes."""
        if variable in self._serving.going:
            return
        self._serving.going.add(variable)
        left = []
        for file, node, _ in uses_of(self._analysis, variable):
            if self._gone.covers(file, node.start_byte):
                continue
            statement = statement_of(node)
            is_set = statement is not None and only_sets(statement, node)
            is_other = is_set and not self._is_of_going(file, statement, variable)
            if (variable.kind != "local" and is_other) or not self.take(file, node):
                left.append((file, node))
        self.used += [(file, node.start_point.row + 1) for file, node in left]
        if not self._is_own(variable):
            self.used.append((variable.file, variable.node.start_point.row + 1))
        if not left and not self._gone.covers(variable.file, variable.node.start_byte):
            delete_declarator(variable, self._gone)

    def _is_own(self, variable: Variable) -> bool:
        """Tell whether no other file can name a variable."""
        if variable.file.is_beside or variable.kind not in ("local", "member", "global"):
            return False
        if variable.kind == "local" or not variable.file.name:
            return True
        owner = variable.scope.enclosing("class")
        return owner is not None and access_of(owner, variable.node) != "public"

    def _is_of_going(self, file: CppFile, statement: Node | None, variable: Variable) -> bool:
        """Tell whether a statement gives a variable what comes of something else that goes."""
        if statement is None:
            return False
        named = self._serving.named_in(file, statement)
        return any(each in self._serving.going and each is not variable for each in named)

    def _take_given(self, variable: Variable, *, is_answer: bool) -> None:
        """Take out a local variable that was only made and filled to be given away."""
        setting: list[tuple[CppFile, Node]] = []
        left: list[tuple[CppFile, Node]] = []
        for file, node, _ in uses_of(self._analysis, variable):
            if self._gone.covers(file, node.start_byte):
                continue
            statement = statement_of(node)
            if statement is not None and self._is_filling(file, statement, node):
                setting.append((file, statement))
            else:
                left.append((file, node))
        if left or variable.kind != "local":
            # What would be an answer is none any more.
            self.used += [
                (file, node.start_point.row + 1)
                for file, node in left
                if is_answer or _reads(file, node)
            ]
            return
        if not self._serving.is_idle(variable.file, variable.node):
            return
        for file, statement in setting:
            if not self._gone.covers(file, statement.start_byte):
                self._take_statement(file, statement)
        if not self._gone.covers(variable.file, variable.node.start_byte):
            delete_declarator(variable, self._gone)
        for each in list(self._serving.holders(variable.file, variable.node)):
            if each is not variable:
                self._hold(each)

    def _is_filling(self, file: CppFile, statement: Node, node: Node) -> bool:
        if only_sets(statement, node):
            return True
        if not only_calls(statement, node):
            return False
        callee = statement.named_children[0].child_by_field_name("function")
        field = None if callee is None else callee.child_by_field_name("field")
        return field is not None and file.syntax.word(field) in _FILLING

    def timers_of(self, file: CppFile, node: Node) -> Iterator[tuple[Site, Variable]]:
        """Yield the timers that call the function or lambda around a node, and what holds them."""
        for site in self._analysis.sites:
            if site.endpoint.kind is not EndpointKind.TIMER:
                continue
            bodies = self.bodies_of(site)
            if any(each is file and is_inside(node, body) for each, body in bodies):
                holder = holder_of(self._analysis, site)
                if holder is not None:
                    yield site, holder

    def bodies_of(self, site: Site) -> list[tuple[CppFile, Node]]:
        """Return the bodies of the functions, or of the lambda, that an endpoint calls."""
        found = [
            (each.file, body)
            for listed in functions_of(self._analysis, site)
            for each in listed
            if (body := each.node.child_by_field_name("body")) is not None
        ]
        at = site.shape.callback
        given = site.arguments[at] if at is not None and at < len(site.arguments) else None
        if given is not None and given.type == "lambda_expression":
            body = given.child_by_field_name("body")
            found += [] if body is None else [(site.place.file, body)]
        return found

    def is_idle(self, site: Site) -> bool:
        """Tell whether a timer has nothing left to do but to end itself."""
        holder = holder_of(self._analysis, site)
        self._serving.ending = set() if holder is None else {holder}
        return any(self._is_left_idle(file, body) for file, body in self.bodies_of(site))

    def _is_left_idle(self, file: CppFile, body: Node) -> bool:
        parts = statements_in(body)
        left = [each for each in parts if not self._gone.covers(file, each.start_byte)]
        return len(left) < len(parts) and all(
            each.type in ("declaration", "expression_statement", "return_statement")
            and not self._serving.is_work(file, each)
            for each in left
        )

    def take_handle(self, site: Site) -> None:
        """Take out the handle of a timer that goes, where it is there for a thread of its own.

        With it go the queue and the spinner of that thread.
        """
        handle = site.node
        left = [] if handle is None else self._left(handle)
        if handle is None or len(left) != 1:
            return
        file, node, _ = left[0]
        statement = statement_of(node)
        call = None if statement is None else statement.named_children[0]
        if statement is None or call is None or not only_calls(statement, node):
            return
        callee, given = (call.child_by_field_name(each) for each in ("function", "arguments"))
        if callee is None or not file.syntax.word(callee).endswith("setCallbackQueue"):
            return
        queue = self._serving.root(file, given.named_children[0]) if given is not None else None
        if queue is None or not queue.type.endswith("CallbackQueue"):
            return
        others = [
            (used, x)
            for used, x, _ in self._left(queue)
            if not (used is file and is_inside(x, statement))
        ]
        spinners = [
            each
            for known in self._analysis.unit.scopes()
            for listed in known.variables.values()
            for each in listed
            if each.type.endswith("AsyncSpinner")
            and any(used is each.file and is_inside(x, each.node) for used, x in others)
        ]
        if len(spinners) != len(others):
            return
        beginning = []
        for each in spinners:
            for x_file, x, _ in self._left(each):
                inner = statement_of(x)
                if inner is None or not only_calls(inner, x):
                    return
                beginning.append((x_file, inner))
        for x_file, inner in ((file, statement), *beginning):
            self._gone.statement(x_file, inner)
        for each in (handle, queue, *spinners):
            delete_declarator(each, self._gone)

    def _left(self, variable: Variable) -> list[tuple[CppFile, Node, Scope]]:
        return [
            each
            for each in uses_of(self._analysis, variable)
            if not self._gone.covers(each[0], each[1].start_byte)
        ]

    def note(self, file: CppFile, statement: Node) -> None:
        """Note the functions that a statement names which goes."""
        self._named += _words(file, statement, self._analysis)

    def _serves_alone(self, functions: list[Function]) -> bool:
        """Tell whether functions do nothing but log, and answer what is always the same."""
        own = DependentStatements(self._analysis, self._gone)
        own.is_alone = True
        own.going = {*self._serving.going, *(x for each in functions for x in each.parameters)}
        bodies = [(each.file, each.node.child_by_field_name("body")) for each in functions]
        return all(body is None or own.serves(file, body, leaves=True) for file, body in bodies)

    def is_asking(self, file: CppFile, node: Node, condition: Node) -> bool:
        """Tell whether a condition asks what goes, and hands it to nobody."""
        inner: Node | None = node
        while inner is not None and inner.id != condition.id:
            if inner.type in ("argument_list", "initializer_list"):
                return self._serving.is_idle(file, condition)
            inner = inner.parent
        return True

    def finish(self, lost: list[Site]) -> None:
        """Take out the functions that were only given away, and the captures of what is gone."""
        self.take_named()
        for site, file, statement in self._ended:
            if site not in lost:
                self.used.append((file, statement.start_point.row + 1))
        for file, node in self._captures:
            if not self._gone.covers(file, node.start_byte):
                self._take_capture(file, node)

    def take_named(self) -> None:
        """Take out the functions that only what goes named, and that do nothing but serve it."""
        for name in dict.fromkeys(self._named):
            for same in self._analysis.unit.functions_by_class(name):
                if any(each.file.is_beside for each in same):
                    continue
                if not any(each.statements for each in same):
                    continue
                if not has_uses(self._analysis, same, self._gone) and self._serves_alone(same):
                    for each in same:
                        remove_function(each, self._gone)

    def _take_capture(self, file: CppFile, node: Node) -> None:
        listed = node.parent
        if listed is None or listed.type != "lambda_capture_specifier":
            self.used.append((file, node.start_point.row + 1))
            return
        text = file.syntax.code
        start, end = node.start_byte, node.end_byte
        while text[start - 1 : start] in (b"&", b" "):
            start -= 1
        items = [each for each in listed.named_children if each.end_byte > each.start_byte]
        if items and items[0].id == node.id:
            while text[end : end + 1] in (b",", b" ", b"\n"):
                end += 1
            start = listed.start_byte + 1
        else:
            while text[start - 1 : start] in (b",", b" ", b"\n"):
                start -= 1
        self._gone.part(file, start, end)


def _names(file: CppFile, statement: Node, variable: Variable) -> bool:
    return variable.name in file.syntax.word(statement)


def _words(file: CppFile, statement: Node, analysis: Analysis) -> Iterator[str]:
    """Yield the names of functions of the files that a statement has."""
    pending = [statement]
    while pending:
        each = pending.pop()
        pending += each.named_children
        if each.type.endswith("identifier"):
            name = file.syntax.word(each).rpartition("::")[2]
            if name in analysis.unit.functions:
                yield name


def _reads(file: CppFile, node: Node) -> bool:
    """Tell whether a use reads the answer that a service gives."""
    outer = node.parent
    field = None if outer is None else outer.child_by_field_name("field")
    return field is not None and file.syntax.word(field) in _ANSWERS
