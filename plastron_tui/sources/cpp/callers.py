"""Which calls of a unit call its functions, and what they give for a parameter."""

from __future__ import annotations

import re
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING

from tree_sitter import Node

from .arguments import Call, arguments_of
from .scopes import Function, Scope, Variable, type_text
from .type_texts import template_arguments
from .types import Types
from .unit import Unit

if TYPE_CHECKING:
    from .read_parameters import ReadParameters

MOST_CALLERS = 64
MOST_OVERLOADS = 256
"""Which of more functions of one name a call calls is not asked."""

_HANDLES = re.compile(r"(?:this->)?get(?:MT)?(?:Private)?NodeHandle\(\s*\)")
_LITERALS = frozenset(
    {
        "lambda_expression",
        "string_literal",
        "concatenated_string",
        "number_literal",
        "true",
        "false",
    }
)
_HEADERS = (".hpp", ".h", ".hh", ".hxx")
_FUNCTION = re.compile(r"(?:std|boost)::function<")
_NUMBER = re.compile(r"(?:unsigned|signed|short|long|int|char|float|double|size_t|u?int\d+_t)+")
_NO_FUNCTION = re.compile(rf"\A(?:std::(?:string|vector<.*>)|bool|{_NUMBER.pattern})\Z|_msgs::")
_MAKERS = ("make_shared", "make_unique", "allocate_shared", "construct", "emplace")


class Callers:
    """The calls of the functions of a unit.

    Attributes:
        parameters: what reading a parameter of ROS gives.
    """

    parameters: ReadParameters

    def __init__(self, unit: Unit, types: Types) -> None:
        self._unit = unit
        self._types = types
        self._found: dict[Function, list[Call]] = {}
        self._used: dict[Function, bool] = {}
        self._least: dict[Function, int] = {}

    def of(self, function: Function) -> list[Call]:
        """Return the calls of a function; of a constructor, what makes objects of its class."""
        if function not in self._found:
            owner = self._unit.class_of_function(function)
            if len(self._unit.functions.get(function.name, ())) > MOST_OVERLOADS:
                found = []
            elif owner is not None and owner.name == function.name:
                found = self.makers(owner)
            else:
                found = [
                    call
                    for call in self._unit.calls.get(function.name, ())
                    if self._may_call(call, function, owner)
                ]
            self._found[function] = [
                each
                for each in found
                if self.fits(each, function)
                and self._counts(each, function, owner)
                and self.is_run(each.scope)
            ]
        return self._found[function]

    def is_run(self, scope: Scope) -> bool:
        """Tell whether the unit may run what is in a scope.

        A header may have functions for all nodes of a package: one that is no method, and that
        neither the main file nor what the headers run mentions, is not run by this node, and
        neither is an overload that no call fits.
        """
        function = scope.around
        if function is None or scope.file is self._unit.files[0]:
            return True
        if not scope.file.name.endswith(_HEADERS):
            return True
        if function not in self._used:
            self._used[function] = False
            self._used[function] = self._is_used(function)
        return self._used[function]

    def _is_used(self, function: Function) -> bool:
        unit, name = self._unit, function.name
        owner = unit.class_of_function(function)
        if not name.isidentifier() or (owner is not None and owner.name == name):
            return True
        calls = unit.calls.get(name, ())
        defined = sum(each.scope is not None for each in unit.functions.get(name, ()))
        if calls and defined > 1 and not self.of(function):
            # Of overloads those are run that the calls fit.
            return False
        if owner is not None or any(self.is_run(each.scope) for each in calls):
            return True
        word = re.compile(rb"\b" + name.encode() + rb"\b")
        mentions = sum(len(word.findall(file.syntax.text)) for file in unit.files)
        # It may be handed on by its name, or stand in a macro.
        return mentions > len(calls) + len(unit.functions.get(name, ()))

    def _counts(self, call: Call, function: Function, owner: Scope | None) -> bool:
        """Whether a call says what a function of the unit gets.

        Another source says it of the constructor of a class that the main file defines, and of
        nothing else: it calls the helpers of a header for a node of its own.
        """
        if not call.scope.file.is_beside:
            return True
        main = self._unit.files[0]
        return (
            owner is not None
            and owner.name == function.name
            and any(
                scope.function is not None and self._unit.class_of_function(scope.function) is owner
                for scope in main.scopes
                if scope.kind == "function"
            )
        )

    def _may_call(self, call: Call, function: Function, owner: Scope | None) -> bool:
        if owner is None:
            return call.receiver is None
        if call.receiver is None or call.receiver.type == "this":
            of = self._unit.class_of(call.scope)
            return of is None or any(
                each is owner for each in (*self._unit.bases(of), *self._unit.bases(owner))
            ) or self._unit.derives_from(owner, of)  # fmt: skip
        # What a nodelet gets its handles by returns no object of a class of the files.
        return _HANDLES.fullmatch(call.scope.file.syntax.word(call.receiver)) is None

    def fits(self, call: Call, function: Function) -> bool:
        """Tell whether a function may take as many arguments as a call gives, and such ones."""
        most = len(function.parameters)
        if len(call.arguments) > most:
            return False
        if len(call.arguments) < most and len(call.arguments) < self._needed(function):
            return False
        return len(self._unit.functions.get(function.name, ())) < 2 or all(
            self._may_take(parameter, given)
            for parameter, given in zip(function.parameters, call.arguments, strict=False)
        )

    def _needed(self, function: Function) -> int:
        """Return how many arguments a function has to be given."""
        if function not in self._least:
            positions = range(len(function.parameters))
            self._least[function] = sum(self.default_of(function, at) is None for at in positions)
        return self._least[function]

    def _may_take(self, parameter: Variable, given: Node) -> bool:
        """Tell whether a parameter of an overload may be what a literal or a lambda gives."""
        if given.type not in _LITERALS:
            return True
        type_ = self._types.expand(parameter.type, parameter.scope)
        if _FUNCTION.match(type_):
            return given.type == "lambda_expression"
        if given.type == "lambda_expression":
            return _NO_FUNCTION.search(type_) is None
        if given.type in ("string_literal", "concatenated_string"):
            return _NUMBER.fullmatch(type_) is None or parameter.is_pointer
        return type_ != "std::string"

    def default_of(self, function: Function, position: int) -> Node | None:
        """Return the default of a parameter, which its declaration may have."""
        own = function.parameters[position].value
        if own is not None:
            return own
        owner = self._unit.class_of_function(function)
        for other in self._unit.functions.get(function.name, ()):
            if other.scope is None and len(other.parameters) == len(function.parameters):
                of = self._unit.class_of_function(other)
                if of is owner and other.parameters[position].value is not None:
                    return other.parameters[position].value
        return None

    def given(self, call: Call, function: Function, position: int) -> Node | None:
        """Return what a call gives for a parameter, None where it leaves it to the default."""
        del function
        return call.argument(position)

    @cached_property
    def made(self) -> dict[str, list[Call]]:
        """What makes objects, by the last name of the class as it is written."""
        found: dict[str, list[Call]] = {}
        for call in self._all_made():
            found.setdefault(call.name, []).append(call)
        return found

    def _all_made(self) -> list[Call]:
        found: list[Call] = []
        for file in self._unit.all_files:
            syntax = file.syntax
            for call in file.calls:
                if call.name in _MAKERS and call.type_nodes:
                    type_ = call.type_nodes[0]
                    text = type_text(syntax.word(type_))
                    found.append(_making(call.node, text, call.arguments, call.scope, type_))
                elif call.name == "make_shared" and call.qualifier:
                    name = call.qualifier
                    found.append(
                        _making(call.node, name, call.arguments, call.scope, call.name_node)
                    )
                elif call.receiver is None:
                    found.append(call)
            for node, scope in file.news:
                type_node = node.child_by_field_name("type")
                if type_node is not None:
                    listed = arguments_of(node.child_by_field_name("arguments"))
                    found.append(
                        _making(node, type_text(syntax.word(type_node)), listed, scope, type_node)
                    )
            for each in file.scopes:
                for variables in each.variables.values():
                    for variable in variables:
                        type_node = variable.type_node
                        if type_node is None or variable.kind in ("parameter", "loop"):
                            continue
                        if type_node.type == "primitive_type":
                            continue
                        if variable.is_pointer or variable.is_reference:
                            continue
                        if variable.kind == "member" and self._is_initialized(variable, each):
                            continue
                        if variable.value is None:
                            found.append(
                                _making(
                                    variable.node,
                                    variable.type,
                                    variable.arguments or [],
                                    each,
                                    variable.type_node,
                                )
                            )
        for name, initializers in self._unit.initialized.items():
            for node, given, scope in initializers:
                owner = self._unit.class_of(scope)
                member = self._unit.member(owner, name) if owner is not None else None
                if member is not None and member.is_pointer:
                    continue
                text = member.type if member is not None else name
                found.append(_making(node, text, given, scope, None))
        return found

    def _is_initialized(self, member: Variable, owner: Scope) -> bool:
        """Whether a constructor says what a member is made of."""
        return any(
            self._unit.class_of(scope) is owner
            for _, _, scope in self._unit.initialized.get(member.name, ())
        )

    def makers(self, owner: Scope) -> list[Call]:
        """Return what makes objects of a class."""
        made = self.made.get(owner.name, ())
        found = (
            each for each in made if self._unit.find_class(each.qualified, each.scope) is owner
        )
        return list(islice(found, MOST_CALLERS + 1))


def _making(
    node: Node, type_: str, arguments: list[Node], scope: Scope, type_node: Node | None
) -> Call:
    """Return what makes an object of a type as a call of its constructor."""
    plain, _, inner = type_.partition("<")
    qualifier, _, name = plain.rpartition("::")
    types = tuple(template_arguments(inner.rpartition(">")[0])) if inner else ()
    return Call(node, name, qualifier, None, None, arguments, scope, type_node, types)
