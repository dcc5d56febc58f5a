"""The catalog: look an interface up by its full or its bare name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes, did_you_mean
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.definition import MAX_DEFINITION_BYTES, parse_definition
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.primitives import PRIMITIVES

from . import data
from .distributions import DISTRIBUTIONS
from .folders import TypeFolders

_GEOMETRY = ("Point", "Vector3", "Quaternion", "Pose2D", "Pose", "Twist")

# What these bare names mean, whatever else is installed (the language's table of types).
_WELL_KNOWN: Mapping[InterfaceKind, Mapping[str, str]] = {
    InterfaceKind.MESSAGE: {
        **dict.fromkeys(("String", "Char", "Int32", "Float32"), "std_msgs"),
        **dict.fromkeys(_GEOMETRY, "geometry_msgs"),
    },
    InterfaceKind.SERVICE: {
        **dict.fromkeys(("Empty", "SetBool", "Trigger"), "std_srvs"),
        **dict.fromkeys(("WaypointClear", "WaypointPull"), "mavros_msgs"),
        "WordCount": "basics",
    },
    InterfaceKind.ACTION: {},
}
_BY_VERSION: Mapping[tuple[InterfaceKind, str], Mapping[int, str]] = {
    (InterfaceKind.SERVICE, "AddTwoInts"): {1: "beginner_tutorials", 2: "example_interfaces"},
    (InterfaceKind.ACTION, "Fibonacci"): {1: "actionlib_tutorials", 2: "example_interfaces"},
}

_Key = tuple[InterfaceKind, InterfaceName]

Refusal = Callable[[Path], "Diagnostic | None"]
"""Tells why a definition is not to be read, None where it may be."""

# Messages within messages, in files of a user's; real ones have fewer than ten levels.
_DEEPEST_NESTING = 50


class Catalog:
    """The interface types of one distribution, and on top those of the type folders.

    The packages of a distribution are what its release says they are: a definition in a type
    folder does not change them. It does replace a type of a package that the catalog holds only
    a few types of, such as `mavros_msgs`, and it adds every other package. Type folders are
    listed when a name is looked up that the distribution does not settle.

    Attributes:
        distribution: the name of the distribution.
        ros_version: 1 or 2.
        problems: what is wrong in the definitions that were asked for, so far or since the list
            was cleared; a type whose definition has a mistake is not found.
    """

    def __init__(
        self,
        distribution: str,
        type_folders: Sequence[Path] = (),
        installed: Sequence[Path] = (),
        refusal: Refusal = lambda _: None,
    ) -> None:
        """Make a catalog; no file is read yet.

        Args:
            distribution: one of `DISTRIBUTIONS`.
            type_folders: folders that hold packages (at any depth), package folders, `msg`,
                `srv` and `action` folders, or definitions themselves; the first that has a type
                wins.
            installed: such folders of an installed ROS, which come after the others.
            refusal: asked before a definition in one of `type_folders` is read.

        Raises:
            ValueError: the distribution is not one of `DISTRIBUTIONS`.
        """
        if distribution not in DISTRIBUTIONS:
            raise ValueError(f"no distribution `{distribution}` in the catalog")
        self.distribution = distribution
        self.ros_version = DISTRIBUTIONS[distribution]
        self.problems: list[Diagnostic] = []
        self._own = TypeFolders(type_folders)
        self._installed = TypeFolders(installed)
        self._refusal = refusal
        self._open: list[_Key] = []
        self._found: dict[_Key, Interface | None] = {}
        self._overlay: Mapping[_Key, Interface] = {}
        self._undefined: Mapping[_Key, Interface] = {}
        self._wrong: dict[_Key, list[Diagnostic]] = {}
        self._candidates: dict[tuple[InterfaceKind, str], tuple[InterfaceName, ...]] = {}

    def find(self, name: InterfaceName, kind: InterfaceKind) -> Interface | None:
        """Return the interface of a full name, None when there is none such.

        A definition with a mistake, and one whose messages contain each other without end or
        are not to be found, adds to `problems` and is not found.
        """
        key = (kind, name)
        if key in self._overlay:
            return self._overlay[key]
        if key in self._found:
            self._note(*self._wrong.get(key, ()))
            return self._found[key]
        interface = self._read(key)
        # A name that nothing has is not kept: a day of typing makes many.
        if interface is not None or self._file(name, kind) is not None:
            self._found[key] = interface
        return interface

    def is_sole(self, name: InterfaceName, kind: InterfaceKind) -> bool:
        """Tell whether there is one definition of an interface at most.

        There is more than one where several folders have it, and where a type folder has a type of
        a package of the distribution, whose own one counts.
        """
        index = data.index(self.distribution)
        is_own = name in index.names[kind] and name.package not in index.partial
        has_file = self._own.file(name, kind) is not None
        return not (is_own and has_file) and not self._own.is_twice(name, kind)

    def with_undefined(self, used: Iterable[tuple[InterfaceKind, InterfaceName]]) -> Catalog:
        """Return a catalog that takes the types that a file uses as they are, defined or not."""
        unknown = {
            (kind, name): Interface.undefined(name, kind)
            for kind, name in used
            if self.find(name, kind) is None
        }
        if not unknown:
            return self
        other = copy(self)
        other._undefined = {**self._undefined, **unknown}
        other._found = {**self._found, **unknown}
        return other

    def with_own(self, interfaces: Mapping[_Key, Interface]) -> Catalog:
        """Return a catalog in which a program's own types come before all others.

        What was found so far is kept only where there is no own type that it may contain. What
        is wrong in definitions, either asked for, both catalogs list.
        """
        other = copy(self)
        other._overlay = dict(interfaces)
        other._open, other._candidates = [], {}
        if interfaces or self._overlay:
            other._found, other._wrong = dict(self._undefined), {}
        return other

    def candidates(self, bare: str, kind: InterfaceKind) -> tuple[InterfaceName, ...]:
        """Return every interface that a bare name may mean, sorted.

        A name of the language's table has its one meaning, or none where the distribution
        does not have it.
        """
        key = (kind, bare)
        known = self._candidates.get(key)
        if known is None:
            known = tuple(self._meanings(bare, kind))
            if known:
                self._candidates[key] = known
        return known

    def names(self, kind: InterfaceKind) -> Sequence[InterfaceName]:
        """Return the names of all interfaces of a kind, sorted."""
        own = data.index(self.distribution).names[kind]
        mine = (name for each, name in self._overlay if each is kind)
        return sorted({*mine, *own, *self._own.names(kind), *self._installed.names(kind)})

    def table_package(self, name: str) -> data.Definitions | None:
        """Return the definitions of a package that is here for the language's table alone.

        They are a few of those that the package has. None for every other package, and where a
        type folder defines types of that name.
        """
        folders = (self._own, self._installed)
        names = (each for kind in InterfaceKind for one in folders for each in one.names(kind))
        if name not in data.index(self.distribution).partial or name in {n.package for n in names}:
            return None
        return data.definitions(self.distribution, name)

    def has_package(self, name: str) -> bool:
        """Tell whether the distribution has a package of types, whole or in part."""
        index = data.index(self.distribution)
        return name in index.partial or any(
            (name, kind) in index.packages for kind in InterfaceKind
        )

    def has_all_of(self, package: str, kind: InterfaceKind) -> bool:
        """Tell whether the distribution has a package's types of a kind, and all of them."""
        index = data.index(self.distribution)
        is_in_part = package in index.partial or package in data.FURTHER
        return (package, kind) in index.packages and not is_in_part

    def packages(self, kind: InterfaceKind) -> Sequence[str]:
        """Return the packages that have interfaces of a kind, sorted."""
        return sorted({name.package for name in self.names(kind)})

    def _meanings(self, bare: str, kind: InterfaceKind) -> Iterator[InterfaceName]:
        mine = sorted(name for each, name in self._overlay if each is kind and name.name == bare)
        if mine:
            yield from mine
            return
        package = _WELL_KNOWN[kind].get(bare)
        if (kind, bare) in _BY_VERSION:
            package = _BY_VERSION[kind, bare][self.ros_version]
        own = data.index(self.distribution).by_bare[kind].get(bare, ())
        if package is not None:
            yield from (name for name in own if name.package == package)
        else:
            folders = (self._own, self._installed)
            found = (name for each in folders for name in each.by_bare(kind).get(bare, ()))
            yield from sorted({*own, *found})

    def _file(self, name: InterfaceName, kind: InterfaceKind) -> Path | None:
        """Return the file that defines an interface: one that is not to be read is the last."""
        own = self._own.file(name, kind)
        if own is not None and self._refusal(own) is None:
            return own
        return self._installed.file(name, kind) or own

    def _read(self, key: _Key) -> Interface | None:
        kind, name = key
        index = data.index(self.distribution)
        is_own = name in index.names[kind]
        if not is_own or name.package in index.partial:
            file = self._file(name, kind)
            if file is not None:
                self._open.append(key)
                try:
                    return self._read_file(key, file)
                finally:
                    self._open.pop()
        package = data.definitions(self.distribution, name.package) if is_own else self._more(name)
        text = package.get(kind.value, {}).get(name.name)
        if text is None:
            return None
        definition = parse_definition(text, name, kind, self.ros_version)
        assert definition.interface is not None, f"{name}: {definition.diagnostics}"
        return definition.interface

    def _more(self, name: InterfaceName) -> data.Definitions:
        """Return the definitions of a package whose types no bare name means."""
        if name.package not in data.FURTHER:
            return {}
        return data.further(self.distribution).get(name.package, {})

    def _read_file(self, key: _Key, file: Path) -> Interface | None:
        kind, name = key
        refusal = self._refusal(file) if file == self._own.file(name, kind) else None
        if refusal is not None:
            self._note(refusal)
            return None
        try:
            source = read_regular(file, MAX_DEFINITION_BYTES)
        except OSError as error:
            self._report(f"the definition of `{name}` cannot be read: {reason(error)}", file)
            return None
        definition = parse_definition(source, name, kind, self.ros_version, file)
        self._note(*definition.diagnostics)
        interface = definition.interface
        is_sound = interface is not None and self._has_sound_messages(interface, file)
        return interface if is_sound else None

    def _has_sound_messages(self, interface: Interface, file: Path) -> bool:
        """Tell whether the messages within a user's type are found; if not, report it once."""
        for field in (field for section in interface.sections for field in section.fields):
            message = field.type.message
            if message is None:
                continue
            if (InterfaceKind.MESSAGE, message) in self._open:
                self._report(f"`{interface.name}` contains itself, in field `{field.name}`", file)
                return False
            if len(self._open) > _DEEPEST_NESTING:
                self._report(f"`{interface.name}` is a message within too many others", file)
                return False
            if self.find(message, InterfaceKind.MESSAGE) is None:
                # A definition that is there has been reported itself.
                if self._file(message, InterfaceKind.MESSAGE) is None:
                    text = f"field `{field.name}` is of type `{message}`, which does not exist"
                    self._report(text, file, self._similar(message))
                return False
        return True

    def _similar(self, message: InterfaceName) -> str | None:
        known = self.candidates(message.name, InterfaceKind.MESSAGE)
        if known:
            return "write " + " or ".join(f"`{name}`" for name in known)
        return did_you_mean(message.name, PRIMITIVES[self.ros_version])

    def _report(self, message: str, file: Path, remedy: str | None = None) -> None:
        self._note(Diagnostic(codes.BAD_DEFINITION, message, file=file, help=remedy))

    def _note(self, *problems: Diagnostic) -> None:
        """Add to the problems, and to those of each definition that is being read."""
        lists = (self.problems, *(self._wrong.setdefault(key, []) for key in self._open))
        for noted in lists:
            noted += [each for each in problems if each not in noted]
