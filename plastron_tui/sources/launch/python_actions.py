"""What the classes of `launch` and `launch_ros` say in a launch file in Python."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from itertools import chain
from typing import Any, NamedTuple

from tree_sitter import Node

from plastron_tui.ros.launch import (
    Argument,
    Condition,
    Container,
    Group,
    Include,
    Item,
    Namespace,
    Parameter,
    ParameterFile,
    ParameterValue,
    Place,
    Remap,
    Remapping,
    SetParameter,
    StartedNode,
    Unread,
    Variable,
)
from plastron_tui.ros.launch_text import Kind, Substitution, Text, text
from plastron_tui.ros.launch_values import as_value, typed

_Named = dict[str, Any]
_Action = Callable[[list[Any], _Named, Place], Any]


class Computed(NamedTuple):
    """A value that is only known when the file runs: what it is, for a person."""

    what: str


class Written(tuple[Any, ...]):
    """A tuple of Python, and where it stands."""

    place: Place


SEQUENCES = (list, tuple, Written)
"""The classes of lists and tuples of Python; those above are tuples, but none of Python's."""


class _TypedText(NamedTuple):
    """A `ParameterValue` of Python: its text stays one, where `is_text`."""

    value: Any
    is_text: bool
    is_float: bool


class _File(NamedTuple):
    """A `ParameterFile` of Python."""

    file: Text


def placed(node: Node) -> Place:
    """Return where something stands."""
    return Place(node.start_byte, node.end_byte, node.start_point[0] + 1)


def as_text(value: Any) -> Text | None:
    """Return a value as a text; a list is the texts of its elements, one behind the other."""
    if isinstance(value, Text):
        return value if type(value) is Text else Text(value.parts)
    if isinstance(value, bool):
        return text(str(value))
    if isinstance(value, (str, int, float)):
        return text(str(value))
    if type(value) in SEQUENCES:
        found = [as_text(each) for each in value]
        known = [each for each in found if each is not None]
        return text(*known) if len(known) == len(found) else None
    return None


_WORDS = ("package", "name", "variable_name", "command", "path")
"""What the first argument of a substitution is called, where it has a name."""


def _of(kind: Kind) -> _Action:
    def make(positional: list[Any], named: _Named, place: Place) -> Text | None:
        values = [*positional, *(named[key] for key in _WORDS if key in named)]
        name = as_text(values[0]) if values else None
        if kind is Kind.FOLDER:
            return Text((Substitution(kind, text()),))
        if name is None:
            return None
        default = _optional(named.get("default_value", named.get("default")))
        return Text((Substitution(kind, name, default),))

    return make


def _joined(positional: list[Any], named: _Named, place: Place) -> Text | None:
    parts = positional[0] if len(positional) == 1 else positional
    if not isinstance(parts, list):
        return as_text(parts)
    found: list[Text] = []
    for part in parts:
        value = as_text(part)
        if value is None:
            return None
        if found:
            found.append(text("/"))
        found.append(value)
    return text(*found)


def _first(positional: list[Any], named: _Named, place: Place) -> Any:
    values = [*positional, *named.values()]
    return values[0] if values else None


def _condition(negated: bool) -> _Action:
    def make(positional: list[Any], named: _Named, place: Place) -> Condition | None:
        value = as_text(_first(positional, named, place))
        return None if value is None else Condition(value, negated)

    return make


def when(named: _Named) -> Condition | None:
    """Return the condition of an action; one that is computed is a text that nobody knows."""
    found = named.get("condition")
    if found is None or isinstance(found, Condition):
        return found
    what = found.what if isinstance(found, Computed) else "a condition"
    return Condition(Text((Substitution(Kind.OTHER, text(what)),)))


def _argument(positional: list[Any], named: _Named, place: Place) -> Item | None:
    name = positional[0] if positional else named.get("name")
    if not isinstance(name, str):
        return None
    given = named.get("default_value", positional[1] if len(positional) > 1 else None)
    default = as_text(given)
    if default is None and given is not None:
        default = unknown_text(given)
    about = named.get("description")
    about = about if isinstance(about, str) else ""
    return Argument(name, default, about, condition=when(named), place=place)


def unknown_text(value: Any) -> Text:
    """Return the text that stands for a value which nobody knows."""
    what = value.what if isinstance(value, Computed) else "a value"
    return Text((Substitution(Kind.OTHER, text(what)),))


def _optional(value: Any) -> Text | None:
    if value is None:
        return None
    found = as_text(value)
    return unknown_text(value) if found is None else found


def _node(executable: str) -> _Action:
    def make(positional: list[Any], named: _Named, place: Place) -> StartedNode | None:
        started = _optional(named.get(executable, named.get("node_executable")))
        if started is None:
            return None
        known = ("package", executable, "node_executable", "name", "node_name", "namespace",
                 "node_namespace", "remappings", "parameters", "condition",
                 "composable_node_descriptions")  # fmt: skip
        others = ((key, as_text(value) or unknown_text(value)) for key, value in named.items()
                  if key not in known)  # fmt: skip
        return StartedNode(
            _optional(named.get("package")) or text(),
            started,
            _optional(named.get("name", named.get("node_name"))),
            _optional(named.get("namespace", named.get("node_namespace"))),
            tuple(_remaps(named.get("remappings"))),
            tuple(_parameters(named.get("parameters"))),
            tuple((key, _lower_flag(value)) for key, value in others),
            condition=when(named),
            place=place,
        )

    return make


def _lower_flag(value: Text) -> Text:
    return text(value.literal.lower()) if value.literal in ("True", "False") else value


def _remaps(found: Any) -> Iterable[Remapping]:
    if isinstance(found, Computed):
        yield Remapping(unknown_text(found), unknown_text(found))
    for each in found if isinstance(found, list) else ():
        pair: Any = each if type(each) in SEQUENCES else ()
        if len(pair) == 2:
            place = each.place if isinstance(each, Written) else None
            yield Remapping(_optional(pair[0]) or text(), _optional(pair[1]) or text(), place)
        else:
            yield Remapping(unknown_text(each), unknown_text(each))


def _parameters(found: Any) -> Iterable[Parameter]:
    if isinstance(found, Computed):
        yield ParameterFile(unknown_text(found))
    for each in found if isinstance(found, list) else ():
        if isinstance(each, dict):
            yield from _values(each, text())
        elif isinstance(each, _File):
            yield ParameterFile(each.file)
        else:
            yield ParameterFile(as_text(each) or unknown_text(each))


def _values(found: dict[Any, Any], before: Text) -> Iterable[ParameterValue]:
    for key, value in found.items():
        name = replace(text(before, "." if before.parts else "", key), span=key.span)
        if isinstance(value, dict):
            yield from _values(value, name)
        elif isinstance(value, _TypedText):
            inner = as_text(value.value) or unknown_text(value.value)
            literal = inner.literal if value.is_text else None
            yield ParameterValue(name, inner if literal is None else literal,
                                 value.is_text and literal is None, value.is_float)  # fmt: skip
        else:
            yield _value(name, value)


def _value(name: Text, value: Any) -> ParameterValue:
    setting = None if isinstance(value, Computed) else as_value(value)
    if isinstance(setting, str):
        setting = typed(setting, 2)
    if setting is not None:
        return ParameterValue(name, setting)
    return ParameterValue(name, as_text(value) or unknown_text(value))


def _container(positional: list[Any], named: _Named, place: Place) -> Container | None:
    node = _node("executable")(positional, {**named, "condition": None}, place)
    if node is None:
        return None
    parts = _components(named.get("composable_node_descriptions"))
    return Container(node, None, parts, condition=when(named), place=place)


def _load(positional: list[Any], named: _Named, place: Place) -> Container | None:
    target = _optional(named.get("target_container"))
    parts = _components(named.get("composable_node_descriptions"))
    if target is None:
        return None
    return Container(None, target, parts, condition=when(named), place=place)


def _components(found: Any) -> tuple[StartedNode, ...]:
    if isinstance(found, Group):
        # What an `if` adds to the list hangs on its condition.
        return tuple(
            replace(each, condition=found.condition or each.condition)
            for each in _components(list(found.items))
        )
    if isinstance(found, StartedNode):
        return (found,)
    if type(found) in SEQUENCES:
        return tuple(chain.from_iterable(map(_components, found)))
    return () if found is None else (StartedNode(unknown_text(found), text()),)


def _include(positional: list[Any], named: _Named, place: Place) -> Include | None:
    source = positional[0] if positional else named.get("launch_description_source")
    if source is None:
        return None
    given = named.get("launch_arguments") or []
    if isinstance(given, dict):
        given = list(given.items())
    if not isinstance(given, list):
        return None
    arguments = []
    for pair in given:
        if not isinstance(pair, (tuple, list)) or len(pair) != 2:
            return None
        name = as_text(pair[0])
        if name is None or name.literal is None:
            return None
        arguments.append((name.literal, as_text(pair[1]) or unknown_text(pair[1])))
    file = as_text(source) or unknown_text(source)
    return Include(file, tuple(arguments), condition=when(named), place=place)


def _group(positional: list[Any], named: _Named, place: Place) -> Group | None:
    actions = positional[0] if positional else named.get("actions")
    if not isinstance(actions, list):
        return None
    items = tuple(
        each if isinstance(each, Item)
        else Unread(f"`{each.what if isinstance(each, Computed) else 'a value'}`", place=place)
        for each in actions
    )  # fmt: skip
    is_scoped = named.get("scoped") is not False
    return Group(items, is_scoped, condition=when(named), place=place)


def _namespace(positional: list[Any], named: _Named, place: Place) -> Namespace | None:
    found = _optional(positional[0] if positional else named.get("namespace"))
    return None if found is None else Namespace(found, condition=when(named), place=place)


def _set_remap(positional: list[Any], named: _Named, place: Place) -> Remap | None:
    pair = [*positional, *(named[key] for key in ("src", "dst") if key in named)]
    found = [_optional(each) for each in pair]
    if len(found) != 2 or found[0] is None or found[1] is None:
        return None
    return Remap(found[0], found[1], condition=when(named), place=place)


def _set_parameter(positional: list[Any], named: _Named, place: Place) -> SetParameter | None:
    pair = [*positional, *(named[key] for key in ("name", "value") if key in named)]
    name = as_text(pair[0]) if len(pair) == 2 else None
    if name is None:
        return None
    return SetParameter(_value(name, pair[1]), condition=when(named), place=place)


def _variable(positional: list[Any], named: _Named, place: Place) -> Variable | None:
    pair = [*positional, *(named[key] for key in ("name", "value") if key in named)]
    name = as_text(pair[0]) if len(pair) == 2 else None
    if name is None or name.literal is None:
        return None
    value = as_text(pair[1]) or unknown_text(pair[1])
    return Variable(name.literal, value, condition=when(named), place=place)


def _typed(positional: list[Any], named: _Named, place: Place) -> _TypedText:
    value = positional[0] if positional else named.get("value")
    kind = named.get("value_type")
    word = kind.what if isinstance(kind, Computed) else ""
    return _TypedText(value, word == "str", word == "float")


def _file(positional: list[Any], named: _Named, place: Place) -> _File:
    found = _first(positional, named, place)
    return _File(as_text(found) or unknown_text(found))


ACTIONS: dict[str, _Action] = {
    "LaunchConfiguration": _of(Kind.ARGUMENT),
    "FindPackageShare": _of(Kind.PACKAGE),
    "get_package_share_directory": _of(Kind.PACKAGE),
    "get_package_share_path": _of(Kind.PACKAGE),
    "EnvironmentVariable": _of(Kind.ENVIRONMENT),
    "ThisLaunchFileDir": _of(Kind.FOLDER),
    "FileContent": _of(Kind.CONTENT),
    "Command": _of(Kind.COMMAND),
    "PathJoinSubstitution": _joined,
    "join": _joined,
    "TextSubstitution": _first,
    "PythonLaunchDescriptionSource": _first,
    "XMLLaunchDescriptionSource": _first,
    "FrontendLaunchDescriptionSource": _first,
    "AnyLaunchDescriptionSource": _first,
    "YAMLLaunchDescriptionSource": _first,
    "IfCondition": _condition(False),
    "UnlessCondition": _condition(True),
    "DeclareLaunchArgument": _argument,
    "SetLaunchConfiguration": _variable,
    "Node": _node("executable"),
    "LifecycleNode": _node("executable"),
    "ComposableNode": _node("plugin"),
    "ComposableNodeContainer": _container,
    "LoadComposableNodes": _load,
    "IncludeLaunchDescription": _include,
    "GroupAction": _group,
    "PushRosNamespace": _namespace,
    "PushROSNamespace": _namespace,
    "SetRemap": _set_remap,
    "SetParameter": _set_parameter,
    "ParameterValue": _typed,
    "ParameterFile": _file,
}
"""What calls come to, by the last word of what is called; None for one that is not understood."""
