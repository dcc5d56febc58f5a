"""What is known of a unit: the calls that create endpoints, and what makes its nodes."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from tree_sitter import Node

from plastron_tui.model.source import SourceEndpoint

from .arguments import Call
from .callbacks import NONE, Callback
from .callers import Callers
from .fields import Fields
from .held import Holding
from .read_parameters import ReadParameters
from .receivers import Receivers
from .scopes import CppFile, Function, Scope, Variable
from .shapes import Shape
from .types import Types
from .unit import Unit
from .values import Evaluator


@dataclass(frozen=True, slots=True, eq=False)
class Site:
    """A call that creates an endpoint.

    Attributes:
        endpoint: what it creates, as data.
        call: the call; of an object the declaration, initializer or `new` that makes it.
        shape: the shape that the call matched.
        arguments: its arguments from the one that names the endpoint on, as the shape counts them.
        owner: the class whose instance is the node, None for none.
        node: the variable that is the node or its handle, None for none.
        callback: what it calls back, with the function's definition and declarations.
        bindings: the call of its function in which it creates the endpoint, among others.
        options: the call that makes the options which are all that the call gets.
    """

    endpoint: SourceEndpoint
    call: Call
    shape: Shape
    arguments: list[Node]
    owner: Scope | None
    node: Variable | None = None
    callback: Callback = NONE
    bindings: tuple[tuple[Function, Call], ...] = ()
    options: Call | None = None

    @property
    def place(self) -> Scope:
        """The scope that its arguments stand in."""
        return (self.options or self.call).scope

    @property
    def file(self) -> CppFile:
        """The file that has the call."""
        return self.call.scope.file


@dataclass(frozen=True, slots=True, eq=False)
class NodeSite:
    """A place that makes a node, or names one.

    Attributes:
        name: the name where the source says it literally.
        expression: the source text that decides the name.
        place: the call or class that makes it.
        file: the file of the place.
        owner: the node class of the files, None for a node that a function makes.
        variable: the variable that has it, None for none.
        is_managed: whether it is a lifecycle node.
    """

    name: str | None
    expression: str
    place: Node
    file: CppFile
    owner: Scope | None = None
    variable: Variable | None = None
    is_managed: bool = False


@dataclass(slots=True)
class Analysis:
    """All that a reader and an editor know of the files of a unit.

    Attributes:
        unit: the files with their names.
        ros_version: the generation of ROS that they are read for.
        types: what their types stand for.
        evaluator: what their expressions are worth.
        callers: which calls call their functions.
        receivers: what the objects are whose methods they call.
        holding: what their variables hold.
        fields: what the fields of their variables are set to.
        qos_steps: what changes the profiles of their variables, as far as it was looked for.
        calls_found: how many calls create endpoints.
        worlds_left: how many calls of functions are yet looked at for what they create.
        cut: the calls that create more than was looked at, by their ids.
        sites: the calls that create endpoints, in the order of the files.
        nodes: what makes the nodes.
    """

    unit: Unit
    ros_version: int
    types: Types = field(init=False)
    evaluator: Evaluator = field(init=False)
    callers: Callers = field(init=False)
    receivers: Receivers = field(init=False)
    holding: Holding = field(init=False)
    fields: Fields = field(init=False)
    qos_steps: dict[Variable, Any] = field(default_factory=dict)
    calls_found: int = 0
    worlds_left: int = 4_000
    cut: set[int] = field(default_factory=set)
    sites: list[Site] = field(default_factory=list)
    nodes: list[NodeSite] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Set up what answers questions about the files."""
        self.types = Types(self.unit, self.ros_version)
        self.callers = Callers(self.unit, self.types)
        self.callers.parameters = ReadParameters(self.unit)
        self.evaluator = Evaluator(self.unit, self.callers)
        self.holding = Holding(self.unit, self.types, self.callers)
        self.fields = self.evaluator.fields
        self.receivers = Receivers(self.unit, self.types, self.evaluator, self.callers)
        if self.ros_version == 2:
            self.callers.parameters.declare(self.evaluator)
