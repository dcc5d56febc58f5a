"""Which calls of a unit match a shape that creates endpoints."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from .analysis import Analysis
from .arguments import Call
from .found import Found, template_of
from .objects import Objects
from .receivers import HANDLE
from .scopes import Scope, last_name
from .shapes import FILLED, FUNCTIONS, METHODS, OBJECTS, Shape

_NODE_NAME = re.compile(r"(?:\w*_)?(?:node|n|nh|self|parent|ros_node|lc_?node)\w{0,3}_?", re.I)
_HANDLE_NAME = re.compile(
    r"\w*(?:nh|node_?handle|handle|node)\w{0,8}|n_?|nhp?_?|pn_?|np_?|priv\w*", re.I
)
_OPTIONS = {
    "ros::AdvertiseOptions": "advertise",
    "ros::SubscribeOptions": "subscribe",
    "ros::AdvertiseServiceOptions": "advertiseService",
    "ros::ServiceClientOptions": "serviceClient",
}
_HANDLE_ALONE = frozenset({"param", "getParam", "getParamCached", "setParam", "hasParam"})


class Finder:
    """The calls of a unit that match a shape."""

    def __init__(self, analysis: Analysis) -> None:
        self._a = analysis
        self._unit = analysis.unit
        self._receivers = analysis.receivers
        self._ros = analysis.ros_version
        self._wanted = {"handle", "lazy"} if self._ros == 1 else {"node"}
        self._unsure: list[Found] = []
        self._used: set[int] = set()
        self._unsure_methods: list[tuple[str, Found]] = []
        self._used_classes: set[str] = set()

    def found(self) -> Iterator[Found]:
        """Yield the calls."""
        for name, shapes in METHODS.items():
            for call in self._unit.calls.get(name, ()):
                if (found := self._method(call, shapes)) is not None:
                    yield found
        yield from (each for each in self._unsure if id(each.owner) in self._used)
        yield from (each for name, each in self._unsure_methods if name in self._used_classes)
        short = {name.rpartition("::")[2] for name in FUNCTIONS}
        for name in sorted(short):
            for call in self._unit.calls.get(name, ()):
                if (found := self._function(call)) is not None:
                    yield found
        yield from Objects(self._a, self._owner).found()

    def _method(self, call: Call, shapes: tuple[Shape, ...]) -> Found | None:
        scope = call.scope
        if call.receiver is None or call.receiver.type == "this":
            return self._implicit(call, shapes)
        type_ = self._receivers.type_of(call.receiver, scope)
        for shape in shapes:
            if shape.on in ("handle", "node") and shape.on not in self._wanted:
                continue
            given, handle = call.arguments, call.receiver
            owner = self._unit.find_class(type_, scope) if type_ else None
            if shape.on == "empty":
                if (filled := self._filled(call, type_)) is not None:
                    return filled
                continue
            if self._is_on(shape, type_, owner, call):
                if shape.on == "handle" and (options := self._options(call)) is not None:
                    return Found(
                        call, shape, options.arguments, handle, scope, owner, options=options
                    )
                return Found(call, shape, given, handle, scope, owner)
        return None

    def _is_on(self, shape: Shape, type_: str, owner: Scope | None, call: Call) -> bool:
        """Whether a call is made on what a shape is for."""
        scope = call.scope
        if shape.on == "transport":
            return type_ == "image_transport::ImageTransport"
        if shape.on == "handle":
            if type_ == HANDLE:
                return True
            if owner is not None:
                return self._receivers.derives_from(owner, frozenset({HANDLE}))
            return self._is_shown(shape, type_, call, _HANDLE_NAME)
        if type_:
            if owner is not None and call.name in owner.functions:
                return False
            is_node = self._receivers.is_node(type_, scope)
            if owner is not None and not is_node and shape.type != "":
                # Of a class of another file: nothing but a node takes an interface type.
                is_open = any(True for _ in self._unit.foreign_bases(owner))
                return is_open and self._is_typed(shape, call)
            if is_node and type_.rpartition("::")[2] not in ("Node", "LifecycleNode"):
                return owner is not None or self._is_typed(shape, call)
            is_template = self._a.types.is_parameter(type_, scope)
            return is_node or (is_template and self._is_typed(shape, call))
        return self._is_shown(shape, type_, call, _NODE_NAME)

    def _is_shown(self, shape: Shape, type_: str, call: Call, names: re.Pattern[str]) -> bool:
        """Whether a call on an object of an unknown type shows that it is a node's."""
        if type_ and not self._a.types.is_parameter(type_, call.scope):
            return False
        if call.receiver is None:
            return False
        name = last_name(call.receiver, call.scope)
        if call.receiver.type == "call_expression":
            inner = call.receiver.child_by_field_name("function")
            name = last_name(inner, call.scope) if inner is not None else ""
            name = name.removeprefix("get").removeprefix("_")
        is_named = names.fullmatch(name) is not None
        if call.name in _HANDLE_ALONE or shape.type == "":
            return is_named and len(call.arguments) > 0
        return (is_named and self._has_enough(shape, call)) or self._is_typed(shape, call)

    def _has_enough(self, shape: Shape, call: Call) -> bool:
        least = 1 + max(shape.name, shape.callback or 0)
        return len(call.arguments) >= min(least, 2)

    def _is_typed(self, shape: Shape, call: Call) -> bool:
        """Whether a call names an interface where its shape wants one."""
        if shape.type == "":
            return True
        types = self._a.types
        syntax = call.scope.file.syntax
        for each in call.type_nodes[:1]:
            text = "".join(syntax.word(each).split())
            if types.interface(text, call.scope) or types.is_parameter(text, call.scope):
                return True
        return False

    def _implicit(self, call: Call, shapes: tuple[Shape, ...]) -> Found | None:
        """Match a call of a method of the object itself, `create_publisher<T>(…)`."""
        scope = call.scope
        owner = self._unit.class_of(scope)
        for shape in shapes:
            if shape.on not in self._wanted:
                continue
            if owner is None:
                if (found := self._of_unknown_class(call, shape)) is not None:
                    return found
                continue
            if any(call.name in each.functions for each in self._unit.bases(owner)):
                continue
            if shape.on == "handle":
                if self._receivers.derives_from(owner, frozenset({HANDLE})):
                    return Found(call, shape, call.arguments, None, scope, owner)
                continue
            if call.qualifier and not self._is_base(call.qualifier, owner):
                continue
            if shape.on == "lazy":
                if (found := self._lazy(call, shape, owner)) is not None:
                    return found
                continue
            found = Found(call, shape, call.arguments, None, scope, owner)
            if self._receivers.is_node_class(owner):
                return found
            if not any(True for _ in self._unit.foreign_bases(owner)):
                continue
            # Of a class of another file: nothing but a node takes an interface type.
            if shape.type != "" and self._is_typed(shape, call):
                self._used.add(id(owner))
                return found
            if shape.type == "":
                self._unsure.append(found)
        return None

    def _of_unknown_class(self, call: Call, shape: Shape) -> Found | None:
        """Match a call in a method of a class that none of the files declares."""
        function = call.scope.around
        if shape.on != "node" or function is None or not function.qualifier or call.qualifier:
            return None
        if call.name in self._unit.functions:
            return None
        found = Found(call, shape, call.arguments, None, call.scope, None)
        if shape.type == "":
            self._unsure_methods.append((function.qualifier, found))
            return None
        if not self._is_typed(shape, call):
            return None
        self._used_classes.add(function.qualifier)
        return found

    def _lazy(self, call: Call, shape: Shape, owner: Scope) -> Found | None:
        """Match `advertise<T>(nh, "topic", 1)` of nodelets that publish for who listens."""
        given = call.arguments
        if len(given) < 2 or not any(True for _ in self._unit.foreign_bases(owner)):
            return None
        inner = given[0].child_by_field_name("argument") or given[0]
        type_ = self._receivers.type_of(given[0], call.scope)
        if type_ != HANDLE and (type_ or not _HANDLE_NAME.fullmatch(last_name(inner, call.scope))):
            return None
        return Found(call, shape, given[1:], given[0], call.scope, owner)

    def _is_base(self, qualifier: str, owner: Scope) -> bool:
        last = qualifier.rpartition("::")[2]
        bases = [*owner.bases, *(each.name for each in self._unit.bases(owner))]
        return any(base.partition("<")[0].rpartition("::")[2] == last for base in bases)

    def _function(self, call: Call) -> Found | None:
        if call.receiver is not None:
            return None
        scope = call.scope
        name = self._a.types.expand(call.qualified, scope)
        shape = FUNCTIONS.get(name)
        if shape is None and not call.qualifier:
            for space in {using for each in scope.chain for using in each.usings}:
                shape = shape or FUNCTIONS.get(f"{space}::{name}")
        if shape is None:
            return None
        needs = 2 if name.startswith("ros::") else 1
        if (needs == 2) != (self._ros == 1):
            return None
        if shape.on == "function":
            if len(call.arguments) <= shape.node:
                return None
            handle = call.arguments[shape.node]
            owner = self._owner(handle, scope)
            given = call.arguments[shape.node + 1 :]
            while given and self._is_part_of_node(given[0], scope):
                given = given[1:]
            return Found(call, shape, given, handle, scope, owner)
        return Found(call, shape, call.arguments, None, scope, self._unit.class_of(scope))

    def _is_part_of_node(self, node: Node, scope: Scope) -> bool:
        """Whether an argument is one of the interfaces of a node, which may stand for it."""
        text = scope.file.syntax.word(node)
        if "_interface" in text and node.type != "string_literal":
            return True
        return "::node_interfaces::" in self._receivers.type_of(node, scope)

    def _owner(self, handle: Node, scope: Scope) -> Scope | None:
        type_ = self._receivers.type_of(handle, scope)
        return self._unit.find_class(type_, scope) if type_ else None

    def _options(self, call: Call) -> Call | None:
        """Return the call that makes the options that `advertise(options)` gets."""
        if len(call.arguments) != 1:
            return None
        given = call.arguments[0]
        scope = call.scope
        type_ = self._receivers.type_of(given, scope)
        if type_ not in _OPTIONS and "Options" not in type_:
            return None
        name = last_name(given, scope)
        held = self._unit.lookup(name, scope, given.start_byte) if name else None
        if type_ == "ros::TimerOptions" and held is not None and held.arguments:
            return Call(
                held.node, "TimerOptions", "ros", None, None, held.arguments, held.scope, None
            )
        for maker in ("create", "init", "initByFullCallbackType"):
            for each in self._unit.calls.get(maker, ()):
                if not each.type_nodes or each.scope.file is not scope.file:
                    continue
                if each.receiver is not None and last_name(each.receiver, each.scope) == name:
                    return each
                if each.receiver is None and each.qualifier.endswith("Options"):
                    variable = self._unit.lookup(name, scope, given.start_byte) if name else None
                    writes = self._unit.writes(variable) if variable is not None else []
                    if each.node.id == given.id or any(
                        write.value is not None and write.value.id == each.node.id
                        for write in writes
                    ):
                        return each
        return None

    def _filled(self, call: Call, type_: str) -> Found | None:
        """Match `sub.subscribe(nh, "topic", 1)` on an object that is empty before."""
        name = type_.partition("<")[0]
        if name not in FILLED[call.name] or len(call.arguments) < 2:
            return None
        handle, *given = call.arguments
        owner = self._owner(handle, call.scope)
        return Found(call, OBJECTS[name], given, handle, call.scope, owner, template_of(type_))
