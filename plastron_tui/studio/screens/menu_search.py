"""Finds actions by what somebody types in the menu: titles, other words for them, help."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from ..actions import Action

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
RECENT = "Recent"
"""The heading of what was done last."""


class Entry(NamedTuple):
    """A line of the menu: a heading, or an action."""

    heading: str
    action: Action | None = None


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


def found(query: str, actions: Iterable[Action], recent: Sequence[str]) -> tuple[Entry, ...]:
    """Return the actions that all words of a query are in, those that fit best first.

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
    return tuple(Entry("", action) for *_, action in ranked)


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
