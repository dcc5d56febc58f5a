"""What a statement is: its sentence, its slots, and what is said about it.

A statement is declared once, by a class with a sentence. Lowering, the formatter, the
explanation of a syntax error, completion, forms and the language reference are derived from
the declaration.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from tree_sitter import Node

from plastron_tui.diagnostics import Span

if TYPE_CHECKING:
    from typing_extensions import dataclass_transform
else:

    def dataclass_transform(**_: object) -> Callable[[Any], Any]:
        """Only type checkers need the real one."""
        return lambda decorated: decorated


class Form(Enum):
    """How what fills a slot is written: what is matched, lowered and explained alike."""

    VARIABLE = auto()
    WORD = auto()
    QUOTED = auto()
    TYPE = auto()
    FILE = auto()
    NUMBER = auto()
    VALUES = auto()


class SlotKind(Enum):
    """What fills a slot; a new kind is an entry here, with the form that it is written in.

    Attributes:
        placeholder: how it is written in a usage line.
        words: what it is called in a message.
        form: how it is written in a program.
    """

    NODE_NAME = "'NODE_NAME'", "a node name in single quotes", Form.QUOTED
    NODE_OF_FILE = "'NODE_NAME'", "the name of a node of the file, in single quotes", Form.QUOTED
    NEW_NODE = "VARIABLE", "a variable for the node", Form.VARIABLE, "NODE"
    NEW_MESSAGE = "MESSAGE", "a variable for the message", Form.VARIABLE, "MESSAGE"
    NODE = "VARIABLE", "the variable of a node", Form.VARIABLE
    MESSAGE = "MESSAGE", "the variable of a message", Form.VARIABLE
    TOPIC = "'TOPIC_NAME'", "a topic name in single quotes", Form.QUOTED
    SERVICE = "'SERVICE_NAME'", "a service name in single quotes", Form.QUOTED
    MESSAGE_TYPE = "MESSAGE_TYPE", "a message type", Form.TYPE
    SERVICE_TYPE = "SERVICE_TYPE", "a service type", Form.TYPE
    NAMED = "topic | service | action | parameter", "what is renamed, such as `topic`", Form.WORD
    OLD_NAME = "'OLD_NAME'", "a name in single quotes", Form.QUOTED
    NEW_NAME = "'NEW_NAME'", "a name in single quotes", Form.QUOTED
    INPUT = "VALUES | none", "values, or `none`", Form.VALUES
    RATE = "NUMBER", "a number", Form.NUMBER
    FUNCTION = "FUNCTION", "the name of a function", Form.WORD
    LIBRARY = "CLIENT_LIBRARY", "a client library", Form.WORD
    FILE = "FILE_NAME | 'RELATIVE/PATH.py'", "a file name, or a path in single quotes", Form.FILE

    def __init__(self, placeholder: str, words: str, form: Form, makes: str = "") -> None:
        self.placeholder = placeholder
        self.words = words
        self.form = form
        self._makes = makes

    @property
    def makes(self) -> SlotKind | None:
        """The kind of slot that may name, further down, what this one gives a name to."""
        return SlotKind[self._makes] if self._makes else None

    @property
    def is_variable(self) -> bool:
        """Whether a variable fills the slot."""
        return self.form is Form.VARIABLE

    @property
    def is_quoted(self) -> bool:
        """Whether single quotes are around what fills the slot."""
        return self.form is Form.QUOTED


@dataclass(frozen=True, slots=True)
class Slot:
    """A place in a sentence: the grammar's field, what fills it, and a line about it."""

    name: str
    kind: SlotKind
    help: str


@dataclass(frozen=True, slots=True)
class Clause:
    """A part of a sentence that may be left out."""

    elements: tuple[str | Slot, ...]


Element = str | Slot | Clause
StatementType: TypeAlias = "type[Statement]"


@dataclass(frozen=True, slots=True)
class Declaration:
    """All that is known of a statement.

    Attributes:
        type: the class of its statements.
        kind: the grammar's node.
        elements: its sentence.
        summary: a sentence about it.
        example: a line of it.
        purpose: what somebody wants who writes it, in words that need no ROS.
        ros_term: what ROS calls it, "" where ROS has no word for it.
        about: one sentence for somebody who does not know that word.
        undoes: the statement that it takes back.
        writes_file: whether it writes a node of the program to its file.
    """

    type: type[Statement]
    kind: str
    elements: tuple[Element, ...]
    summary: str
    example: str
    purpose: str = ""
    ros_term: str = ""
    about: str = ""
    undoes: StatementType | None = None
    writes_file: bool = False

    @property
    def keyword(self) -> str:
        """The word that only this statement has."""
        return next(element for element in self.elements if isinstance(element, str))

    @property
    def slots(self) -> tuple[Slot, ...]:
        """The slots, in the order of the sentence."""
        return tuple(
            part
            for element in self.elements
            for part in (element.elements if isinstance(element, Clause) else (element,))
            if isinstance(part, Slot)
        )

    @property
    def usage(self) -> str:
        """The sentence with its slots in capitals, and optional clauses in brackets."""
        return " ".join(map(_usage, self.elements))


def _usage(element: Element) -> str:
    match element:
        case Slot(kind=kind):
            return kind.placeholder
        case Clause(elements=parts):
            return "[" + " ".join(map(_usage, parts)) + "]"
        case word:
            return word


# Not frozen: a program has one of these a line, and a frozen dataclass is five times as slow
# to make. Nothing assigns to them.
@dataclass(slots=True, eq=False)
class Statement:
    """A statement of a program.

    Attributes:
        span: where the whole statement stands.
        syntax: the node that it was lowered from, in a tree of its own time: since then the
            statement may have moved. Where a part stands now, `span_of` and `shift` tell.
    """

    span: Span
    syntax: Node

    @property
    def shift(self) -> int:
        """How many bytes farther it stands than when its `syntax` was parsed."""
        return self.span.start - self.syntax.start_byte

    def span_of(self, slot: str) -> Span:
        """Return where a slot's text stands; the statement's span when the slot is empty."""
        child = self.syntax.child_by_field_name(slot)
        if child is None:
            return self.span
        return Span(child.start_byte, child.end_byte).moved(self.shift)


DECLARATIONS: dict[type[Statement], Declaration] = {}

S = TypeVar("S", bound=Statement)


def slot(kind: SlotKind, help: str) -> Any:  # noqa: A002 - the word that users of it read best
    """Declare a slot; its name is the attribute's, which is the grammar's field."""
    return dataclasses.field(metadata={"slot": (kind, help)})


@dataclass_transform(field_specifiers=(slot,))
def statement(
    kind: str,
    sentence: str,
    *,
    summary: str,
    example: str,
    purpose: str = "",
    ros_term: str = "",
    about: str = "",
    undoes: type[Statement] | None = None,
    writes_file: bool = False,
) -> Callable[[type[S]], type[S]]:
    """Declare a statement.

    `sentence` has words, `{slots}`, and optional clauses in brackets; `kind` is the grammar's
    node. Without a `purpose` the summary says what it is for.
    """

    def declare(cls: type[S]) -> type[S]:
        made = dataclass(slots=True, eq=False)(cls)
        slots = {
            field.name: Slot(field.name, *field.metadata["slot"])
            for field in dataclasses.fields(made)
            if "slot" in field.metadata
        }
        DECLARATIONS[made] = Declaration(
            made,
            kind,
            _parse_sentence(sentence, slots),
            summary,
            example,
            purpose or summary[:1].lower() + summary[1:].rstrip("."),
            ros_term,
            about or summary,
            undoes,
            writes_file,
        )
        return made

    return declare


def _parse_sentence(sentence: str, slots: dict[str, Slot]) -> tuple[Element, ...]:
    elements: list[Element] = []
    clause: list[str | Slot] | None = None
    for word in sentence.replace("[", "[ ").replace("]", " ]").split():
        if word == "[":
            clause = []
        elif word == "]":
            elements.append(Clause(tuple(clause or ())))
            clause = None
        else:
            part = slots[word[1:-1]] if word.startswith("{") else word
            (elements if clause is None else clause).append(part)
    return tuple(elements)
