"""The pages that are menus."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from textual import events, on
from textual.app import ComposeResult
from textual.containers import Vertical
from textual.content import Content
from textual.message import Message
from textual.widgets import Checkbox, Label, OptionList
from textual.widgets.option_list import Option as Line

from .menu import Option
from .rows import Confirmed, Turn


@dataclass(frozen=True, slots=True)
class Item:
    """An entry of a menu: its words, the word of ROS, a sentence, and why it is closed."""

    title: str
    term: str = ""
    about: str = ""
    closed: str = ""
    is_advised: bool = False


_LINES = 2
"""The lines of an entry: its words, and the sentence about it."""


class Picked(Message):
    """An entry was chosen, by its number."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


class Menu(OptionList):
    """A list of what one may want."""

    takes_bursts = True
    """A text that comes as keys is a pasted one, of which no key chooses an entry."""

    def __init__(self, items: Sequence[Item], here: int | None = None) -> None:
        """List the entries; the cursor is on one of them, where that can be chosen."""
        options = (
            Line(_words(item), id=str(number), disabled=bool(item.closed))
            for number, item in enumerate(items)
        )
        super().__init__(*options, id="wizard-menu", compact=True, markup=False)
        self._titles = [item.title for item in items]
        free = [number for number, item in enumerate(items) if not item.closed]
        advised = [number for number in free if items[number].is_advised]
        self._here = here if here in free else next(iter(advised or free), None)

    def on_mount(self) -> None:
        """Take the keys."""
        self.highlighted = self._here
        self.focus()

    @property
    def _free(self) -> list[int]:
        """The entries that can be chosen."""
        return [n for n, option in enumerate(self.options) if not option.disabled]

    def _page(self, by: int) -> None:
        """Go on by as many entries as are seen at once, and always to one of them."""
        free, here = self._free, self.highlighted
        if not free:
            return
        at = free.index(here) if here in free else 0
        step = max(1, self.scrollable_content_region.height // _LINES)
        self.highlighted = free[min(max(at + by * step, 0), len(free) - 1)]

    def on_key(self, event: events.Key) -> None:
        """Go to the next entry that begins with a letter."""
        letter = event.character
        if letter is None or not letter.isalnum():
            return
        event.stop()
        found = next_with(letter, self._titles, self._free, self.highlighted)
        if found is not None:
            self.highlighted = found

    def action_page_down(self) -> None:
        """Go a page on."""
        self._page(1)

    def action_page_up(self) -> None:
        """Go a page back."""
        self._page(-1)

    def action_select(self) -> None:
        """Choose the entry with the cursor, or else the first one."""
        if self.highlighted is None:
            self.highlighted = next(iter(self._free), None)
        super().action_select()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Tell what was chosen."""
        event.stop()
        self.post_message(Picked(int(event.option.id or 0)))


def next_with(
    letter: str, titles: Sequence[str], free: Sequence[int], here: int | None
) -> int | None:
    """Return the next of the free entries that begins with a letter, None for none."""
    fitting = [number for number in free if titles[number][:1].lower() == letter.lower()]
    behind = (number for number in fitting if here is not None and number > here)
    return next(behind, next(iter(fitting), None))


def _words(item: Item) -> Content:
    title = item.title[:1].upper() + item.title[1:]
    parts: list[str | tuple[str, str]] = [(title, "$foreground 50%" if item.closed else "bold")]
    if item.is_advised and not item.closed:
        parts.insert(0, ("next: ", "$text-success"))
    if item.term:
        parts.append((f"  {item.term}", "$text-secondary"))
    # What cannot be chosen is no louder than what can.
    said = f"Not now: {item.closed}" if item.closed else item.about
    parts.append((f"\n  {said}", "$foreground 60%"))
    return Content.assemble(*parts)


class MenuPage(Vertical):
    """A menu, with a line above it."""

    def __init__(self, text: str, items: Sequence[Item], here: int | None = None) -> None:
        super().__init__(id="wizard-menu-page")
        self._text = text
        self._items = list(items)
        self._here = here

    def compose(self) -> ComposeResult:
        """Make the line and the menu."""
        if self._text:
            yield Label(self._text, id="wizard-about", markup=False)
        yield Menu(self._items, self._here)


class Wanted(Message):
    """Whether something is to be written along was turned."""

    def __init__(self, key: str, value: bool) -> None:
        super().__init__()
        self.key = key
        self.value = value


_PREFIX = "wizard-"


class ReviewPage(Vertical):
    """The last look before the statements enter the program."""

    def __init__(self, words: str, options: Sequence[Option]) -> None:
        super().__init__(id="wizard-review")
        self._words = words
        self._options = options

    def compose(self) -> ComposeResult:
        """Make the words, and the questions what is to be written along."""
        yield Label(self._words, id="wizard-about", markup=False)
        for each in self._options:
            # What would be written is said whole, on as many lines as it takes.
            yield Turn(Content(each.words), each.is_wanted, compact=True, id=f"{_PREFIX}{each.key}")
        yield Label("", id="wizard-help", markup=False)

    @on(Checkbox.Changed)
    def turned(self, event: Checkbox.Changed) -> None:
        """Tell it."""
        event.stop()
        key = (event.checkbox.id or "").removeprefix(_PREFIX)
        self.post_message(Wanted(key, event.value))

    def say(self, words: str, problem: str) -> None:
        """Say what will be written, and what is wrong with it, "" for nothing."""
        self.query_one("#wizard-about", Label).update(words)
        label = self.query_one("#wizard-help", Label)
        label.set_class(bool(problem), "-wrong")
        label.update(f"✗ {problem}" if problem else "")


__all__ = ["Confirmed", "Item", "Menu", "MenuPage", "Picked", "ReviewPage", "Wanted"]
