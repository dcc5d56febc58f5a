"""The entries of the wizard's menus."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from plastron_tui.language import Declaration
from plastron_tui.model.workspace import Workspace
from plastron_tui.session import Session

from ..recipes import recipes
from .goals import Aim, generating


@dataclass(frozen=True, slots=True)
class Offer:
    """An entry of a menu.

    Attributes:
        declaration: the statement, None for the entry that leads to a menu of its own.
        title: what one wants.
        term: what ROS calls it.
        about: a sentence about it.
        closed: why it cannot be had now, "" where it can.
        is_advised: whether it is what most would do next.
        recipe: the program that it starts from.
        group: the menu of its own that it leads to.
        drives: whether it drives a robot until something is near.
        takes_away: whether it leads to the menu of what can be taken away.
    """

    declaration: Declaration | None
    title: str
    term: str
    about: str
    closed: str = ""
    is_advised: bool = False
    recipe: Path | None = None
    group: Aim | None = None
    drives: bool = False
    takes_away: bool = False


class Option(NamedTuple):
    """What may be written along with statements: its key, its words, whether it is wanted."""

    key: str
    words: str
    is_wanted: bool


RECIPES = Offer(
    None,
    "start from a program that works",
    "recipe",
    "Opens a whole program, to be run and changed; the one at hand is closed.",
)
"""The entry that leads to the recipes."""


AWAY = Offer(
    None,
    "take something away",
    "",
    "Something that is there already goes again.",
    takes_away=True,
)
"""The entry that leads to what can be taken away."""


def recipe_offers() -> list[Offer]:
    """Return the programs that one can start from."""
    return [
        Offer(None, each.title, "", f"{each.description}.", recipe=each.path) for each in recipes()
    ]


def writes_too(session: Session, node: str) -> str:
    """Return the words of the question whether a node is written to its file along with it."""
    found = session.workspace.nodes.get(node)
    source = None if found is None else found.source
    folder = f"{session.output.name}/"
    if source is None:
        return f"write {node} to its file in {folder}, too"
    if session.options.in_place:
        return f"write the changed {source.path.name}, too"
    return f"write the changed {source.path.name} to {folder}, too; your own file stays as it is"


def writes_at_once(offer: Offer, workspace: Workspace) -> bool:
    """Tell whether all that could be generated is: then the files can be written."""
    if offer.declaration is None or offer.declaration is not generating():
        return False
    generated = {made.node.variable for made in workspace.generations}
    return all(node.is_idle or name in generated for name, node in workspace.nodes.items())
