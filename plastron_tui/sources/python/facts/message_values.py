"""Which message an expression of a file is, as far as all that may give it is known."""

from __future__ import annotations

from collections.abc import Callable, Container
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import MessageField, MessageType, Part
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.callers import given_for
from plastron_tui.sources.python.constants import without_none
from plastron_tui.sources.python.flow import reaching
from plastron_tui.sources.python.references import function_of
from plastron_tui.sources.python.scopes import Binding, BindingKind, Scope
from plastron_tui.sources.python.syntax import holders, parts_of

from .answers import ASKED, THEN
from .attribute_flow import last_in_function
from .callers import calls_of, future_of
from .handed_messages import Held, Helds, handed_messages, items, merged, sure_types
from .message_classes import message_class
from .python_functions import LIBRARY_METHODS
from .returns import is_special, returned_values

_DEEPEST = 24
_MOST_BINDINGS = 16
_MOST_HOLDERS = 8
_SAME = frozenset({"copy.copy", "copy.deepcopy"})
_LISTS = frozenset({"list", "tuple", "reversed", "sorted"})
_METHODS = frozenset(name for _, name in THEN)
_LOOPS = frozenset({"for_statement", "for_in_clause"})


class Loop(NamedTuple):
    """What the variable of a loop takes: the elements of `taken`, or its number in them."""

    taken: Node | None
    is_number: bool = False


class MessageValues:
    """Answers which messages the expressions of a file are.

    Attributes:
        analysis: the file.
        sites: its call sites, by the calls.
        makers: what is just looked at for how it makes a message: functions, and names.
        is_elsewhere: whether another file calls functions of this one, which may change more.
    """

    def __init__(self, analysis: Analysis, misfits: Container[Span] = frozenset()) -> None:
        """Look at what callbacks get; all else is looked at when it is asked for.

        Args:
            analysis: the file.
            misfits: the parameters of callbacks that cannot be called: what they get is not known.
        """
        self.analysis = analysis
        self._misfits = misfits
        self.sites = {site.call.id: site for site in analysis.first_sites()}
        self.makers: set[int] = set()
        self._types = sure_types(analysis)
        self._handed = handed_messages(analysis)
        self._known: dict[int, Helds] = {}
        self._classes: dict[int, MessageType | None] = {}
        self._returned: dict[int, Helds] = {}
        self.is_elsewhere = False
        self._of_files: dict[int, MessageValues] = {id(analysis): self}

    def of_file(self, file: Analysis) -> MessageValues:
        """Return the messages of another file that this one calls functions of."""
        if id(file) not in self._of_files:
            other = MessageValues(file)
            other._of_files = self._of_files
            other.is_elsewhere = True
            self._of_files[id(file)] = other
        return self._of_files[id(file)]

    def scope(self, node: Node) -> Scope:
        """Return the scope that a node is in."""
        return self.analysis.scopes.at(node.start_byte)

    def class_of(self, node: Node | None) -> MessageType | None:
        """Return the message that an expression is the class of."""
        if node is None:
            return None
        if node.id not in self._classes:
            self._classes[node.id] = message_class(self.analysis, node, self.scope(node))
        return self._classes[node.id]

    def held(self, node: Node | None, depth: int = 0) -> Helds:
        """Return the message, or the part of one, that an expression is."""
        if node is None or depth > _DEEPEST:
            return ()
        if node.id not in self._known:
            # What leads to itself is not known.
            self._known[node.id] = ()
            self._known[node.id] = self._held(node, depth + 1)
        return self._known[node.id]

    def bindings(self, node: Node) -> tuple[str, list[Binding]]:
        """Return what may have given a name, or an attribute of the file's objects, its value."""
        analysis = self.analysis
        if node.type == "identifier":
            name = analysis.syntax.slice(node)
            scope = self.scope(node)
            found = scope.lookup(name)
            if found is None or len(found[1]) > _MOST_BINDINGS:
                return name, []
            owner, bindings = found
            if owner.self_name == name and owner.parent is not None:
                return name, []
            return name, reaching(bindings, owner, node, scope)
        if node.type == "attribute":
            name_node = node.child_by_field_name("attribute")
            name = analysis.syntax.slice(name_node) if name_node is not None else ""
            found_there = self._attribute_bindings(node, name)
            found_there = last_in_function(found_there, node, self.scope(node))
            return name, found_there if len(found_there) <= _MOST_BINDINGS else []
        return "", []

    def _attribute_bindings(self, node: Node, name: str) -> list[Binding]:
        holder = node.child_by_field_name("object")
        owner = self.object_class(holder) if holder is not None else None
        return [] if owner is None else self.analysis.resolver.classes.attribute(owner, name)

    def object_class(self, node: Node) -> Scope | None:
        """Return the class of the file that an object is of: `self`, or what its call has made."""
        if node.type == "identifier":
            name = self.analysis.syntax.slice(node)
            found = self.scope(node).lookup(name)
            if found is not None and found[0].self_name == name:
                return None if self._is_misfit(found[0]) else found[0].parent
        if node.type not in ("identifier", "attribute") or len(holders(node)) > _MOST_HOLDERS:
            return None
        known = without_none(self.bindings(node)[1])
        made = known[0] if len(known) == 1 else None
        if made is None or made.value is None or made.value.type != "call":
            return made.owner if made is not None and made.kind is BindingKind.CLASS else None
        callee = made.value.child_by_field_name("function")
        if callee is None or callee.type != "identifier":
            return None
        classes = made.scope.lookup(self.analysis.syntax.slice(callee))
        is_class = classes is not None and len(classes[1]) == 1
        binding = classes[1][0] if classes is not None and is_class else None
        return binding.owner if binding and binding.kind is BindingKind.CLASS else None

    def site_of(self, node: Node | None) -> Site | None:
        """Return the call site that made the endpoint which an expression is."""
        if node is None:
            return None
        if node.type == "call":
            return self.sites.get(node.id)
        bindings = without_none(self.bindings(node)[1])
        made = {b.value.id for b in bindings if b.value is not None}
        if len(bindings) != 1 or len(made) != 1:
            return None
        return self.sites.get(made.pop())

    def of_site(self, site: Site, part: Part) -> Helds:
        """Return a message of an endpoint's type, none where that is not sure."""
        type_ = self._types.get(site.call.id)
        return () if type_ is None else (Held(MessageType(type_, part)),)

    def loop(self, binding: Binding, name: str) -> Loop | None:
        """Return what a variable of a loop takes, None for any other binding."""
        if binding.node.type not in _LOOPS:
            return None
        target = binding.node.child_by_field_name("left")
        taken = binding.node.child_by_field_name("right")
        if target is None or taken is None:
            return None
        if target.type == "identifier":
            return Loop(taken)
        names = [self.analysis.syntax.slice(each) for each in parts_of(target)]
        called = self.analysis.syntax.called_name(taken)
        if taken.type != "call" or name not in names or not self.is_builtin(taken):
            return Loop(None)
        given = Arguments.of(taken, self.analysis.syntax)
        if given.is_open or not given.positional:
            return Loop(None)
        position = names.index(name)
        if called == "enumerate" and len(names) == 2:
            return Loop(given.positional[0] if position else None, position == 0)
        if called == "zip" and len(names) == len(given.positional):
            return Loop(given.positional[position])
        return Loop(None)

    def is_builtin(self, call: Node) -> bool:
        """Whether a call is of a plain name that the file gives to nothing."""
        callee = call.child_by_field_name("function")
        if callee is None or callee.type != "identifier":
            return False
        return self.scope(call).lookup(self.analysis.syntax.slice(callee)) is None

    def _held(self, node: Node, depth: int) -> Helds:
        match node.type:
            case "identifier":
                name, bindings = self.bindings(node)
                return self._bound(name, bindings, depth)
            case "attribute":
                return self._attribute(node, depth)
            case "call":
                return self._call(node, depth)
            case "subscript":
                return self._subscript(node, depth)
            case "parenthesized_expression" | "await":
                parts = parts_of(node)
                inner = parts[0] if len(parts) == 1 else None
                if node.type == "await":
                    return self._given_by_future(inner, "result")
                return self.held(inner, depth)
            case "conditional_expression":
                parts = parts_of(node)
                sides = [each for each in (parts[0], parts[-1]) if each.type != "none"]
                return merged(self.held(side, depth) for side in sides)
            case "named_expression":
                return self.held(node.child_by_field_name("value"), depth)
        return ()

    def _bound(self, name: str, bindings: list[Binding], depth: int) -> Helds:
        return merged(self._binding(name, each, depth) for each in without_none(bindings))

    def _binding(self, name: str, binding: Binding, depth: int) -> Helds:
        match binding.kind:
            case BindingKind.VALUE:
                return self.held(binding.value, depth) or self._said(name, binding)
            case BindingKind.PARAMETER:
                return self._parameter(name, binding, depth)
            case BindingKind.UNKNOWN:
                loop = self.loop(binding, name)
                if loop is not None and loop.taken is not None:
                    return items(self.held(loop.taken, depth))
        return ()

    def _parameter(self, name: str, binding: Binding, depth: int) -> Helds:
        function = binding.owner
        if function is None or self._is_misfit(function) or self._is_looked_at(name, function):
            return ()
        if function.node.id in self._handed:
            position = binding.index - bool(function.self_name)
            return self._handed[function.node.id].get(position, ())
        if (future := future_of(self.analysis, function)) is not None:
            return self.held(future, depth)
        calls = calls_of(self.analysis, function)
        if calls:
            given = (
                given_for(call, function, binding, name, self.analysis.syntax) for call in calls
            )
            return merged(self.held(value, depth) for value in given)
        said = self._annotated(binding)
        if said is None or (calls is None and said.kind is not InterfaceKind.SERVICE):
            # What gets a function as a value may call it with something around the message.
            return ()
        return (Held(said, is_said=True),)

    def _is_misfit(self, function: Scope) -> bool:
        """Whether a function is a callback that cannot be called, as with `self` left out."""
        parameters = function.node.child_by_field_name("parameters")
        at = parameters and Span(parameters.start_byte, parameters.end_byte)
        return at in self._misfits

    def _said(self, name: str, binding: Binding) -> Helds:
        """Return what the annotation says of a variable that a call gives its value."""
        target, value = binding.node.child_by_field_name("left"), binding.value
        if target is None or target.type != "identifier" or value is None or value.type != "call":
            return ()
        said = self._annotated(binding)
        is_sure = said is not None and not self._is_looked_at(name, binding.scope)
        return (Held(said, is_said=True),) if said is not None and is_sure else ()

    def _annotated(self, binding: Binding) -> MessageType | None:
        annotation = binding.annotation
        if annotation is None or not annotation.named_child_count:
            return None
        return message_class(self.analysis, annotation.named_children[0], binding.scope)

    def _is_looked_at(self, name: str, function: Scope) -> bool:
        """Whether a function asks what its parameter is."""
        text = self.analysis.syntax.slice(function.node)
        asks = ("isinstance(", "hasattr(", "type(", "_type")
        return any(f"{ask}{name}" in text for ask in asks[:3]) or f"{name}.{asks[3]}" in text

    def _attribute(self, node: Node, depth: int) -> Helds:
        holder = self.held(node.child_by_field_name("object"), depth)
        name_node = node.child_by_field_name("attribute")
        if holder and name_node is not None:
            name = self.analysis.syntax.slice(name_node)
            return merged(each.attribute(name) for each in holder)
        name, bindings = self.bindings(node)
        return self._bound(name, bindings, depth)

    def _subscript(self, node: Node, depth: int) -> Helds:
        holder = self.held(node.child_by_field_name("value"), depth)
        index = node.child_by_field_name("subscript")
        if index is not None and index.type == "slice":
            return holder
        return items(holder)

    def _call(self, call: Node, depth: int) -> Helds:
        callee = call.child_by_field_name("function")
        made = self.class_of(callee)
        if made is not None:
            return (Held(made),)
        site = self.sites.get(call.id)
        if site is not None:
            is_message = site.shape.gives_message and self.analysis.library.ros_version == 1
            return self.of_site(site, Part.MESSAGE) if is_message else ()
        syntax = self.analysis.syntax
        arguments = Arguments.of(call, syntax)
        only = arguments.positional[0] if len(arguments.positional) == 1 else None
        if only is not None and not arguments.is_open:
            if self.is_builtin(call) and syntax.called_name(call) in _LISTS:
                return self.held(only, depth)
            names = self.analysis.resolver.qualified(callee, self.scope(call))
            if names and all(name in _SAME for name in names):
                return self.held(only, depth)
        return (
            self._answer(call)
            or self._taken_out(call, depth)
            or self._result(callee, depth)
            or self.given_by_library(call)
        )

    def _taken_out(self, call: Node, depth: int) -> Helds:
        """Return the element that `msg.poses.pop()` gives."""
        callee = call.child_by_field_name("function")
        is_pop = self.analysis.syntax.called_name(call) == "pop"
        if callee is None or callee.type != "attribute" or not is_pop:
            return ()
        return items(self.held(callee.child_by_field_name("object"), depth))

    def given_by_library(self, call: Node) -> Helds:
        """Return what a method of cv_bridge or tf2 gives, where the file has none of its name."""
        name = self.analysis.syntax.called_name(call)
        type_ = LIBRARY_METHODS.get(name)
        if type_ is None or any(each.name == name for each in self.analysis.scopes.all):
            return ()
        callee = call.child_by_field_name("function")
        is_method = callee is not None and callee.type == "attribute"
        return (Held(MessageType(type_)),) if is_method else ()

    def _answer(self, call: Node) -> Helds:
        """Return what a service or an action answers to a call of its client, or will answer."""
        callee = call.child_by_field_name("function")
        if callee is None:
            return ()
        version = self.analysis.library.ros_version
        if version == 1 and (site := self.site_of(callee)) is not None:
            is_client = site.endpoint.kind is EndpointKind.CLIENT
            return self.of_site(site, Part.RESPONSE) if is_client else ()
        if callee.type != "attribute":
            return ()
        receiver = callee.child_by_field_name("object")
        name = self.analysis.syntax.called_name(call)
        answer = ASKED.get((version, name))
        if answer is None:
            return self._given_by_future(receiver, name)
        site = self.site_of(receiver)
        if site is None or site.endpoint.kind is not answer.kind:
            return ()
        held = self.of_site(site, answer.part)
        return tuple(each._replace(behind=answer.behind) for each in held)

    def _given_by_future(self, receiver: Node | None, name: str) -> Helds:
        """Return what a method of a future or of the handle of a goal gives."""
        if name not in _METHODS:
            return ()
        held = self.held(receiver)
        if not held or any((each.behind, name) not in THEN for each in held):
            return ()
        return tuple(each._replace(behind=THEN[each.behind, name]) for each in held)

    def _result(self, callee: Node | None, depth: int) -> Helds:
        """Return what a function of the file gives."""
        function = function_of(callee, self.analysis) if callee is not None else None
        if function is None or function.node.type != "function_definition":
            return ()
        if function.node.id not in self._returned:
            self._returned[function.node.id] = ()
            found = self._returns(function, lambda node: self.held(node, depth))
            self._returned[function.node.id] = found
        return self._returned[function.node.id]

    def _returns(self, function: Scope, ask: Callable[[Node], Helds]) -> Helds:
        if is_special(function):
            return ()
        values = returned_values(function)
        return merged(ask(each) for each in values if each.type != "none")


def field_of(held: Held) -> MessageField:
    """Return a message as facts have it."""
    return MessageField(held.type, held.path)
