"""The way through the wizard: which page comes next, and what all pages together write."""

from __future__ import annotations

from plastron_tui.language import Declaration, SlotKind
from plastron_tui.language import statements as st
from plastron_tui.model.kinds import INTERFACES
from plastron_tui.session import Session

from . import driving_lines
from .ask import Choice
from .context import Scene, Surroundings
from .filling import Filled, Filler
from .followers import chosen, extras_of
from .form import Form
from .goals import GROUPS, Aim, aim_of, answering
from .helps import helps_of
from .menu import RECIPES, Offer, Option, recipe_offers, writes_too
from .offers import Offering, give
from .pages import Heard, Look, Page, PageKind
from .program_trial import Finding, Outcome, Placed, check, node_of
from .values import Path
from .where_mended import where_mended

SEARCHED = (*INTERFACES, SlotKind.CONDITION)
"""The slots whose choices are what a search finds, not a list that is narrowed down."""

GENERATES = "generates"
"""The key of writing a node to its file along with what it does."""

MOST_CHOICES = 200
"""The most choices that are listed; who has more of them writes a part of the name."""


class Course:
    """The state of the wizard, without a screen.

    Attributes:
        session: the program as it is without the wizard.
        at: the number of the page that is shown.
        generates: whether the node is to be generated along with it.
        wanted: by key, whether what may follow a statement is wanted; what is not there is.
        drives: whether what was chosen drives a robot until something is near.
        takes_away: whether the menu of what can be taken away was chosen.
    """

    def __init__(self, session: Session, surroundings: Surroundings | None = None) -> None:
        self.session = session
        self.surroundings = surroundings or Surroundings()
        self.at = 0
        self.generates = True
        self.wanted: dict[str, bool] = {}
        self.head: Declaration | None = None
        self.purpose: Declaration | None = None
        self.group: Aim | None = None
        self._is_recipes = False
        self.drives = False
        self.takes_away = False
        self._forms: dict[tuple[Declaration | None, Declaration, bool], Form] = {}
        self._filler = Filler()

    @property
    def scene(self) -> Scene:
        """The program as it is without the wizard."""
        return Scene(self.session, self.surroundings)

    def take(self, offer: Offer) -> None:
        """Take an entry of the menu that is shown, and go on."""
        if offer.takes_away:
            self.choose_what_goes()
        elif offer.group is not None:
            self.choose_group(offer.group)
        elif offer.declaration is not None:
            self.choose(offer.declaration, drives=offer.drives)
        else:
            self.choose_recipes()

    def choose(self, declaration: Declaration, *, drives: bool = False) -> None:
        """Go on with a statement; `drives` for one that drives until something is near."""
        if self.page.kind is PageKind.START:
            self._is_recipes = False
            self.group = None
            if declaration != self.head:
                self.purpose, self.takes_away = None, False
            self.head = declaration
        else:
            self.takes_away = self.page.kind is PageKind.AWAY
            self.purpose = declaration
            self.drives = drives
        self.at += 1

    def choose_what_goes(self) -> None:
        """Go on to the menu of what can be taken away."""
        if not self.takes_away:
            self.purpose = None
        self.takes_away = True
        self.at += 1

    def choose_group(self, group: Aim) -> None:
        """Go on to a menu of its own."""
        if group is not self.group:
            self.purpose, self.takes_away = None, False
        self._is_recipes, self.group = False, group
        self.head = None
        self.at += 1

    def choose_recipes(self) -> None:
        """Go on to the programs that work."""
        self._is_recipes, self.group = True, None
        self.head = self.purpose = None
        self.takes_away = False
        self.at = 1

    def answer(self, heard: Heard) -> None:
        """Go on to what a node sends for each message of a topic."""
        self.begin_with(answering())
        form = self.main_form
        assert form is not None
        for kind, text in ((SlotKind.NODE, heard.node), (SlotKind.TRIGGER, heard.topic)):
            slot = form.slot_of(kind)
            if slot is not None:
                form.enter(slot.name, text)

    def begin_with(self, declaration: Declaration) -> None:
        """Go to the form of a statement, by way of the menu that has it."""
        if aim_of(declaration) in GROUPS:
            self.choose_group(aim_of(declaration))
        self.choose(declaration)

    def heard(self, look: Look) -> Heard | None:
        """Return what a node listens to by what was entered; None where that is something else."""
        form = self.main_form
        filled = None if form is None else look.of(form)
        if filled is None or filled.form.declaration.type is not st.Subscribe:
            return None
        return Heard(filled.cells["node"].text, filled.cells["topic"].text)

    def is_chosen(self, offer: Offer) -> bool:
        """Tell whether an entry of the menu that is shown was taken before."""
        if self.page.kind in (PageKind.PURPOSE, PageKind.AWAY):
            if offer.takes_away or (self.takes_away and self.page.kind is PageKind.PURPOSE):
                return offer.takes_away and self.takes_away
            return offer.declaration is self.purpose and offer.drives == self.drives
        if offer is RECIPES:
            return self._is_recipes
        if offer.group is not None:
            return offer.group is self.group
        return offer.declaration is self.head

    @property
    def is_filled_in(self) -> bool:
        """Whether somebody wrote or chose something in a form."""
        return any(form.is_filled_in for form in self._forms.values())

    def go_on(self) -> None:
        """Go on a page."""
        self.at += 1

    def back(self) -> bool:
        """Go back a page; False on the first one."""
        if self.at == 0:
            return False
        self.at -= 1
        return True

    @property
    def _has_purpose(self) -> bool:
        """Whether it is asked what a node shall do."""
        if self.head is None:
            return self.group is not None
        return any(slot.kind is SlotKind.NEW_NODE for slot in self.head.slots)

    def _form(
        self, around: Declaration | None, declaration: Declaration, *, drives: bool = False
    ) -> Form:
        key = (around, declaration, drives)
        if key not in self._forms:
            self._forms[key] = Form(declaration, drives=drives)
        return self._forms[key]

    @property
    def head_form(self) -> Form | None:
        """The form of what the first menu led to."""
        return None if self.head is None else self._form(None, self.head)

    @property
    def main_form(self) -> Form | None:
        """The form of what a node shall do."""
        if self.purpose is None or not self._has_purpose:
            return None
        return self._form(self.head, self.purpose, drives=self.drives)

    def pages(self, look: Look) -> list[Page]:
        """Return the pages, as far as it is known which there will be."""
        pages = [Page(PageKind.START)]
        head, main = self.head_form, self.main_form
        if self._is_recipes:
            return [*pages, Page(PageKind.RECIPES)]
        if head is None and self.group is None:
            return pages
        if head is not None:
            pages += self._form_pages(head, look)
        if self._has_purpose:
            pages.append(Page(PageKind.PURPOSE))
            if self.takes_away:
                pages.append(Page(PageKind.AWAY))
            if main is None:
                return pages
            pages += self._form_pages(main, look)
        pages.append(Page(PageKind.REVIEW))
        return pages

    def _form_pages(self, form: Form, look: Look) -> list[Page]:
        filled = look.of(form)
        makers = [] if filled is None else [each.form for each in filled.makers]
        return [Page(PageKind.FORM, form), *(Page(PageKind.FORM, each) for each in makers)]

    @property
    def page(self) -> Page:
        """The page that is shown."""
        pages = self.pages(self._seen)
        self.at = min(self.at, len(pages) - 1)
        return pages[self.at]

    _seen = Look()

    @property
    def forms_so_far(self) -> list[Form]:
        """The forms of the pages up to the one that is shown."""
        pages = self.pages(self._seen)[: self.at + 1]
        return [page.form for page in pages if page.form is not None]

    def look(self) -> Look:
        """Find out all that follows from what was entered."""
        head, main = self.head_form, self.main_form
        filled: list[Filled] = []
        scene = self.scene
        if head is not None:
            head.purpose = main
            filled.append(self._filler.fill(head, scene))
            if main is not None:
                scene = self._filler.extended(scene, filled[0])
        if main is not None:
            give(main, filled)
            filled.append(self._filler.fill(main, scene))
        self._seen = self._looked(filled)
        return self._seen

    def _looked(self, filled: list[Filled]) -> Look:
        if not filled:
            return Look()
        placed = [each for one in filled for each in one.written]
        if not placed:
            found = (problem for each in filled for problem in each.all_problems)
            return Look(tuple(filled), None, tuple(found), filled[-1].goes_on_with)
        node = node_of(placed)
        extras = extras_of(filled[-1])
        if extras:
            placed, extras = chosen(self.session, placed, extras, self.wanted)
        driving: tuple[int, ...] = ()
        accepted: frozenset[str] = frozenset()
        if driving_lines.is_asked(placed):
            driving = driving_lines.numbers_of(self.session.document.text, placed)
            if not self._replaces:
                placed, accepted = driving_lines.kept(placed), driving_lines.LIVED_WITH
        has_work = self.main_form is not None and node is not None
        generates = has_work and self.generates
        outcome = check(self.session, placed, generates=generates, accepted=accepted)
        can = has_work and self._can_generate(placed, node, outcome, accepted)
        if generates and not can:
            outcome = check(self.session, placed, accepted=accepted)
        known = [problem for each in filled for problem in each.all_problems]
        places = {(each.form, each.slot, each.path) for each in known}
        broken = {each.form for each in known}
        more = [
            each
            for each in (where_mended(found, filled) for found in outcome.findings)
            # What a slot knows of itself is said in its own words, and nothing that follows.
            if (each.form, each.slot, each.path) not in places
            and not (broken and (each.form in broken or each.form is None))
        ]
        return Look(
            tuple(filled),
            outcome,
            (*known, *more),
            node,
            can,
            tuple(extras),
            filled[-1].robot,
            filled[-1].part,
            self._before(filled),
            driving,
        )

    @property
    def _replaces(self) -> bool:
        """Whether lines that drive whatever arrives are to give way."""
        return self.wanted.get(driving_lines.REPLACES, True)

    def _before(self, filled: list[Filled]) -> Session:
        """Return the program without what a node shall do, but with that node."""
        if len(filled) == 1 or filled[0].goes_on_with:
            return self.session
        return check(self.session, filled[0].written).session

    def _can_generate(
        self, placed: list[Placed], node: str | None, plain: Outcome, accepted: frozenset[str]
    ) -> bool:
        if node is None:
            return False
        generated = {made.node.variable for made in self.session.workspace.generations}
        if node in generated:
            return False
        if self.generates:
            return not any(each.form is None for each in plain.findings)
        return not check(self.session, placed, generates=True, accepted=accepted).findings

    def options(self, look: Look) -> list[Option]:
        """Return what may be written along with the statements."""
        options = [
            Option(each.key, each.words, self.wanted.get(each.key, True)) for each in look.extras
        ]
        if look.can_generate:
            words = writes_too(self.session, look.node or "")
            options.insert(0, Option(GENERATES, words, self.generates))
        if look.driving:
            text = self.session.document.text
            options.insert(0, driving_lines.option(text, look.driving, is_wanted=self._replaces))
        return options

    def want(self, key: str, is_wanted: bool) -> None:
        """Have something written along with the statements, or not."""
        if key == GENERATES:
            self.generates = is_wanted
        else:
            self.wanted[key] = is_wanted

    def blocking(self, look: Look) -> tuple[Finding, ...]:
        """Return what keeps the page that is shown from being left forwards."""
        page = self.page
        if page.kind is PageKind.REVIEW:
            return look.problems
        if page.kind is not PageKind.FORM:
            return ()
        so_far = self.forms_so_far
        later = [each.form for each in self.pages(look)[self.at + 1 :] if each.form is not None]
        return tuple(
            each
            for each in look.problems
            if each.form in so_far or (each.form is None and not later)
        )

    def page_of(self, form: Form | None, look: Look) -> int | None:
        """Return the number of the page that shows a form."""
        for number, page in enumerate(self.pages(look)):
            if page.form is form and form is not None:
                return number
        return None

    def choices(self, filled: Filled, slot: str, path: Path | None, query: str) -> list[Choice]:
        """Return what can be taken for a slot, or for a field of the values."""
        found = next(each for each in filled.form.declaration.slots if each.name == slot)
        if path is not None:
            choices = self._filler.value_choices(filled, found, path, query)
        elif filled.cells[slot].reason:
            return []
        else:
            choices = self._filler.choices(filled, found, query)
        if found.kind not in SEARCHED:
            folded = query.strip().lower()
            fitting = [each for each in choices if folded in each.text.lower()]
            choices = fitting or choices
        return choices[:MOST_CHOICES]

    def helps(self, filled: Filled) -> dict[tuple[str, Path | None], str]:
        """Return what is said about each row of a form."""
        return helps_of(filled, lambda slot: self._filler.ask(filled, slot))

    def offers(self) -> list[Offer]:
        """Return the entries of the menu that is shown, none where it is no menu."""
        offering = Offering(self.scene, self._filler)
        kind, group = self.page.kind, self.group or Aim.MORE
        is_new = self.head is not None and aim_of(self.head) is Aim.NODE
        if kind is PageKind.START:
            return offering.start()
        if kind is PageKind.PURPOSE:
            return offering.purposes(group, self.head_form, is_new=is_new)
        if kind is PageKind.AWAY:
            return offering.takeaways(group, self.head_form)
        return recipe_offers() if kind is PageKind.RECIPES else []
