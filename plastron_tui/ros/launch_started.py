"""What comes of a launch file: the nodes that it starts, and what of it is not known."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plastron_tui.diagnostics import Span

from .launch import LaunchFile, ParameterValue, Place, StartedNode
from .launch_text import Scope
from .parameters import Setting

SHOWN = frozenset(("output", "emulate_tty", "exec_name", "respawn_delay", "sigterm_timeout",
                   "sigkill_timeout"))  # fmt: skip
"""What is said of a node and makes no difference to what runs: how its lines are shown, and how
long it may take."""

VALUES = frozenset(
    (
        "`<param>`", "`<rosparam>`", "`<env>`", "`<set_env>`", "`<unset_env>`", "`<append_env>`",
        "`<log>`", "`<log_info>`", "`SetEnvironmentVariable`", "`AppendEnvironmentVariable`",
        "`UnsetEnvironmentVariable`", "`LogInfo`", "`SetUseSimTime`", "`SetParametersFromFile`",
        "the period of a `TimerAction`",
    )
)  # fmt: skip
"""What is not understood and starts no node: it sets values, or says something."""

SETTINGS = frozenset(("`<param>`", "`<rosparam>`", "`SetParametersFromFile`"))
"""Of these, what gives parameters of nodes their values."""

Settings = tuple[tuple[str, Setting] | str, ...]
"""Values of parameters by their names, and files with such, in the order that nodes get them."""


Site = tuple[str | None, Place | None]
"""Where something stands: the launch file, and the place in it."""


class Started(NamedTuple):
    """A node that is started.

    Attributes:
        package: the package that has it.
        executable: what starts it, or the class of a component.
        name: its name, None where it has its own.
        namespace: its namespace, such as `/front`; "" for the root.
        remaps: names of its topics and services, and those that they get; the first for a name
            holds.
        settings: values of its parameters, and files with such; of two for one, the later holds.
        others: what else is said of it, by name.
        container: the full name of the container that it runs in, None for a process of its own.
        file: the launch file that starts it.
        place: where that file does.
        remap_places: the file and the place of each of the remaps.
        included: the includes that lead to the file, the outermost first: each a file and a place.
        pushed: what says the last part of its namespace, None where nothing does.
        is_named: whether its namespace and all of its remaps are known.
        package_span: where its file says the package.
        executable_span: where its file says the executable.
        setting_spans: where its file names the parameters that it sets of this node alone.
    """

    package: str
    executable: str
    name: str | None
    namespace: str
    remaps: tuple[tuple[str, str], ...] = ()
    settings: Settings = ()
    others: tuple[tuple[str, str], ...] = ()
    container: str | None = None
    file: str | None = None
    place: Place | None = None
    remap_places: tuple[Site, ...] = ()
    included: tuple[Site, ...] = ()
    pushed: Site | None = None
    is_named: bool = True
    package_span: Span | None = None
    executable_span: Span | None = None
    setting_spans: tuple[tuple[str, Span], ...] = ()

    @property
    def full_name(self) -> str | None:
        """Its full name, None where it has its own."""
        return None if self.name is None else f"{self.namespace}/{self.name}"

    @property
    def parameters(self) -> tuple[tuple[str, Setting], ...]:
        """The values that the launch files themselves have for its parameters."""
        return tuple(each for each in self.settings if not isinstance(each, str))

    @property
    def files(self) -> tuple[str, ...]:
        """The files with values of its parameters."""
        return tuple(each for each in self.settings if isinstance(each, str))


class Unresolved(NamedTuple):
    """Something that is left out, since it is not known before the file is started.

    Attributes:
        message: what, and why, for a person.
        file: the launch file.
        place: where it stands there.
        is_wrong: whether the files cannot be started at all.
        is_value: whether it is a value alone: no node and no name is left out with it.
        parameter: the parameter whose value it is, "" for anything else.
        sets_parameters: whether parameters of nodes may have their values by it.
    """

    message: str
    file: str | None
    place: Place | None
    is_wrong: bool = False
    is_value: bool = False
    parameter: str = ""
    sets_parameters: bool = False


class Resolved(NamedTuple):
    """What a launch file starts, and what of it is not known.

    Attributes:
        started: what it starts.
        unresolved: what of it is not known.
        shared: the parameters that a file of ROS 1 sets for whichever node reads them, "" for
            those of a parameter file.
    """

    started: tuple[Started, ...]
    unresolved: tuple[Unresolved, ...]
    shared: frozenset[str] = frozenset()


class Opened(NamedTuple):
    """A launch file that another one includes, and what it says; None where it is not read."""

    launch: LaunchFile | None
    ros_version: int
    folder: str
    reason: str = ""


def setting_spans(node: StartedNode, scope: Scope) -> Iterator[tuple[str, Span]]:
    """Yield the parameters that a launch file sets of a node, each with where it is named."""
    for each in node.parameters:
        if isinstance(each, ParameterValue) and each.name.span is not None:
            name = scope.value(each.name)
            if name is not None:
                yield name, each.name.span
