"""What a launch file starts: nodes with their full names, as far as they can be known.

Sources: the ROS wiki page "roslaunch/XML"; for ROS 2 `launch_ros`: `prefix_namespace` joins a
namespace to the one around it unless it starts with `/`; `launch_ros.actions.Node` puts what
`SetRemap` says before its own remaps. For ROS 1 `roslaunch.loader.LoaderContext.remap_args`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

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
    Remap,
    SetParameter,
    StartedNode,
    Unread,
    Variable,
    joined,
)
from .launch_inclusion import Including
from .launch_started import (
    SETTINGS,
    SHOWN,
    VALUES,
    Opened,
    Resolved,
    Started,
    Unresolved,
    setting_spans,
)
from .launch_state import Renaming, State
from .launch_text import Scope, Text
from .launch_values import typed, typed_as
from .names import spelled
from .parameters import Setting

DEEPEST = 20
"""How deep launch files include each other at most."""

MOST_NODES = 2000
"""How many nodes are resolved at most."""

OpenInclude = Callable[[str], Opened]


def _no_include(path: str) -> Opened:
    return Opened(None, 2, "", "included files are not read here")


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
    run.go(launch.items, State(scope, file, ros_version, given=frozenset(scope.arguments)))
    return Resolved(tuple(run.started), tuple(run.unresolved), frozenset(run.shared))


class _Resolution:
    """Goes over the items, and remembers what they start."""

    def __init__(self, open_include: OpenInclude) -> None:
        self.started: list[Started] = []
        self.unresolved: list[Unresolved] = []
        self.shared: set[str] = set()
        self._open = open_include
        self._included = 0

    def go(self, items: Iterable[Item], state: State) -> State:
        """Resolve items one by one, and return what holds behind them."""
        for item in items:
            if len(self.started) >= MOST_NODES:
                break
            if self._applies(item, state):
                state = self._item(item, state)
        return state

    def _item(self, item: Item, state: State) -> State:
        match item:
            case Argument(name=name, default=default):
                if not state.scope.has(name):
                    if default is not None:
                        return self._set(state, name, default, item)
                    return replace(state, scope=state.scope.with_argument(name, None))
            case Variable(name=name, value=value):
                return self._set(state, name, value, item)
            case Namespace(namespace=namespace):
                pushed = self._value(namespace, state, item, "a namespace")
                if pushed is not None:
                    within = joined(state.namespace, pushed) or ""
                    return replace(state, namespace=within, pushed=(state.file, item.place))
                return replace(state, is_named=False)
            case Remap(old=old, new=new):
                pair = state.scope.value(old), state.scope.value(new)
                if pair[0] is not None and pair[1] is not None:
                    names = (spelled(pair[0]), spelled(pair[1]))
                    found = Renaming(names, (state.file, item.place))
                    return replace(state, remaps=(*state.remaps, found))
                self._tell(state, item, "a remap", old if pair[0] is None else new)
                return replace(state, is_named=False)
            case SetParameter(parameter=parameter) if state.ros_version == 2:
                set_ = self._settings((parameter,), state, item)
                return replace(state, settings=(*state.settings, *set_))
            case SetParameter(parameter=parameter):
                named = None if isinstance(parameter, ParameterFile) else parameter.name
                self.shared.add("" if named is None else state.scope.value(named) or "")
            case StartedNode():
                self._start(item, state, None)
            case Container():
                self._container(item, state)
            case Group():
                inner = self.go(item.items, state)
                return state if item.is_scoped else inner
            case Include():
                return self._include(item, state)
            case Unread(what=what):
                message = f"{what} is not understood, and left out"
                self._left_out(state, item, message, is_value=what in VALUES)
                if what in SETTINGS:
                    self._sets("")
            case _:
                pass
        return state

    def _applies(self, item: Item, state: State) -> bool:
        if item.condition is None:
            return True
        found = item.condition.holds(state.scope)
        if found is None:
            self._tell(state, item, "what hangs on a condition", item.condition.value)
        return found is True

    def _set(self, state: State, name: str, value: Text, item: Item) -> State:
        found = state.scope.value(value)
        if found is None:
            self._tell(state, item, f"the value of `{name}`", value, is_value=True)
        return replace(state, scope=state.scope.with_argument(name, found))

    def _start(self, item: StartedNode, state: State, container: str | None) -> Started | None:
        names = [item.package, item.executable, *(x for x in (item.name, item.namespace) if x)]
        if any(self._value(each, state, item, "a node") is None for each in names):
            return None
        value, remaps = state.scope.value, self._remaps(item, state)
        found = Started(
            value(item.package) or "",
            value(item.executable) or "",
            None if item.name is None else value(item.name) or None,
            self._within(item, state) or "",
            tuple(each.names for each in remaps),
            (*state.settings, *self._settings(item.parameters, state, item)),
            tuple(self._others(item, state)),
            container,
            state.file,
            item.place,
            tuple(each.site for each in remaps),
            state.included,
            (state.file, item.place) if item.namespace is not None else state.pushed,
            state.is_named and len(remaps) == len(state.remaps) + len(item.remaps),
            item.package.span,
            item.executable.span,
            tuple(setting_spans(item, state.scope)),
        )
        self.started.append(found)
        return found

    def _within(self, item: StartedNode | Include, state: State) -> str | None:
        """Return the namespace of a node or an included file, None where it is not known."""
        own = "" if item.namespace is None else state.scope.value(item.namespace)
        return None if own is None else joined(state.namespace, own)

    def _others(self, item: StartedNode, state: State) -> Iterable[tuple[str, str]]:
        for key, text in item.others:
            found = state.scope.value(text)
            if found is not None:
                yield key, found
            elif key not in SHOWN:
                self._tell(state, item, f"`{key}`", text)

    def _remaps(self, item: StartedNode, state: State) -> tuple[Renaming, ...]:
        """Return the remaps of a node, the one that holds first.

        In ROS 1 one that stands nearer to the node holds. ROS 2 has those around it before its
        own on the command line, and takes the first that fits.
        """
        found = list(state.remaps)
        for each in item.remaps:
            pair = state.scope.value(each.old), state.scope.value(each.new)
            if pair[0] is None or pair[1] is None:
                self._tell(state, item, "a remap", each.old if pair[0] is None else each.new)
            else:
                names, place = (spelled(pair[0]), spelled(pair[1])), each.place or item.place
                found.append(Renaming(names, (state.file, place)))
        return tuple(found if state.ros_version == 2 else reversed(found))

    def _settings(
        self, parameters: Iterable[Parameter], state: State, item: Item
    ) -> Iterable[tuple[str, Setting] | str]:
        for each in parameters:
            if isinstance(each, ParameterFile):
                file = state.scope.value(each.file)
                if file is None:
                    self._tell(state, item, "a parameter file", each.file, is_value=True)
                    self._sets("")
                else:
                    yield file
                continue
            name, value = state.scope.value(each.name), self._setting(each, state)
            if name is not None and value is not None:
                yield name, value
            else:
                unknown = each.value if isinstance(each.value, Text) else each.name
                self._tell(state, item, f"the parameter `{each.name}`", unknown, is_value=True)
                self._sets(name or "")

    def _setting(self, parameter: ParameterValue, state: State) -> Setting | None:
        if not isinstance(parameter.value, Text):
            return parameter.value
        found = state.scope.value(parameter.value)
        if found is None or parameter.is_text:
            return found
        held = typed_as(found, "float", state.ros_version) if parameter.is_float else None
        return typed(found, state.ros_version) if held is None else held

    def _container(self, item: Container, state: State) -> None:
        name = None if item.target is None else self._value(item.target, state, item, "a container")
        if item.target is not None and name is None:
            return
        if item.node is not None:
            started = self._start(replace(item.node, place=item.place), state, None)
            name = None if started is None else started.full_name
        for component in item.components:
            if self._applies(component, state):
                self._start(component, state, name or "")

    def _include(self, item: Include, state: State) -> State:
        """Resolve an included file, and return what holds behind it.

        In ROS 2 what the file sets holds there, too, as if it was written in the place of the
        include: only groups end that.
        """
        path = self._value(item.file, state, item, "an included file")
        namespace, known = self._within(item, state), self._passed(item, state)
        if namespace is None and item.namespace is not None:
            self._tell(state, item, "an included file", item.namespace)
        if path is None or namespace is None or known is None:
            return state
        self._included += 1
        if len(state.around) >= DEEPEST or self._included > MOST_NODES:
            self._left_out(state, item, "the files include each other too often")
            return state
        around = self._around(state)
        real = os.path.realpath(path)
        again = next((each for each in around if each.is_again(real, known)), None)
        if again is not None:
            self._endless(item, state, around[around.index(again) + 1 :], again)
            return state
        opened = self._open(path)
        if opened.launch is None:
            self._left_out(state, item, f"`{path}` is left out: {opened.reason}")
            return state
        inner = replace(
            state,
            scope=replace(
                state.scope,
                arguments=known,
                unknown_arguments=_unknown_in(item, state, known),
                folder=opened.folder,
            ),
            file=path,
            ros_version=opened.ros_version,
            around=around,
            namespace=namespace,
            pushed=state.pushed if item.namespace is None else (state.file, item.place),
            given=frozenset(known),
            included=(*state.included, (state.file, item.place)),
        )
        after = self.go(opened.launch.items, inner)
        if state.ros_version == 1:
            return state
        return replace(
            state,
            scope=replace(after.scope, folder=state.scope.folder),
            namespace=after.namespace,
            pushed=after.pushed,
            is_named=after.is_named,
            remaps=after.remaps,
            settings=after.settings,
        )

    def _passed(self, item: Include, state: State) -> dict[str, str] | None:
        """Return the arguments that an included file is given, None where they are not known."""
        # In ROS 2 the arguments of a file are those of what it includes, too.
        is_all: bool | None = state.ros_version == 2
        flag = dict(item.others).get("pass_all_args")
        if flag is not None and state.ros_version == 1:
            is_all = Condition(flag).holds(state.scope)
            if is_all is None:
                self._tell(state, item, "an included file", flag)
                return None
        known = dict(state.scope.arguments) if is_all else {}
        for name, text in item.arguments:
            value = state.scope.value(text)
            if value is None:
                self._tell(state, item, f"the argument `{name}`", text, is_value=True)
                known.pop(name, None)
            else:
                known[name] = value
        return known

    def _around(self, state: State) -> tuple[Including, ...]:
        """Return the files that include each other at a place, the outermost first."""
        if state.file is None:
            return state.around
        real = os.path.realpath(state.file)
        return (*state.around, Including(real, state.given, state.scope.arguments))

    def _endless(
        self, item: Include, state: State, between: tuple[Including, ...], again: Including
    ) -> None:
        names = " and ".join(f"`{os.path.basename(each.path)}`" for each in between)  # noqa: PTH119
        message = f"`{os.path.basename(again.path)}` includes itself without end"  # noqa: PTH119
        if names:
            message += f", by {names}"
        self.unresolved.append(Unresolved(message, state.file, item.place, is_wrong=True))

    def _value(self, text: Text, state: State, item: Item, what: str) -> str | None:
        found = state.scope.value(text)
        if found is None:
            self._tell(state, item, what, text)
        return found

    def _tell(
        self, state: State, item: Item, what: str, text: Text, *, is_value: bool = False
    ) -> None:
        unknown = state.scope.unknown(text)
        shown = f"`{text}`" if unknown is None else f"`{Text((unknown,))}`"
        message = f"{what} is left out: {shown} is not known here"
        self._left_out(state, item, message, is_value=is_value)

    def _left_out(self, state: State, item: Item, message: str, *, is_value: bool = False) -> None:
        self.unresolved.append(Unresolved(message, state.file, item.place, is_value=is_value))

    def _sets(self, parameter: str) -> None:
        """Note that what is left out last may give a parameter its value, "" for any."""
        last = self.unresolved[-1]
        self.unresolved[-1] = last._replace(parameter=parameter, sets_parameters=True)


def _unknown_in(item: Include, state: State, known: Mapping[str, str]) -> frozenset[str]:
    """Return the arguments that an included file is given, and whose values are not known."""
    around = state.scope.unknown_arguments if state.ros_version == 2 else ()
    return frozenset((*around, *(name for name, _ in item.arguments))) - known.keys()
