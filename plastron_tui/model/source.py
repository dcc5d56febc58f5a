"""What a reader found in the files of nodes, and the changes that an editor is asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import NamedTuple, TypeVar

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.qos import Qos

from .endpoint_details import EndpointDetails, ParameterDetails, TimerDetails, merged
from .kinds import Endpoint
from .kinds import EndpointKind as EndpointKind

P = TypeVar("P", bound=PurePath)

LARGEST_FILE = 4 * 1024 * 1024
"""The largest node file that is read, in bytes; a node is a few kilobytes."""


@dataclass(frozen=True, slots=True)
class FileSet:
    """The texts of files that are read, changed and written together, the main file's first.

    Each text stands under its file's name from the folder of the main file, in which `{}` is the
    main file's stem: `{}.cpp` and `include/{}.hpp`. So the set of a file that gets another name
    keeps its names. A set is never empty.
    """

    texts: tuple[tuple[str, bytes], ...]

    @staticmethod
    def single(suffix: str, text: bytes) -> FileSet:
        """Return the set of one file."""
        return FileSet((("{}" + suffix, text),))

    @staticmethod
    def gather(
        path: Path, text: bytes, others: Iterable[str], read: Callable[[Path], bytes | None]
    ) -> FileSet:
        """Return the set of a file and of what there is of others.

        Args:
            path: the main file.
            text: what it holds.
            others: the names of the other files.
            read: returns a file's text, None where there is no such file.
        """
        found = ((name, read(place_of(path, name))) for name in others)
        there = tuple((name, text) for name, text in found if text is not None)
        return FileSet((*FileSet.single(path.suffix, text).texts, *there))

    @property
    def main(self) -> bytes:
        """The text of the main file."""
        return self.texts[0][1]

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the files."""
        return tuple(name for name, _ in self.texts)

    def get(self, name: str) -> bytes | None:
        """Return the text of a file, None where the set has no such file."""
        return next((text for each, text in self.texts if each == name), None)

    def with_text(self, name: str, text: bytes) -> FileSet:
        """Return the set with another text of one of its files."""
        return FileSet(tuple((each, text if each == name else old) for each, old in self.texts))

    def with_main(self, text: bytes) -> FileSet:
        """Return the set with another text of its main file."""
        return self.with_text(self.texts[0][0], text)


def place_of(main: P, name: str) -> P:
    """Return where a file of a set is, by the path of the set's main file."""
    folder, name = main.parent, name.replace("{}", main.stem)
    # A name of the set may lead out of the folder, which names of an output folder may not.
    while name.startswith("../") and folder.name not in ("", ".."):
        folder, name = folder.parent, name.removeprefix("../")
    return folder / name


OWN_NAME = "~"
"""What a name is given by that is the full name of its node."""


class SourceEndpoint(NamedTuple):
    """One call site.

    Attributes:
        kind: what the call creates.
        name: the topic, service, action or parameter where the source says it literally, else
            None. A timer has none.
        expression: the source text that decides the name (a timer's: its period or rate); where
            a literal default decides it, the text of the whole expression.
        type: the interface, None where the source does not say it.
        type_expression: the source text of the type, "" where there is none.
        callback: the callback's name as the source has it (`on_chatter` for `self.on_chatter`),
            None where there is none or it has no name.
        default: the literal default of a name that is read from a parameter.
        given_by: the parameter whose value is the name as it stands, or `~` where that is the
            full name of the node; None where neither is sure.
        span: the call.
        line: the call's line, from 1.
        file: the name of the file in its set that has the call, "" for the main file.
        is_guess: whether the name, the type or the endpoint itself is no more than likely: the
            name is the default of a parameter that another file may give another value, the type
            is of the one module imported whole that it may be of, or what creates it is an object
            of another file.
        qos: the quality of service of a topic, None where nothing of it is known.
        details: what else the file says of one of its kind: of a parameter, a timer, an action.
        transition: the transition of a managed node in which the call is made (`on_configure`),
            None where that is not sure, or it is made in none.
    """

    kind: EndpointKind
    name: str | None
    expression: str
    span: Span
    line: int
    type: InterfaceName | None = None
    type_expression: str = ""
    callback: str | None = None
    default: str | None = None
    file: str = ""
    is_guess: bool = False
    qos: Qos | None = None
    details: EndpointDetails | None = None
    transition: str | None = None
    given_by: str | None = None

    @property
    def label(self) -> str | None:
        """What statements call it, None where they cannot: its name; a timer's is its function.

        A timer that ticks once, or serves another endpoint, is nothing that a node repeats.
        """
        if self.kind is not EndpointKind.TIMER:
            return self.name
        details = self.details
        is_part = isinstance(details, TimerDetails) and (details.serves or details.is_oneshot)
        return None if is_part else self.callback


class SourceNode(NamedTuple):
    """A node of a file.

    Attributes:
        name: its name, None where the file does not say it.
        expression: the source text that decides the name.
        endpoints: its call sites.
        span: what makes it.
        class_name: the class that the file has for it, None where it has none.
        is_managed: whether it is a lifecycle node of ROS 2.
    """

    name: str | None
    expression: str
    endpoints: tuple[SourceEndpoint, ...]
    span: Span | None = None
    class_name: str | None = None
    is_managed: bool = False

    @property
    def label(self) -> str:
        """What a program calls the node: its name, or that of its class where it says none."""
        return self.name or self.class_name or ""

    def of_kind(self, kind: EndpointKind) -> Iterator[SourceEndpoint]:
        """Yield the endpoints of one kind, in the order of the file."""
        return (endpoint for endpoint in self.endpoints if endpoint.kind is kind)

    @property
    def parameters(self) -> dict[str, ParameterDetails]:
        """What all calls together say of each parameter whose name is known."""
        said: dict[str, list[ParameterDetails]] = {}
        for endpoint in self.of_kind(EndpointKind.PARAMETER):
            if endpoint.name is not None and isinstance(endpoint.details, ParameterDetails):
                said.setdefault(endpoint.name, []).append(endpoint.details)
        return {name: merged(each) for name, each in said.items()}


class Origin(NamedTuple):
    """What a program started from, where `SourceUnit.files` are not simply files of the disk.

    Attributes:
        path: the main file that the program loaded at first.
        files: what these files hold, or held, without what was changed in the output by hand.
        output: the main file that the program wrote; the source has what was changed there by
            hand.
        start: for a source that the program itself generates: what it makes it from.
        is_torn: the file at `path` was changed, and the output has handwork that the program
            has changed since.
        turns: how often the program generated it and loaded that again.
    """

    path: Path
    files: FileSet
    output: Path | None = None
    start: FileSet | None = None
    is_torn: bool = False
    turns: int = 0


class TextOrigin(NamedTuple):
    """What a program started from where it changed a file of one text in place before.

    Attributes:
        original: what it started from then.
        present: what the file holds now.
        is_whole: whether all that was changed by hand since is in what it starts from now.
    """

    original: bytes
    present: bytes
    is_whole: bool


class SourceUnit(NamedTuple):
    """Files that are read and changed together, with the nodes that they hold.

    Attributes:
        path: the main file's path.
        files: what the files hold.
        library: the client library that they use.
        nodes: their nodes; with a label, the one of that label alone.
        origin: there where the program itself wrote the files on an earlier run: their texts are
            then what it started from, with what was changed by hand since.
        label: the label of the node that is meant, None where all are.
    """

    path: Path
    files: FileSet
    library: str
    nodes: tuple[SourceNode, ...]
    origin: Origin | None = None
    label: str | None = None

    @property
    def endpoints(self) -> Iterator[SourceEndpoint]:
        """The endpoints of all its nodes, in the order of the files."""
        return (endpoint for node in self.nodes for endpoint in node.endpoints)

    def of_kind(self, kind: EndpointKind) -> Iterator[SourceEndpoint]:
        """Yield the endpoints of one kind, in the order of the files."""
        return (endpoint for endpoint in self.endpoints if endpoint.kind is kind)

    def only(self, label: str | None) -> SourceUnit:
        """Return the unit with one of its nodes alone, or as it is for None."""
        if label is None:
            return self
        found = next((node for node in self.nodes if node.label == label), None)
        return self._replace(nodes=() if found is None else (found,), label=label)

    def path_of(self, endpoint: SourceEndpoint) -> Path:
        """Return the file that has a call site."""
        return place_of(self.path, endpoint.file) if endpoint.file else self.path


class Add(NamedTuple):
    """Ask an editor for an endpoint that a node does not have yet.

    Attributes:
        endpoint: the endpoint.
        node: the label of the node that gets it, None for the file's only one.
    """

    endpoint: Endpoint
    node: str | None = None


class Remove(NamedTuple):
    """Ask an editor to take every call site of an endpoint away from a node.

    Attributes:
        kind: the kind of the endpoint.
        name: its name.
        span: the statement that asked, for a refusal to point at.
        node: the label of the node that has it, None for the file's only one.
    """

    kind: EndpointKind
    name: str
    span: Span | None = None
    node: str | None = None


class Update(NamedTuple):
    """Ask an editor to change an endpoint of a node where it stands.

    What differs is changed: name, type, callback, and what is sent. All else about the endpoint
    stays, as does the callback where `endpoint` has none, and what is sent where it sends nothing.

    Attributes:
        kind: the kind of the endpoint.
        name: its name in the file.
        endpoint: what it shall be, of the same kind.
        span: the statement that took it away, for a refusal to point at.
        node: the label of the node that has it, None for the file's only one.
    """

    kind: EndpointKind
    name: str
    endpoint: Endpoint
    span: Span | None = None
    node: str | None = None

    @property
    def apart(self) -> tuple[Remove, Add]:
        """What to do where it cannot be changed in place: take it out, and write it anew."""
        remove = Remove(self.kind, self.name, self.span, self.node)
        return remove, Add(self.endpoint, self.node)


class Rename(NamedTuple):
    """Ask an editor to give an endpoint of a node another name, and to change nothing else.

    Every call site of that name gets it. All renames of a list of changes are made at once and
    before the others, which speak of endpoints by their new names: so two may change places.

    Attributes:
        kind: the kind of the endpoint, which may be one that no statement makes.
        name: its name in the file.
        to: the name that it gets.
        span: the statement that asked, for a refusal to point at.
        node: the label of the node that has it, None for the file's only one.
    """

    kind: EndpointKind
    name: str
    to: str
    span: Span | None = None
    node: str | None = None


Change = Add | Remove | Update | Rename
