"""The objects of a unit that are endpoints, where they are made with a name."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tree_sitter import Node

from .analysis import Analysis
from .arguments import Call
from .found import Found, template_of
from .receivers import HANDLE
from .scopes import Scope
from .shapes import OBJECTS, Shape
from .type_texts import without_pointer


class Objects:
    """The objects that are endpoints."""

    def __init__(self, analysis: Analysis, owner: Callable[[Node, Scope], Scope | None]) -> None:
        self._a = analysis
        self._unit = analysis.unit
        self._receivers = analysis.receivers
        self._owner = owner

    def found(self) -> Iterator[Found]:
        """Yield the objects that are endpoints where they are made with a name."""
        wanted = {name.rpartition("::")[2] for name in OBJECTS}
        seen: set[int] = set()
        for written, calls in self._a.callers.made.items():
            for call in calls:
                if not self._may_be_object(call, wanted):
                    continue
                if not call.arguments or call.node.start_byte in seen:
                    continue
                type_ = self._made_type(call, written)
                name = type_.partition("<")[0]
                if name.rpartition("::")[2] not in wanted or name not in OBJECTS:
                    continue
                found = self._object(call, OBJECTS[name], type_)
                if found is not None:
                    seen.add(call.node.start_byte)
                    yield found

    def _may_be_object(self, call: Call, wanted: set[str]) -> bool:
        may_be, qualifier = self._a.types.may_be, call.qualifier
        if call.name == "make_shared" or may_be(call.name, wanted):
            return True
        return bool(qualifier) and may_be(qualifier.partition("::")[0], wanted)

    def _made_type(self, call: Call, written: str) -> str:
        """Return the whole type of what is made."""
        del written
        scope = call.scope
        syntax = scope.file.syntax
        if call.name_node is not None and call.template is None:
            text = "".join(syntax.word(call.name_node).split())
        else:
            text = call.qualified
            if call.template is not None:
                text += "".join(syntax.word(call.template).split())
        if call.node.type == "field_initializer":
            text = _initialized_type(self._a, call) or text
            if text.endswith("*"):
                return ""
        elif text == "make_shared":
            text = call.qualified
        whole = self._a.types.expand(text, scope)
        if call.node.type != "call_expression" and without_pointer(whole) != whole:
            # A pointer that is given what is made.
            return ""
        return self._receivers.plain(whole, scope)

    def _object(self, call: Call, shape: Shape, type_: str) -> Found | None:
        scope = call.scope
        given = call.arguments
        handle: Node | None = None
        if shape.on in ("function", "filter"):
            if len(given) < 2:
                return None
            handle, given = given[0], given[1:]
        elif shape.on == "maybe":
            first = self._receivers.type_of(given[0], scope)
            is_text = given[0].type in ("string_literal", "concatenated_string")
            value = None if is_text else self._a.evaluator.fold(given[0], scope)
            is_text = (
                is_text
                or first.endswith("string")
                or (first != HANDLE and value is not None and value.text is not None)
            )
            if not is_text and len(given) > 1 and (first == HANDLE or not first or len(given) > 2):
                second = given[1]
                if second.type not in ("true", "false") or first == HANDLE:
                    handle, given = given[0], given[1:]
        owner = self._owner(handle, scope) if handle is not None else self._unit.class_of(scope)
        return Found(call, shape, given, handle, scope, owner, template_of(type_))


def _initialized_type(analysis: Analysis, call: Call) -> str | None:
    children = call.node.named_children
    owner = analysis.unit.class_of(call.scope)
    if owner is None or not children:
        return None
    name = "".join(call.scope.file.syntax.word(children[0]).split())
    member = analysis.unit.member(owner, name)
    if member is None:
        return None
    return f"{member.type}*" if member.is_pointer else member.type
