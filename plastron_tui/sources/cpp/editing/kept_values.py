"""Parameters that go while what they say is still used: their default takes their place.

A node that nobody gives a parameter works with the default, and so does the node without it.
"""

from __future__ import annotations

from collections.abc import Sequence

from tree_sitter import Node

from plastron_tui.model.endpoint_details import ParameterDetails
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.sources.splices import line_start, newline_of

from ..analysis import Analysis, Site
from ..arguments import call_of
from ..details import Details
from ..read_parameters import AS_VALUE, parameter_call
from ..scopes import CppFile, Variable
from .creation import creation_of, variable_of
from .deletions import Deletions
from .leftovers import logs
from .parameters import setting_text
from .statements import only_sets
from .uses import uses_of

_GETS = frozenset({*AS_VALUE, "get", "get_value", "get_parameter_value"})
_LITERALS = frozenset({"number_literal", "string_literal", "true", "false", "concatenated_string"})
_PRIMARY = frozenset(
    {*_LITERALS, "identifier", "field_expression", "call_expression", "qualified_identifier"}
    | {"subscript_expression", "parenthesized_expression", "compound_literal_expression"}
    | {"template_function"}
)
_SETTING = frozenset({"param", "get_parameter_or"})
_READING = frozenset({"param", "declare_parameter", "get_parameter"})


class KeptValues:
    """The values of a parameter that goes, where the files use them.

    Args:
        analysis: the files.
        sites: the call sites of the parameter, which all go.
        gone: what goes; the values that stay are written into it.
    """

    def __init__(self, analysis: Analysis, sites: Sequence[Site], gone: Deletions) -> None:
        self._analysis = analysis
        self._sites = sites
        self._gone = gone
        self._details = Details(analysis)

    def keep(self, site: Site) -> bool:
        """Write the default for what a call reads; tell whether that was needed, and done.

        It is not where nothing uses the value, and cannot be done where no default is known.
        """
        said = parameter_call(site.call)
        if said.into is not None:
            return self._keep_variable(site, said.into)
        whole = _value_of(site)
        outer = whole.parent
        if outer is None or outer.type == "expression_statement" or not self._is_used(site):
            return False
        if site.call.name not in _READING or outer.type == "field_expression":
            return False
        if whole.id == site.call.node.id and site.call.name == "get_parameter":
            return False
        text = self._default(site, is_typed=_is_typed(whole, site.file))
        if text is None:
            return False
        self._gone.replace(site.file, whole, text)
        return True

    def _keep_variable(self, site: Site, into: Node) -> bool:
        """Set the variable that a call would have read a parameter into."""
        if not self._is_used(site):
            return False
        file, node = site.file, site.call.node
        variable = variable_of(self._analysis, into, site.call.scope)
        outer = node.parent
        name = file.syntax.slice(into)
        if name.startswith("&"):
            name = name[1:].strip()
        if outer is None or variable is None:
            return False
        if outer.type != "expression_statement":
            return self._keep_otherwise(site, node)
        text = self._default(site, is_typed=True)
        if text not in (None, name):
            declared = _declared_above(outer, variable, file)
            if declared is not None:
                self._gone.replace(file, declared, f"{name} = {text}")
                self._gone.statement(file, outer)
            else:
                self._gone.replace(file, node, f"{name} = {text}")
            return True
        if text is None and not self._is_set(variable, site):
            return False
        self._gone.statement(file, outer)
        return True

    def _keep_otherwise(self, site: Site, node: Node) -> bool:
        """Keep what `if (!nh.getParam("x", x)) {x = 1;}` does where nobody sets the parameter."""
        file, whole = site.file, node.parent
        if whole is None or whole.type != "unary_expression" or site.call.name in _SETTING:
            return False
        condition = whole.parent
        outer = None if condition is None else condition.parent
        if not file.syntax.slice(whole).startswith("!") or outer is None:
            return False
        body = outer.child_by_field_name("consequence")
        if outer.type != "if_statement" or body is None or condition is None:
            return False
        is_alone = condition.named_child_count == 1 and outer.parent is not None
        if not is_alone or outer.child_by_field_name("alternative") is not None:
            return False
        if outer.parent is None or outer.parent.type != "compound_statement":
            return False
        parts = body.named_children if body.type == "compound_statement" else [body]
        kept = [each for each in parts if not logs(file.syntax.word(each).strip())]
        if not kept or not all(_only_assigns(each) for each in kept):
            return False
        text = file.syntax.text
        indent = text[line_start(text, outer.start_byte) : outer.start_byte].decode()
        if indent.strip():
            return False
        between = newline_of(text).decode() + indent
        self._gone.replace(file, outer, between.join(map(file.syntax.slice, kept)))
        return True

    def _details_of(self, site: Site) -> ParameterDetails:
        found = self._details.of(site).details
        return found if isinstance(found, ParameterDetails) else ParameterDetails()

    def _is_used(self, site: Site) -> bool:
        """Tell whether anything uses what a call reads."""
        creation = creation_of(self._analysis, site)
        if creation is None:
            return True
        variable = creation.variable
        if variable is None:
            return _value_of(site).parent is not creation.node
        own = [creation_of(self._analysis, each) for each in self._sites]
        parts = [
            (each.file, each.node.start_byte, each.node.end_byte)
            for each in own
            if each is not None
        ]
        return variable.file.is_beside or any(
            not any(file is each and start <= node.start_byte < end for each, start, end in parts)
            for file, node, _ in uses_of(self._analysis, variable)
        )

    def _is_set(self, variable: Variable, site: Site) -> bool:
        """Tell whether a variable has a value before a call."""
        if variable.value is not None or variable.arguments:
            return True
        for file, node, _ in uses_of(self._analysis, variable):
            outer = node.parent
            if outer is None:
                continue
            if outer.type == "field_initializer":
                return True
            statement, own = outer.parent, site.call.node.parent
            if statement is None or own is None or not only_sets(statement, node):
                continue
            is_before = file is site.file and node.start_byte < own.start_byte
            if is_before and statement.parent == own.parent:
                return True
        return False

    def _default(self, site: Site, *, is_typed: bool) -> str | None:
        """Write the value of a parameter that nobody sets, None where it is not known.

        Args:
            site: the call that reads it.
            is_typed: whether what gets the value says its type.
        """
        details = self._details_of(site)
        version = self._analysis.ros_version
        if details.default_expression:
            given = parameter_call(site.call).default
            if given is None:
                return None
            given = _unwrapped(given, site)
            return _own_text(site, given, details, version, is_typed=is_typed)
        said = {
            (each.default, each.type)
            for each in map(self._details_of, self._sites)
            if each.default_expression and not each.is_guess
        }
        if len(said) != 1:
            return None
        ((default, type_),) = said
        return None if default is None else _text(default, details.type or type_, version, is_typed)


def _value_of(site: Site) -> Node:
    """Return the whole of `get_parameter("x").as_double()`."""
    node, syntax = site.call.node, site.file.syntax
    while (field := node.parent) is not None and field.type == "field_expression":
        call = field.parent
        name = field.child_by_field_name("field")
        word = "" if name is None else syntax.word(name).partition("<")[0]
        is_called = call is not None and call.type == "call_expression"
        if call is None or not is_called or word.removeprefix("template ").strip() not in _GETS:
            break
        node = call
    return node


def _is_typed(node: Node, file: CppFile) -> bool:
    """Tell whether what gets a value says its type itself."""
    outer = node.parent
    if outer is None:
        return False
    if outer.type in ("argument_list", "initializer_list"):
        whole = outer.parent
        called = None if whole is None else whole.child_by_field_name("function")
        is_cast = called is not None and file.syntax.word(called).startswith("static_cast")
        return is_cast or (whole is not None and whole.type == "field_initializer")
    if outer.type == "assignment_expression":
        right = outer.child_by_field_name("right")
        return right is not None and right.id == node.id
    if outer.type != "init_declarator" or outer.parent is None:
        return False
    type_ = outer.parent.child_by_field_name("type")
    return type_ is not None and "auto" not in file.syntax.word(type_)


def _unwrapped(node: Node, site: Site) -> Node:
    """Return what is in a `rclcpp::ParameterValue(…)`."""
    if node.type == "call_expression":
        call = call_of(node, site.call.scope, site.file.syntax)
        if call is not None and call.name == "ParameterValue" and len(call.arguments) == 1:
            return call.arguments[0]
    return node


def _own_text(
    site: Site, given: Node, details: ParameterDetails, version: int, *, is_typed: bool
) -> str | None:
    """Write the default that a call itself gives."""
    syntax = site.file.syntax
    text = syntax.slice(given)
    if given.type == "initializer_list":
        return None
    if is_typed:
        return text
    literal = given
    if given.type == "unary_expression":
        literal = given.child_by_field_name("argument") or given
    types = site.call.type_nodes
    if literal.type in _LITERALS and details.default is not None:
        return _text(details.default, details.type, version, is_typed=False)
    if types:
        return f"static_cast<{syntax.slice(types[0])}>({text})"
    return text if given.type in _PRIMARY else f"({text})"


def _text(default: object, type_: str | None, version: int, is_typed: bool) -> str | None:
    """Write a value that is known."""
    holds = None if type_ is None or "byte" in type_ else ParameterType(type_)
    if holds is None or not isinstance(default, bool | int | float | str | tuple):
        return None
    text = setting_text(default, holds, version)
    if is_typed or holds.is_list:
        return text
    if holds is ParameterType.STRING:
        return f"std::string({text})"
    is_wide = version == 2 and holds is ParameterType.INT
    return f"int64_t{{{text}}}" if is_wide else text


def _declared_above(statement: Node, variable: Variable, file: CppFile) -> Node | None:
    """Return the name in the declaration just above that has no value yet, None for none."""
    node, name = statement.prev_sibling, variable.declarator
    if node is None or name is None or name.parent is None or variable.file is not file:
        return None
    if node.type != "declaration" or node.id != variable.node.id or node.id != name.parent.id:
        return None
    return name if len(node.children_by_field_name("declarator")) == 1 else None


def _only_assigns(node: Node) -> bool:
    inner = node.named_children[0] if node.named_child_count == 1 else None
    is_statement = node.type == "expression_statement"
    return is_statement and inner is not None and inner.type == "assignment_expression"
