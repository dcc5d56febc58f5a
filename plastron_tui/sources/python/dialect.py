"""How two Python client libraries differ in the types and values that they take."""

from __future__ import annotations

import keyword
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from plastron_tui.model.kinds import Parameter
from plastron_tui.model.values import Value
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import FieldType, Interface, InterfaceKind, InterfaceName

from . import literals
from .import_block import Imports, Symbol


@dataclass(frozen=True, slots=True)
class Dialect:
    """A Python client library.

    Attributes:
        library: its name, which is the template's folder too.
        ros_version: 1 or 2.
        standard: modules of Python that every node imports.
        calling: modules of Python that a node imports that calls services or sends goals; `sys`
            only where it ends then.
        timing: modules of Python that a node imports that has timers.
        modules: modules of ROS that every node imports whole.
        symbols: names that every node imports.
        server_symbols: names that a node imports that provides actions.
        client_symbols: names that a node imports that has clients of actions.
        goal_symbols: names that a node imports that sends goals.
        task_symbols: names that a node imports that calls services or has any part in actions.
        module_names: names that the template gives to what it defines in the file.
        method_names: names that a method of a node must not have.
        attribute_names: names that the template gives to its own methods and attributes.
        task_names: those that only a node has that calls services or has any part in actions.
        serving: how the attribute of an action ends that a node provides.
        managed_symbols: names that a managed node imports, in place of `symbols`.
        managed_server_symbols: names that a managed node imports that provides actions.
        managed_names: names that only a method of a managed node must not have.
    """

    library: str
    ros_version: int
    standard: tuple[str, ...]
    calling: tuple[str, ...]
    timing: tuple[str, ...]
    modules: tuple[str, ...]
    symbols: tuple[Symbol, ...]
    server_symbols: tuple[Symbol, ...]
    client_symbols: tuple[Symbol, ...]
    goal_symbols: tuple[Symbol, ...]
    task_symbols: tuple[Symbol, ...]
    module_names: frozenset[str]
    method_names: frozenset[str]
    attribute_names: frozenset[str]
    task_names: frozenset[str]
    serving: str
    managed_symbols: tuple[Symbol, ...] = ()
    managed_server_symbols: tuple[Symbol, ...] = ()
    managed_names: frozenset[str] = frozenset()

    def reserved(self, symbols: Iterable[Symbol]) -> set[str]:
        """Return the names that no imported type may have in a file that imports symbols."""
        own = {name for _, name in symbols}
        return {
            *self.standard,
            *self.calling,
            *self.timing,
            *self.modules,
            *own,
            *self.module_names,
        }

    def scalar(self, type_: FieldType, value: Value, imports: Imports) -> str:
        """Write one value of a primitive field."""
        raise AssertionError(f"{self.library} writes no values")

    def field(self, name: str) -> str:
        """Return what the constructor of a message calls a field."""
        return name

    def parameter(self, parameter: Parameter, getter: Callable[[str], str]) -> str:
        """Write what reads a parameter of the node; `getter` names a method that does."""
        raise AssertionError(f"{self.library} has no parameters")

    def unusable(self, interface: Interface, catalog: Catalog) -> str | None:
        """Return why there is no class of an interface, None where there is one.

        Its package stands in the lines that import the class.
        """
        del catalog
        if keyword.iskeyword(interface.name.package):
            return f"the package of `{interface.name}` is called as a keyword of Python is"
        return None

    def class_of(self, type_: InterfaceName, kind: InterfaceKind, imports: Imports) -> str:
        """Return the class of a type."""
        return imports.use(f"{type_.package}.{kind.value}", type_.name)

    def part_of(
        self, type_: InterfaceName, kind: InterfaceKind, part: str, imports: Imports
    ) -> str:
        """Return the class of a part of a service (`Request`, …) or of an action (`Goal`, …)."""
        return f"{self.class_of(type_, kind, imports)}.{part}"

    def request(self, type_: InterfaceName, imports: Imports) -> str:
        """Return the class of a service's requests."""
        return self.part_of(type_, InterfaceKind.SERVICE, "Request", imports)

    def response(self, type_: InterfaceName, imports: Imports) -> str:
        """Return an expression that makes a service's default response."""
        return f"{self.part_of(type_, InterfaceKind.SERVICE, 'Response', imports)}()"


def plain_scalar(value: Value) -> str:
    """Write a value that both libraries take as Python has it."""
    match value:
        case bool():
            return repr(value)
        case int() | float():
            return literals.number(value)
        case str():
            return literals.string(value)
        case _:
            raise TypeError(f"{value!r} is no scalar")
