"""A parameter of a node: its name, its type, its default, its range and what it is for."""

from __future__ import annotations

from plastron_tui.language import SlotKind
from plastron_tui.language.sentence import quoted
from plastron_tui.ros.interfaces import FieldType
from plastron_tui.ros.names import check_parameter_name
from plastron_tui.ros.parameters import ParameterType

from .ask import Ask, Choice
from .context import free_name
from .form import Cell
from .kind import OF_THE_LIST, Kind, name_problem
from .taken_back import nothing_to_take, taken_back
from .values import Entry, Python, problem_of, written

_TYPES: dict[ParameterType, tuple[str, Python]] = {
    ParameterType.BOOL: ("bool", bool),
    ParameterType.INT: ("int64", int),
    ParameterType.FLOAT: ("float64", float),
    ParameterType.STRING: ("string", str),
}
"""The type of a field that holds what a parameter does, and that of its values in Python."""

_ABOUT = {
    ParameterType.BOOL: "yes or no",
    ParameterType.INT: "a whole number",
    ParameterType.FLOAT: "a number",
    ParameterType.STRING: "a text",
    ParameterType.BOOL_LIST: "a list of yes or no",
    ParameterType.INT_LIST: "a list of whole numbers",
    ParameterType.FLOAT_LIST: "a list of numbers",
    ParameterType.STRING_LIST: "a list of texts",
}
_USUAL = {
    ParameterType.BOOL: "True",
    ParameterType.INT: "1",
    ParameterType.FLOAT: "0.5",
    ParameterType.STRING: "hello",
}


def _type_of(ask: Ask) -> ParameterType | None:
    try:
        return ParameterType(ask.text(SlotKind.PARAMETER_TYPE))
    except ValueError:
        return None


def _entry(ask: Ask, type_: ParameterType) -> Entry:
    """Return the default as a field of a message."""
    return parameter_entry(ask.slot.name, type_)


def parameter_entry(name: str, type_: ParameterType) -> Entry:
    """Return a parameter as a field of a message."""
    primitive, python = _TYPES[type_.element]
    return Entry((name,), FieldType(primitive, is_array=type_.is_list), python, _ABOUT[type_])


class ParameterKind(Kind):
    """The name of a parameter."""

    def suggest(self, ask: Ask) -> str:
        """Return a name that the node has none of; of those to be taken away, the first."""
        if ask.form.declaration.undoes is not None:
            return next((each.text for each in taken_back(ask) if not each.closed), "")
        return free_name("speed", ask.scene.parameters(ask.node))

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those that can be taken away."""
        return taken_back(ask) if ask.form.declaration.undoes is not None else []

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if text:
            return name_problem(check_parameter_name(text, ask.version))
        if ask.form.declaration.undoes is not None:
            return nothing_to_take(ask)
        return "a parameter needs a name, such as `speed`"


class ParameterTypeKind(Kind):
    """What a parameter holds."""

    def suggest(self, ask: Ask) -> str:
        """Return the type that most have: a number."""
        return ParameterType.FLOAT.value

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all types."""
        return [Choice(each.value, about) for each, about in _ABOUT.items()]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        known = {each.value for each in ParameterType}
        return None if text in known else f"no such type: {OF_THE_LIST}"


class DefaultKind(Kind):
    """The value that a parameter has where none is set; texts are entered without their quotes."""

    def suggest(self, ask: Ask) -> str:
        """Return a value of the type."""
        type_ = _type_of(ask)
        return "" if type_ is None else _USUAL[type_.element]

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return what there is where it is either this or that."""
        is_switch = _type_of(ask) is ParameterType.BOOL
        return [Choice("True"), Choice("False")] if is_switch else []

    def written(self, ask: Ask, text: str) -> str:
        """Return a value as the program has it."""
        type_ = _type_of(ask)
        return text if type_ is None else written(_entry(ask, type_), text)

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a value is not of the type."""
        type_ = _type_of(ask)
        if type_ is None:
            return None
        if not text:
            return f"a value is needed, such as {_USUAL[type_.element]}"
        return problem_of(_entry(ask, type_), text, ask.version)


class BoundKind(Kind):
    """The least or the greatest value of a parameter."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return that there is none where it is not about numbers."""
        type_ = _type_of(ask)
        has_range = type_ is None or type_.is_number
        return None if has_range else Cell("", "only a number has a range")

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no number."""
        type_ = _type_of(ask)
        return None if type_ is None else problem_of(_entry(ask, type_), text, ask.version)


class TextKind(Kind):
    """A text, which is entered without its quotes."""

    def written(self, ask: Ask, text: str) -> str:
        """Return the text as the program has it."""
        return quoted(text)
