"""Files that would be written, as a tree of their folders; few of them are a plain list."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from textual import events
from textual.binding import Binding, BindingType

from plastron_tui.diagnostics.wording import counted

from .entry import Entries, Entry
from .entry_list import EntryList

if TYPE_CHECKING:
    from plastron_tui.output.plan import FileState

FEW = 2
"""So many files are a list: folders would only be in the way."""

_SIGNS: dict[str | None, tuple[str, str]] = {
    "create": ("+", "success"),
    "identical": ("=", "quiet"),
    "changed": ("~", "warning"),
    "conflict": ("!", "error"),
    None: ("·", "quiet"),
}
_LOOKED_AT = ("conflict", "changed", "create")
_FOLDER = ("▾", "quiet")
_WORDS = {"changed": "changed", "conflict": "by hand"}
"""What of its files is said beside a folder: that of the others shows in their signs."""


class TreeFile(NamedTuple):
    """A file.

    Attributes:
        name: its name; between folders stands `/`.
        state: what writing does to it, None where it is not to be written yet.
        size: how large it will be, in bytes.
    """

    name: str
    state: FileState | None
    size: int


class _Keyed(NamedTuple):
    """A file with its own name, and the key of its line."""

    name: str
    key: str
    file: TreeFile


@dataclass(slots=True)
class _Folder:
    folders: dict[str, _Folder] = field(default_factory=dict)
    files: list[_Keyed] = field(default_factory=list)

    def states(self) -> Iterator[FileState | None]:
        yield from (each.file.state for each in self.files)
        for inner in self.folders.values():
            yield from inner.states()


def is_tree(files: Sequence[TreeFile]) -> bool:
    """Tell whether files are shown with their folders."""
    return len(files) > FEW and any("/" in file.name for file in files)


def entries_of(files: Sequence[TreeFile]) -> Entries:
    """Return files as the lines of a list, by the keys of `keys_of`.

    Folders come first; one that holds nothing but another one shares its line with that.
    """
    keyed = zip(keys_of(files), files, strict=True)
    if not is_tree(files):
        return Entries(_plain(key, file) for key, file in keyed)
    top = _Folder()
    for key, file in keyed:
        *folders, name = file.name.split("/")
        place = top
        for each in folders:
            place = place.folders.setdefault(each, _Folder())
        place.files.append(_Keyed(name, key, file))
    return Entries(_lines(top, "", 0))


def keys_of(files: Sequence[TreeFile]) -> list[str]:
    """Return a key for each file: its name, and where several have it, which of them it is."""
    seen: Counter[str] = Counter()
    keys = []
    for file in files:
        seen[file.name] += 1
        count = seen[file.name]
        keys.append(file.name if count == 1 else f"{file.name} {count}")
    return keys


def _plain(key: str, file: TreeFile) -> Entry:
    sign, tone = _SIGNS[file.state]
    word = "" if file.state is None else file.state.value
    return Entry(key, file.name, "", f"{sign} {word:<9}", tone)


def _lines(folder: _Folder, before: str, depth: int) -> Iterator[Entry]:
    for name, inner in sorted(folder.folders.items()):
        shown, here = name, inner
        while not here.files and len(here.folders) == 1:
            ((following, here),) = here.folders.items()
            shown += f"/{following}"
        path = f"{before}{shown}/"
        yield _folder(path, f"{shown}/", here, depth)
        yield from _lines(here, path, depth + 1)
    for name, key, file in sorted(folder.files, key=lambda each: each.name):
        yield Entry(key, name, size_text(file.size), *_SIGNS[file.state], depth=depth)


def _folder(path: str, shown: str, folder: _Folder, depth: int) -> Entry:
    states: list[str | None] = list(folder.states())
    said = [counted(len(states), "file")]
    said += [f"{states.count(each)} {word}" for each, word in _WORDS.items() if each in states]
    return Entry(path, shown, ", ".join(said), *_FOLDER, depth=depth, is_branch=True)


def first_seen(files: Sequence[TreeFile]) -> int:
    """Return which file is shown first: one that was written by hand, or changes, or is new."""
    states: list[str | None] = [file.state for file in files]
    found = (states.index(each) for each in _LOOKED_AT if each in states)
    return next(found, 0)


def size_text(size: int) -> str:
    """Return a size as it is read: `312 B`, `1.2 kB`, `3.4 MB`."""
    if size < 1000:
        return f"{size} B"
    for unit in ("kB", "MB"):
        size_in_unit = size / (1000 if unit == "kB" else 1_000_000)
        if size_in_unit < 999.95:
            break
    return f"{size_in_unit:.1f} {unit}"


class FileTree(EntryList):
    """Files to look at, one after the other."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("space,left,right", "fold", "Fold", id="panel.fold"),
        Binding("enter", "choose", "Take it", show=False, id="panel.choose"),
    ]

    _numbers: Mapping[str, int] = {}

    def show_files(self, files: Sequence[TreeFile]) -> None:
        """Show files; the cursor stays where it is, at first on the file that comes first."""
        was_empty = not self.entries.all
        self._numbers = {key: number for number, key in enumerate(keys_of(files))}
        self.show(entries_of(files))
        if was_empty or self.number is None:
            self.go_to(0)

    @property
    def number(self) -> int | None:
        """Which of the files is under the cursor, None for a folder."""
        current = self.current
        return None if current is None else self._numbers.get(current.key)

    def go_to(self, number: int) -> None:
        """Put the cursor on a file, in a folder that is folded too."""
        key = next((key for key, each in self._numbers.items() if each == number), None)
        if key is None:
            return
        if key not in self._rows:
            self._folded.clear()
            self._lay_out()
        self.index = self._rows[key]
        self._reveal(self.index)
        self.tell_current()

    def action_choose(self) -> None:
        """Fold the folder, or take the file."""
        if self.current is not None and self.current.is_branch:
            self.action_fold()
        else:
            super().action_choose()

    def on_click(self, event: events.Click) -> None:
        """Fold the folder under the mouse, or show the file."""
        event.prevent_default()
        row = event.y + self.scroll_offset.y
        if not 0 <= row < len(self._shown):
            return
        self.index = row
        if self._shown[row].is_branch:
            self.action_fold()
        self.tell_current()
