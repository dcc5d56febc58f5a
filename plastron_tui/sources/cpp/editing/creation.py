"""How a call that creates an endpoint stands in its file, and what holds what it creates."""

from __future__ import annotations

from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from ..analysis import Analysis, Site
from ..scopes import CppFile, Scope, Variable, last_name
from ..shapes import OBJECTS
from .deletions import Deletions

_WRAPPING = frozenset(
    {"argument_list", "call_expression", "new_expression", "parenthesized_expression"}
    | {"unary_expression"}
)

_PUTTING = frozenset(
    {"push_back", "emplace_back", "push_front", "emplace_front", "insert", "emplace", "push"}
)
_ASKING = frozenset({"hasParam", "has_parameter"})


@dataclass(frozen=True, slots=True)
class Creation:
    """What creates an endpoint.

    Attributes:
        file: the file that has it.
        node: the statement, declaration or initializer.
        variable: what holds the endpoint, None where nothing of the files does.
        container: what it is put into as one of several, None where it is not.
    """

    file: CppFile
    node: Node
    variable: Variable | None
    container: Variable | None = None

    def delete(self, gone: Deletions) -> None:
        """Take it out."""
        if self.node.type == "field_initializer":
            _delete_item(self.file, self.node, gone)
        elif self.variable is not None and self.node.id == self.variable.node.id:
            delete_declarator(self.variable, gone)
        else:
            gone.statement(self.file, self.node)

    def delete_declaration(self, gone: Deletions) -> None:
        """Take out the declaration of what held the endpoint."""
        if self.variable is not None and self.node.id != self.variable.node.id:
            delete_declarator(self.variable, gone)


def creation_of(analysis: Analysis, site: Site) -> Creation | None:
    """Return what creates an endpoint, None where the statement does more."""
    file, scope = site.file, site.call.scope
    node: Node | None = site.call.node
    while node is not None:
        parent = node.parent
        if node.type in ("declaration", "field_declaration"):
            return Creation(file, node, _declared(file, node, site))
        if node.type == "field_initializer":
            name = node.named_children[0]
            written = file.syntax.word(name)
            owner = analysis.unit.class_of(scope)
            member = None if owner is None else analysis.unit.member(owner, written)
            return None if member is None else Creation(file, node, member)
        if node.type == "assignment_expression":
            left = node.child_by_field_name("left")
            variable = None if left is None else variable_of(analysis, left, scope)
            if parent is None or parent.type != "expression_statement":
                return None
            if variable is None and left is not None and left.type == "field_expression":
                variable = _only_member(analysis, left.child_by_field_name("field"), scope)
            return None if variable is None else Creation(file, parent, variable)
        if node.type == "expression_statement":
            return _in_statement(analysis, site, node)
        if node.type == "condition_clause":
            return _unless_set(analysis, site, node)
        if (
            node is not site.call.node
            and node.type not in _WRAPPING
            and (node.type not in ("init_declarator", "initializer_list", "field_expression"))
        ):
            return None
        node = parent
    return None


def _in_statement(analysis: Analysis, site: Site, statement: Node) -> Creation | None:
    """Return what a statement creates, None where it hands that to what may do anything with it."""
    found = Creation(site.file, statement, _set_by(analysis, site))
    inner, outer = site.call.node, None
    while inner.parent is not None and inner.id != statement.id:
        if inner.parent.type == "argument_list":
            outer = inner.parent.parent
        inner = inner.parent
    if found.variable is not None or outer is None or outer.type != "call_expression":
        return found
    if site.endpoint.kind is EndpointKind.PARAMETER:
        return found
    callee = outer.child_by_field_name("function")
    field = None if callee is None else callee.child_by_field_name("field")
    holder = None if callee is None else callee.child_by_field_name("argument")
    if field is None or holder is None or site.file.syntax.word(field) not in _PUTTING:
        return None
    container = variable_of(analysis, holder, site.call.scope)
    return None if container is None else Creation(site.file, statement, None, container)


def holder_of(analysis: Analysis, site: Site) -> Variable | None:
    """Return what holds an endpoint, None where nothing of the files does."""
    found = creation_of(analysis, site)
    return None if found is None else found.variable


def _only_member(analysis: Analysis, name: Node | None, scope: Scope) -> Variable | None:
    """Return the member of a name that one class alone has."""
    word = "" if name is None else scope.file.syntax.word(name)
    found = [
        each.variables[word][0]
        for each in analysis.unit.scopes()
        if each.kind == "class" and word in each.variables
    ]
    return found[0] if len(found) == 1 else None


def _unless_set(analysis: Analysis, site: Site, condition: Node) -> Creation | None:
    """Return `if (!nh.hasParam("x")) {nh.setParam("x", 1);}` whose body does no more."""
    whole = condition.parent
    if whole is None or whole.type != "if_statement" or site.call.name not in _ASKING:
        return None
    body = whole.child_by_field_name("consequence")
    if body is None or whole.child_by_field_name("alternative") is not None:
        return None
    parts = body.named_children if body.type == "compound_statement" else [body]
    same = [
        each.call.node.parent
        for each in analysis.sites
        if each.file is site.file
        and each.endpoint.kind is site.endpoint.kind
        and each.endpoint.name == site.endpoint.name
    ]
    is_alone = all(any(each is not None and each.id == part.id for each in same) for part in parts)
    return Creation(site.file, whole, None) if parts and is_alone else None


def _declared(file: CppFile, node: Node, site: Site) -> Variable | None:
    """Return the variable of a declaration that a call gives its value."""
    at = site.call.node.start_byte
    found = None
    for scope in file.scopes:
        for variables in scope.variables.values():
            for variable in variables:
                if variable.node.id == node.id and (variable.start <= at or at == node.start_byte):
                    found = variable if found is None or variable.start > found.start else found
    return found


def _set_by(analysis: Analysis, site: Site) -> Variable | None:
    """Return the variable of `x.reset(new T(…))` or `read("name", x)` or `x.subscribe(nh, …)`."""
    scope = site.call.scope
    call = site.call.node
    receiver = site.call.receiver
    if receiver is not None and site.shape in OBJECTS.values():
        name = last_name(receiver, scope)
        return analysis.unit.lookup(name, scope, call.start_byte) if name else None
    parent = call.parent
    if parent is not None and parent.type == "argument_list" and parent.parent is not None:
        outer = parent.parent.child_by_field_name("function")
        if outer is not None and outer.type == "field_expression":
            field = outer.child_by_field_name("field")
            holder = outer.child_by_field_name("argument")
            if field is not None and scope.file.syntax.word(field) == "reset":
                name = "" if holder is None else last_name(holder, scope)
                return analysis.unit.lookup(name, scope, call.start_byte)
        return None
    given = site.call.argument(1)
    if site.shape.type == "" and given is not None and site.call.name.startswith(("get", "param")):
        return variable_of(analysis, given, scope)
    return None


def variable_of(analysis: Analysis, node: Node, scope: Scope) -> Variable | None:
    """Return the variable that `a`, `this->a` or `b.a` names, None where it is not known."""
    if node.type == "field_expression":
        return analysis.receivers.member(node, scope)
    name = last_name(node, scope)
    return analysis.unit.lookup(name, scope, node.start_byte) if name else None


def delete_declarator(variable: Variable, gone: Deletions) -> None:
    """Take out a declaration, or one of the names that it declares."""
    node, file = variable.node, variable.file
    declarators = node.children_by_field_name("declarator")
    if len(declarators) < 2:
        gone.statement(file, node)
        return
    index = next(
        at
        for at, each in enumerate(declarators)
        if each.start_byte <= variable.start < each.end_byte
    )
    own = declarators[index]
    if index:
        gone.part(file, declarators[index - 1].end_byte, own.end_byte)
    else:
        gone.part(file, own.start_byte, declarators[1].start_byte)


def _delete_item(file: CppFile, node: Node, gone: Deletions) -> None:
    """Take out an initializer of a constructor, with its comma; the `:` goes with the last."""
    outer = node.parent
    assert outer is not None, "an initializer is in a list"
    items = [each for each in outer.named_children if each.type == "field_initializer"]
    index = next(at for at, each in enumerate(items) if each.id == node.id)
    if len(items) == 1:
        before = outer.prev_sibling
        start = outer.start_byte if before is None else before.end_byte
        gone.part(file, start, outer.end_byte)
    elif index:
        gone.part(file, items[index - 1].end_byte, node.end_byte)
    else:
        gone.part(file, node.start_byte, items[1].start_byte)
