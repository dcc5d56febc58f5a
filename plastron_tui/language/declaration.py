"""What a statement is: its sentence, its slots, and what is said about it.

A statement is declared once, by a class with a sentence. Lowering, the formatter, the
explanation of a syntax error, completion, forms and the language reference are derived from
the declaration.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum, auto
from itertools import count, groupby
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
    RATE = auto()
    TEXT = auto()
    FLAG = auto()
    VALUE = auto()
    VALUES = auto()
    QOS = auto()
    CONDITION = auto()

    @property
    def is_open(self) -> bool:
        """Whether it goes on until another clause begins, or the line ends."""
        return self in (Form.VALUE, Form.VALUES, Form.QOS, Form.CONDITION)


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
    ACTION = "'ACTION_NAME'", "an action name in single quotes", Form.QUOTED
    PARAMETER = "'PARAMETER_NAME'", "a parameter name in single quotes", Form.QUOTED
    MESSAGE_TYPE = "MESSAGE_TYPE", "a message type", Form.TYPE
    SERVICE_TYPE = "SERVICE_TYPE", "a service type", Form.TYPE
    ACTION_TYPE = "ACTION_TYPE", "an action type", Form.TYPE
    PARAMETER_TYPE = "PARAMETER_TYPE", "a parameter type, such as `float`", Form.WORD
    NAMED = "topic | service | action | parameter", "what is renamed, such as `topic`", Form.WORD
    OLD_NAME = "'OLD_NAME'", "a name in single quotes", Form.QUOTED
    NEW_NAME = "'NEW_NAME'", "a name in single quotes", Form.QUOTED
    INPUT = "VALUES | none", "values, or `none`", Form.VALUES
    ANSWER = "VALUES | none", "values of the answer, or `none`", Form.VALUES
    DEFAULT = "VALUE", "a value", Form.VALUE
    BOUND = "NUMBER", "a number", Form.NUMBER
    RATE = "RATE", "a number, or `parameter` and a name", Form.RATE
    ONCE = "once", "`once`", Form.FLAG
    MANAGED = "managed", "`managed`", Form.FLAG
    TRIGGER = "'TOPIC_NAME'", "the name of a topic in single quotes", Form.QUOTED
    CONDITION = "CONDITION", "a condition, such as `received.data > 5`", Form.CONDITION
    QOS = "QOS", "words of quality of service, such as `sensor_data`", Form.QOS
    TEXT = '"TEXT"', "a text in double quotes", Form.TEXT
    FUNCTION = "FUNCTION", "the name of a function", Form.WORD
    TIMER = "FUNCTION", "the name of a function that is repeated", Form.WORD
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
    """A part of a sentence that may be left out; clauses beside each other stand in any order.

    Attributes:
        elements: what it is made of. The last of them may be a clause again.
        bracket: which brackets it is in: of the clauses in the same ones there is one at most.
    """

    elements: tuple[Element, ...]
    bracket: int = 0

    @property
    def keyword(self) -> str:
        """The word that it begins with."""
        first = self.elements[0]
        assert not isinstance(first, Clause)
        return first if isinstance(first, str) else first.kind.placeholder

    @property
    def slots(self) -> Iterator[Slot]:
        """The slots in it, those of clauses within it left out."""
        return (part for part in self.elements if isinstance(part, Slot))


Element: TypeAlias = "str | Slot | Clause"
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
        return tuple(_slots_of(self.elements))

    @property
    def clauses(self) -> tuple[Clause, ...]:
        """The clauses, those within others too."""
        return tuple(_clauses_of(self.elements))

    @property
    def usage(self) -> str:
        """The sentence with its slots in capitals, and optional clauses in brackets."""
        return written(self.elements, lambda element, text: text)


def written(elements: Sequence[Element], show: Callable[[Element, str], str]) -> str:
    """Return parts of a sentence as a reader is shown them, clauses in brackets.

    `show` is handed each part and its text, and says how it looks.
    """

    def text_of(element: Element) -> str:
        match element:
            case Slot(kind=kind):
                return show(element, kind.placeholder)
            case Clause(elements=parts):
                return show(element, written(parts, show))
            case word:
                return show(element, word)

    def is_clause(element: Element) -> int:
        return element.bracket if isinstance(element, Clause) else 0

    shown = []
    for bracket, group in groupby(elements, key=is_clause):
        texts = map(text_of, group)
        shown.append(f"[{' | '.join(texts)}]" if bracket else " ".join(texts))
    return " ".join(shown)


def _slots_of(elements: Iterable[Element]) -> Iterator[Slot]:
    for element in elements:
        if isinstance(element, Slot):
            yield element
        elif isinstance(element, Clause):
            yield from _slots_of(element.elements)


def _clauses_of(elements: Iterable[Element]) -> Iterator[Clause]:
    for element in elements:
        if isinstance(element, Clause):
            yield element
            yield from _clauses_of(element.elements)


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

    `sentence` has words, `{slots}`, and optional clauses in brackets, a `|` between those that
    exclude each other; `kind` is the grammar's node. Without a `purpose` the summary says what it
    is for.
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
    words = iter(re.findall(r"[\[\]|]|[^\s\[\]|]+", sentence))
    brackets = count(1)

    def parts() -> list[list[Element]]:
        """Return what stands before the next bracket that closes, parted at each `|`."""
        found: list[list[Element]] = [[]]
        for word in words:
            match word:
                case "[":
                    bracket = next(brackets)
                    found[-1] += [Clause(tuple(each), bracket) for each in parts()]
                case "]":
                    break
                case "|":
                    found.append([])
                case _:
                    found[-1].append(slots[word[1:-1]] if word.startswith("{") else word)
        return found

    return tuple(parts()[0])
