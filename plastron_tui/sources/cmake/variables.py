"""What arguments stand for: variables followed where that is sure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from .syntax import Argument, Command

_MOST = 2_000
"""Values of one list, and bytes of one value: more were written to keep a reader busy."""


@dataclass(frozen=True, slots=True)
class Item:
    """A value of a command, and where it is written.

    Attributes:
        value: what it is; a reference that is not followed is left in it, as `${NAME}`.
        argument: the argument that says it, in the call of `set` for one of a variable.
        command: the command of that argument.
        is_pattern: whether it is a pattern of `file(GLOB …)`.
        is_own: whether the value is all that the argument says.
    """

    value: str
    argument: Argument
    command: Command
    is_pattern: bool = False
    is_own: bool = True


@dataclass(slots=True)
class Variable:
    """A list that a name stands for.

    Attributes:
        items: what is in it for sure.
        is_whole: whether that is all.
        setting: the `set` or `list(APPEND)` that wrote its last items, None in a branch.
    """

    items: list[Item] = field(default_factory=list)
    is_whole: bool = True
    setting: Command | None = None


class Variables:
    """The variables as they are at one place of a file."""

    def __init__(self) -> None:
        self._known: dict[str, Variable] = {}

    def get(self, name: str) -> Variable | None:
        """Return what a name stands for, None where that is not known."""
        return self._known.get(name)

    def copy(self) -> Variables:
        """Return the same variables, for a branch."""
        copied = Variables()
        copied._known = dict(self._known)
        return copied

    def put(self, name: str, variable: Variable | None) -> None:
        """Say what a name stands for from here on, None for what is not known."""
        if variable is None or len(variable.items) > _MOST:
            self._known.pop(name, None)
        else:
            self._known[name] = variable

    def after_branch(self, branch: Variables) -> None:
        """Take over what may have changed in a branch: what is sure is what stands in both."""
        for name in {*self._known, *branch._known}:
            here, there = self._known.get(name), branch._known.get(name)
            if here is there:
                continue
            if here is None or there is None or there.items[: len(here.items)] != here.items:
                self._known.pop(name, None)
            else:
                self._known[name] = Variable(here.items, False, here.setting)

    def become(self, other: Variables) -> None:
        """Take over the variables as they are elsewhere."""
        self._known = dict(other._known)

    def forget_changed(self, other: Variables) -> None:
        """Forget what is not the same elsewhere."""
        for name in list(self._known):
            if other._known.get(name) is not self._known[name]:
                del self._known[name]

    def expand(self, argument: Argument, command: Command) -> list[Item]:
        """Return the values of an argument."""
        if argument.is_bracket:
            return [Item(argument.value, argument, command)]
        alone = _alone(argument)
        variable = self.get(alone) if alone else None
        if variable is not None and not argument.is_quoted:
            return [part for each in variable.items for part in split_list(each)]
        value = self.substituted(argument.value)
        if argument.is_quoted or "$<" in value:
            return [Item(value, argument, command)]
        parts = [part for part in value.split(";") if part]
        is_own = len(parts) == 1
        return [Item(part, argument, command, False, is_own) for part in parts]

    def is_whole(self, arguments: Sequence[Argument]) -> bool:
        """Whether all references of arguments that are nothing else are known."""
        for each in arguments:
            alone = _alone(each)
            variable = self.get(alone) if alone else None
            if alone and (variable is None or not variable.is_whole):
                return False
        return True

    def substituted(self, value: str) -> str:
        """Return a value with what is known of `${NAME}` in its place, the innermost first."""
        end = value.find("}")
        while end >= 0 and len(value) <= _MOST:
            start = value.rfind("${", 0, end)
            known = self.get(value[start + 2 : end]) if start >= 0 else None
            if known is None or not known.is_whole or any(each.is_pattern for each in known.items):
                end = value.find("}", end + 1)
                continue
            text = ";".join(each.value for each in known.items)
            value = value[:start] + text + value[end + 1 :]
            end = value.find("}", start + len(text))
        return value


def split_list(item: Item) -> list[Item]:
    """Return the values of one that was written as a list within quotes."""
    if ";" not in item.value or "$<" in item.value:
        return [item]
    parts = [each for each in item.value.split(";") if each]
    return [replace(item, value=each, is_own=False) for each in parts]


def _alone(argument: Argument) -> str | None:
    """Return the name of a variable that an argument is nothing but a reference to."""
    value = argument.value
    name = value[2:-1]
    is_reference = value.startswith("${") and value.endswith("}") and not set("${};") & set(name)
    return name if is_reference and name else None


def reference_of(argument: Argument) -> str | None:
    """Return the name that an unquoted argument is nothing but a reference to."""
    return None if argument.is_quoted else _alone(argument)


def appended(variable: Variable | None, items: list[Item], setting: Command) -> Variable | None:
    """Return a variable with more items at its end."""
    if variable is None:
        return None
    return replace(variable, items=[*variable.items, *items], setting=setting)
