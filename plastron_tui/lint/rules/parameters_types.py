"""Values of parameters that are of another type than the parameter."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, Fix, Span, write
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import SettingPlace, SourceTree
from plastron_tui.ros.parameter_blocks import ParameterKey
from plastron_tui.ros.parameter_values import Mistake, parse_value
from plastron_tui.ros.parameters import Setting

from .parameters_examples import GIVEN, given
from .parameters_given import Declared, Given, Receivers, receivers_of, settings

_NAMES = {bool: "bool", int: "int", float: "float", str: "string"}
_SHOWN = {
    "bool": "a bool",
    "int": "an int",
    "float": "a float",
    "string": "a string",
}


@rule(
    "RP303",
    "wrong-parameter-type",
    "A parameter gets a value of another type than it is declared with.",
    why="ROS 2 refuses it, and the node ends as it declares the parameter: not even an int is "
    "taken for a float. Words such as `on` and `yes` are bools, and digits without quotes are "
    "numbers. A list is of one type. A parameter whose type is not sure, or may change "
    "(`dynamic_typing`), takes any value.",
    bad=given("max_speed: 1"),
    good=GIVEN,
)
def wrong_parameter_type(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find values that the nodes which get them refuse."""
    receivers = receivers_of(tree)
    told: set[tuple[Path, Span]] = set()
    for each in receivers.given:
        for found in _wrong_values(code, each):
            if found.span is not None and (each.file, found.span) not in told:
                told.add((each.file, found.span))
                yield found
    yield from _wrong_settings(tree, code, receivers)


def _wrong_values(code: Code, given: Given) -> Iterator[Diagnostic]:
    for key in given.block.keys:
        for node in given.nodes:
            wanted = node.type_of(key.name)
            is_loaded = node.node.started is not None and node.node.started.container is not None
            if key.problem and key.name in node.uses and not is_loaded:
                message = f"{key.problem}, and `{key.name}` mixes several: ROS 2 refuses the file"
                yield Diagnostic(
                    code,
                    message,
                    key.span,
                    given.file,
                    help="write each number with a point: `1.0`",
                    labels=node.label(key.name),
                )
                break
            if wanted is not None and key.value is not None and is_wrong(key.value, wanted):
                yield _told(
                    code, node, key.name, key.value, key.span, given.file, _fix(key, wanted)
                )
                break


def _wrong_settings(tree: SourceTree, code: Code, receivers: Receivers) -> Iterator[Diagnostic]:
    """Find what a launch file itself sets, and the node that it starts refuses."""
    done: set[SettingPlace] = set()
    for receiver in receivers.all:
        values = dict(receiver.started.parameters)
        for name, place, span in settings(tree, receiver):
            for node in receiver.nodes:
                wanted, value = node.type_of(name), values.get(name)
                if wanted is None or value is None:
                    continue
                if is_wrong(value, wanted) and place not in done:
                    done.add(place)
                    yield _told(code, node, name, value, span, Path(place.file), None)


def is_wrong(value: Setting, wanted: str) -> bool:
    """Tell whether a parameter of a type refuses a value."""
    return wanted != "byte_list" and kind_of(value) not in (None, wanted)


def kind_of(value: Setting) -> str | None:
    """Return the type that ROS 2 takes a value for, None for a list without elements."""
    if not isinstance(value, tuple):
        return _NAMES[type(value)]
    return f"{_NAMES[type(value[0])]}_list" if value else None


def _told(
    code: Code,
    node: Declared,
    name: str,
    value: Setting,
    span: Span,
    file: Path,
    fix: Fix | None,
) -> Diagnostic:
    wanted, kind = node.type_of(name) or "", kind_of(value) or ""
    return Diagnostic(
        code,
        f"`{name}` of `{node.node.full_name}` is {shown(wanted)}, and this is {shown(kind)}: "
        "ROS 2 refuses it",
        span,
        file,
        help=_help(value, wanted),
        fix=fix,
        labels=node.label(name),
    )


def shown(type_: str) -> str:
    """Return how people call a type of parameters."""
    if type_.endswith("_list"):
        return f"a list of {type_.removesuffix('_list')}s"
    return _SHOWN.get(type_, type_)


def _help(value: Setting, wanted: str) -> str | None:
    if wanted == "float" and type(value) is int:
        return f"write `{value}.0`"
    if wanted == "float_list" and isinstance(value, tuple) and type(value[0]) is int:
        return f"write each number with a point: `{value[0]}.0`"
    if wanted == "string" and not isinstance(value, tuple):
        return "write it in quotes"
    if isinstance(value, str) and kind_of_text(value) == wanted:
        return "write it without quotes"
    return None


def kind_of_text(text: str) -> str | None:
    """Return the type that a text has without quotes."""
    found = parse_value(text)
    return None if isinstance(found, Mistake) else kind_of(found)


def _fix(key: ParameterKey, wanted: str) -> Fix | None:
    """Return the fix that writes an int as a float, None for other values."""
    if wanted != "float" or type(key.value) is not int:
        return None
    # What is written with digits of another base is no number of so many digits.
    is_plain = key.span.end - key.span.start == len(str(key.value))
    return write(f"{key.value}.0", key.span) if is_plain else None
