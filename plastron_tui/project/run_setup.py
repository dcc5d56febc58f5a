"""What a run gives its nodes: names, and the values of parameters."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.boundary import Boundary
from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes, did_you_mean
from plastron_tui.model.endpoint_details import ParameterDetails, merged
from plastron_tui.model.kinds import EndpointKind, Parameter
from plastron_tui.model.source import SourceEndpoint, SourceUnit
from plastron_tui.model.workspace import Node
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import parameter_name, resolved_name
from plastron_tui.ros.parameter_values import (
    Assignment,
    Mistake,
    NodeParameters,
    name_problem,
    read_params,
    unfit,
    values_of,
    yaml_text,
)
from plastron_tui.ros.parameters import OF_EVERY_NODE, ParameterType, Setting, as_setting
from plastron_tui.ros.run_names import AS_WRITTEN, RunNames
from plastron_tui.runtime.arguments import ros_arguments

if TYPE_CHECKING:
    from plastron_tui.generating.generation import Generated

MOST_MISTAKES = 20
"""The most mistakes of a parameter file that are told."""

LARGEST_PARAMS = 256 * 1024
"""The largest parameter file that is read, in bytes."""

_NAMED = tuple(kind for kind in EndpointKind if kind.facts.interface is not None)
_ACTIONS = tuple(kind for kind in _NAMED if kind.facts.interface is InterfaceKind.ACTION)
# What lets a node take parameters that its file does not name.
_TAKES_OTHERS = (
    "allow_undeclared_parameters",
    "automatically_declare_parameters_from_overrides",
    "get_param_names",
)
# What lets a parameter have values of another type than its default's.
_TAKES_ANY = "dynamic_typing"


class RunNode(NamedTuple):
    """A node that is to run, and what is known of its names.

    Attributes:
        name: its name.
        variable: the program's variable for it.
        ros_version: the generation of ROS that it is for.
        names: its topics, services and actions, as programs spell them; None where there may be
            others.
        parameters: its parameters, those of ROS 1 by their private names; None likewise.
        details: what its file says for sure of parameters that the client library checks.
    """

    name: str
    variable: str
    ros_version: int
    names: Collection[str] | None
    parameters: Collection[str] | None = None
    details: Mapping[str, ParameterDetails] = {}


def run_node(
    node: Node, ros_version: int, unit: SourceUnit | None, text: str | None = None
) -> RunNode:
    """Return what is known of a node.

    Args:
        node: the node.
        ros_version: the generation of ROS that it is for.
        unit: what its files hold; None for a created node that is not written yet.
        text: its main file, None where that is not known: it may then take parameters that its
            files do not name.
    """
    if unit is None:
        own = [name for kind in _NAMED for name in node.names(kind)]
        return RunNode(node.name, node.variable, ros_version, own)
    found = tuple(unit.endpoints)
    names = _sure(None if each.is_guess else each.name for each in found if each.kind in _NAMED)
    declared = [each for each in found if each.kind is EndpointKind.PARAMETER]
    parameters = _sure(each.name for each in declared)
    if parameters is not None and ros_version == 1:
        own_space = f"{resolved_name(node.name, '~')}/"
        full = [resolved_name(node.name, name) for name in parameters]
        parameters = [name.removeprefix(own_space) for name in full if name.startswith(own_space)]
    if text is None or any(word in text for word in _TAKES_OTHERS):
        parameters = None
    # rospy checks nothing.
    is_checked = ros_version == 2 and text is not None and _TAKES_ANY not in text
    details = {name: each for name, each in _details(declared) if is_checked}
    return RunNode(node.name, node.variable, ros_version, names, parameters, details)


def generated_node(generated: Generated, output: Path) -> RunNode:
    """Return what is known of a node from the files that it becomes.

    Args:
        generated: the files.
        output: the output folder.
    """
    from plastron_tui.targets import find_target, ros_version

    node, library = generated.generation.node, generated.generation.library
    target, path = find_target(library), generated.path(output)
    if target is None or path is None or generated.files is None:
        return run_node(node, ros_version(library), node.source)
    files = generated.files.files
    unit = target.language.read(path, files, library).source
    if unit is not None and node.source is not None:
        unit = unit.only(node.source.label)
    text = files.main.decode("utf-8", "replace")
    return run_node(node, ros_version(library), unit, text)


def _details(parameters: Iterable[SourceEndpoint]) -> Iterator[tuple[str, ParameterDetails]]:
    by_name: dict[str, list[ParameterDetails]] = {}
    for each in parameters:
        if each.name is not None and isinstance(each.details, ParameterDetails):
            by_name.setdefault(each.name, []).append(each.details)
    return ((name, merged(said)) for name, said in by_name.items())


class RunSetup(NamedTuple):
    """What the user says about a run.

    Attributes:
        names: the namespace and the remaps.
        settings: the values of parameters; they win over those of the file.
        params: what the program's parameter file has.
    """

    names: RunNames = AS_WRITTEN
    settings: tuple[Assignment, ...] = ()
    params: tuple[NodeParameters, ...] = ()

    @property
    def nodes(self) -> tuple[str, ...]:
        """The nodes that are named."""
        remapped = (each.node for each in self.names.remaps if each.node is not None)
        return tuple(dict.fromkeys((*remapped, *(each.node for each in self.settings))))

    def wrong_option(self, nodes: Iterable[RunNode]) -> str | None:
        """Return what is wrong with what the user says, for these nodes; None when nothing is."""
        for node in nodes:
            wrong = self._names(node).problem(node.ros_version, node.name)
            if wrong is not None:
                return wrong
            for one in self._settings(node.name, node.variable):
                wrong = _unfit(node, one.name, one.value)
                if wrong is not None:
                    return f"`{one.node}.{one.name}`: {wrong}"
        return None

    def problems(self, nodes: Sequence[RunNode], file: Path | None) -> Iterator[Diagnostic]:
        """Yield what is wrong with the values of the parameter file for these nodes, and doubtful.

        Args:
            nodes: the nodes.
            file: the parameter file, None for a program that has none.
        """
        for node in nodes:
            for name, value in self._from_file(node.name).items():
                wrong = _unfit(node, name, value)
                if wrong is not None:
                    message = f"`{name}` of `{node.name}`: {wrong}"
                    yield Diagnostic(codes.BAD_PARAMETERS, message, file=file)
            # What a file gives to all nodes is not for each of them.
            own = [each for each in self.params if "*" not in each.pattern]
            given = dict.fromkeys(self._from_file(node.name, own), file)
            set_here = self._settings(node.name, node.variable)
            given |= dict.fromkeys((each.name for each in set_here), None)
            for name, place in given.items():
                if (found := _undeclared(node, name)) is not None:
                    yield found._replace(file=place)
        yield from self.unmet(nodes)

    def unmet(self, nodes: Sequence[RunNode]) -> Iterator[Diagnostic]:
        """Yield a warning for each remap that none of these nodes has a name for."""
        for remap in self.names.remaps:
            meant = [one for one in nodes if remap.node in (None, one.name, one.variable)]
            if any(one.names is None for one in meant):
                continue
            names = [(one, name) for one in meant for name in one.names or ()]
            alone = self.names._replace(remaps=())
            if any(
                alone.joined(one.name, remap.old) == alone.joined(one.name, name)
                for one, name in names
            ):
                continue
            yield Diagnostic(
                codes.UNMET_REMAP,
                f"`{remap.old}` is the name of no topic or service, so that "
                f"`{remap.words}` changes nothing",
                help=did_you_mean(remap.old, (name for _, name in names)),
                severity=Severity.WARNING,
            )

    def values(self, name: str, variable: str) -> dict[str, Setting]:
        """Return the parameters of a node; of what is set twice the last."""
        own = {each.name: each.value for each in self._settings(name, variable)}
        return {**self._from_file(name), **own}

    def arguments(self, ros_version: int, nodes: Sequence[Node]) -> tuple[str, ...]:
        """Return the arguments of a process that has these nodes."""
        names = self.names.of(*(word for node in nodes for word in (node.name, node.variable)))
        values: dict[str, Setting] = {}
        for node in nodes:
            own = self.values(node.name, node.variable)
            values |= {name: _held(node, name, each, ros_version) for name, each in own.items()}
            actions = [name for kind in _ACTIONS for name in node.names(kind)]
            names = names.with_actions(node.name, actions, ros_version)
        return ros_arguments(ros_version, names, values)

    def _names(self, node: RunNode) -> RunNames:
        return self.names.of(node.name, node.variable)

    def _settings(self, *node: str) -> Iterator[Assignment]:
        return (each for each in self.settings if each.node in node)

    def _from_file(
        self, name: str, params: Iterable[NodeParameters] | None = None
    ) -> dict[str, Setting]:
        # The file is the program's, which knows no namespace.
        found = self.params if params is None else params
        return values_of(found, f"/{name}", self.names.full_node(name))


def find_params(
    file: Path, boundary: Boundary
) -> tuple[tuple[NodeParameters, ...], tuple[Diagnostic, ...]]:
    """Read a parameter file; one that is not there says nothing.

    Args:
        file: the file.
        boundary: the program's project; what leads out of it is not read.
    """
    if not boundary.allows(file):
        if not file.is_file():
            return (), ()
        message = f"`{file.name}` is {boundary.place_of(file)}, and is not read"
        found = Diagnostic(codes.OUTSIDE_PROJECT, message, file=file, help=boundary.remedy)
        return (), (found._replace(severity=Severity.WARNING),)
    try:
        text = read_regular(file, LARGEST_PARAMS).decode("utf-8")
    except FileNotFoundError:
        return (), ()
    except (OSError, ValueError) as error:
        why = "it is not UTF-8" if isinstance(error, UnicodeDecodeError) else reason(error)
        message = f"`{file.name}` cannot be read: {why}"
        return (), (Diagnostic(codes.BAD_PARAMETERS, message, file=file),)
    params, mistakes = read_params(text)
    return params, tuple(_told(each, text, file) for each in mistakes[:MOST_MISTAKES])


def _told(mistake: Mistake, text: str, file: Path) -> Diagnostic:
    start, end = text[: mistake.start], text[: mistake.end].rstrip()
    span = Span(len(start.encode()), max(len(start.encode()), len(end.encode())))
    return Diagnostic(codes.BAD_PARAMETERS, mistake.message, span, file, help=mistake.help)


def _held(node: Node, name: str, value: Setting, ros_version: int) -> Setting:
    """Return a value as the node's parameter holds it: 1 is 1.0 for a number with a fraction.

    A value that the parameter cannot hold stays as it is, for the node to refuse.
    """
    name = name.replace(".", "/") if ros_version == 1 else name
    parameter = node.of(Parameter).get(parameter_name(name, ros_version))
    if parameter is None or parameter.holds is None:
        return value
    held = as_setting(parameter.holds, value)
    return value if held is None else held


def _sure(names: Iterable[str | None]) -> list[str] | None:
    """Return the names, None where one of them is not known."""
    listed = list(names)
    return None if None in listed else [name for name in listed if name is not None]


def _unfit(node: RunNode, name: str, value: Setting) -> str | None:
    problem = name_problem(name, node.ros_version) or unfit(value, node.ros_version)
    details = node.details.get(name)
    return problem if problem is not None or details is None else _refused(details, value)


def _refused(details: ParameterDetails, value: Setting) -> str | None:
    """Return why rclpy refuses a value for a parameter, None where it does not."""
    type_ = details.type
    # Infinity and what is no number at all are floats, though no program can write them.
    finite = 0.0 if isinstance(value, float) and not math.isfinite(value) else value
    if type_ in set(ParameterType) and as_setting(ParameterType(type_), finite) is None:
        return f"{yaml_text(value)} is no `{type_}`"
    if details.range is None or not isinstance(value, (int, float)):
        return None
    low, high, _ = details.range
    is_within = low <= value <= high
    return None if is_within else f"{yaml_text(value)} is not between {low:g} and {high:g}"


def _undeclared(node: RunNode, name: str) -> Diagnostic | None:
    """Return a warning for a parameter that a node has not, nor one that this is a part of."""
    if node.parameters is None:
        return None
    known = {_parts(one, node.ros_version) for one in (*node.parameters, *OF_EVERY_NODE)}
    parts = _parts(name, node.ros_version)
    if any(parts[: count + 1] in known for count in range(len(parts))):
        return None
    return Diagnostic(
        codes.UNDECLARED_PARAMETER,
        f"`{node.name}` has no parameter `{name}`, so that its value changes nothing",
        help=did_you_mean(name, node.parameters),
        severity=Severity.WARNING,
    )


def _parts(name: str, ros_version: int) -> tuple[str, ...]:
    return tuple(name.replace(".", "/").split("/") if ros_version == 1 else name.split("."))
