"""Types of the program's own: their names, their fields, their files."""

from __future__ import annotations

from pathlib import PurePath

from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.language.sentence import quoted
from plastron_tui.model.own_types import OwnType
from plastron_tui.ros.interfaces import Constant, Field, Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.primitives import PRIMITIVES, other_word, primitive

from ..folder_files import found_files, path_text
from .ask import Ask, Choice
from .context import free_name
from .form import Cell
from .kind import OF_THE_LIST, Kind

EXAMPLES = {
    "fields": "float64 value",
    "request": "float64 value",
    "response": "bool success",
    "goal": "float64 value",
    "result": "bool success",
    "feedback": "float64 progress",
}
"""The first field of each part of a definition, as long as nobody entered one."""

_PRIMITIVES = (
    ("float64", "a number with a fraction"),
    ("int32", "a whole number"),
    ("bool", "true or false"),
    ("string", "a text"),
    ("float64[]", "as many numbers as there are"),
    ("uint8", "a whole number from 0 to 255"),
    ("int64", "a large whole number"),
    ("string[]", "texts"),
)
"""The types that most fields have."""

_USUAL = ("std_msgs/Header", "geometry_msgs/Point", "geometry_msgs/Pose", "geometry_msgs/Twist")
_NAMES = {
    st.CreateMessageType: "MyMessage",
    st.CreateServiceType: "MyService",
    st.CreateActionType: "MyAction",
}
_SECTIONS = {
    InterfaceKind.MESSAGE: (),
    InterfaceKind.SERVICE: ("request", "response"),
    InterfaceKind.ACTION: ("goal", "result", "feedback"),
}
_SUFFIXES = frozenset({".msg", ".srv", ".action"})


class TypeNameKind(Kind):
    """The name of a new type."""

    def suggest(self, ask: Ask) -> str:
        """Return a name that no type has."""
        wanted = _NAMES.get(ask.form.declaration.type, "MyType")
        return free_name(wanted, ask.scene.workspace.types)

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            return "a type needs a name, such as `WheelSpeed`"
        if not all(part.isascii() and part.isidentifier() for part in text.split("/")):
            return "a type has letters and digits, a capital first, such as `WheelSpeed`"
        if text in ask.scene.workspace.types:
            return f"a type is called `{text}` already: choose another name"
        return None


class FieldsKind(Kind):
    """The fields of a part of a definition; each has a row of its own."""


def field_choices(ask: Ask, query: str) -> list[Choice]:
    """Return the types that a field can begin with; its name comes behind."""
    word, space, _ = query.lstrip().partition(" ")
    if space:
        return []
    own = [
        Choice(f"{name} ", "a message of your own")
        for name, each in ask.scene.workspace.types.items()
        if each.kind is InterfaceKind.MESSAGE
    ]
    usual = [
        Choice(f"{ask.scene.written(found.name, InterfaceKind.MESSAGE, ask.version)} ", name)
        for name in _USUAL
        if (found := ask.scene.resolve(name, InterfaceKind.MESSAGE, ask.version)) is not None
    ]
    choices = [*(Choice(f"{name} ", note) for name, note in _PRIMITIVES), *own, *usual]
    folded = word.lower()
    return [each for each in choices if folded in each.text.lower()]


def field_problem(text: str) -> str | None:
    """Tell why a text is no field, as far as its shape tells."""
    words = text.replace("=", " = ").split()
    if len(words) == 1:
        if _may_be_type(words[0]):
            return f"the field needs a name: `{words[0]} speed`, say"
        return f"the field needs a type before its name: `float64 {words[0]}`, say"
    if '"' not in text and "'" not in text and "[" not in text and "," in text:
        return "each field has a line of its own"
    return None


def _may_be_type(word: str) -> bool:
    """Tell whether a word is a type as far as its shape tells, and no name of a field."""
    return (
        not (word.isascii() and word.isidentifier() and word.islower())
        or any(primitive(word, version) is not None for version in PRIMITIVES)
        or other_word(word) is not None
    )


class DefinitionKind(Kind):
    """A field that a type gets, entered without its quotes."""

    def suggest(self, ask: Ask) -> str:
        """Return a field that the type does not have."""
        names = _field_names(ask)
        return f"float64 {free_name('value', names)}"

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the types that it can begin with."""
        return field_choices(ask, query)

    def written(self, ask: Ask, text: str) -> str:
        """Return it as the program has it."""
        return quoted(text)

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no field."""
        return field_problem(text) if text else "a field is needed, such as `float64 speed`"


class OwnTypeKind(Kind):
    """A type of the program."""

    def suggest(self, ask: Ask) -> str:
        """Return the last one."""
        return next(reversed(ask.scene.workspace.types), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all, the last one first."""
        types = ask.scene.workspace.types
        return [Choice(name, types[name].kind.value) for name in reversed(types)]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not ask.scene.workspace.types:
            return "there is no type of your own yet: make one first"
        return None if text in ask.scene.workspace.types else f"no such type: {OF_THE_LIST}"


class FieldKind(Kind):
    """A field that a type has."""

    def suggest(self, ask: Ask) -> str:
        """Return the last one."""
        return next(reversed(_field_names(ask)), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all."""
        return [Choice(name) for name in _field_names(ask)]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text else "the type has no field that could be taken away"


class SectionKind(Kind):
    """A part of a service or of an action."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return that there is none for a message."""
        return None if _sections(ask) else Cell("", "a message has one part")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the parts."""
        return [Choice(each) for each in _sections(ask)]


class TypeFileKind(Kind):
    """The file of a definition."""

    def suggest(self, ask: Ask) -> str:
        """Return the first that is found."""
        return next((each.text for each in self.choices(ask, "")), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the definition files of the program's folder."""
        folder = ask.scene.session.folder
        found = ask.scene.surroundings.once("types", lambda: found_files(_SUFFIXES, folder))
        return [Choice(path_text(path, folder), path.suffix[1:]) for path in found]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            return "no definition file is beside the program: write the path of one"
        if PurePath(text).suffix not in _SUFFIXES:
            return "a definition file ends in .msg, .srv or .action"
        return None


def own_type(ask: Ask) -> OwnType | None:
    """Return the type that the form is about."""
    return ask.scene.workspace.types.get(ask.text(SlotKind.OWN_TYPE))


def _sections(ask: Ask) -> tuple[str, ...]:
    found = own_type(ask)
    return () if found is None else _SECTIONS[found.kind]


def _definition(ask: Ask) -> Interface | None:
    found = own_type(ask)
    if found is None:
        return None
    return ask.scene.resolve(ask.text(SlotKind.OWN_TYPE), found.kind, ask.version)


def _field_names(ask: Ask) -> list[str]:
    """Return the names of the fields and constants of a part of the type."""
    found = _definition(ask)
    if found is None:
        return []
    parts = _sections(ask)
    wanted = ask.text(SlotKind.SECTION)
    section = found.sections[parts.index(wanted) if wanted in parts else 0]
    items: tuple[Field | Constant, ...] = (*section.fields, *section.constants)
    return [each.name for each in items]


def own_type_to_send(ask: Ask) -> InterfaceName | None:
    """Return the last type of the program that nothing is of yet, of the kind that is asked for."""
    workspace = ask.scene.workspace
    if not workspace.types:
        return None
    used = {type_ for node in workspace.nodes.values() for type_ in node.types}
    used |= {message.value.type for message in workspace.messages.values()}
    for name, each in reversed(workspace.types.items()):
        found = ask.scene.resolve(name, each.kind, ask.version)
        if each.kind is ask.interface and found is not None and found.name not in used:
            return found.name
    return None
