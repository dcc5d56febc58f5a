"""What a callback gets besides what ROS gives to every callback of its kind."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.unique_names import numbered

from .analysis import Analysis, Site
from .arguments import Arguments
from .callbacks import is_partial
from .calls import Argument
from .functions import callback_scope
from .scopes import BindingKind

# `rospy.topics.Subscriber` calls `cb(msg, cb_args)` where `callback_args` is not None.
_ARGUMENTS = Argument(3, "callback_args")
_SUBSCRIBER = "rospy.Subscriber"
_FUNCTION = Argument(0, "")

Parameter = tuple[str, str]
"""The name of a parameter and its type, "" where it says none."""


@dataclass(frozen=True, slots=True)
class HandedOn:
    """What a callback gets before and behind what ROS gives it, by the names of the parameters."""

    before: tuple[str, ...] = ()
    behind: tuple[str, ...] = ()

    def __len__(self) -> int:
        """Return how many arguments these are."""
        return len(self.before) + len(self.behind)

    def around(self, own: Sequence[Parameter]) -> list[Parameter]:
        """Return the parameters for what ROS gives with those for the rest around them."""
        taken = {name for name, _ in own}
        before = [_untyped(name, taken) for name in self.before]
        return [*before, *own, *(_untyped(name, taken) for name in self.behind)]


def handed_by_call(analysis: Analysis, site: Site, before: int = 0) -> HandedOn:
    """Return what a call says that its callback gets: the `callback_args` of rospy.

    Args:
        analysis: the file.
        site: the call.
        before: how many arguments the callback gets before the message.
    """
    is_subscriber = _SUBSCRIBER in site.shape.callees
    given = site.arguments.get(_ARGUMENTS) if is_subscriber else None
    if given is None or given.type == "none":
        return HandedOn()
    return HandedOn(behind=(_parameters(analysis, site).get(before + 1, "args"),))


def handed_by_partial(analysis: Analysis, site: Site, given: Node) -> tuple[Node, HandedOn] | None:
    """Return the function that a callback wraps in `functools.partial`, and what that hands on."""
    if given.type != "call" or not is_partial(given, site.scope, analysis):
        return None
    arguments = Arguments.of(given, analysis.syntax)
    function = arguments.get(_FUNCTION)
    if function is None or function.type == "call" or arguments.is_open:
        return None
    named = _parameters(analysis, site)
    before = (named.get(index, "value") for index in range(len(arguments.positional) - 1))
    return function, HandedOn(tuple(before), tuple(arguments.keywords))


def _parameters(analysis: Analysis, site: Site) -> dict[int, str]:
    """Return what the callback that a call has calls what it gets, by position."""
    function = callback_scope(analysis, site)
    if function is None:
        return {}
    return {
        binding.index - bool(function.self_name): name
        for name, bindings in function.bindings.items()
        for binding in bindings
        if binding.kind is BindingKind.PARAMETER and binding.index >= 0
    }


def _untyped(wanted: str, taken: set[str]) -> Parameter:
    """Return a parameter of a free name, which is taken from then on."""
    name = next(each for each in numbered(wanted) if each not in taken)
    taken.add(name)
    return name, ""
