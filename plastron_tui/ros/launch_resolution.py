"""What a launch file starts: nodes with their full names, as far as they can be known.

Sources: the ROS wiki page "roslaunch/XML"; for ROS 2 `launch_ros`: `prefix_namespace` joins a
namespace to the one around it unless it starts with `/`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from .launch import (
    Argument,
    Condition,
    Container,
    Group,
    Include,
    Item,
    LaunchFile,
    Namespace,
    Parameter,
    ParameterFile,
    ParameterValue,
    Place,
    Remap,
    SetParameter,
    StartedNode,
    Unread,
    Variable,
)
from .launch_inclusion import Including
from .launch_text import Scope, Text
from .launch_values import typed, typed_as
from .names import spelled
from .parameters import Setting

DEEPEST = 20
"""How deep launch files include each other at most."""

MOST_NODES = 2000
"""How many nodes are resolved at most."""


class Started(NamedTuple):
    """A node that is started.

    Attributes:
        package: the package that has it.
        executable: what starts it, or the class of a component.
        name: its name, None where it has its own.
        namespace: its namespace, such as `/front`; "" for the root.
        remaps: names of its topics and services, and those that they get.
        parameters: values of its parameters.
        files: files with values of its parameters.
        others: what else is said of it, by name.
        container: the full name of the container that it runs in, None for a process of its own.
        file: the launch file that starts it.
        place: where that file does.
    """

    package: str
    executable: str
    name: str | None
    namespace: str
    remaps: tuple[tuple[str, str], ...] = ()
    parameters: tuple[tuple[str, Setting], ...] = ()
    files: tuple[str, ...] = ()
    others: tuple[tuple[str, str], ...] = ()
    container: str | None = None
    file: str | None = None
    place: Place | None = None

    @property
    def full_name(self) -> str | None:
        """Its full name, None where it has its own."""
        return None if self.name is None else f"{self.namespace}/{self.name}"


class Unresolved(NamedTuple):
    """Something that is left out, since it is not known before the file is started.

    Attributes:
        message: what, and why, for a person.
        file: the launch file.
        place: where it stands there.
        is_wrong: whether the files cannot be started at all.
    """

    message: str
    file: str | None
    place: Place | None
    is_wrong: bool = False


class Resolved(NamedTuple):
    """What a launch file starts, and what of it is not known."""

    started: tuple[Started, ...]
    unresolved: tuple[Unresolved, ...]


class Opened(NamedTuple):
    """A launch file that another one includes, and what it says; None where it is not read."""

    launch: LaunchFile | None
    ros_version: int
    folder: str
    reason: str = ""


OpenInclude = Callable[[str], Opened]


def _no_include(path: str) -> Opened:
    return Opened(None, 2, "", "included files are not read here")


@dataclass(frozen=True, slots=True)
class _State:
    """What holds at a place of a launch file."""

    scope: Scope
    file: str | None
    ros_version: int
    around: tuple[Including, ...] = ()
    namespace: str = ""
    remaps: tuple[tuple[str, str], ...] = ()
    parameters: tuple[tuple[str, Setting], ...] = ()
    given: frozenset[str] = field(default_factory=frozenset)


def resolve(
    launch: LaunchFile,
    ros_version: int,
    scope: Scope,
    file: str | None = None,
    open_include: OpenInclude = _no_include,
) -> Resolved:
    """Return what a launch file starts.

    Args:
        launch: what it says.
        ros_version: the generation of ROS that it is for.
        scope: the arguments that it is given, and what else substitutions ask for.
        file: its path.
        open_include: reads a file that it includes.
    """
    run = _Resolution(open_include)
    run.go(launch.items, _State(scope, file, ros_version, given=frozenset(scope.arguments)))
    return Resolved(tuple(run.started), tuple(run.unresolved))


class _Resolution:
    """Goes over the items, and remembers what they start."""

    def __init__(self, open_include: OpenInclude) -> None:
        self.started: list[Started] = []
        self.unresolved: list[Unresolved] = []
        self._open = open_include
        self._included = 0

    def go(self, items: Iterable[Item], state: _State) -> _State:
        """Resolve items one by one, and return what holds behind them."""
        for item in items:
            if len(self.started) >= MOST_NODES:
                break
            if self._applies(item, state):
                state = self._item(item, state)
        return state

    def _item(self, item: Item, state: _State) -> _State:
        match item:
            case Argument(name=name, default=default):
                if name not in state.scope.arguments and default is not None:
                    return self._set(state, name, default, item)
            case Variable(name=name, value=value):
                return self._set(state, name, value, item)
            case Namespace(namespace=namespace):
                pushed = self._value(namespace, state, item, "a namespace")
                if pushed is not None:
                    return replace(state, namespace=_joined(state.namespace, pushed))
            case Remap(old=old, new=new):
                pair = state.scope.value(old), state.scope.value(new)
                if pair[0] is not None and pair[1] is not None:
                    names = (spelled(pair[0]), spelled(pair[1]))
                    return replace(state, remaps=(*state.remaps, names))
                self._tell(state, item, "a remap", old if pair[0] is None else new)
            case SetParameter(parameter=ParameterValue() as parameter) if state.ros_version == 2:
                found = self._parameters((parameter,), state, item)
                return replace(state, parameters=(*state.parameters, *found))
            case StartedNode():
                self._start(item, state, None)
            case Container():
                self._container(item, state)
            case Group():
                inner = self.go(item.items, state)
                return state if item.is_scoped else inner
            case Include():
                self._include(item, state)
            case Unread(what=what):
                self._left_out(state, item, f"{what} is not understood, and left out")
            case _:
                pass
        return state

    def _applies(self, item: Item, state: _State) -> bool:
        if item.condition is None:
            return True
        found = holds(item.condition, state.scope)
        if found is None:
            self._tell(state, item, "what hangs on a condition", item.condition.value)
        return found is True

    def _set(self, state: _State, name: str, value: Text, item: Item) -> _State:
        found = state.scope.value(value)
        known = dict(state.scope.arguments)
        if found is None:
            known.pop(name, None)
            self._tell(state, item, f"the value of `{name}`", value)
        else:
            known[name] = found
        return replace(state, scope=replace(state.scope, arguments=known))

    def _start(self, item: StartedNode, state: _State, container: str | None) -> Started | None:
        names = [item.package, item.executable, *(x for x in (item.name, item.namespace) if x)]
        if any(self._value(each, state, item, "a node") is None for each in names):
            return None
        value = state.scope.value
        namespace = state.namespace
        if item.namespace is not None:
            namespace = _joined(namespace, value(item.namespace) or "")
        found = Started(
            value(item.package) or "",
            value(item.executable) or "",
            None if item.name is None else value(item.name) or None,
            namespace,
            (*self._remaps(item, state), *state.remaps),
            (*state.parameters, *self._parameters(item.parameters, state, item)),
            tuple(self._files(item.parameters, state, item)),
            tuple((key, value(each) or "") for key, each in item.others),
            container,
            state.file,
            item.place,
        )
        self.started.append(found)
        return found

    def _remaps(self, item: StartedNode, state: _State) -> Iterable[tuple[str, str]]:
        for old, new in item.remaps:
            pair = state.scope.value(old), state.scope.value(new)
            if pair[0] is None or pair[1] is None:
                self._tell(state, item, "a remap", old if pair[0] is None else new)
            else:
                yield spelled(pair[0]), spelled(pair[1])

    def _parameters(
        self, parameters: Iterable[Parameter], state: _State, item: Item
    ) -> Iterable[tuple[str, Setting]]:
        found: list[tuple[str, Setting]] = []
        for each in parameters:
            if isinstance(each, ParameterFile):
                continue
            name, value = state.scope.value(each.name), self._setting(each, state)
            if name is not None and value is not None:
                found.append((name, value))
            else:
                unknown = each.value if isinstance(each.value, Text) else each.name
                self._tell(state, item, f"the parameter `{each.name}`", unknown)
        return found

    def _setting(self, parameter: ParameterValue, state: _State) -> Setting | None:
        if not isinstance(parameter.value, Text):
            return parameter.value
        found = state.scope.value(parameter.value)
        if found is None or parameter.is_text:
            return found
        held = typed_as(found, "float", state.ros_version) if parameter.is_float else None
        return typed(found, state.ros_version) if held is None else held

    def _files(self, parameters: Iterable[Parameter], state: _State, item: Item) -> Iterable[str]:
        for each in parameters:
            if isinstance(each, ParameterFile):
                found = self._value(each.file, state, item, "a parameter file")
                if found is not None:
                    yield found

    def _container(self, item: Container, state: _State) -> None:
        name = None if item.target is None else state.scope.value(item.target)
        if item.node is not None:
            started = self._start(replace(item.node, place=item.place), state, None)
            name = None if started is None else started.full_name
        for component in item.components:
            if self._applies(component, state):
                self._start(component, state, name or "")

    def _include(self, item: Include, state: _State) -> None:
        path = self._value(item.file, state, item, "an included file")
        if path is None:
            return
        self._included += 1
        if len(state.around) >= DEEPEST or self._included > MOST_NODES:
            self._left_out(state, item, "the files include each other too often")
            return
        known = self._passed(item, state)
        around = self._around(state)
        real = os.path.realpath(path)
        again = next((each for each in around if each.is_again(real, known)), None)
        if again is not None:
            self._endless(item, state, around[around.index(again) + 1 :], again)
            return
        opened = self._open(path)
        if opened.launch is None:
            self._left_out(state, item, f"`{path}` is left out: {opened.reason}")
            return
        namespace = state.namespace
        if item.namespace is not None:
            namespace = _joined(namespace, state.scope.value(item.namespace) or "")
        scope = replace(state.scope, arguments=known, folder=opened.folder)
        inner = replace(
            state,
            scope=scope,
            file=path,
            ros_version=opened.ros_version,
            around=around,
            namespace=namespace,
            given=frozenset(known),
        )
        self.go(opened.launch.items, inner)

    def _passed(self, item: Include, state: _State) -> dict[str, str]:
        """Return the arguments that an included file is given."""
        is_all = dict(item.others).get("pass_all_args")
        # In ROS 2 the arguments of a file are those of what it includes, too.
        known = dict(state.scope.arguments) if state.ros_version == 2 or is_all else {}
        for name, text in item.arguments:
            value = self._value(text, state, item, f"the argument `{name}`")
            if value is not None:
                known[name] = value
        return known

    def _around(self, state: _State) -> tuple[Including, ...]:
        """Return the files that include each other at a place, the outermost first."""
        if state.file is None:
            return state.around
        real = os.path.realpath(state.file)
        return (*state.around, Including(real, state.given, state.scope.arguments))

    def _endless(
        self, item: Include, state: _State, between: tuple[Including, ...], again: Including
    ) -> None:
        names = " and ".join(f"`{os.path.basename(each.path)}`" for each in between)  # noqa: PTH119
        message = f"`{os.path.basename(again.path)}` includes itself without end"  # noqa: PTH119
        if names:
            message += f", by {names}"
        self.unresolved.append(Unresolved(message, state.file, item.place, is_wrong=True))

    def _value(self, text: Text, state: _State, item: Item, what: str) -> str | None:
        found = state.scope.value(text)
        if found is None:
            self._tell(state, item, what, text)
        return found

    def _tell(self, state: _State, item: Item, what: str, text: Text) -> None:
        unknown = state.scope.unknown(text)
        shown = f"`{text}`" if unknown is None else f"`{Text((unknown,))}`"
        self._left_out(state, item, f"{what} is left out: {shown} is not known here")

    def _left_out(self, state: _State, item: Item, message: str) -> None:
        self.unresolved.append(Unresolved(message, state.file, item.place))


def holds(condition: Condition, scope: Scope) -> bool | None:
    """Tell whether a condition holds, None where that is not known."""
    value = scope.value(condition.value)
    found = {"true": True, "1": True, "false": False, "0": False}.get((value or "").strip().lower())
    return None if value is None or found is None else found is not condition.is_negated


def _joined(outer: str, inner: str) -> str:
    parts = [part for part in inner.split("/") if part]
    start = "" if inner.startswith("/") else outer
    return start + "".join(f"/{part}" for part in parts)
