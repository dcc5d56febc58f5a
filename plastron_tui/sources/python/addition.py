"""One endpoint on its way into a file."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import chain

from tree_sitter import Node

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import Endpoint
from plastron_tui.model.kinds.ranges import EVERY_FLOAT, EVERY_INTEGER, Interval
from plastron_tui.model.source import EndpointKind
from plastron_tui.model.unique_names import numbered
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface
from plastron_tui.ros.names import name_as_written, parameter_name

from . import literals, naming
from .analysis import Analysis, Site
from .calls import Argument
from .conventions import conventions_of
from .dialect import Dialect
from .handed_on import HandedOn
from .loggers import Filling, filling_of, own_logger, prints
from .messages import CannotAddError, Messages
from .parameter_calls import parameter_call
from .place import Place
from .references import identifiers
from .scopes import Scope
from .typeimports import FileImports
from .writing import Writer

# What is called otherwise may be made anew in each call.
_LITERALS = frozenset({"integer", "float", "string", "true", "false", "unary_operator", "list"})
_NAME = re.compile(r"[\w.]+")


@dataclass(slots=True)
class Addition:
    """One endpoint on its way into a file.

    Attributes:
        variable: the source of the variable that holds it, "" where none does.
        handed: what its callback gets besides what ROS gives it.
        heard: the message that what is sent is computed of: its name and type, None for none.
    """

    analysis: Analysis
    kind: EndpointKind
    endpoint: Endpoint
    name: str
    place: Place
    writer: Writer
    imports: FileImports
    catalog: Catalog
    dialect: Dialect
    variable: str = ""
    handed: HandedOn = field(default_factory=HandedOn)
    heard: tuple[str, Interface] | None = None

    @classmethod
    def at(
        cls,
        place: Place,
        analysis: Analysis,
        kind: EndpointKind,
        endpoint: Endpoint,
        catalog: Catalog,
        dialect: Dialect,
    ) -> Addition:
        """Begin to write an endpoint of a kind, or a part of it, at a place of a file."""
        conventions = conventions_of(analysis)
        imports = FileImports(analysis, conventions)
        writer = Writer(analysis, conventions)
        added = cls(
            analysis, kind, endpoint, endpoint.name, place, writer, imports, catalog, dialect
        )
        added.stand(is_nested=True)
        return added

    @property
    def messages(self) -> Messages:
        """What writes types and values; made anew, for the two would keep each other alive."""
        imports, conventions = self.imports, self.writer.conventions
        span, read = self.endpoint.span, self.read_parameter
        messages = Messages(
            self.catalog, self.dialect, imports, conventions, span, read, self.free_name
        )
        if self.heard is not None:
            messages.hear(*self.heard)
        return messages

    def read_parameter(self, name: str) -> tuple[str, Interval]:
        """Write what reads a parameter of the node, and tell which numbers it may be.

        Raises:
            CannotAddError: rospy is to read it with a default, which the file does not say.
        """
        version = self.dialect.ros_version
        whole = parameter_name(name, version)
        sites = [
            each
            for each in self.analysis.sites
            if each.endpoint.kind is EndpointKind.PARAMETER and each.endpoint.name == whole
        ]
        found = (parameter_call(self.analysis, each).default for each in sites)
        default = next((each for each in found if each is not None), None)
        is_float = default is not None and default.type == "float"
        range_ = EVERY_FLOAT if is_float else EVERY_INTEGER
        self.writer.endpoints.append((EndpointKind.PARAMETER, whole, "None", ""))
        written = self.writer.conventions.string(name_as_written(whole, version))
        if self.is_rclpy:
            receiver = self.receiver_in_callback() or self.place.receiver
            return f"{receiver}.get_parameter({written}).value", range_
        if default is None or default.type not in _LITERALS:
            message = f"the file does not say the default of `{name}` in one place"
            remedy = f"write by hand what `{name}` is needed for"
            raise CannotAddError(codes.EDIT_REFUSED, message, self.endpoint.span, remedy)
        value = self.analysis.syntax.slice(default)
        return f"{self.rospy('get_param', in_callback=True)}({written}, {value})", range_

    def interface(self) -> Interface:
        """Return the type of the endpoint."""
        folder = self.kind.facts.interface
        assert folder is not None, "what statements make is of a type"
        return self.messages.interface(self.endpoint.type, folder, self.name)

    @property
    def is_rclpy(self) -> bool:
        """Whether the node is one of rclpy's."""
        return self.dialect.ros_version == 2

    @property
    def label(self) -> str:
        """The endpoint's name, as prose."""
        return naming.label(name_as_written(self.name, self.dialect.ros_version), "its topic")

    def free_name(self, wanted: str, *others: str) -> str:
        """Return a name that the file does not use yet: one of those wanted, or one numbered."""
        free = next(
            name
            for name in chain([wanted, *others], numbered(wanted))
            if name not in self.dialect.method_names
            and name not in self.writer.names
            and literals.is_name(name)
            and not any(True for _ in identifiers(name, self.analysis))
        )
        self.writer.names.add(free)
        return free

    def rospy(self, name: str, *, in_callback: bool = False) -> str:
        """Return what the file calls a name of rospy, where the endpoint is or in a callback."""
        scope = self.place.scope
        if in_callback:
            scope = self._outside
        return self.imports.library("rospy", name, scope)

    def log(self, level: str, value: str, *, in_callback: bool = True) -> str:
        """Return a statement that logs a value of the endpoint, as the file logs its others."""
        own = logger = own_logger(self.analysis, self.place, level)
        if not own and not self.is_rclpy:
            logger = self.rospy({"info": "loginfo"}.get(level, "logerr"), in_callback=in_callback)
        elif not own:
            logger = self._node_logger(level, in_callback=in_callback)
        usual = Filling.ARGUMENT
        if own or self.is_rclpy:
            # Only the functions of rospy are known to take arguments.
            usual = Filling.INTERPOLATED if self.is_rclpy else Filling.PERCENT
        filling = filling_of(self.analysis, usual, logger)
        return f"{logger}({filling.fill(self.writer.conventions.quote, self.label, value)})"

    def _node_logger(self, level: str, *, in_callback: bool) -> str:
        """Return what logs for a node of rclpy, from where the node may not be seen."""
        receiver = self.receiver_in_callback() if in_callback else self.place.receiver
        names = {node.name for node in self.analysis.nodes}
        name = names.pop() if len(names) == 1 else None
        if receiver:
            return f"{receiver}.get_logger().{level}"
        if name is None or prints(self.analysis):
            return "print"
        get_logger = self.imports.use("rclpy.logging", "get_logger")
        return f"{get_logger}({self.writer.conventions.string(name)}).{level}"

    def receiver_in_callback(self) -> str:
        """Return what a callback calls the node, "" where it cannot see it."""
        if self.is_method_place:
            return self._held_receiver or self.place.receiver or self.place.self_name
        found = self.place.scope.lookup(self.place.receiver.partition(".")[0])
        is_global = found is not None and found[0].parent is None
        return self.place.receiver if is_global else ""

    @property
    def _held_receiver(self) -> str:
        """The attribute by which an object holds the node that its method gets, "" for none."""
        attributes = self.place.owner.attributes if self.place.owner is not None else {}
        for name, bindings in attributes.items():
            value = bindings[0].value if len(bindings) == 1 else None
            if (
                value is not None
                and bindings[0].scope is self.place.scope
                and value.start_byte < self.place.offset
                and self.analysis.syntax.slice(value) == self.place.receiver
            ):
                return f"{self.place.self_name}.{name}"
        return ""

    @property
    def is_nested(self) -> bool:
        """Whether a function that uses the endpoint stands within the one that creates it."""
        is_method = self.is_method_place and "." in self.variable
        return not is_method and self.place.scope.parent is not None

    def stand(self, *, is_nested: bool) -> None:
        """Say where what is written next stands: where the endpoint is, or in another function."""
        scope = self.place.scope if is_nested else self._outside
        method = self.place.scope if self.place.owner is not None else None
        self.imports.stand(scope, self.place.offset, method)

    @property
    def _outside(self) -> Scope:
        """What a callback sees: a function of the module, or a method, what is around its class."""
        module = self.analysis.scopes.module
        owner = self.place.owner if self.is_method_place else None
        return module if owner is None else owner.parent or module

    @property
    def is_method_place(self) -> bool:
        """Whether the methods of the class around the endpoint see the node as it does."""
        holder = self.place.receiver.partition(".")[0]
        is_seen = holder in ("", self.place.self_name) or bool(self._held_receiver)
        return self.place.owner is not None and is_seen

    def is_beside(self, site: Site) -> bool:
        """Whether a call is in the function, or the module, that the endpoint goes into."""
        module = self.analysis.scopes.module
        return (site.scope.enclosing("function") or module) is self.place.scope

    def callback_group(self, kind: EndpointKind) -> str:
        """Return the callback group that all endpoints of a kind beside this one are in."""
        given = set(self.given_beside(kind, Argument(-1, "callback_group")))
        found = given.pop() if len(given) == 1 else ""
        return found if self.is_rclpy and _NAME.fullmatch(found) else ""

    def given_beside(self, kind: EndpointKind, argument: Argument) -> list[str]:
        """Return what the endpoints of a kind beside this one say, "" for those that do not."""
        return [
            self.analysis.syntax.slice(given) if given is not None else ""
            for site in self.analysis.sites
            if site.endpoint.kind is kind and site.scope is self.place.scope
            for given in [site.arguments.get(argument)]
            if given is None or self._is_set(given)
        ]

    def _is_set(self, given: Node) -> bool:
        """Whether a name that another endpoint is given has its value where the new one is made."""
        scope, owner = self.place.scope, self.place.owner
        holder, dot, name = self.analysis.syntax.slice(given).partition(".")
        found = scope.bindings.get(holder, [])
        if dot and owner is not None and holder == self.place.self_name:
            found = owner.attributes.get(name, [])
        own = [each.node.start_byte for each in found if each.scope is scope]
        return not own or min(own) < self.place.offset
