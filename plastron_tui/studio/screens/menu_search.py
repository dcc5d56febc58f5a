"""Finds what somebody types in the menu: actions by title, other words and help, and names."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from ..actions import Action

if TYPE_CHECKING:
    from ..program_names import ProgramName

_MOST_RECENT = 5
WORDS = {
    "help": "manual explain", "run": "start launch execute play", "stop": "kill end interrupt",
    "generate": "build make write code", "wizard": "form guide create node robot",
    "menu": "palette commands", "panels": "sidebar", "next_panel": "focus tab",
    "zoom": "maximize full", "wider": "bigger grow resize", "narrower": "shrink resize",
    "fix": "repair remedy correct", "new": "create empty", "open": "load file",
    "save": "write store", "save_as": "write copy", "welcome": "start recent examples recipes",
    "tour": "tutorial learn introduction", "trust": "allow safe",
    "theme": "colors appearance dark light", "keys": "shortcuts bindings keyboard",
    "config": "settings preferences options remap", "suspend": "background shell",
    "quit": "exit close leave end", "problems": "errors mistakes warnings", "output": "log print",
    "preview": "code diff python", "graph": "picture diagram", "topics": "publishers subscribers",
    "back": "jump return previous place", "forward": "jump next place",
    "editor.undo": "back revert", "editor.redo": "forward again", "editor.copy": "yank clipboard",
    "editor.paste": "clipboard insert", "editor.find": "search look",
    "editor.replace": "substitute exchange", "editor.go_to_line": "jump number",
    "editor.complete": "suggest autocomplete", "editor.toggle_comment": "uncomment disable",
    "editor.duplicate": "copy repeat", "editor.delete_line": "remove erase",
    "editor.definition": "jump source", "editor.rename": "refactor",
    "editor.uses": "references usages find all who",
    "editor.format": "tidy indent pretty", "editor.external_editor": "vim nano emacs",
    "editor.toggle_wrap": "break soft", "editor.next_problem": "error jump",
    "editor.previous_problem": "error jump",
}  # fmt: skip
"""What somebody may look for who does not know how an action is called, by its id."""
NAMES = "In this program"
"""The heading of the names of the program."""
ONLY_NAMES = "@"
"""What a query begins with that is to find names alone."""
_MOST_NAMES = 100
RECENT = "Recent"
"""The heading of what was done last."""


class Entry(NamedTuple):
    """A line of the menu: a heading, an action, or a name of the program."""

    heading: str
    action: Action | None = None
    name: ProgramName | None = None

    @property
    def chosen(self) -> Action | ProgramName | None:
        """What is chosen with the line; None of a heading."""
        return self.action or self.name


def listed(
    groups: Iterable[tuple[str, Sequence[Action]]], recent: Sequence[str]
) -> tuple[Entry, ...]:
    """Return all actions under their headings, with those of late before them."""
    groups = list(groups)
    by_id = {action.id: action for _, actions in groups for action in actions}
    late = [by_id[name] for name in dict.fromkeys(recent) if name in by_id][:_MOST_RECENT]
    entries: list[Entry] = []
    for heading, actions in [(RECENT, late), *groups]:
        if actions:
            entries.append(Entry(heading))
            entries += [Entry(heading, action) for action in actions]
    return tuple(entries)


def answers(
    query: str, actions: Iterable[Action], recent: Sequence[str], names: Sequence[ProgramName]
) -> tuple[Entry, ...]:
    """Return what fits a query: actions, and the names of the program below their heading.

    The names come first where one begins with the query, and the title of no action does.
    """
    is_about_names = query.lstrip().startswith(ONLY_NAMES)
    named = _names(query.strip().removeprefix(ONLY_NAMES), names)
    acting = [] if is_about_names else _ranked(query, actions, recent)
    below = [Entry(NAMES), *(Entry(NAMES, name=name) for _, name in named)] if named else []
    above = [Entry("", action) for _, action in acting]
    is_better = named and named[0][0] == 0 and (not acting or acting[0][0] > 0)
    return (*below, *above) if is_better else (*above, *below)


def found(query: str, actions: Iterable[Action], recent: Sequence[str]) -> tuple[Entry, ...]:
    """Return the actions that all words of a query are in, those that fit best first."""
    return tuple(Entry("", action) for _, action in _ranked(query, actions, recent))


def _ranked(
    query: str, actions: Iterable[Action], recent: Sequence[str]
) -> list[tuple[int, Action]]:
    """Return the actions that all words of a query are in, each with a rank, the best first.

    A word fits a title better than a synonym, and that better than the help; its beginning fits
    better than its middle, and the letters of a title in their order fit last of all. Among those
    that fit as well the one of late comes first, then the one that is declared first.
    """
    words = query.lower().split()
    late = {name: place for place, name in enumerate(recent)}
    ranked = []
    for place, action in enumerate(actions):
        ranks = [_rank(word, action) for word in words]
        if all(rank is not None for rank in ranks):
            total = sum(rank for rank in ranks if rank is not None)
            ranked.append((total, late.get(action.id, len(late)), place, action))
    ranked.sort(key=lambda each: each[:3])
    return [(total, action) for total, _, _, action in ranked]


def _names(query: str, names: Iterable[ProgramName]) -> list[tuple[int, ProgramName]]:
    """Return the names that all words of a query fit, each with a rank, the best first."""
    words = [word.strip("/'\"") for word in query.lower().split()]
    ranked = []
    for name in names:
        ranks = [_rank_of_name(word, name) for word in words]
        if all(rank is not None for rank in ranks):
            ranked.append((sum(rank for rank in ranks if rank is not None), name))
    ranked.sort(key=lambda each: each[0])
    return ranked[:_MOST_NAMES]


def _rank_of_name(word: str, name: ProgramName) -> int | None:
    """Return how well a word fits a name, or what has the name; None where it does not."""
    text = name.entry.text.lower().lstrip("/")
    others = f"{text} {name.entry.detail}".lower()
    parts = others.translate(_AS_BLANKS)
    places = (
        text.startswith(word) or name.kind.startswith(word),
        f" {word}" in f" {parts}",
        word in others or f" {word}" in name.kind,
        len(word) > 1 and _is_spread(word, text),
    )
    return next((rank for rank, fits in enumerate(places) if fits), None)


_AS_BLANKS = str.maketrans("/_.~", "    ")
"""What is between the parts of a name."""


def _rank(word: str, action: Action) -> int | None:
    """Return how well a word fits, 0 for the best; None where it does not."""
    title = action.title.lower()
    others = f"{WORDS.get(action.id, '')} {action.id.replace('.', ' ').replace('_', ' ')}"
    places = (
        title.startswith(word),
        f" {word}" in title,
        f" {word}" in f" {others}",
        f" {word}" in f" {action.help} {action.group}".lower(),
        len(word) > 1 and word in f"{title} {others}",
        len(word) > 1 and _is_spread(word, title),
    )
    return next((rank for rank, fits in enumerate(places) if fits), None)


def _is_spread(word: str, title: str) -> bool:
    """Tell whether the letters of a word are the first ones of a title's words, or follow them.

    `gtl` is in `go to line`, and no help has to be read for it.
    """
    letters = iter(title)
    return word[0] == title[:1] and all(letter in letters for letter in word)
