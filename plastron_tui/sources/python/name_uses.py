"""What a file does with a name besides giving it to an endpoint: what may say another one too."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Collection

from tree_sitter import Node

from .analysis import Analysis
from .callers import called_function, given_for
from .constants import Known
from .flow import straight_line
from .log_uses import told
from .name_texts import texts_saying
from .references import Reference, Use, Variable, references, statement_of, variable_of
from .runs import LOOPS
from .scopes import BindingKind, Scope

_HOLDERS = frozenset({"dictionary", "list", "pair", "tuple"})
_DICTIONARIES = frozenset({"dict", "defaultdict", "OrderedDict"})
_LOOKING_UP = frozenset({"get", "pop", "values"})
_TESTS = frozenset({"elif_clause", "if_statement"})


class NameUses:
    """The uses of what holds a name in a file.

    A use is harmless where the name alone is another one after it: where it is told, or only asked
    whether there is one; where what it is handed on to is harmless; where it is the key of a
    dictionary that the file looks into by such keys alone.

    Args:
        analysis: the file.
        said: the ids of the expressions that give endpoints the name, and of its literals.
    """

    def __init__(self, analysis: Analysis, said: Collection[int]) -> None:
        self._analysis = analysis
        self._said = said
        self._seen: set[Variable] = set()

    def are_harmless(self, variable: Variable | None) -> bool:
        """Whether all uses of a variable are harmless."""
        if variable is None:
            return False
        if variable in self._seen:
            return True
        self._seen.add(variable)
        uses = [use for use in self._uses(variable) if not _binds(use)]
        # What nothing in the file uses may be for another file.
        return bool(uses) and all(self.is_harmless(use.node) for use in uses)

    def is_handed_alone(self, node: Node) -> bool:
        """Whether the uses of a variable that see what one of them hands on are harmless."""
        variable = variable_of(node, self._analysis)
        alike = self._seeing_alike(node, variable) if variable is not None else None
        if alike is None:
            return self.are_harmless(variable)
        return all(_binds(use) or self.is_harmless(use.node) for use in alike)

    def _seeing_alike(self, node: Node, variable: Variable) -> list[Reference] | None:
        """Return the uses of a local that see the same literal; None where others may see it."""
        owner = variable.scope
        lines = straight_line(owner.bindings.get(variable.name, []), owner)
        block = statement_of(lines[0]).parent if lines else None
        ends = [line.end_byte for line in lines]
        place = bisect_right(ends, node.start_byte)
        value = lines[place - 1].child_by_field_name("right") if place else None
        if block is None or value is None or value.type != "string":
            return None
        start, uses = lines[0].start_byte, self._uses(variable)
        for use in uses:
            is_inside = start <= use.node.start_byte < block.end_byte
            if not is_inside or self._analysis.scopes.at(use.node.start_byte) is not owner:
                return None
        return [use for use in uses if bisect_right(ends, use.node.start_byte) == place]

    def is_harmless(self, node: Node) -> bool:
        """Whether what is done with an expression is harmless: a name, or what holds one."""
        if node.id in self._said or _outermost(node).id in self._said:
            return True
        if _is_tested(node) or self._is_key(node):
            return True
        text, is_told = told(self._analysis, node)
        parent = text.parent
        if is_told or parent is None:
            return is_told
        if parent.type == "assignment" and _is_child(parent, "right", text):
            target = parent.child_by_field_name("left")
            return target is not None and self.are_harmless(variable_of(target, self._analysis))
        if parent.type in LOOPS and _is_child(parent, "right", text):
            target = parent.child_by_field_name("left")
            return target is not None and self.are_harmless(variable_of(target, self._analysis))
        if parent.type == "argument_list" and parent.parent is not None:
            return self.are_harmless(self._parameter(parent.parent, text))
        return False

    def is_given_alone(self, call: Node) -> bool:
        """Whether the calls of a function of the file that gives a name are harmless."""
        callee = call.child_by_field_name("function")
        function = variable_of(callee, self._analysis) if callee is not None else None
        if callee is None or function is None or self._called(callee) is None:
            return True
        uses = [each.node for each in self._uses(function)]
        calls = [node.parent for node in uses if not _is_child(node.parent, "name", node)]
        return all(each and each.type == "call" and self.is_harmless(each) for each in calls)

    def is_held_alone(self, literal: Node) -> bool:
        """Whether the list or dictionary in which a literal stands serves nothing else."""
        item, holder = literal, literal
        while (parent := holder.parent) is not None and parent.type in _HOLDERS:
            item, holder = holder, parent
        if holder is literal or parent is None or parent.type != "assignment":
            return True
        target, key = parent.child_by_field_name("left"), self._key_of(holder, item)
        variable = variable_of(target, self._analysis) if target is not None else None
        return variable is None or all(
            _binds(use)
            or self._takes_other(use.node, key)
            or self.is_harmless(_outermost(use.node))
            for use in self._uses(variable)
        )

    def _uses(self, variable: Variable) -> list[Reference]:
        return references(variable, self._analysis)

    def _key_of(self, holder: Node, item: Node) -> object:
        if item.type == "pair":
            return self._folded(item.child_by_field_name("key"))
        return [each.id for each in holder.named_children].index(item.id)

    def _takes_other(self, holder: Node, key: object) -> bool:
        """Whether a list or dictionary is asked for another item than that of a key."""
        parent = holder.parent
        if parent is None or parent.type != "subscript" or not _is_child(parent, "value", holder):
            return False
        other = self._folded(parent.child_by_field_name("subscript"))
        is_from_end = isinstance(other, int) and other < 0
        return None not in (key, other) and other != key and not is_from_end

    def _folded(self, node: Node | None) -> object:
        if node is None:
            return None
        folded = self._analysis.resolver.fold(node, self._analysis.scopes.at(node.start_byte))
        return folded.value if isinstance(folded, Known) else None

    def _is_key(self, node: Node) -> bool:
        """Whether a name is the key of a dictionary that the file looks into by such keys alone."""
        holder = _holder_of_key(node)
        variable = variable_of(holder, self._analysis) if holder is not None else None
        name = self._folded(node)
        if variable is None or not isinstance(name, str):
            return False
        uses = self._uses(variable)
        is_own = any(use.use is Use.BINDING for use in uses) and all(map(self._looks_up, uses))
        others = (each.node.id for each in texts_saying(self._analysis, name) if each.is_whole)
        return is_own and all(each in self._said for each in others)

    def _looks_up(self, use: Reference) -> bool:
        """Whether a use of a variable makes it a dictionary of the file, or looks into it."""
        parent, syntax = use.node.parent, self._analysis.syntax
        if parent is None or use.use is Use.NOTHING:
            return parent is not None
        if use.use is Use.BINDING:
            value = parent.child_by_field_name("right")
            callee = value.child_by_field_name("function") if value is not None else None
            is_made = callee is not None and syntax.slice(callee).split(".")[-1] in _DICTIONARIES
            return is_made or (value is not None and value.type == "dictionary")
        method = parent.child_by_field_name("attribute")
        if method is not None:
            return syntax.slice(method) in _LOOKING_UP
        is_asked = parent.type == "comparison_operator" and parent.children[-1].id == use.node.id
        return is_asked or _is_child(parent, "value", use.node)

    def _called(self, callee: Node) -> Scope | None:
        analysis = self._analysis
        scope = analysis.scopes.at(callee.start_byte)
        bindings = analysis.resolver.attribute_bindings
        return called_function(callee, scope, bindings, analysis.scopes, analysis.syntax)

    def _parameter(self, call: Node, argument: Node) -> Variable | None:
        """Return the parameter of a function of the file that gets an argument."""
        callee = call.child_by_field_name("function")
        function = self._called(callee) if callee is not None else None
        given = argument.child_by_field_name("value") or argument
        for name, bindings in function.bindings.items() if function is not None else ():
            for binding in bindings:
                if binding.kind is BindingKind.PARAMETER and function is not None:
                    found = given_for(call, function, binding, name, self._analysis.syntax)
                    if found is not None and found.id == given.id:
                        return Variable(function, name, False)
        return None


def _binds(use: Reference) -> bool:
    loop = use.node.parent
    is_taken = loop is not None and loop.type in LOOPS and _is_child(loop, "left", use.node)
    return is_taken or use.use in (Use.BINDING, Use.NOTHING)


def _is_child(parent: Node | None, name: str, node: Node) -> bool:
    return parent is not None and node.id in {
        each.id for each in parent.children_by_field_name(name)
    }


def _outermost(node: Node) -> Node:
    """Return `a['b']['c']`, or `a.get('b')`, for its `a`."""
    while (parent := node.parent) is not None and _is_child(parent, "value", node):
        if parent.type != "subscript":
            break
        node = parent
    call = parent.parent if parent is not None and _is_child(parent, "object", node) else None
    return call if call is not None and call.type == "call" else node


def _holder_of_key(node: Node) -> Node | None:
    """Return the `a` of `a[node]`, `node in a` and `a = {node: …}`."""
    parent = node.parent
    if parent is None:
        return None
    if _is_child(parent, "subscript", node):
        return parent.child_by_field_name("value")
    if parent.type == "comparison_operator" and parent.children[1].type in ("in", "not in"):
        return parent.children[-1]
    if parent.type == "pair" and _is_child(parent, "key", node) and parent.parent is not None:
        outer = parent.parent.parent
        is_assigned = outer is not None and outer.type == "assignment"
        return outer.child_by_field_name("left") if outer is not None and is_assigned else None
    return None


def _is_tested(node: Node) -> bool:
    """Whether an expression is only asked whether it is there."""
    parent = node.parent
    if parent is None:
        return False
    if parent.type == "comparison_operator":
        rest = {each.type for each in parent.children if each.id != node.id}
        return rest <= {"is", "is not", "none"}
    return parent.type == "not_operator" or (
        parent.type in _TESTS and _is_child(parent, "condition", node)
    )
