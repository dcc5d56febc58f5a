"""Statements of the wizard, put into the program and checked for real."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from plastron_tui.diagnostics import Diagnostic, Edit, Severity, Span, codes
from plastron_tui.language import SlotKind
from plastron_tui.language.declaration import Form as Written
from plastron_tui.language.declaration import Statement
from plastron_tui.language.inputs import COMMENTS
from plastron_tui.language.keywords import KEYWORDS
from plastron_tui.session import Session

from ..insertion_point import Ground, Placing
from ..insertion_point import placed as where
from .form import Form, is_variable, laid_out
from .goals import generating
from .replaced_lines import line_of, moved, whole_edit, without
from .values import Entry, Path


@dataclass(frozen=True, slots=True)
class Placed:
    """A statement for the program: its form (None for one that follows), text, and values.

    `node` is what stands where it names its node, "" where it names none, `robot` likewise.
    `rows` has, by slot, the rows of a form that the parts of what is in it come from. `replaces`
    has the statements of the program whose place it takes.
    """

    form: Form | None
    text: str
    entries: tuple[Entry, ...] = ()
    node: str = ""
    rows: Mapping[str, tuple[Path, ...]] = field(default_factory=dict)
    robot: str = ""
    replaces: tuple[Span, ...] = ()


@dataclass(frozen=True, slots=True)
class Finding:
    """What is wrong with what was entered.

    Attributes:
        form: the form that it is about, None where it is about no statement of the wizard.
        slot: the slot, "" where it is about the whole statement.
        message: what is wrong.
        help: what to do about it, "" where nothing is known.
        path: the field of the values, where it is about one.
    """

    form: Form | None
    slot: str
    message: str
    help: str = ""
    path: Path | None = None

    @property
    def words(self) -> str:
        """What is wrong, and what to do about it."""
        return f"{self.message} ({self.help})" if self.help else self.message


@dataclass(frozen=True, slots=True)
class Outcome:
    """What comes of statements in a program.

    Attributes:
        session: the program with them.
        edits: how the text of the program becomes the new one.
        span: where the statements stand in the new text.
        findings: what is wrong with them.
        lines: the statements.
        replaced: the numbers of the lines whose place they take, from 1.
    """

    session: Session
    edits: tuple[Edit, ...]
    span: Span
    findings: tuple[Finding, ...]
    lines: tuple[str, ...]
    replaced: tuple[int, ...] = ()


def check(
    session: Session,
    placed: Sequence[Placed],
    *,
    generates: bool = False,
    accepted: frozenset[str] = frozenset(),
) -> Outcome:
    """Put statements where they take effect, and look at what is wrong then that was right before.

    Args:
        session: the program; it stays as it is.
        placed: the statements, in order; the last one is what is wanted, the others it needs.
        generates: whether a node that is not generated yet is to be, at the end.
        accepted: the codes of diagnostics that somebody wants to live with.
    """
    node = node_of(placed)
    late: tuple[Placed, ...] = ()
    declaration = generating()
    is_late = node is not None and (generates or _is_generated(session, node))
    if is_late and declaration is not None and not _generates(placed):
        slot = next(s for s in declaration.slots if s.kind is SlotKind.NODE)
        late = (Placed(None, laid_out(declaration, {slot.name: node or ""})),)
    robot = next((each.robot for each in reversed(placed) if each.robot), None)
    replaced = sorted({span for each in placed for span in each.replaces})
    place = where(
        Ground(session.document, session.program, session.workspace),
        None if _generates(placed) else node or robot,
        [each.text for each in placed],
        late=[each.text for each in late],
        is_apart=_opens_block(placed),
    )
    return _checked(session, (*placed, *late)[: len(place.lines)], place, replaced, accepted)


def node_of(placed: Sequence[Placed]) -> str | None:
    """Return the variable of the node that statements are about, None where it is not known."""
    name = placed[-1].node
    return name if is_variable(name) and name not in KEYWORDS else None


def _generates(placed: Sequence[Placed]) -> bool:
    return any(each.form is not None and each.form.declaration.writes_file for each in placed)


def _is_generated(session: Session, node: str) -> bool:
    return any(made.node.variable == node for made in session.workspace.generations)


def _checked(
    session: Session,
    placed: Sequence[Placed],
    place: Placing,
    replaced: Sequence[Span],
    accepted: frozenset[str],
) -> Outcome:
    start, end = place.edit.span
    written = place.edit.text.encode("utf-8", "surrogatepass")
    candidate = session.snapshot()
    candidate.learn_from(session)
    candidate.edit(start, end, written)
    edits, spans = (place.edit,), place.spans
    text = session.document.text
    if replaced:
        grown = len(written) - (end - start)
        gone = [moved(line_of(text, each), start, grown) for each in replaced]
        for line in reversed(gone):
            candidate.edit(line.start, line.end, b"")
        spans = tuple(without(each, gone) for each in spans)
        edits = (whole_edit(text, candidate.document.text),)
    told = [each for each in candidate.diagnostics if each.code not in accepted]
    findings = tuple(_findings(session, candidate, told, placed, spans))
    block = Span(spans[0].start, spans[-1].end)
    numbers = tuple(text.count(b"\n", 0, each.start) + 1 for each in replaced)
    return Outcome(candidate, edits, block, findings, place.lines, numbers)


_BLOCKS = (SlotKind.NEW_NODE, SlotKind.NEW_PACKAGE, SlotKind.NEW_LAUNCH, SlotKind.NEW_ROBOT)
"""The slots that name what has a block of statements of its own."""


def _opens_block(placed: Sequence[Placed]) -> bool:
    first = placed[0].form
    return first is not None and first.slot_of(*_BLOCKS) is not None


def _findings(
    session: Session,
    candidate: Session,
    told: Sequence[Diagnostic],
    placed: Sequence[Placed],
    spans: Sequence[Span],
) -> Iterator[Finding]:
    known = Counter(_key(each) for each in session.diagnostics)
    said = {*map(_key, candidate.type_problems), *map(_key, session.type_problems)}
    statements = {each.span.start: each for each in candidate.program.statements}
    found: list[Diagnostic] = []
    for each in told:
        key = _key(each)
        if known[key] > 0:
            known[key] -= 1
        elif key not in said:
            # One answer may be written at several places: it is wrong once.
            said.add(key)
            found.append(each)
    for one, span in zip(placed, spans, strict=True):
        own = [each for each in found if _lies_in(each, span)]
        statement = statements.get(span.start)
        is_whole = statement is not None and statement.span == span
        if one.form is not None and is_whole:
            is_whole = type(statement) is one.form.declaration.type
        for each in own:
            found.remove(each)
            yield _finding(each, one, statement if is_whole else None)
        if not is_whole and not own:
            yield Finding(one.form, "", "this is no statement of the language")
    for each in found:
        # A remark about a file that is read is no mistake of the one who reads it.
        if each.file is not None and each.severity is not Severity.ERROR:
            continue
        reading = _reading(placed) if each.file is not None else None
        if reading is not None:
            yield Finding(*reading, each.message, each.help or "")
        else:
            yield Finding(None, "", _elsewhere(each))


def _elsewhere(diagnostic: Diagnostic) -> str:
    """Say what would be wrong with another statement."""
    if diagnostic.code == codes.IDLE_NODE:
        return "the node would have nothing left to do, and could not be written to its file"
    return f"another statement would be wrong: {diagnostic.message}"


def _reading(placed: Sequence[Placed]) -> tuple[Form, str] | None:
    """Return the form and the slot that name a file, None where none does."""
    for each in placed:
        slot = None if each.form is None else each.form.slot_of(SlotKind.FILE)
        if each.form is not None and slot is not None:
            return each.form, slot.name
    return None


def _key(diagnostic: Diagnostic) -> tuple[str, str, object]:
    return diagnostic.code, diagnostic.message, diagnostic.file


def _lies_in(diagnostic: Diagnostic, span: Span) -> bool:
    where = diagnostic.span
    return where is not None and diagnostic.file is None and span.start <= where.start <= span.end


def _finding(diagnostic: Diagnostic, placed: Placed, statement: Statement | None) -> Finding:
    message, help_ = diagnostic.message, diagnostic.help or ""
    form, where = placed.form, diagnostic.span
    if form is None or statement is None or where is None:
        return Finding(form, "", message, help_)
    # The tree of a statement may count from another place than the program does.
    at = where.start - statement.span.start + statement.syntax.start_byte
    for slot in form.declaration.slots:
        child = statement.syntax.child_by_field_name(slot.name)
        if child is None or not child.start_byte <= at < child.end_byte:
            continue
        path = None
        paths = [entry.path for entry in placed.entries]
        if slot.name in placed.rows:
            paths = list(placed.rows[slot.name])
        if slot.kind.form in (Written.VALUES, Written.FIELDS, Written.VECTOR):
            values = [each for each in child.named_children if each.kind_id not in COMMENTS]
            for each, value in zip(paths, values, strict=False):
                if value.start_byte <= at < value.end_byte:
                    path = each
        return Finding(form, slot.name, message, help_, path)
    return Finding(form, "", message, help_)
