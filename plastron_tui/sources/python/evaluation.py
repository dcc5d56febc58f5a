"""What an expression gives: numbers, booleans, texts and lists, worked out where that is sure.

`Constants` folds the texts that name endpoints; here are the values of parameters and periods.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.work_limits import bounded

from . import literals
from .analysis import Analysis
from .arguments import Arguments
from .calls import Argument
from .constants import MOST_DEEP, Defaulted, Known, without_none
from .containers import Given
from .evaluated import (
    CONVERSIONS,
    LONGEST,
    OPERATORS,
    UNKNOWN,
    Evaluated,
    computed,
    converted,
    evaluated,
    repeated,
)
from .flow import reaching
from .guesses import is_default_guess
from .parameter_calls import READERS, VALUE_FIELDS, parameter_call
from .scopes import Binding, BindingKind, Scope
from .syntax import parts_of

_CONSTANTS = {
    f"{module}.{name}": getattr(math, name)
    for module in ("math", "numpy")
    for name in ("pi", "e", "inf", "nan")
} | {"math.tau": math.tau}
_FUNCTIONS = {
    "math.sqrt": math.sqrt,
    "math.radians": math.radians,
    "math.degrees": math.degrees,
    "numpy.radians": math.radians,
    "numpy.deg2rad": math.radians,
    "numpy.degrees": math.degrees,
    "numpy.rad2deg": math.degrees,
}
_TEXTS = frozenset(
    {"os.path.join", "os.path.expanduser", "os.path.abspath", "os.path.dirname", "os.getcwd"}
    | {"os.path.realpath", "os.path.basename", "os.path.expandvars", "socket.gethostname"}
    | {"ament_index_python.packages.get_package_share_directory"}
    | {"ament_index_python.get_package_share_directory"}
    | {"rospy.get_name", "rospy.get_namespace"}
)
# What gives its second argument where nobody says anything else.
_READERS = READERS | dict.fromkeys(("os.getenv", "os.environ.get"), Argument(1, "default"))
_TEXT_METHODS = frozenset({"format", "join", "strip", "lower", "upper", "replace"})
# Where a file says what runs it.
_HEAD = 4096
_RECORDS = frozenset({b"NamedTuple", b"TypedDict", b"BaseModel", b"Struct"})
# That of two large integers takes for ever; a negative one gives a float.
_GREATEST_POWER = 64
# How often a parameter is declared at most whose default is looked for.
_MOST_DECLARED = 8
_GETTERS = frozenset({"get_parameter", "get_parameter_or", "declare_parameter"})


class Evaluator:
    """Evaluates the expressions of one file, whose call sites are known."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._syntax = analysis.syntax
        self._resolver = analysis.resolver
        self._values: dict[int, Evaluated] = {}
        self._declared: dict[str, list[Given]] | None = None
        self._fields: dict[str, list[tuple[str, Node]]] | None = None
        self.effort = analysis.resolver.effort

    @bounded(UNKNOWN)
    def evaluate(self, node: Node | None, scope: Scope, depth: int = 0) -> Evaluated:
        """Return what an expression gives."""
        handler = _HANDLERS.get(node.type) if node is not None else None
        if node is None or handler is None or depth > MOST_DEEP:
            return UNKNOWN
        if node.id not in self._values:
            # What is said by itself is unknown.
            self._values[node.id] = UNKNOWN
            self._values[node.id] = handler(self, node, scope, depth + 1)
        return self._values[node.id]

    def resolved(self, node: Node | None, scope: Scope) -> Given | None:
        """Return the expression that an expression stands for, itself where it is no name."""
        if node is None:
            return None
        return self._resolver.containers.literal(node, scope)

    def field_values(self, holder: Node) -> Sequence[tuple[str, Node]]:
        """Return what the file assigns to fields of an object of a name, in its order."""
        if self._fields is None:
            self._fields = {}
            for assignment in self._analysis.captures.get("assignment", []):
                target, value = (assignment.child_by_field_name(s) for s in ("left", "right"))
                if target is None or value is None or target.type != "attribute":
                    continue
                held, _, name = "".join(self._syntax.slice(target).split()).rpartition(".")
                self._fields.setdefault(held, []).append((name, value))
        return self._fields.get("".join(self._syntax.slice(holder).split()), ())

    def read_parameter(self, node: Node, scope: Scope) -> Given | None:
        """Return the call that reads the parameter whose value `….value` is, None for others."""
        field = node.child_by_field_name("attribute")
        if field is None or self._syntax.slice(field) not in ("value", "_value", *VALUE_FIELDS):
            return None
        held = self.resolved(node.child_by_field_name("object"), scope)
        for _ in range(2):
            if held is None or held.node.type != "call":
                return None
            called = self._syntax.called_name(held.node)
            if called in _GETTERS:
                return held
            callee = held.node.child_by_field_name("function")
            if called != "get_parameter_value" or callee is None:
                return None
            held = self.resolved(callee.child_by_field_name("object"), held.scope)
        return None

    def _literal(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        try:
            value = literals.value_of(self._syntax.slice(node))
        except (ValueError, SyntaxError, MemoryError, RecursionError):
            return UNKNOWN
        return evaluated(value)

    def _text(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        folded = self._resolver.fold(node, scope, depth)
        if folded is not None and isinstance(folded.value, str):
            return Evaluated("string", folded.value, isinstance(folded, Defaulted))
        prefix = self._syntax.slice(node)[:2].lower()
        return UNKNOWN if "b" in prefix.split("'")[0].split('"')[0] else Evaluated("string")

    def _within(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        inner = parts_of(node)
        return self.evaluate(inner[0], scope, depth) if len(inner) == 1 else UNKNOWN

    def _not(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        given = self.evaluate(node.child_by_field_name("argument"), scope, depth)
        known = given.value is not None
        return Evaluated("bool", not given.value if known else None, given.is_guess)

    def _sign(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        given = self.evaluate(node.child_by_field_name("argument"), scope, depth)
        sign = node.child_by_field_name("operator")
        if given.type not in ("int", "float") or sign is None or sign.type not in ("-", "+"):
            return UNKNOWN
        if isinstance(given.value, int | float) and sign.type == "-":
            return given._replace(value=-given.value)
        return given

    def _operation(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        fields = (node.child_by_field_name(name) for name in ("left", "operator", "right"))
        left_node, sign, right_node = fields
        if sign is None:
            return UNKNOWN
        left = self.evaluate(left_node, scope, depth)
        if left.type == "string" and sign.type in ("+", "%"):
            return self._text(node, scope, depth)
        right = self.evaluate(right_node, scope, depth)
        if right.type == "string" and sign.type == "+":
            return self._text(node, scope, depth)
        is_guess = left.is_guess or right.is_guess
        if sign.type == "*" and isinstance(left.value, tuple):
            return repeated(left, right)
        types = {left.type, right.type}
        if sign.type not in OPERATORS or not types <= {"int", "float"}:
            return UNKNOWN
        is_float = "float" in types or sign.type == "/"
        is_guess = is_guess or (types == {"int"} and sign.type == "/" and self._may_round)
        plain = Evaluated("float" if is_float else "int", None, is_guess)
        if sign.type == "**" and not is_float and right.value not in range(_GREATEST_POWER):
            return UNKNOWN
        return computed(OPERATORS[sign.type], (left.value, right.value), plain)

    @property
    def _may_round(self) -> bool:
        """Whether Python 2 may run the file, where `1 / 2` is 0."""
        head = self._syntax.text[:_HEAD]
        is_python3 = b"python3" in head.partition(b"\n")[0] or b"import division" in head
        return self._analysis.library.ros_version == 1 and not is_python3

    def _choice(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        """Evaluate `a if condition else b` as far as both are the same."""
        sides = parts_of(node)
        if len(sides) != 3:
            return UNKNOWN
        one, other = (self.evaluate(side, scope, depth) for side in (sides[0], sides[2]))
        if one.type != other.type:
            return UNKNOWN
        is_guess = one.is_guess or other.is_guess
        return Evaluated(one.type, one.value if one.value == other.value else None, is_guess)

    def _sequence(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        if node.named_child_count > LONGEST:
            return UNKNOWN
        items = [self.evaluate(each, scope, depth) for each in parts_of(node)]
        types = {item.type for item in items}
        of = types.pop() if len(types) == 1 else None
        type_ = f"{of}_list" if of is not None and not of.endswith("_list") else None
        is_guess = any(item.is_guess for item in items)
        values = tuple(item.value for item in items if item.value is not None)
        is_known = len(values) == len(items)
        return Evaluated(type_, values if is_known else None, is_guess)

    def _named(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        read = self.read_parameter(node, scope) if node.type == "attribute" else None
        if read is not None:
            return self._default_of(read, depth)
        for name in self._resolver.qualified(node, scope):
            if name in _CONSTANTS:
                return evaluated(_CONSTANTS[name])
        bound = self._bound(node, scope)
        is_value = bound is not None and bound.kind is BindingKind.VALUE
        given = None if is_value else self._resolver.containers.literal(node, scope, depth)
        found = UNKNOWN
        if given is not None and given.node.id != node.id:
            found = self.evaluate(given.node, given.scope, depth)
        elif bound is not None:
            found = self._followed(bound, node, depth)
        return self._folded(node, scope, depth) if found == UNKNOWN else found

    def _folded(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        """Return the constant that a name is in each of its bindings, or in another file."""
        folded = self._resolver.fold(node, scope, depth)
        if folded is None:
            return UNKNOWN
        file = self._analysis.scopes, self._syntax
        is_guess = isinstance(folded, Defaulted)
        is_guess = is_guess or is_default_guess(node, scope, self._resolver, *file)
        return evaluated(folded.value)._replace(is_guess=is_guess)

    def _bound(self, node: Node, scope: Scope) -> Binding | None:
        """Return the one binding of a name or an attribute."""
        bindings: list[Binding] = []
        if node.type == "identifier":
            found = scope.lookup(self._syntax.slice(node))
            bindings = reaching(found[1], found[0], node, scope) if found is not None else []
        elif node.type == "attribute":
            bindings = self._resolver.attribute_bindings(node, scope)
        bindings = without_none(bindings)
        return bindings[0] if len(bindings) == 1 else None

    def _followed(self, binding: Binding, node: Node, depth: int) -> Evaluated:
        """Evaluate what a binding gives a name, where no caller gives it anything else."""
        if binding.kind is BindingKind.VALUE:
            found = self.evaluate(binding.value, binding.scope, depth)
            here = self._analysis.scopes.at(node.start_byte)
            if isinstance(found.value, tuple) and self.resolved(node, here) is None:
                # Something changes its items.
                found = found._replace(value=None)
            return found._replace(is_guess=found.is_guess or _is_field(binding))
        name = self._syntax.slice(node)
        if binding.kind is not BindingKind.PARAMETER or binding.owner is None:
            return UNKNOWN
        if binding.value is None or not self._resolver.keeps_default(binding, name, depth):
            return UNKNOWN
        found = self.evaluate(binding.value, binding.scope, depth)
        return found._replace(is_guess=found.is_guess or not self._is_called(binding.owner))

    def _is_called(self, function: Scope) -> bool:
        return bool(self._resolver.callers_of(function))

    def _call(self, node: Node, scope: Scope, depth: int) -> Evaluated:
        callee = node.child_by_field_name("function")
        arguments = Arguments.of(node, self._syntax)
        if callee is None or arguments.is_open:
            return UNKNOWN
        for name in self._resolver.qualified(callee, scope):
            if name in _FUNCTIONS:
                given = self.evaluate(arguments.get(Argument(0, "x")), scope, depth)
                plain = Evaluated("float", None, given.is_guess)
                return computed(_FUNCTIONS[name], (given.value,), plain)
            if name in _TEXTS:
                return Evaluated("string")
            if name in _READERS:
                default = self.evaluate(arguments.get(_READERS[name]), scope, depth)
                return default._replace(is_guess=True) if default != UNKNOWN else UNKNOWN
        called = self._syntax.slice(callee)
        if called in CONVERSIONS and scope.lookup(called) is None:
            given = self.evaluate(arguments.get(Argument(0, "")), scope, depth)
            return converted(called, given)
        held = self._resolver.containers.literal(node, scope, depth)
        if held is not None and held.node.id != node.id:
            return self.evaluate(held.node, held.scope, depth)
        folded = self._resolver.fold(node, scope, depth)
        if isinstance(folded, Known | Defaulted):
            return evaluated(folded.value)._replace(is_guess=isinstance(folded, Defaulted))
        return self._method(callee, scope, depth)

    def _method(self, callee: Node, scope: Scope, depth: int) -> Evaluated:
        """Evaluate a method of a text, such as `'{}/map'.format(robot)`."""
        name = callee.child_by_field_name("attribute")
        if name is None or self._syntax.slice(name) not in _TEXT_METHODS:
            return UNKNOWN
        holder = self.evaluate(callee.child_by_field_name("object"), scope, depth)
        return Evaluated("string") if holder.type == "string" else UNKNOWN

    def _default_of(self, read: Given, depth: int) -> Evaluated:
        """Evaluate the default that a parameter has where the file declares it."""
        arguments = Arguments.of(read.node, self._syntax)
        found = []
        if self._syntax.called_name(read.node) == "declare_parameter":
            found = [Given(arguments.get(Argument(1, "value")) or read.node, read.scope)]
        else:
            name = self._resolver.fold(arguments.get(Argument(0, "name")), read.scope, depth)
            if isinstance(name, Known) and isinstance(name.value, str):
                found = self._declarations().get(name.value, [])[:_MOST_DECLARED]
        values = {self.evaluate(each.node, each.scope, depth) for each in found}
        value = values.pop() if len(values) == 1 else UNKNOWN
        return value._replace(is_guess=True) if value != UNKNOWN else UNKNOWN

    def _declarations(self) -> dict[str, list[Given]]:
        """Return the defaults of the parameters that the file declares, by their names."""
        if self._declared is None:
            self._declared = {}
            for site in self._analysis.sites:
                name = site.endpoint.name
                if site.endpoint.kind is EndpointKind.PARAMETER and name is not None:
                    default = parameter_call(self._analysis, site).default
                    if default is not None:
                        self._declared.setdefault(name, []).append(Given(default, site.scope))
        return self._declared


def _is_field(binding: Binding) -> bool:
    """Whether an object may be made with another value of what its class has, as of a dataclass."""
    if binding.scope.kind != "class" or binding.annotation is None:
        return False
    around = binding.scope.node.parent
    is_decorated = around is not None and around.type == "decorated_definition"
    bases = (each.text or b"" for each in binding.scope.bases)
    return is_decorated or any(each.rpartition(b".")[2] in _RECORDS for each in bases)


_HANDLERS: dict[str, Callable[[Evaluator, Node, Scope, int], Evaluated]] = {
    "true": Evaluator._literal,
    "false": Evaluator._literal,
    "integer": Evaluator._literal,
    "float": Evaluator._literal,
    "string": Evaluator._text,
    "concatenated_string": Evaluator._text,
    "parenthesized_expression": Evaluator._within,
    "not_operator": Evaluator._not,
    "unary_operator": Evaluator._sign,
    "binary_operator": Evaluator._operation,
    "conditional_expression": Evaluator._choice,
    "list": Evaluator._sequence,
    "tuple": Evaluator._sequence,
    "identifier": Evaluator._named,
    "attribute": Evaluator._named,
    "subscript": Evaluator._named,
    "call": Evaluator._call,
}
