"""From what was entered to what stands in every slot, and to the text of the statements."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from plastron_tui.language import Slot, SlotKind
from plastron_tui.language.declaration import Form as Written
from plastron_tui.model.kinds import INTERFACES

from .ask import Ask, Choice, Trial
from .computed_values import sources_of
from .context import Scene
from .definition_kinds import field_choices
from .definition_rows import fields_text, filled_rows, row_path, row_problems, rows_of
from .form import NEW, Cell, Cells, Form, excluded_by, laid_out
from .given_up import given_up
from .goals import maker_of
from .kinds import KINDS
from .part_rows import FilledPart, filled_parts, part_problems, parts_text, used_paths
from .program_trial import Finding, Placed, check
from .values import Entry, Heading, Path, entries_of, first_value, input_text

LARGEST_TRIED = 64 * 1024
"""In a larger program choices are not tried out before they are offered: it takes too long."""

_MOST_REMEMBERED = 2000
_DEEPEST = 2
_EXAMPLES: Mapping[type, str] = {str: "hello", bool: "True", int: "5", float: "0.5"}


@dataclass(slots=True)
class Filled:
    """A form with all its slots filled.

    Attributes:
        form: the form.
        base: the program that the statements are for.
        scene: the program with what the form itself needs to be made before.
        cells: what is in the slots.
        entries: the form of the values, where the statement has values and the type is known.
        given: the values of the entries; those that were not entered are suggestions.
        used: the entries that stand in the text, in order.
        rows: by slot, the rows of the fields of a definition.
        parts: by slot, the rows of one that has several: of a place, of a shape.
        makers: the forms that make what the statement names, to be written before it.
        problems: what is wrong as far as the slots know.
        around: the cells of the form that this one makes something for.
    """

    form: Form
    base: Scene
    scene: Scene
    cells: Cells
    around: Cells
    entries: list[Entry | Heading] = field(default_factory=list)
    given: dict[Path, str] = field(default_factory=dict)
    used: list[Entry] = field(default_factory=list)
    rows: dict[str, list[str]] = field(default_factory=dict)
    parts: dict[str, list[FilledPart]] = field(default_factory=dict)
    makers: list[Filled] = field(default_factory=list)
    problems: list[Finding] = field(default_factory=list)

    @property
    def text(self) -> str:
        """The statement."""
        texts = {name: cell.in_program for name, cell in self.cells.items()}
        return laid_out(self.form.declaration, texts)

    @property
    def goes_on_with(self) -> str:
        """The node that it reads from a file where the program has read it already, or ""."""
        new = self.form.slot_of(SlotKind.NEW_NODE)
        if new is None or self.form.slot_of(SlotKind.FILE) is None:
            return ""
        cell = self.cells[new.name]
        # A reason says why the name cannot be chosen: the node has one (see `NewNodeKind`).
        return cell.text if cell.reason else ""

    @property
    def written(self) -> list[Placed]:
        """The statements in the order of the program; none where it has them already."""
        if self.goes_on_with:
            return []
        before = [each for maker in self.makers for each in maker.written]
        node = self._text(SlotKind.NODE, SlotKind.NEW_NODE)
        paths = {
            slot.name: tuple(row_path(slot, number) for number in filled_rows(rows))
            for slot in self.form.declaration.slots
            if (rows := self.rows.get(slot.name)) is not None
        }
        paths.update((name, used_paths(each)) for name, each in self.parts.items())
        texts = {slot.kind: self.cells[slot.name].text for slot in self.form.declaration.slots}
        gives_way = given_up(self.base, self.form.declaration, texts)
        if gives_way.line:
            before.append(Placed(None, gives_way.line, node=node))
        return [
            *before,
            Placed(self.form, self.text, tuple(self.used), node, paths, self._text(SlotKind.ROBOT),
                   gives_way.spans),
        ]  # fmt: skip

    @property
    def robot(self) -> str | None:
        """The variable of the robot that the statement is about, None where it is about none."""
        return self._text(SlotKind.ROBOT, SlotKind.NEW_ROBOT) or None

    @property
    def part(self) -> str:
        """The link or the joint that the statement is about, "" where it is about none."""
        return self._text(SlotKind.JOINT) or self._text(SlotKind.LINK)

    def _text(self, *kinds: SlotKind) -> str:
        slot = self.form.slot_of(*kinds)
        return "" if slot is None else self.cells[slot.name].text

    @property
    def all_problems(self) -> list[Finding]:
        """What is wrong in it and in what it needs."""
        return [*(each for maker in self.makers for each in maker.all_problems), *self.problems]


def filled_of(form: Form, filled: Sequence[Filled]) -> Filled | None:
    """Return a form as it is filled, among some and those that make what they need."""
    for each in filled:
        found = each if each.form is form else filled_of(form, each.makers)
        if found is not None:
            return found
    return None


class Filler:
    """Fills forms; it remembers what came of the choices that were tried out."""

    def __init__(self) -> None:
        self._tried: dict[object, Trial] = {}

    def fill(
        self, form: Form, scene: Scene, around: Filled | None = None, depth: int = 0
    ) -> Filled:
        """Fill every slot: with what was entered, what must be there, or a suggestion."""
        cells_around = around.cells if around is not None else {}
        filled = Filled(form, scene, scene, {}, cells_around)
        later: list[Slot] = []
        for slot in form.declaration.slots:
            cell = self._cell(filled, slot, depth)
            filled.cells[slot.name] = cell
            if cell.is_new:
                # What needs nothing of this form is made before the rest is filled.
                if _needs(form, slot):
                    later.append(slot)
                else:
                    self._make(filled, slot, depth)
        for slot in later:
            self._make(filled, slot, depth)
        self._find_problems(filled, depth)
        return filled

    def _cell(self, filled: Filled, slot: Slot, depth: int) -> Cell:
        form = filled.form
        given = form.given.get(slot.name)
        if given is not None:
            return Cell(given, "just described")
        ask = self.ask(filled, slot, depth)
        kind = KINDS[slot.kind]
        fixed = kind.fixed(ask)
        if fixed is not None:
            return fixed
        parts = kind.parts(ask)
        if parts is not None:
            filled.parts[slot.name] = filled_parts(slot.name, parts, form.values)
            return Cell(parts_text(filled.parts[slot.name]))
        if slot.kind.form is Written.VALUES:
            return self._values(filled, ask)
        if slot.kind.form is Written.FIELDS:
            filled.rows[slot.name] = rows_of(form, slot)
            return Cell(fields_text(filled.rows[slot.name]))
        text = form.entered.get(slot.name)
        if text is None:
            others = excluded_by(form.declaration, slot.name)
            text = "" if any(map(form.entered.get, others)) else kind.suggest(ask)
        if text == NEW:
            return Cell("", is_new=True)
        text = kind.meant(ask, text)
        return Cell(text, written=kind.written(ask, text) if text else None)

    def _values(self, filled: Filled, ask: Ask) -> Cell:
        type_ = ask.text(*INTERFACES)
        found = ask.scene.resolve(type_, ask.interface, ask.version)
        if found is None:
            return Cell("" if ask.slot.kind is SlotKind.ANSWER else "none")
        is_answer = ask.slot.kind is SlotKind.ANSWER
        section = found.response if is_answer else found.sections[0]
        filled.entries = entries_of(found, ask.scene.catalog(ask.version), section)
        entries = [each for each in filled.entries if isinstance(each, Entry)]
        is_stop = "<" in ask.parent_text(SlotKind.CONDITION)
        filled.given = {entry.path: first_value(entry, is_stop=is_stop) for entry in entries}
        if len(filled.entries) == 1 and entries and not is_answer:
            entry = entries[0]
            if entry.python is not None and not entry.type.is_array and entry.meaning is None:
                filled.given[entry.path] = _EXAMPLES[entry.python]
        filled.given.update((path, text) for path, text in filled.form.values.items()
                            if path in filled.given)  # fmt: skip
        text, filled.used = input_text(filled.entries, filled.given)
        return Cell("" if is_answer and not filled.used else text)

    def _make(self, filled: Filled, slot: Slot, depth: int) -> None:
        """Fill the form of what a slot names and nobody has made yet."""
        form = filled.form
        maker = form.makers.get(slot.name)
        if maker is None:
            declaration = maker_of(slot.kind)
            if declaration is None:
                return
            maker = form.makers[slot.name] = Form(declaration, parent=(form, slot.name))
        own, node = maker.slot_of(SlotKind.NODE), form.slot_of(SlotKind.NODE)
        if own is not None and node is not None:
            maker.given[own.name] = filled.cells[node.name].text
        made = self.fill(maker, filled.scene, filled, depth)
        filled.makers.append(made)
        # Where something is to arrive, a topic is what is made.
        name = maker.made or maker.slot_of(SlotKind.TOPIC)
        text = made.cells[name.name].text if name is not None else ""
        filled.cells[slot.name] = Cell(text, is_new=True)
        if not _needs(form, slot):
            filled.scene = self.extended(filled.scene, made)

    def extended(self, scene: Scene, filled: Filled) -> Scene:
        """Return the scene in which statements are written at the end of the program."""
        if filled.goes_on_with:
            return scene
        return Scene(check(scene.session, filled.written).session, scene.surroundings)

    def _find_problems(self, filled: Filled, depth: int) -> None:
        form = filled.form
        optional = form.optional
        filled.problems += _clause_problems(filled)
        for slot in form.declaration.slots:
            cell = filled.cells[slot.name]
            for path, words in part_problems(filled.parts.get(slot.name, ())):
                filled.problems.append(Finding(form, slot.name, words, path=path))
            if cell.is_new or cell.reason or (slot.name in optional and not cell.text):
                continue
            ask = self.ask(filled, slot, depth)
            problem = KINDS[slot.kind].problem(ask, cell.text)
            if problem is not None:
                filled.problems.append(Finding(form, slot.name, problem))
            for number, problem in row_problems(filled.rows.get(slot.name, [])):
                path = row_path(slot, number)
                filled.problems.append(Finding(form, slot.name, problem, path=path))
            if slot.kind.form is Written.VALUES and slot.name not in filled.parts:
                sources = sources_of(ask)
                for entry in filled.used:
                    problem = sources.problem(entry, filled.given[entry.path])
                    if problem is not None:
                        finding = Finding(form, slot.name, problem, path=entry.path)
                        filled.problems.append(finding)

    def ask(self, filled: Filled, slot: Slot, depth: int = 0) -> Ask:
        """Return the question about a slot."""

        def try_out(text: str, without: frozenset[str]) -> Trial:
            return self._try(filled, slot, text, depth, without)

        return Ask(filled.form, slot, filled.scene, filled.cells, try_out, filled.around, depth > 0)

    def choices(self, filled: Filled, slot: Slot, query: str) -> list[Choice]:
        """Return what can be taken for a slot of a filled form."""
        before: Cells = {}
        for each in filled.form.declaration.slots:
            if each.name == slot.name:
                break
            before[each.name] = filled.cells[each.name]
        shown = Filled(filled.form, filled.base, filled.scene, before, filled.around)
        return KINDS[slot.kind].choices(self.ask(shown, slot), query)

    def value_choices(self, filled: Filled, slot: Slot, path: Path, query: str) -> list[Choice]:
        """Return what can be taken for a field of the values, or of a definition."""
        if slot.name in filled.parts:
            return []
        if slot.kind.form is Written.FIELDS:
            return field_choices(self.ask(filled, slot), query)
        sources = sources_of(self.ask(filled, slot))
        entries = (each for each in filled.entries if isinstance(each, Entry))
        return [
            choice
            for each in entries
            if each.path == path
            for choice in (
                *(Choice(str(constant.value), constant.name) for constant in each.constants),
                *sources.choices(each),
            )
        ]

    def _try(
        self, filled: Filled, slot: Slot, text: str, depth: int, without: frozenset[str]
    ) -> Trial:
        scene = filled.base
        if depth >= _DEEPEST or len(scene.text) > LARGEST_TRIED:
            return Trial(None, scene.lonely)
        form = filled.form.trial(slot.name, text, filled.cells, without)
        key = (
            scene.text,
            form.declaration.kind,
            tuple(form.entered.items()),
            tuple(form.values.items()),
            slot.name,
            depth,
            form.drives,
            tuple(form.given.items()),
            tuple(
                (name, tuple(each.entered.items()), tuple(each.values.items()))
                for name, each in form.makers.items()
            ),
        )
        found = self._tried.get(key)
        if found is None:
            if len(self._tried) > _MOST_REMEMBERED:
                self._tried.clear()
            found = self._tried[key] = self._outcome(form, scene, depth)
        return found

    def _outcome(self, form: Form, scene: Scene, depth: int) -> Trial:
        filled = self.fill(form, scene, depth=depth + 1)
        problems = filled.all_problems
        if problems:
            return Trial(problems[0].message, scene.lonely, _needing(problems[0], form))
        if filled.goes_on_with:
            return Trial(None, scene.lonely)
        outcome = check(scene.session, filled.written)
        lonely = Scene(outcome.session).lonely
        if not outcome.findings:
            return Trial(None, lonely)
        return Trial(outcome.findings[0].words, lonely, _needing(outcome.findings[0], form))


def _needing(finding: Finding, form: Form) -> str:
    """Return the slot of a form that what is wrong is in, or that needs the form which it is in."""
    needs = (name for name, maker in form.makers.items() if maker is finding.form)
    return next(needs, finding.slot)


def _clause_problems(filled: Filled) -> Iterator[Finding]:
    """Find what is missing in a clause that is begun, and clauses that exclude each other."""
    form, cells = filled.form, filled.cells
    for clause in form.declaration.clauses:
        slots = [slot.name for slot in clause.slots]
        given = [name for name in slots if cells[name].text]
        for name in slots if given else ():
            if not cells[name].text and name not in filled.parts:
                words = f"it is needed along with `{given[0]}`: give both, or leave both out"
                yield Finding(form, name, words)
    passed: list[str] = []
    for slot in form.declaration.slots:
        others = excluded_by(form.declaration, slot.name)
        other = next((name for name in passed if name in others), None)
        if other is not None and cells[slot.name].text:
            words = f"it does not go with `{other}`: leave one of them out"
            yield Finding(form, slot.name, words)
        if cells[slot.name].text:
            passed.append(slot.name)


def _needs(form: Form, slot: Slot) -> bool:
    """Tell whether what a slot names is made to fit the rest of the form: it has a type, too."""
    declaration = maker_of(slot.kind)
    if declaration is None or slot.kind is SlotKind.TRIGGER:
        return False
    own = {(each.name, each.kind) for each in form.declaration.slots}
    typed = (each for each in declaration.slots if each.kind in INTERFACES)
    return any((each.name, each.kind) in own for each in typed)
