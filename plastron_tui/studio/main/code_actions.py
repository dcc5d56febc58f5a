"""From an entry of a panel, or from the cursor, to the code."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from textual.screen import Screen

from ..editor.name_uses import function_at
from ..panels.entry import Entry, Subject
from ..panels.entry_keys import Pointing
from .active_program import ActiveProgram
from .node_runs import NodeRuns

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Node

    from ..code_places import Found, Place


class CodeActions:
    """Shows the files that something of the program is in."""

    def __init__(self, screen: Screen[None], program: ActiveProgram, runs: NodeRuns) -> None:
        self._searches = 0
        self._screen = screen
        self._program = program
        self._runs = runs

    @property
    def is_finding(self) -> bool:
        """Whether a file is looked for: keys are for what shows it."""
        return self._searches > 0

    async def show_of(self, of: Entry | str | None) -> None:
        """Show the code of an entry, of a service's answer, or of what the cursor is on.

        The cursor is that of the panel with the focus, or of the text.
        """
        if isinstance(of, str):
            await self._write_answer(of)
        elif of is not None:
            await self.show(of)
        else:
            await self._show_here()

    async def _show_here(self) -> None:
        focused = self._screen.focused
        entry = focused.current if isinstance(focused, Pointing) else None
        is_known = entry is not None and (entry.subject is not Subject.OTHER or entry.span)
        await self.show(entry if entry and is_known else self._program.editor.cursor_offset)

    async def _write_answer(self, service: str) -> None:
        """Save the program, write its files, and show where a service's answer is to be written."""
        from plastron_tui.model.kinds import EndpointKind

        nodes = self._program.open.session.workspace.nodes
        node = next((each for each, node in nodes.items() if _provides(node, service)), None)
        entry = Entry("", service, subject=EndpointKind.SERVICE, node=node, name=service)
        if await self._runs.actions.generate(only_new=True):
            await self.show(entry)

    async def show(self, asked: Entry | int) -> None:
        """Show the code of an entry, or of the statement at an offset: its function where it is.

        What is not written yet can be from there, and is shown again then.
        """
        while await self._shown(asked):
            await self._runs.actions.generate()

    async def _shown(self, asked: Entry | int) -> bool:
        """Show code, and return whether its file is to be written."""
        from ..screens.code_view import ChoosePlace, CodeView

        self._searches += 1
        try:
            found = await self._find(asked)
        finally:
            self._searches -= 1
        places = self._of_function(found.places, asked) or found.places
        # What is there, and can be changed, comes before what would be written.
        places = tuple(sorted(places, key=lambda place: place.text is not None))
        if not places:
            self._say(found.reason)
            return False
        at = 0
        if len({place.path for place in places}) > 1:
            at = await self._screen.app.push_screen_wait(ChoosePlace(places))
        return at >= 0 and await self._screen.app.push_screen_wait(CodeView(places, at))

    def _of_function(self, places: tuple[Place, ...], asked: Entry | int) -> tuple[Place, ...]:
        """Return the places of the function that is named at an offset, none where none is."""
        if not isinstance(asked, int):
            return ()
        name = function_at(self._program.open.session.document, asked)
        return tuple(each for each in places if each.what == f"function {name}")

    async def _find(self, asked: Entry | int) -> Found:
        """Find places, apart from the screen; those that the project may not lead to go."""
        from ..code_places import Found, find_code

        session = self._program.open.session
        found = await asyncio.to_thread(find_code, session.anew(), asked)
        allowed = tuple(place for place in found.places if self._is_allowed(place))
        if allowed or not found.places:
            return Found(allowed, found.reason)
        boundary, path = session.boundary, found.places[0].path
        return Found((), f"{path.name} is {boundary.place_of(path)}: trust the project to see it")

    def _is_allowed(self, place: Place) -> bool:
        return self._program.open.session.boundary.allows(place.path)

    def _say(self, text: str) -> None:
        self._screen.notify(text, severity="warning", markup=False)


def _provides(node: Node, service: str) -> bool:
    from plastron_tui.model.kinds import Service

    return any(each.name == service for each in node.of(Service).values())
