"""What a statement is: its sentence, its slots, and what is said about it.

A statement is declared once, by a class with a sentence. Lowering, the formatter, the
explanation of a syntax error, completion, forms and the language reference are derived from
the declaration.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import count, groupby, takewhile
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from tree_sitter import Node

from plastron_tui.diagnostics import Span

from .slot_kinds import Form as Form
from .slot_kinds import SlotKind as SlotKind

if TYPE_CHECKING:
    from typing_extensions import dataclass_transform
else:

    def dataclass_transform(**_: object) -> Callable[[Any], Any]:
        """Only type checkers need the real one."""
        return lambda decorated: decorated


@dataclass(frozen=True, slots=True)
class Slot:
    """A place in a sentence: the grammar's field, what fills it, and a line about it.

    `placeholder` is how it is written in a usage line.
    """

    name: str
    kind: SlotKind
    help: str
    placeholder: str


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
        slots: the slots, in the order of the sentence.
        clauses: the clauses, those within others too.
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
    # Asked for at each look at each statement: found once.
    slots: tuple[Slot, ...] = field(init=False, repr=False, compare=False)
    clauses: tuple[Clause, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Find the slots and clauses."""
        object.__setattr__(self, "slots", tuple(_slots_of(self.elements)))
        object.__setattr__(self, "clauses", tuple(_clauses_of(self.elements)))

    @property
    def keyword(self) -> str:
        """The word that only this statement has."""
        return next(element for element in self.elements if isinstance(element, str))

    @property
    def usage(self) -> str:
        """The sentence with its slots in capitals, and optional clauses in brackets."""
        return written(self.elements, lambda element, text: text)

    def usage_around(
        self,
        part: Element | None,
        mark: Callable[[Element, str], str] = lambda element, text: text,
    ) -> str:
        """The sentence; of a long one, only the clause that a part is in is there in full.

        `mark` is handed each part and its text, and says how it looks.
        """
        if len(self.usage) <= _LONG_USAGE:
            return written(self.elements, mark)

        def show(element: Element, text: str) -> str:
            if not isinstance(element, Clause) or len(element.elements) == 1:
                return mark(element, text)
            if part is not None and part in (element, *_parts_of(element.elements)):
                return mark(element, text)
            words = takewhile(lambda each: isinstance(each, str), element.elements)
            return " ".join([*map(str, words), "…"])

        return written(self.elements, show)


_LONG_USAGE = 100
"""Characters of a sentence that is too long to be read in a message."""


def _parts_of(elements: Iterable[Element]) -> Iterator[Element]:
    for element in elements:
        yield element
        if isinstance(element, Clause):
            yield from _parts_of(element.elements)


def written(elements: Sequence[Element], show: Callable[[Element, str], str]) -> str:
    """Return parts of a sentence as a reader is shown them, clauses in brackets.

    `show` is handed each part and its text, and says how it looks.
    """

    def text_of(element: Element) -> str:
        match element:
            case Slot(placeholder=placeholder):
                return show(element, placeholder)
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
        fields = [each for each in dataclasses.fields(made) if "slot" in each.metadata]
        slots = {each.name: _slot_of(each, fields) for each in fields}
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


def _slot_of(made: Any, fields: Sequence[Any]) -> Slot:
    """Return the slot of a field; of several that hold alike, each is shown by its own name."""
    kind, text = made.metadata["slot"]
    placeholder = kind.placeholder
    is_one = sum(each.metadata["slot"][0] is kind for each in fields) == 1
    if not is_one and re.fullmatch(r"'?[A-Z_]+'?", placeholder):
        placeholder = re.sub("[A-Z_]+", made.name.upper(), placeholder)
    return Slot(made.name, kind, text, placeholder)


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
