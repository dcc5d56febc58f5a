"""Launch files, whatever they are written in: what starts nodes together.

Sources: the ROS wiki page "roslaunch/XML"; the ROS 2 documentation, "Using Python, XML, and YAML
for ROS 2 Launch Files", and the design article "ROS 2 Launch System".
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import dataclass, field
from enum import Enum
from typing import NamedTuple, TypeVar

from .launch_text import Kind, Scope, Substitution, Text
from .parameters import Setting


class Format(Enum):
    """What a launch file is written in."""

    ROS1_XML = "roslaunch XML"
    XML = "XML"
    PYTHON = "Python"
    YAML = "YAML"

    @property
    def ros_version(self) -> int:
        """The generation of ROS that takes it."""
        return 1 if self is Format.ROS1_XML else 2


class Condition(NamedTuple):
    """When something is done: where a text says `true` or `1`, or where it does not."""

    value: Text
    is_negated: bool = False

    def holds(self, scope: Scope) -> bool | None:
        """Tell whether it holds, None where that is not known."""
        value = scope.value(self.value)
        found = {"true": True, "1": True, "false": False, "0": False}.get(
            (value or "").strip().lower()
        )
        return None if value is None or found is None else found is not self.is_negated


class Place(NamedTuple):
    """Where something stands in its file, in bytes, and its line, counted from 1."""

    start: int
    end: int
    line: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """Something that a launch file says; where it says so makes no difference between two."""

    condition: Condition | None = None
    place: Place | None = field(default=None, compare=False, repr=False)

    @property
    def called(self) -> str | None:
        """What a program calls it by, None where it has no name, or one that is computed."""
        return None


@dataclass(frozen=True, slots=True)
class Argument(Item):
    """A value that who starts the file can give it.

    Attributes:
        name: its name.
        default: its value where none is given, None where one has to be.
        description: what it is for.
    """

    name: str
    default: Text | None = None
    description: str = ""

    @property
    def called(self) -> str | None:
        """Its name."""
        return self.name


@dataclass(frozen=True, slots=True)
class Variable(Item):
    """A value that the file sets itself: `let`, or an argument of ROS 1 that has a value."""

    name: str
    value: Text


@dataclass(frozen=True, slots=True)
class Remapping:
    """A name of a node's, and the one that it gets; where it stands tells no two apart."""

    old: Text
    new: Text
    place: Place | None = field(default=None, compare=False, repr=False)


class ParameterValue(NamedTuple):
    """A parameter, and its value: typed already, or a text whose substitutions have to be known.

    Attributes:
        name: its name, with dots or slashes as the generation of ROS has them.
        value: its value.
        is_text: whether what a text comes to stays a text, and is no number.
        is_float: whether what it comes to is a float: 1 is 1.0.
    """

    name: Text
    value: Setting | Text
    is_text: bool = False
    is_float: bool = False


class ParameterFile(NamedTuple):
    """A file that has values of parameters."""

    file: Text


Parameter = ParameterValue | ParameterFile


@dataclass(frozen=True, slots=True)
class StartedNode(Item):
    """A node that is started.

    Attributes:
        package: the package that has it.
        executable: what starts it; for a component the class, such as `demo::Talker`.
        name: the name that it gets, None for its own.
        namespace: what stands before its name, None where nothing is said.
        remaps: other names for its topics and services.
        parameters: their values, and files with them; what comes later wins.
        others: what else is said of it (`output`, `respawn`, `args`), by name.
    """

    package: Text
    executable: Text
    name: Text | None = None
    namespace: Text | None = None
    remaps: tuple[Remapping, ...] = ()
    parameters: tuple[Parameter, ...] = ()
    others: tuple[tuple[str, Text], ...] = ()

    @property
    def called(self) -> str | None:
        """The name that it gets, else its executable."""
        return (self.executable if self.name is None else self.name).literal


@dataclass(frozen=True, slots=True)
class Container(Item):
    """A process that holds components.

    Attributes:
        node: the container itself, None where it is started elsewhere.
        target: the name of the container that is started elsewhere.
        components: what is loaded into it.
    """

    node: StartedNode | None
    target: Text | None = None
    components: tuple[StartedNode, ...] = ()


@dataclass(frozen=True, slots=True)
class Namespace(Item):
    """From here to the end of the group, nodes are in this namespace."""

    namespace: Text


@dataclass(frozen=True, slots=True)
class Remap(Item):
    """From here to the end of the group, nodes get this name for another."""

    old: Text
    new: Text


@dataclass(frozen=True, slots=True)
class SetParameter(Item):
    """A parameter of ROS 1's server, or of all nodes from here on in ROS 2."""

    parameter: Parameter


@dataclass(frozen=True, slots=True)
class Group(Item):
    """What stands together: names and variables that are set in it end with it.

    Attributes:
        items: what it says, in that order.
        is_scoped: whether what is set in it ends with it.
    """

    items: tuple[Item, ...] = ()
    is_scoped: bool = True


@dataclass(frozen=True, slots=True)
class Include(Item):
    """Another launch file, whose nodes are started too.

    Attributes:
        file: its path.
        arguments: the values that it gets.
        namespace: the namespace that its nodes are in (ROS 1), None where nothing is said.
        others: what else is said of it, by name.
    """

    file: Text
    arguments: tuple[tuple[str, Text], ...] = ()
    namespace: Text | None = None
    others: tuple[tuple[str, Text], ...] = ()

    @property
    def called(self) -> str | None:
        """Its package, and the name of the file."""
        match self.file.parts:
            case (Substitution(kind=Kind.PACKAGE, argument=package), str(path)) if package.literal:
                path = path.removeprefix("/")
                return f"{package.literal}/{path.removeprefix('launch/')}"
            case _:
                return self.file.literal


@dataclass(frozen=True, slots=True)
class Unread(Item):
    """Something of a launch file that is not understood: what it is, for a person."""

    what: str


@dataclass(frozen=True, slots=True)
class LaunchFile:
    """What a launch file says, in that order."""

    items: tuple[Item, ...] = ()


_Kind = TypeVar("_Kind", bound=Item)


def loaded_nodelet(package: str | None, arguments: str) -> str | None:
    """Return the class of the nodelet that a node loads, None for none (wiki page "nodelet").

    Args:
        package: the package of the node.
        arguments: what it is started with: `load PACKAGE/CLASS MANAGER`, `standalone ...`.
    """
    words = arguments.split() if package == "nodelet" else []
    return words[1] if words[:1] in (["load"], ["standalone"]) and len(words) > 1 else None


def items_of(items: tuple[Item, ...], kind: type[_Kind]) -> Iterator[_Kind]:
    """Yield all of a kind that a file itself has, in groups and containers too."""
    for item in items:
        if isinstance(item, kind):
            yield item
        if isinstance(item, Group):
            yield from items_of(item.items, kind)
        elif isinstance(item, Container):
            yield from items_of((*filter(None, (item.node,)), *item.components), kind)


def names_of(items: tuple[Item, ...], kind: type[Item]) -> list[str]:
    """Return what programs call all of a kind; nodes by their full names, without the first `/`.

    A node of which the namespace is computed goes by its name alone.
    """
    if kind is StartedNode:
        return [name for name, _ in named_nodes(items)]
    return [each.called for each in items_of(items, kind) if each.called]


def named_nodes(items: tuple[Item, ...]) -> Iterator[tuple[str, StartedNode]]:
    """Yield the nodes that have a name which is not computed, with what programs call them."""
    for namespace, node in _in_namespaces(items, ""):
        name = node.called
        own = "" if node.namespace is None else node.namespace.literal
        whole = None if own is None else joined(namespace, own)
        if name:
            yield (name if whole is None else f"{whole}/{name}".lstrip("/")), node


def joined(outer: str | None, inner: str) -> str | None:
    """Return a namespace in another one, such as `/front`; None where it is not known."""
    parts = "".join(f"/{part}" for part in inner.split("/") if part)
    if inner.startswith("/"):
        return parts
    return None if outer is None else outer + parts


def _in_namespaces(
    items: tuple[Item, ...], outer: str | None
) -> Generator[tuple[str | None, StartedNode], None, str | None]:
    """Yield the nodes, each with what is pushed before its name, and return what still is."""
    for item in items:
        match item:
            case Namespace(namespace=pushed):
                literal = pushed.literal
                outer = None if literal is None else joined(outer, literal)
            case Group(items=inner, is_scoped=is_scoped):
                after = yield from _in_namespaces(inner, outer)
                outer = outer if is_scoped else after
            case Container(node=held, components=components):
                for each in (*filter(None, (held,)), *components):
                    yield outer, each
            case StartedNode():
                yield outer, item
            case _:
                pass
    return outer
