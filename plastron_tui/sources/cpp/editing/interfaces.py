"""Interface types as an edit writes them: their classes, headers and values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NoReturn

from plastron_tui.diagnostics import Code, Diagnostic, Span, codes, listed
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.catalog import Catalog, moved
from plastron_tui.ros.interfaces import Field, Interface, InterfaceKind, InterfaceName

from .. import interface_types
from ..computed import Computing
from ..guarded import Conditions
from ..messages import Filling
from .refusals import RefusedError

_HEADER = InterfaceName("std_msgs", "Header")


def refuse(code: Code, message: str, span: Span | None, remedy: str | None = None) -> NoReturn:
    """Stop: something cannot be added.

    Raises:
        RefusedError: always.
    """
    refusal = RefusedError(message)
    refusal.diagnostic = Diagnostic(code, message, span, help=remedy)
    raise refusal


@dataclass(slots=True)
class Interfaces:
    """What an edit knows of interface types.

    Attributes:
        catalog: the types.
        ros_version: the generation of ROS of the files.
        headers: those that what was written needs.
        packages: the packages of the types.
    """

    catalog: Catalog
    ros_version: int
    headers: dict[str, None] = field(default_factory=dict)
    packages: dict[str, None] = field(default_factory=dict)

    def find(self, type_: InterfaceName, kind: InterfaceKind, span: Span | None) -> Interface:
        """Return an interface, under its new name where ROS has renamed it."""
        found = self.catalog.find(type_, kind)
        instead = moved(type_, self.catalog.ros_version)
        if found is None and isinstance(instead, InterfaceName):
            found = self.catalog.find(instead, kind)
        if found is None:
            remedy = f"use `{instead}`" if isinstance(instead, InterfaceName) else instead
            message = f"{self.catalog.distribution} has no type `{type_}`"
            refuse(codes.UNKNOWN_TYPE, message, span, remedy)
        reason = interface_types.unusable(found, self.catalog)
        if reason is not None:
            refuse(codes.UNUSABLE_TYPE, reason, span)
        return found

    def checked_field(
        self, interface: Interface, fields: Sequence[Field], name: str, span: Span | None
    ) -> Field:
        """Return a field of an interface by its name."""
        found = next((each for each in fields if each.name == name), None)
        if found is None:
            message = f"`{interface.name}` has no field `{name}` in {self.catalog.distribution}"
            names = listed(f"`{each.name}`" for each in fields)
            remedy = f"it has {names}" if fields else "it has no field at all"
            refuse(codes.UNKNOWN_FIELD, message, span, remedy)
        return found

    def class_of(self, type_: InterfaceName, kind: InterfaceKind) -> str:
        """Write the class of a type; its header is noted."""
        part = "Action" if kind is InterfaceKind.ACTION and self.ros_version == 1 else ""
        self.headers[interface_types.header(type_, kind, self.ros_version, part)] = None
        self.packages[type_.package] = None
        return interface_types.class_name(type_, kind, self.ros_version) + part

    def fill(
        self,
        interface: Interface,
        fields: Sequence[Field],
        value: MessageValue,
        holder: str,
        computing: Computing,
        span: Span | None,
        received: str = "received",
        heard: Sequence[Field] = (),
    ) -> list[str]:
        """Write the statements that give fields their values; see `Filling`."""
        return Filling(self, computing, span, received, heard).lines(
            interface, fields, value, holder
        )

    def needs_stamp(self, value: MessageValue) -> bool:
        """Tell whether a message has a header whose time nothing says."""
        found = self.catalog.find(value.type, InterfaceKind.MESSAGE)
        fields = found.fields if found is not None else ()
        has_header = any(each.name == "header" and each.type.message == _HEADER for each in fields)
        header = value.fields.get("header")
        says = header is not None and (
            not isinstance(header, MessageValue) or "stamp" in header.fields
        )
        return has_header and not says


__all__ = ["Conditions", "Interfaces", "refuse"]
