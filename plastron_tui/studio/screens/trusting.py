"""What waits until the user trusts the project: it is said once, and asked."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from textual import work

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.project import TRUST_CODES

from .part import Part

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plastron_tui.diagnostics import Diagnostic

    from ..analysis import Analysis

_NOTHING = "nothing in this project has to be trusted"


class Trusting(Part):
    """Lets the user trust the project of the program."""

    _told: Path | None = None

    def tell_what_waits(self, analysis: Analysis) -> None:
        """Say, once for a project, that something in it is not used until it is trusted."""
        waiting, root = _waiting(analysis), analysis.session.boundary.root
        if not waiting or root == self._told:
            return
        self._told = root
        message = f"{visible(waiting[0].message)}\nIf you trust it: {self._trust_key}"
        self.notify(message, severity="warning", timeout=10, markup=False)

    def trust_first(self, errors: Sequence[Diagnostic]) -> str | None:
        """Say that trust is all that is missing; None where something else is wrong."""
        if any(found.code not in TRUST_CODES for found in errors):
            return None
        return f"only once you trust this project: {self._trust_key}"

    @property
    def _trust_key(self) -> str:
        from ..actions import BY_ID

        return self.studio.key_of("trust", BY_ID["trust"].keys)

    @work(exclusive=True, group="trust")
    async def action_trust(self) -> None:
        """Ask whether the project is trusted, and do then what waited for it."""
        from plastron_tui.trust import TrustStore, TrustStoreError

        from .question import Question

        open_ = self.open
        waiting = [] if open_.analysis is None else _waiting(open_.analysis)
        if not waiting:
            is_trusted = open_.session.boundary.is_trusted
            said = "you trust this project already" if is_trusted else _NOTHING
            self.notify(said, timeout=3)
            return
        root = open_.session.boundary.root
        said = "\n".join(dict.fromkeys(visible(found.message) for found in waiting[:4]))
        # The question says what they said.
        self.app.clear_notifications()
        answer = await self.app.push_screen_wait(
            Question(
                "Do you trust this project?",
                [("leave", "Leave it"), ("trust", "Trust it")],
                text=f"{visible(str(root))}\n\n{said}\n\nTrust it if you know "
                "who made it. `plastron trust --remove` takes it back.",
            )
        )
        if answer != "trust":
            return
        try:
            TrustStore().add(root)
        except TrustStoreError as error:
            self.notify(visible(str(error)), severity="error", timeout=10, markup=False)
            return
        if open_ is self.open:
            open_.session.trust_changed()
            self.ask_anew()


def _waiting(analysis: Analysis) -> list[Diagnostic]:
    """Return what the user has to trust the project for."""
    return [found for found in analysis.diagnostics if found.code in TRUST_CODES]
