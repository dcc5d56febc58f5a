"""Actions of launch files in Python that do something later: timers, event handlers, functions.

Sources: the classes of `launch.actions`, `launch.event_handlers` and
`launch_ros.event_handlers`: what a handler does is its argument `on_exit`, `on_start` and such, or
`entities`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from plastron_tui.ros.launch import Condition, Group, Item, Place, Unread
from plastron_tui.ros.launch_text import Kind, Substitution, Text, text

from .python_actions import SEQUENCES, Computed, when
from .python_functions import Function

_HANDLERS = (
    "EventHandler", "OnExecutionComplete", "OnIncludeLaunchDescription", "OnProcessExit",
    "OnProcessIO", "OnProcessStart", "OnShutdown", "OnStateTransition",
)  # fmt: skip
_DOES = ("on_completion", "on_exit", "on_shutdown", "on_start", "on_stderr", "on_stdin",
         "on_stdout", "entities")  # fmt: skip


@dataclass(frozen=True, slots=True)
class Opaque(Item):
    """A function that is called when the launch file runs, and returns what is done then."""

    function: Function
    positional: tuple[Any, ...] = ()
    named: Mapping[str, Any] = field(default_factory=dict)


class Handler(NamedTuple):
    """What is done when something happens."""

    event: str
    items: tuple[Item, ...]


def maybe(items: Iterable[Item], what: str, place: Place | None) -> Group:
    """Return items of which nobody knows whether they are done."""
    unknown = Text((Substitution(Kind.OTHER, text(what)),))
    return Group(tuple(items), is_scoped=False, condition=Condition(unknown), place=place)


def items_in(value: Any, place: Place | None) -> Iterator[Item]:
    """Yield what a value that is done holds: an action, a list of such, or nothing."""
    if isinstance(value, Item):
        yield value
    elif type(value) in SEQUENCES:
        for each in value:
            yield from items_in(each, place)
    elif value is not None:
        what = value.what if isinstance(value, Computed) else "a value"
        yield Unread(f"`{what}`", place=place)


def _description(positional: list[Any], named: dict[str, Any], place: Place) -> Item:
    return Group(tuple(items_in([*positional, *named.values()], place)), False, place=place)


def _timer(positional: list[Any], named: dict[str, Any], place: Place) -> Item | None:
    actions = named.get("actions")
    if not isinstance(actions, list):
        return None
    period = Unread("the period of a `TimerAction`", place=place)
    items = (period, *items_in(actions, place))
    return Group(items, is_scoped=False, condition=when(named), place=place)


def _handler(event: str) -> Any:
    def make(positional: list[Any], named: dict[str, Any], place: Place) -> Handler | None:
        found: list[Item] = []
        for value in (named[key] for key in _DOES if key in named):
            if isinstance(value, Function):
                found.append(Opaque(value, (Computed("event"), Computed("context")), place=place))
            else:
                found += (x for x in items_in(value, place) if not isinstance(x, Unread))
        return Handler(event, tuple(found)) if found else None

    return make


def _register(positional: list[Any], named: dict[str, Any], place: Place) -> Item | None:
    found = positional[0] if positional else named.get("event_handler")
    return maybe(found.items, found.event, place) if isinstance(found, Handler) else None


def _opaque(positional: list[Any], named: dict[str, Any], place: Place) -> Item | None:
    function, args, kwargs = (named.get(key) for key in ("function", "args", "kwargs"))
    words: dict[str, Any] = {}
    if not isinstance(function, Function) or not isinstance(kwargs, (dict, type(None))):
        return None
    for key, value in (kwargs or {}).items():
        if key.literal is None:
            return None
        words[key.literal] = value
    if args is not None and type(args) not in SEQUENCES:
        return None
    values = (Computed("context"), *(args or ()))
    return Opaque(function, values, words, condition=when(named), place=place)


LATER: dict[str, Any] = {
    "LaunchDescription": _description,
    "TimerAction": _timer,
    "RegisterEventHandler": _register,
    "OpaqueFunction": _opaque,
    **{event: _handler(event) for event in _HANDLERS},
}
"""What calls come to, by the last word of what is called; None for one that is not understood."""
