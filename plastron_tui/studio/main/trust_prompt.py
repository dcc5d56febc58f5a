"""What waits until the user trusts the project: it is said once, and asked."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from textual.screen import Screen

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.diagnostics.terminal import visible

from .active_program import ActiveProgram

if TYPE_CHECKING:
    from ..analysis import Analysis


class TrustPrompt:
    """Lets the user trust the project of the program."""

    def __init__(
        self, screen: Screen[None], program: ActiveProgram, key_of: Callable[[str], str]
    ) -> None:
        """Prepare to ask.

        Args:
            screen: shows the question.
            program: the program whose project it is.
            key_of: returns the key of an action.
        """
        self._screen = screen
        self._program = program
        self._key_of = key_of
        self._told: Path | None = None

    def tell_what_waits(self, analysis: Analysis) -> None:
        """Say, once for a project, that something in it is not used until it is trusted."""
        waiting, root = _waiting(analysis), analysis.session.boundary.root
        if not waiting or root == self._told:
            return
        self._told = root
        message = f"{visible(waiting[0].message)}\nIf you trust it: {self._key_of('trust')}"
        self._screen.notify(message, severity="warning", timeout=10, markup=False)

    def explain(self, errors: Sequence[Diagnostic]) -> str | None:
        """Say that trust is all that is missing; None where something else is wrong."""
        if not all(map(_waits_for_trust, errors)):
            return None
        return f"only once you trust this project: {self._key_of('trust')}"

    async def ask(self) -> bool:
        """Ask whether the project is trusted; tell whether it now is, and was not before."""
        from plastron_tui.trust import TrustStore, TrustStoreError

        from ..screens.question import Question

        screen, open_ = self._screen, self._program.open
        waiting = [] if open_.analysis is None else _waiting(open_.analysis)
        boundary = open_.session.boundary
        if not waiting:
            said = (
                "you trust this project already"
                if boundary.is_trusted
                else "nothing in this project has to be trusted"
            )
            screen.notify(said, timeout=3)
            return False
        said = "\n".join(dict.fromkeys(visible(found.message) for found in waiting[:4]))
        # The question says what they said.
        screen.app.clear_notifications()
        answer = await screen.app.push_screen_wait(
            Question(
                "Do you trust this project?",
                [("leave", "Leave it"), ("trust", "Trust it")],
                text=f"{visible(str(boundary.root))}\n\n{said}\n\nTrust it if you know "
                "who made it. `plastron trust --remove` takes it back.",
            )
        )
        if answer != "trust":
            return False
        try:
            TrustStore().add(boundary.root)
        except TrustStoreError as error:
            screen.notify(visible(str(error)), severity="error", timeout=10, markup=False)
            return False
        if open_ is not self._program.open:
            return False
        open_.session.trust_changed()
        return True


def _waiting(analysis: Analysis) -> list[Diagnostic]:
    """Return what the user has to trust the project for."""
    return list(filter(_waits_for_trust, analysis.diagnostics))


def _waits_for_trust(found: Diagnostic) -> bool:
    from plastron_tui.project.settings import TRUST_CODES

    return found.code in TRUST_CODES
