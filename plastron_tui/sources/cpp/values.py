"""What the expressions of a unit are worth, as far as its files say it.

A value that is not known is None: what a function of another file returns, what a loop counts,
what two places give differently.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from tree_sitter import Node

from plastron_tui.sources.work_limits import bounded

from .arguments import Call, call_of
from .fields import Fields
from .flow import reaching_write
from .literals import number_value, replaced, string_value
from .scopes import Function, Scope, Variable, last_name
from .unit import Unit
from .value import Value, calculated
from .writes import Write

if TYPE_CHECKING:
    from .callers import Callers

MOST_WRITES = 16
_STRING_TYPES = re.compile(r"(?:std::)?(?:string|string_view|basic_string)")
_PLAIN = re.compile(
    r"(?:std::)?(?:string|string_view)|bool|float|double|auto|char|(?:std::)?u?int(?:8|16|32|64)?_t"
    r"|(?:std::)?size_t|(?:un)?signed(?:int|long|short)*|u?int|(?:long|short)+(?:int)?|"
)
_SAME = frozenset({"c_str", "str", "data", "string", "value", "get"})
_CASTS = frozenset({"static_cast", "const_cast", "reinterpret_cast", "dynamic_cast"})
_NUMBERS = frozenset(
    {"int", "double", "float", "unsigned", "size_t", "long", "uint32_t", "int32_t"}
)


class Evaluator:
    """What the expressions of the files of a unit are worth."""

    def __init__(self, unit: Unit, callers: Callers) -> None:
        self.unit = unit
        self.effort = unit.effort
        self._callers = callers
        self.fields = Fields(unit)
        self._known: dict[Variable, Value | None] = {}
        self._asked: set[Variable] = set()

    @bounded(None)
    def fold(self, node: Node | None, scope: Scope) -> Value | None:
        """Return what an expression is worth, None where that is not known."""
        if node is None:
            return None
        syntax = scope.file.syntax
        match node.type:
            case "string_literal" | "raw_string_literal":
                text = string_value(syntax.word(node))
                return None if text is None else Value(text)
            case "concatenated_string":
                return self._joined(node, scope)
            case "char_literal":
                text = syntax.word(node)
                return Value(text[1:-1]) if len(text) == 3 else None
            case "number_literal":
                number = number_value(syntax.word(node))
                return None if number is None else Value(number)
            case "true" | "false":
                return Value(node.type == "true")
            case "user_defined_literal":
                text = string_value(syntax.word(node).strip())
                return None if text is None else Value(text)
            case "identifier" | "field_identifier" | "type_identifier":
                return self._named(syntax.word(node), node, scope)
            case "qualified_identifier":
                return self._qualified(node, scope)
            case "field_expression":
                return self._field(node, scope)
            case "parenthesized_expression":
                inner = node.named_children
                return self.fold(inner[0], scope) if len(inner) == 1 else None
            case "initializer_list":
                return self._listed(node, scope)
            case "binary_expression":
                return self._binary(node, scope)
            case "unary_expression":
                return self._unary(node, scope)
            case "cast_expression":
                return self.fold(node.child_by_field_name("value"), scope)
            case "call_expression":
                call = call_of(node, scope, syntax)
                return self._called(call, scope) if call is not None else None
            case "compound_literal_expression":
                return self._made(node, scope)
            case _:
                return None

    def _joined(self, node: Node, scope: Scope) -> Value | None:
        parts = [self.fold(each, scope) for each in node.named_children]
        known = [each for each in parts if each is not None and each.text is not None]
        if len(known) < len(parts) or not known:
            return None
        return Value("".join(each.text or "" for each in known)).like(*known)

    def _listed(self, node: Node, scope: Scope) -> Value | None:
        """Return a list of values; a single value in braces is that value where one is wanted."""
        found = [self.fold(each, scope) for each in node.named_children[:200]]
        items = []
        for each in found:
            if each is None or isinstance(each.value, tuple):
                return None
            items.append(each.value)
        known = [each for each in found if each is not None]
        return Value(tuple(items)).like(*known)

    def _made(self, node: Node, scope: Scope) -> Value | None:
        """Return the value of `std::string{"x"}` and of `std::vector<int>{1, 2}`."""
        type_node, given = node.child_by_field_name("type"), node.child_by_field_name("value")
        if type_node is None or given is None:
            return None
        type_ = "".join(scope.file.syntax.word(type_node).split())
        listed = self._listed(given, scope)
        if listed is None or not isinstance(listed.value, tuple):
            return None
        if "vector<" in type_ or "array<" in type_:
            return listed
        return listed._replace(value=listed.value[0]) if len(listed.value) == 1 else None

    def _named(self, name: str, node: Node, scope: Scope) -> Value | None:
        variable = self.unit.lookup(name, scope, node.start_byte)
        if variable is None:
            return self._defined(name)
        if variable.kind == "local" and variable not in self.unit.items:
            writes = self.unit.writes(variable)
            if 1 < len(writes) <= MOST_WRITES:
                reaching = reaching_write(writes, node, scope)
                if reaching is not None:
                    return self._reached(reaching, variable)
        return self.variable(variable)

    def _reached(self, writes: list[Write], variable: Variable) -> Value | None:
        """Return the value of a local variable after what was last written to it."""
        if self.unit.is_changed_unseen(variable):
            return None
        *earlier, last = writes
        if last.call is None:
            return self._written(last, variable)
        before = self._reached(earlier, variable) if earlier else None
        return self._callers.parameters.read_into(last.call, self, before)

    def _defined(self, name: str) -> Value | None:
        """Return the value of a macro."""
        value = replaced(name, self.unit.defines)
        return None if value is None else Value(value)

    def _qualified(self, node: Node, scope: Scope) -> Value | None:
        """Return the value of `Class::NAME` and `space::NAME`."""
        text = "".join(scope.file.syntax.word(node).split()).removeprefix("::")
        found = self.unit.qualified(text, scope)
        return self._agreed([self.variable(each) for each in found]) if found else None

    def _field(self, node: Node, scope: Scope) -> Value | None:
        holder = node.child_by_field_name("argument")
        inner = node.child_by_field_name("field")
        if holder is None or inner is None:
            return None
        name = scope.file.syntax.word(inner)
        if holder.type == "this":
            owner = self.unit.class_of(scope)
        else:
            held = last_name(holder, scope)
            variable = self.unit.lookup(held, scope, holder.start_byte) if held else None
            owner = None
            is_own = variable is not None and variable.kind in ("local", "member", "global")
            if variable is not None and is_own and not variable.is_pointer:
                owner = self.unit.find_class(variable.type, scope)
                # An object that is made of something may have other values than its class gives.
                if owner is not None and self.unit.writes(variable):
                    given = self.fields.given(variable, owner, name)
                    return self.fold(*given) if given is not None else None
        member = self.unit.member(owner, name) if owner is not None else None
        if member is None and holder.type != "this":
            set_before = self.fields.set_before(node, name, holder, scope)
            return self.fold(*set_before) if set_before is not None else None
        return self.variable(member) if member is not None else None

    def _binary(self, node: Node, scope: Scope) -> Value | None:
        left = self.fold(node.child_by_field_name("left"), scope)
        right = self.fold(node.child_by_field_name("right"), scope)
        operator = node.child_by_field_name("operator")
        if left is None or right is None or operator is None:
            return None
        if left.text is not None or right.text is not None:
            if operator.type != "+" or left.text is None or right.text is None:
                return None
            return Value(left.text + right.text).like(left, right)
        one, other = left.number, right.number
        if one is None or other is None:
            return None
        result = calculated(operator.type, one, other)
        return None if result is None else Value(result).like(left, right)

    def _unary(self, node: Node, scope: Scope) -> Value | None:
        operator = node.child_by_field_name("operator")
        inner = self.fold(node.child_by_field_name("argument"), scope)
        if operator is None or inner is None or inner.number is None:
            return None
        if operator.type not in ("-", "+"):
            return None
        return inner._replace(value=-inner.number if operator.type == "-" else inner.number)

    def _called(self, call: Call, scope: Scope) -> Value | None:
        """Return what a call gives whose arguments say it."""
        name, given = call.name, call.arguments
        first = given[0] if given else None
        if call.receiver is not None:
            if name in _SAME and not given:
                return self.fold(call.receiver, scope)
            return self._read(call, scope)
        if _STRING_TYPES.fullmatch(call.qualified) and len(given) == 1:
            return self.fold(first, scope)
        if name in _CASTS | _NUMBERS or call.qualified in ("std::move", "std::forward"):
            return self.fold(first, scope) if len(given) == 1 else None
        if name == "to_string" and len(given) == 1:
            value = self.fold(first, scope)
            if value is not None and type(value.value) is int:
                return Value(str(value.value)).like(value)
            return None
        return self._read(call, scope) or self._returned(call)

    def _read(self, call: Call, scope: Scope) -> Value | None:
        """Return the default of a parameter that a call reads, which may have another value."""
        del scope
        return self._callers.parameters.read_by(call, self)

    def _returned(self, call: Call) -> Value | None:
        """Return what a function that does nothing else returns."""
        function = self.unit.returning(call)
        if function is None:
            return None
        if not function.parameters:
            return self.fold(function.returned, function.scope or function.place)
        bindings = self.unit.bindings
        if function in bindings:
            return None
        self.unit.bindings = {**bindings, function: (call, {})}
        found = self.fold(function.returned, function.scope or function.place)
        self.unit.bindings = bindings
        return found

    def variable(self, variable: Variable) -> Value | None:
        """Return the one value that a variable has wherever it can be asked for."""
        is_bound = bool(self.unit.bindings or self.unit.items)
        if not is_bound and variable in self._known:
            return self._known[variable]
        if variable in self._asked:
            return None
        self._asked.add(variable)
        found = self._variable(variable)
        self._asked.discard(variable)
        if not is_bound and not self._asked:
            self._known[variable] = found
        return found

    def before(self, node: Node, scope: Scope) -> Value | None:
        """Return what an expression is worth before what is just looked at.

        In `rate = declare_parameter("rate", rate)` the default is what the variable was before.
        """
        name = last_name(node, scope)
        variable = self.unit.lookup(name, scope, node.start_byte) if name else None
        if variable is not None and variable in self._asked:
            return self._initial(variable)
        return self.fold(node, scope)

    def _initial(self, variable: Variable) -> Value | None:
        """Return what a variable is made with."""
        writes = self.unit.writes(variable)
        first = [each for each in writes if each.node.type == "field_initializer"] or [
            each for each in writes if each.node.id == variable.node.id
        ]
        return self._written(first[0], variable) if len(first) == 1 else None

    @bounded(None)
    def _variable(self, variable: Variable) -> Value | None:
        if variable in self.unit.items:
            item = self.unit.items[variable]
            return item if isinstance(item, Value) else None
        if variable.kind == "parameter":
            function = variable.scope.function
            return self._given(variable, function) if function is not None else None
        if variable.kind == "loop":
            return None
        writes = self.unit.writes(variable)
        if not 0 < len(writes) <= MOST_WRITES or self.unit.is_changed_unseen(variable):
            return None
        # An initializer of the constructor takes the place of that of the declaration.
        if any(each.node.type == "field_initializer" for each in writes):
            writes = [each for each in writes if each.node.id != variable.node.id]
        plain = [each for each in writes if each.call is None]
        found = [self._written(each, variable) for each in plain]
        # What is empty before it gets its value is never meant.
        meant = [each for each in found if each is None or each.value != ""]
        reads = [each for each in writes if each.call is not None]
        before = self._agreed(meant) if meant else (found[0] if found else None)
        if not reads:
            return before
        values = [
            self._callers.parameters.read_into(each.call, self, before)
            for each in reads
            if each.call is not None
        ]
        return self._agreed(values)

    def _written(self, write: Write, variable: Variable) -> Value | None:
        if write.value is not None and write.value.type == "initializer_list":
            if not variable.is_list and not _PLAIN.fullmatch(variable.type):
                return None
            listed = self._listed(write.value, write.scope)
            return _single(listed, variable)
        if write.value is not None:
            return self.fold(write.value, write.scope)
        given = write.arguments
        if given is None:
            return None
        if not given:
            return Value("") if _STRING_TYPES.fullmatch(variable.type) else None
        if variable.is_list:
            items = [self.fold(each, write.scope) for each in given]
            known = [each for each in items if each is not None]
            if len(known) < len(items) or any(isinstance(each.value, tuple) for each in known):
                return None
            values = [each.value for each in known if not isinstance(each.value, tuple)]
            return Value(tuple(values)).like(*known)
        # What is made of a text or a number is seldom that text or number.
        if len(given) != 1 or not _PLAIN.fullmatch(variable.type):
            return None
        return self.fold(given[0], write.scope)

    def _given(self, parameter: Variable, function: Function) -> Value | None:
        """Return what a parameter is given, by all calls alike."""
        position = next(
            (at for at, each in enumerate(function.parameters) if each is parameter), None
        )
        if position is None:
            return None
        default = self._callers.default_of(function, position)
        bound = self.unit.bindings.get(function)
        if bound is not None:
            call, _ = bound
            if call is None:
                return None
            given = self._callers.given(call, function, position)
            if given is not None:
                return self.fold(given, call.scope)
            return self.fold(default, function.place) if default is not None else None
        calls = self._callers.of(function)
        if not calls:
            value = self.fold(default, function.place) if default is not None else None
            return None if value is None else value._replace(is_guess=True)
        found = []
        for call in calls[:MOST_WRITES]:
            given = self._callers.given(call, function, position)
            place = call.scope if given is not None else function.place
            found.append(self.fold(given if given is not None else default, place))
        return self._agreed(found) if len(calls) <= MOST_WRITES else None

    def _agreed(self, found: list[Value | None]) -> Value | None:
        """Return the value that all of some are."""
        known = [each for each in found if each is not None]
        if not known or len(known) < len(found):
            return None
        first = known[0]
        if any(
            (each.value, type(each.value)) != (first.value, type(first.value)) for each in known
        ):
            return None
        return first.like(*known)


def _single(listed: Value | None, variable: Variable) -> Value | None:
    if listed is None or variable.is_list or not isinstance(listed.value, tuple):
        return listed
    if not listed.value:
        return Value("") if _STRING_TYPES.fullmatch(variable.type) else None
    return listed._replace(value=listed.value[0]) if len(listed.value) == 1 else None
