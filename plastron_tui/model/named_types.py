"""The interface types that a program names, and values that fit them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Fix, Label, Span, codes, write
from plastron_tui.language.declaration import Statement
from plastron_tui.language.lowering import Program
from plastron_tui.language.statements import CreatePackage, LoadPackage
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface, InterfaceKind
from plastron_tui.ros.packages import check_package_name, mended_package_name

from .consequences import Consequences
from .context import Setting
from .later_types import LaterTypes
from .libraries import default_library
from .mistake import Mistake
from .own_types import InterfaceKey, OwnType, interfaces_of
from .types import TypeProblem, TypeResolver
from .value_check import Fitter
from .values import MessageValue
from .workspace import Workspace


class _Use(NamedTuple):
    """Values of a statement that were fitted to a type."""

    statement: Any
    type: Interface
    version: int
    slot: str
    value: MessageValue


class Refitted(NamedTuple):
    """A statement with values, and what they are of its type as it is now.

    Attributes:
        span: the statement.
        value: the values; None where they fit no longer.
    """

    span: Span
    value: MessageValue | None


class NamedTypes:
    """Looks up the types that statements name, and fits values to them."""

    def __init__(
        self,
        setting: Setting,
        workspace: Workspace,
        consequences: Consequences,
        fitters: Mapping[int, Fitter],
    ) -> None:
        """Start with nothing.

        Args:
            setting: what programs are interpreted in.
            workspace: what the program has built so far.
            consequences: tells what merely follows from an earlier mistake.
            fitters: those of an earlier interpretation, by their generation of ROS.
        """
        self._setting = setting
        self._workspace = workspace
        self._consequences = consequences
        self._version = setting.ros_version(None)
        self._resolvers: dict[int, TypeResolver] = {}
        self._package: str | None = None
        self._later = LaterTypes()
        self._uses: list[_Use] = []
        self.fitters: dict[int, Fitter] = {}
        self._earlier_fitters = fitters

    def named(
        self, statement: Statement, text: str, kind: InterfaceKind, version: int
    ) -> Interface:
        """Return the type that a statement names, in a generation of ROS."""
        found = self.resolver(version).resolve(text, kind)
        if not isinstance(found, TypeProblem):
            return found
        used = self._used_by_file(statement, text, kind)
        if used is not None:
            return used
        if self.is_broken(text, found):
            raise Mistake
        where = statement.span_of("type")
        own = self._own(text, kind)
        if own is not None and version in own.wrong:
            raise Mistake(_not_in(own, version, where))
        later = self.explain(statement, text, kind, found)
        if later is not found:
            raise Mistake(
                Diagnostic(later.code, later.message, where, help=later.help, labels=later.labels)
            )
        remedy: str | None = self._elsewhere(text, kind, version)
        fix: Fix | None = None
        if remedy is None:
            remedy = found.help
            fix = None if found.right is None else write(found.right, where)
        raise Mistake(Diagnostic(found.code, found.message, where, help=remedy, fix=fix))

    def is_broken(self, text: str, problem: TypeProblem) -> bool:
        """Tell whether a type that is not known was to be made by a broken statement."""
        name = text.rpartition("/")[2]
        if problem.code != codes.UNKNOWN_TYPE or name in self._workspace.types:
            return False
        return self._consequences.declares(name)

    def explain(
        self, statement: Statement, text: str, kind: InterfaceKind, problem: TypeProblem
    ) -> TypeProblem:
        """Return what to say of a type that is not known where a statement names it."""
        return self._later.explain(statement, text, kind, problem)

    def _own(self, text: str, kind: InterfaceKind) -> OwnType | None:
        own = self._workspace.types.get(text.rpartition("/")[2])
        return own if own is not None and own.kind is kind else None

    def _used_by_file(
        self, statement: Statement, text: str, kind: InterfaceKind
    ) -> Interface | None:
        """Return the type that a loaded file uses under a name; only values need a definition."""
        node = self._workspace.nodes.get(getattr(statement, "node", ""))
        if node is None or node.source is None or getattr(statement, "input", None):
            return None
        found = {
            each.type
            for each in node.source.endpoints
            if each.type is not None
            and each.kind.facts.interface is kind
            and text
            in (
                each.type.name,
                str(each.type),
                f"{each.type.package}/{kind.value}/{each.type.name}",
            )
        }
        return Interface.undefined(found.pop(), kind) if len(found) == 1 else None

    def _elsewhere(self, text: str, kind: InterfaceKind, version: int) -> str | None:
        """Say how to get the other ROS, which has a type, where nobody chose this one."""
        if self._setting.is_chosen or version != self._version:
            return None
        other = 3 - version
        library = default_library(self._setting.libraries, other)
        if isinstance(self.resolver(other).resolve(text, kind), TypeProblem):
            return None
        return (
            f"ROS {other} has it, and ROS {version} is only the default: use `--target {library}`, "
            f"or write `target: {library}` in plastron.yaml"
        )

    def begin(self, program: Program) -> None:
        """Go on with another program, whose first package its types belong to."""
        kinds = set(map(type, program.statements))
        first = None
        if not kinds.isdisjoint((CreatePackage, LoadPackage)):
            packages = (CreatePackage, LoadPackage)
            first = next(each for each in program.statements if isinstance(each, packages))
        self._package = self._package if first is None else self._name_of(first)
        self._uses = []
        self._later = LaterTypes(program.statements)

    def _name_of(self, statement: CreatePackage | LoadPackage) -> str | None:
        """Return the name of a package, None for a folder that is none."""
        if isinstance(statement, CreatePackage):
            return statement.name
        source = self._setting.read_package(statement.source, self._version).source
        return None if source is None else source.name

    def own_package(self, version: int) -> str:
        """Return the package of the program's types that name none.

        In ROS 2 types have a package of their own, beside that of the nodes.
        """
        packages = self._workspace.packages.values()
        name = next((each.name for each in packages), self._package)
        if name is None:
            program = self._setting.program
            is_fit = check_package_name(program) is None
            name = program if is_fit else mended_package_name(program)
            return f"{name or 'plastron'}_interfaces"
        return name if version == 1 else f"{name}_interfaces"

    def own_interfaces(self, version: int) -> dict[InterfaceKey, Interface]:
        """Return what the program's types are in a generation of ROS."""
        return interfaces_of(self._workspace.types.values(), version, self.own_package(version))

    def is_of_ros(self, package: str, version: int) -> bool:
        """Tell whether the distribution itself has a package of types."""
        return self._setting.catalog(version).has_package(package)

    def changed(self) -> None:
        """Look types up anew: those of the program are others now."""
        self._resolvers.clear()

    def refitted(self) -> dict[int, Refitted]:
        """Fit the values of statements to what their types are now.

        Returns:
            What each is, by the identity of the value that it was.
        """
        return {id(use.value): Refitted(use.statement.span, self._anew(use)) for use in self._uses}

    def take(self, fitted: Mapping[int, Refitted]) -> None:
        """Let the values of statements be those that were fitted to their types anew."""
        self._uses = [
            use._replace(value=fitted[id(use.value)].value or use.value) for use in self._uses
        ]

    def _anew(self, use: _Use) -> MessageValue | None:
        type_ = self.resolver(use.version).catalog.find(use.type.name, use.type.kind)
        if type_ is None:
            return use.value
        try:
            return self._fit(use.statement, type_, use.version, use.slot)
        except Mistake:
            return None

    @property
    def catalogs(self) -> dict[int, Catalog]:
        """The interface types that were asked for, by generation of ROS."""
        return {version: resolver.catalog for version, resolver in self._resolvers.items()}

    def resolver(self, version: int) -> TypeResolver:
        """Return what looks types up in a generation of ROS."""
        resolver = self._resolvers.get(version)
        if resolver is None:
            catalog = self._setting.catalog(version)
            if self._workspace.types:
                catalog = catalog.with_own(self.own_interfaces(version))
            resolver = self._resolvers[version] = TypeResolver(catalog)
            self.fitters[version] = Fitter(catalog, self._earlier_fitters.get(version))
        return resolver

    def catalog(self, version: int) -> Catalog:
        """Return the interface types of a generation of ROS."""
        return self.resolver(version).catalog

    def fit(
        self, statement: Any, type_: Interface, version: int, slot: str = "input"
    ) -> MessageValue:
        """Return the values in a slot of a statement as a message of a type.

        An answer's are those of the response, or of the result; others those of the message, the
        request or the goal.
        """
        value = self._fit(statement, type_, version, slot)
        if self._workspace.types:
            self._uses.append(_Use(statement, type_, version, slot, value))
        return value

    def _fit(self, statement: Any, type_: Interface, version: int, slot: str) -> MessageValue:
        fields = type_.response.fields if slot == "answer" else type_.fields
        self.resolver(version)
        value = self.fitters[version].fit(type_, fields, statement, slot)
        if isinstance(value, tuple):
            raise Mistake(*value)
        return value


def _not_in(own: OwnType, version: int, where: Span) -> Diagnostic:
    """Say why a generation of ROS cannot have a type of the program."""
    found = own.wrong[version]
    return Diagnostic(
        found.code,
        f"`{own.name}` is no type of ROS {version}: {found.message}",
        where,
        help=found.help,
        labels=(Label(found.span or own.span, "made here"),),
    )
