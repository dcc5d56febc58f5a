"""The entries of the menus: which can be had now, and which most would take next."""

from __future__ import annotations

from dataclasses import dataclass, replace

from plastron_tui.language import Declaration, SlotKind
from plastron_tui.session import Session

from .context import Scene
from .filling import Filled, Filler
from .followers import followed
from .form import Form
from .goals import DRIVE, GROUPS, Aim, answering, declarations_of, told
from .menu import AWAY, RECIPES, Offer
from .program_trial import Finding, check

FEW = 2
"""So many entries that take something away stand in a menu themselves, more in one of their own."""

_DRIVE_AT = 2
"""Where that stands in its menu: behind to send, and to listen."""


def undoing(group: Aim) -> list[Declaration]:
    """Return the statements of a menu that take something away."""
    return [each for each in declarations_of(group) if each.undoes is not None]


def give(main: Form, filled: list[Filled]) -> None:
    """Let the node of a form be the one that the form before it makes."""
    slot = main.slot_of(SlotKind.NODE)
    if slot is None or not filled:
        return
    made = filled[0].form.made
    if made is not None:
        main.given[slot.name] = filled[0].cells[made.name].text


@dataclass(frozen=True, slots=True)
class Offering:
    """Makes the entries of menus, for a program."""

    scene: Scene
    filler: Filler

    def start(self) -> list[Offer]:
        """Return the entries of the first menu."""
        offers = []
        for aim in Aim:
            group = GROUPS.get(aim)
            if group is None:
                offers += [self._offer(each, None) for each in declarations_of(aim)]
                continue
            is_closed = aim is Aim.MORE and not self.scene.workspace.nodes
            closed = "there is no node yet: make one first" if is_closed else ""
            offers.append(Offer(None, group.title, group.term, group.about, closed, group=aim))
        return [*offers, RECIPES]

    def purposes(self, group: Aim, head: Form | None, *, is_new: bool) -> list[Offer]:
        """Return the entries of a menu of its own: those that can be had now come first.

        Args:
            group: whose menu it is.
            head: the form that makes the node that it is about, None where there is none.
            is_new: whether that node is a new one, which has nothing that could be taken away.
        """
        scene, filled = self._with(head)
        declared = (each for each in declarations_of(group) if each.undoes is None)
        offers = [self._offer(each, scene, filled) for each in declared]
        away = [] if is_new else [self._offer(each, scene, filled) for each in undoing(group)]
        if len(away) > FEW:
            is_closed = all(each.closed for each in away)
            away = [replace(AWAY, closed="there is nothing yet that can go" if is_closed else "")]
        offers += away
        if group is Aim.MORE:
            offers.insert(_DRIVE_AT, self._drive(scene, filled))
        # What most would do next stands first, and all others as they always do.
        first = next((each for each in offers if each.is_advised), None)
        if first is not None:
            offers = [
                first,
                *(replace(each, is_advised=False) for each in offers if each is not first),
            ]
        return sorted(offers, key=lambda each: bool(each.closed))

    def takeaways(self, group: Aim, head: Form | None) -> list[Offer]:
        """Return the entries of the menu of what can be taken away, or has to stay.

        Of what no node has nothing is said: that is most of it.

        Args:
            group: the menu that leads there.
            head: the form that makes the node that it is about, None where there is none.
        """
        scene, filled = self._with(head)
        nodes = scene.workspace.nodes
        offers = [
            offer
            for each in undoing(group)
            if not (offer := self._offer(each, scene, filled)).closed
            or any(scene.ended_by(node, each.type) for node in nodes)
        ]
        return sorted(offers, key=lambda each: bool(each.closed))

    def _with(self, head: Form | None) -> tuple[Scene, list[Filled]]:
        """Return the program with what a form makes, and that form as it is filled."""
        if head is None:
            return self.scene, []
        filled = self.filler.fill(head, self.scene)
        return self.filler.extended(self.scene, filled), [filled]

    def _drive(self, scene: Scene, filled: list[Filled]) -> Offer:
        """Return the entry that brings the laser along by which a robot is driven."""
        closed, _ = self._tried(answering(), scene, filled, drives=True)
        return Offer(answering(), *DRIVE, closed, drives=True)

    def _offer(
        self, declaration: Declaration, scene: Scene | None, filled: list[Filled] | None = None
    ) -> Offer:
        title, term, about = declaration.purpose, declaration.ros_term, told(declaration)
        if scene is None:
            closed, _ = self._tried(declaration, self.scene, [])
            # A file's path can be written where none was found.
            if not declaration.writes_file:
                closed = ""
            return Offer(declaration, title, term, about, closed)
        closed, after = self._tried(declaration, scene, filled or [])
        advised = not closed and after is not None and _completes(declaration, scene, after)
        return Offer(declaration, title, term, about, closed, advised)

    def _tried(
        self, declaration: Declaration, scene: Scene, filled: list[Filled], *, drives: bool = False
    ) -> tuple[str, Session | None]:
        """Try a statement with what is suggested for it.

        Returns:
            Why it cannot be had, whatever is entered, as far as that is known; and the program with
            it, None where that is not known before a user has said something.
        """
        form = Form(declaration, drives=drives)
        give(form, filled)
        anew = self.filler.fill(form, scene)
        if anew.all_problems:
            first = anew.all_problems[0]
            return "" if _is_for_user(first, declaration) else first.message, None
        if anew.goes_on_with:
            return "", None
        outcome = check(scene.session, anew.written)
        findings = outcome.findings
        if findings:
            # What follows it may be what it lacks.
            findings = check(scene.session, followed(anew)).findings
        return findings[0].words if findings else "", outcome.session


def _completes(declaration: Declaration, scene: Scene, after: Session) -> bool:
    """Tell whether a topic or service that lacks a side has both after a statement."""
    # One that takes something away may take the side that there is: whether that is wanted, nobody
    # knows.
    return declaration.undoes is None and Scene(after).lonely < scene.lonely


_FOR_USERS = frozenset(
    {
        *(SlotKind.TYPE_FILE, SlotKind.PACKAGE_FOLDER, SlotKind.LAUNCH_FILE, SlotKind.INCLUDED),
        SlotKind.ROBOT_FILE,
    }
)
"""The slots that a user can fill where nothing was found for them: with a path."""


def _is_for_user(finding: Finding, declaration: Declaration) -> bool:
    """Tell whether it is for the user to say what is missing."""
    kinds = (slot.kind for slot in declaration.slots if slot.name == finding.slot)
    return declaration.undoes is None and any(kind in _FOR_USERS for kind in kinds)
