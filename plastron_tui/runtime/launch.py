"""Runs a program's nodes with the ROS that is there: `plastron run` without its command line."""

from __future__ import annotations

import contextlib
import json
import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple, TextIO

from plastron_tui.diagnostics import Diagnostic, has_errors

from .child import Exit, Process, Role
from .console import Console
from .environment import Environment, node_environ, with_folders
from .long_arguments import ArgumentFiles
from .master import Master, ensure_master
from .monitor import announcement, monitor_commands
from .supervisor import Supervisor
from .table import Screen, Ticker, Watch

_OBSERVERS = Path(__file__).with_name("observers")
_WATCH_NAME = "watch"
_LIFECYCLE_NAME = "lifecycle"
_COMPONENTS_NAME = "components"
_LOADED = "loaded"
_LONGEST_CALL = 1 << 16
_LONGEST_START = 30.0
"""How long a managed node may take until it is active, in seconds."""


class Loaded(NamedTuple):
    """A component of ROS 2 that is loaded into a container.

    Attributes:
        name: the node's name.
        package: the package that has it.
        plugin: its class.
        arguments: what a process of it would be started with.
    """

    name: str
    package: str
    plugin: str
    arguments: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class NodeFile:
    """A generated node, and what starts it.

    Attributes:
        name: the node's name.
        command: what starts it.
        environment: the ROS that it runs with.
        script: its file where the environment's Python runs it: then its service calls are seen.
        arguments: what it is started with besides.
        namespace: the namespace that they put it in, "" for the root.
        managed: the full names of its lifecycle nodes, which the run has to activate.
        folders: folders that come first in variables of the environment (`PYTHONPATH`).
        label: what its lines are labelled with, where that is not its name.
        starts: the full names of the nodes that it starts itself; its name is then none.
        loads: the components that the run has to load into it.
        is_host: whether the nodes that it has sign off at it, and so end before it.
    """

    name: str
    command: tuple[str, ...]
    environment: Environment
    script: Path | None = None
    arguments: tuple[str, ...] = ()
    namespace: str = ""
    managed: tuple[str, ...] = ()
    folders: tuple[tuple[str, Path], ...] = ()
    label: str = ""
    starts: tuple[str, ...] = ()
    loads: tuple[Loaded, ...] = ()
    is_host: bool = False

    @property
    def title(self) -> str:
        """What its lines are labelled with."""
        return self.label or self.name

    @property
    def full_name(self) -> str:
        """The name that it has in the graph, as far as its arguments say it."""
        return f"{self.namespace}/{self.name}"

    @property
    def graph_names(self) -> tuple[str, ...]:
        """The full names of all nodes that it has in the graph."""
        loaded = (f"{self.namespace}/{each.name}" for each in self.loads)
        return (*(self.starts or (self.full_name,)), *loaded)


class Activation(NamedTuple):
    """How the activation of a managed node, or the loading of a component, ended.

    Attributes:
        node: its full name.
        passed: the transitions that it was asked for and passed.
        error: why it is not active, None where it is.
        wanted: what it was to become: `loaded`, of a component.
    """

    node: str
    passed: tuple[str, ...]
    error: str | None
    wanted: str = "active"


def activation_of(line: str) -> Activation | None:
    """Read a line of the observers that bring nodes up; None for what they have not written."""
    try:
        told = json.loads(line)
        error = told["error"]
        passed = tuple(map(str, told["passed"]))
        wanted = _LOADED if told.get("wanted") == _LOADED else "active"
        return Activation(str(told["node"]), passed, None if error is None else str(error), wanted)
    except (ValueError, TypeError, KeyError, RecursionError):
        return None


@dataclass(frozen=True, slots=True)
class Options:
    """How to run.

    Attributes:
        duration: seconds until the nodes are stopped; None for as long as they run.
        network: whether the nodes may speak to other machines.
        watch: whether to show what travels.
        announce: the file descriptor on which is said, once the nodes are started, what starts
            a monitor of them; None where nobody wants to know.
    """

    duration: float | None = None
    network: bool = False
    watch: bool = False
    announce: int | None = None


@dataclass(frozen=True, slots=True)
class RunResult:
    """The exit status of a run (see `Supervisor.wait`), and what kept it from starting."""

    status: int
    diagnostics: tuple[Diagnostic, ...] = ()


def run_nodes(
    nodes: Sequence[NodeFile],
    options: Options = Options(),
    *,
    out: TextIO | None = None,
    err: TextIO | None = None,
    environ: Mapping[str, str] = os.environ,
) -> RunResult:
    """Run nodes until all have ended, the time is up, or a signal comes.

    The nodes' lines go to `out`, what there is to say about the run to `err`.

    Raises:
        OSError: neither can be written to, for another reason than that a reader has left; the
            nodes have been stopped.
    """
    return _Run(nodes, options, out or sys.stdout, err or sys.stderr, environ).go()


class _Run:
    """The parts of one run, wired together."""

    def __init__(
        self,
        nodes: Sequence[NodeFile],
        options: Options,
        out: TextIO,
        err: TextIO,
        environ: Mapping[str, str],
    ) -> None:
        self._nodes = nodes
        self._options = options
        self._environ = environ
        self._watch = Watch()
        self._ticker = Ticker()
        self._observers: list[Process] = []
        self._activations: list[Process] = []
        self._is_inactive = False
        self._calls = bytearray()
        self._long_arguments = ArgumentFiles()
        self._supervisor = Supervisor(self._on_line, self._on_exit, self._on_tick)
        names = [*(node.title for node in nodes), *([_WATCH_NAME] if options.watch else [])]
        self._console = Console(names, out, err, on_gone=self._supervisor.stop, environ=environ)
        self._screen = Screen(self._watch) if options.watch and out.isatty() else None

    def go(self) -> RunResult:
        diagnostics: list[Diagnostic] = []
        with self._long_arguments, self._supervisor:
            master: Master | None = None
            first = [node for node in self._nodes if node.environment.ros_version == 1][:1]
            for node in first:
                master, diagnostics = ensure_master(
                    self._supervisor,
                    node.environment,
                    [
                        name
                        for one in self._nodes
                        if one.environment.ros_version == 1
                        for name in one.starts or (one.full_name,)
                    ],
                    network=self._options.network,
                    environ=self._environ,
                )
                self._tell(master)
            if not has_errors(diagnostics) and not self._supervisor.is_stopping:
                self._run(master)
        if self._console.failure is not None:
            raise self._console.failure
        has_failed = has_errors(diagnostics) or self._is_inactive
        status = 1 if has_failed else self._supervisor.status
        return RunResult(status, tuple(diagnostics))

    def _tell(self, master: Master | None) -> None:
        if master is not None:
            verb = "using the" if master.process is None else "started a"
            self._console.notice(f"{verb} ROS 1 master at {master.uri}")

    def _run(self, master: Master | None) -> None:
        with self._call_pipe() as pipe:
            for node in self._nodes:
                node = replace(node, arguments=self._long_arguments.placed(node.arguments))
                self._supervisor.start(self._process(node, master, pipe))
        self._activate(master)
        self._load(master)
        self._announce(master)
        if self._options.watch:
            self._start_observers(master)
            self._console.show(self._screen)
        self._supervisor.wait(self._options.duration)
        if self._screen is None:
            self._print_lines()
        self._console.show(None)

    @contextlib.contextmanager
    def _call_pipe(self) -> Iterator[int | None]:
        """Open the pipe by which the nodes report service calls, where they are watched.

        Only the nodes keep its writing end.
        """
        if not self._options.watch:
            yield None
            return
        read_end, write_end = os.pipe()
        self._supervisor.read(read_end, self._on_calls)
        try:
            yield write_end
        finally:
            os.close(write_end)

    def _process(self, node: NodeFile, master: Master | None, pipe: int | None) -> Process:
        environ = with_folders(self._node_environ(node.environment, master), node.folders)
        if pipe is None or node.script is None:
            argv = (*node.command, *node.arguments)
            return Process(node.title, argv, environ, is_host=node.is_host)
        environ["PLASTRON_EVENTS_FD"] = str(pipe)
        environ["PLASTRON_ROS_VERSION"] = str(node.environment.ros_version)
        traced = str(_OBSERVERS / "traced.py")
        argv = (str(node.environment.python), traced, str(node.script), *node.arguments)
        return Process(node.title, argv, environ, fds=(pipe,))

    def _activate(self, master: Master | None) -> None:
        """Bring up the managed nodes, of each environment by a process of its own."""
        names: dict[Environment, list[str]] = {}
        for node in self._nodes:
            if node.managed:
                names.setdefault(node.environment, []).extend(node.managed)
        for environment, managed in names.items():
            script = str(_OBSERVERS / "lifecycle.py")
            process = Process(
                _LIFECYCLE_NAME,
                (str(environment.python), script, str(_LONGEST_START), *managed),
                self._node_environ(environment, master),
                role=Role.OBSERVER,
            )
            self._activations.append(process)
            self._supervisor.start(process)

    def _load(self, master: Master | None) -> None:
        """Load the components, of each container by a process of its own."""
        for node in self._nodes:
            if not node.loads:
                continue
            script = str(_OBSERVERS / "components.py")
            loads = json.dumps([each._asdict() for each in node.loads])
            process = Process(
                _COMPONENTS_NAME,
                (
                    str(node.environment.python),
                    script,
                    str(_LONGEST_START),
                    node.full_name,
                    loads,
                ),
                self._node_environ(node.environment, master),
                role=Role.OBSERVER,
            )
            self._activations.append(process)
            self._supervisor.start(process)

    def _tell_activation(self, line: str) -> None:
        """Say whether a managed node is active now; other lines are those of a client library."""
        told = activation_of(line)
        if told is None:
            return
        name = told.node.removeprefix("/")
        if told.error is not None:
            self._console.notice(f"{name} is not {told.wanted}: {told.error}", is_bad=True)
            self._is_inactive = True
        elif told.wanted == _LOADED:
            self._console.notice(f"loaded {name} into its container")
        elif told.passed:
            done = " and ".join(f"{each.removesuffix('e')}ed" for each in told.passed)
            self._console.notice(f"{done} {name} by its lifecycle services")

    def _announce(self, master: Master | None) -> None:
        """Say what starts a monitor of the nodes, for each ROS that they run with."""
        if self._options.announce is None:
            return
        # Types of the program's own are in the folders.
        commands = monitor_commands(
            [(node.environment, node.folders) for node in self._nodes],
            lambda environment: self._node_environ(environment, master),
        )
        nodes = {node.title: node.graph_names for node in self._nodes}
        named = [replace(each, nodes=nodes) for each in commands]
        with contextlib.suppress(OSError), os.fdopen(self._options.announce, "w") as pipe:
            pipe.write(announcement(named))

    def _start_observers(self, master: Master | None) -> None:
        for environment in dict.fromkeys(node.environment for node in self._nodes):
            process = Process(
                _WATCH_NAME,
                (
                    str(environment.python),
                    str(_OBSERVERS / "watch.py"),
                    str(environment.ros_version),
                ),
                self._node_environ(environment, master),
                role=Role.OBSERVER,
            )
            self._observers.append(process)
            self._supervisor.start(process)

    def _node_environ(self, environment: Environment, master: Master | None) -> dict[str, str]:
        return node_environ(
            environment,
            self._environ,
            network=self._options.network,
            master_uri=None if master is None else master.uri,
        )

    def _on_line(self, process: Process, line: str) -> None:
        if process in self._observers:
            self._watch.feed_topics(line)
        elif process in self._activations:
            self._tell_activation(line)
        elif process.role is Role.NODE:
            self._console.line(process, line)

    def _on_exit(self, end: Exit) -> None:
        # What brings nodes up has told it of each, and is done then.
        is_activation = end.process in self._activations
        if is_activation and end.is_failure:
            self._is_inactive = True
        if not is_activation or end.is_failure:
            self._console.ended(end)

    def _on_calls(self, chunk: bytes) -> None:
        self._calls += chunk
        *lines, rest = bytes(self._calls).split(b"\n")
        # An observer writes whole lines; what is no line, a node has written.
        self._calls = bytearray(rest[-_LONGEST_CALL:])
        for line in lines:
            text = self._watch.feed_call(line.decode("utf-8", "replace"))
            if text is not None and self._screen is None:
                self._console.labelled(_WATCH_NAME, text)

    def _on_tick(self) -> None:
        self._console.refresh()
        if self._options.watch and self._screen is None and self._ticker.is_due():
            self._print_lines()

    def _print_lines(self) -> None:
        for line in self._watch.lines():
            self._console.labelled(_WATCH_NAME, line)
