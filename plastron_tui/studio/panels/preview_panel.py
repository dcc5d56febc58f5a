"""The panel with the files that what is at the cursor becomes."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from textual import events, on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Container, Vertical
from textual.widgets import Static

from plastron_tui.diagnostics import Severity, counted

from .entry_keys import Chosen, Lit
from .file_tree import FileTree, TreeFile, is_tree
from .styles import Line, Piece
from .text_view import TextView

if TYPE_CHECKING:
    from typing_extensions import Self

    from ..analysis import Analysis
    from .preview import Preview

_STATES = {
    "create": ("will be created", "success"),
    "identical": ("is written already", "quiet"),
    "changed": ("will be changed", "warning"),
    "conflict": ("was changed by hand", "error"),
}
"""By the value of a `FileState`."""

_DIM = "$foreground 60%"
"""How the head says what is of little weight."""

_WIDE = 64
"""From so many columns on the files are beside the text, not above it."""

_NOT_GENERATED = ("not generated yet", "quiet")


class PreviewPanel(Vertical):
    """A file, or how it would change."""

    DEFAULT_CSS = """
    #preview-head { height: 1; padding: 0 1; background: $panel-ground; }
    #preview-body { height: 1fr; layout: vertical; }
    #preview-files { display: none; height: auto; max-height: 40%; min-height: 3; }
    PreviewPanel.-tree #preview-files { display: block; }
    PreviewPanel.-wide #preview-body { layout: horizontal; }
    PreviewPanel.-wide #preview-files { width: 32; height: 100%; }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("d", "toggle_diff", "Diff", id="preview.diff",
                tooltip="Show the whole file, or what changes in it"),
        Binding("n", "next_file", "Next file", id="preview.next",
                tooltip="Show the next file"),
        Binding("t", "turn", "Files or text", id="preview.turn",
                tooltip="Go to the list of the files, or to the text"),
    ]  # fmt: skip

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self.previews: tuple[Preview, ...] = ()
        self._subject: str | None = None
        self._shown: str | None = None
        self._at = 0
        self._shows_diff = True
        self._errors = 0
        self._head = Static("", id="preview-head", markup=True)
        self._tree = FileTree(id="preview-files")
        self._view = TextView(numbers=True, id="preview-text")

    def compose(self) -> ComposeResult:
        """Make the heading, the tree of the files, and the text."""
        yield self._head
        with Container(id="preview-body"):
            yield self._tree
            yield self._view

    @property
    def current(self) -> Preview | None:
        """The file that is shown."""
        return self.previews[self._at % len(self.previews)] if self.previews else None

    @property
    def text(self) -> str:
        """What is shown, without its colours."""
        return self._view.text

    def focus(self, scroll_visible: bool = True) -> Self:
        """Give the files the focus, where they are shown, and else the text."""
        (self._tree if self.has_tree else self._view).focus(scroll_visible)
        return self

    @property
    def has_tree(self) -> bool:
        """Whether the files are listed."""
        return is_tree(self._files)

    @property
    def _files(self) -> list[TreeFile]:
        return [TreeFile(each.name, each.state, each.size) for each in self.previews]

    def on_resize(self, event: events.Resize) -> None:
        """Have the files beside the text, where there is room."""
        self.set_class(event.size.width >= _WIDE, "-wide")

    def request(self, analysis: Analysis | None, offset: int) -> str | None:
        """Ask for the files of what is at the cursor, or else of the last one, or the first."""
        if analysis is None:
            return None
        self._errors = sum(each.severity is Severity.ERROR for each in analysis.diagnostics)
        known = analysis.workspace
        kinds = (known.nodes, known.packages, known.launches, known.robots, known.types)
        is_there = any(self._subject in each for each in kinds)
        last = self._subject if is_there else next((name for each in kinds for name in each), None)
        self._subject = analysis.written_at(offset) or last
        return self._subject

    def show(self, previews: tuple[Preview, ...] | None) -> None:
        """Show the files of a node; None for no node."""
        self.previews = previews or ()
        had_focus = self.has_focus_within
        self.set_class(self.has_tree, "-tree")
        self._tree.show_files(self._files if self.has_tree else ())
        if self._shown != self._subject:
            # Of another thing the first file comes first, whichever one has in common.
            self._shown, self._at = self._subject, 0
            self._tree.go_to(0)
            self._view.scroll_home(animate=False)
        elif self.has_tree and self._tree.number is not None:
            self._at = self._tree.number
        if had_focus and self._tree.has_focus and not self.has_tree:
            self._view.focus()
        self._draw()

    def follow(self, offset: int) -> None:
        """Mark the line that the statement at the cursor becomes, and bring it in sight."""
        current = self.current
        is_text = current is not None and not (self._shows_diff and current.diff)
        self._view.mark_line(current.line_at(offset) if current is not None and is_text else None)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Offer the diff where there is one."""
        current = self.current
        if action == "toggle_diff":
            return current is not None and bool(current.diff)
        if action == "next_file":
            return len(self.previews) > 1
        if action == "turn":
            return self.has_tree
        return True

    def action_toggle_diff(self) -> None:
        """Show the whole file, or what changes in it."""
        self._shows_diff = not self._shows_diff
        self._draw()

    def action_next_file(self) -> None:
        """Show the next file."""
        self._at = (self._at + 1) % max(1, len(self.previews))
        if self.has_tree:
            self._tree.go_to(self._at)
        self._draw()

    def action_turn(self) -> None:
        """Go to the list of the files, or to the text."""
        (self._view if self._tree.has_focus else self._tree).focus()

    @on(Lit)
    def lit(self, message: Lit) -> None:
        """Show the file that the cursor is on."""
        message.stop()
        number = self._tree.number
        if number is not None and number != self._at:
            self._at = number
            self._draw()
            self._view.scroll_home(animate=False)

    @on(Chosen)
    def chosen(self, message: Chosen) -> None:
        """Go to the text of the file."""
        message.stop()
        self._view.focus()

    def _draw(self) -> None:
        from textual.content import Content

        current = self.current
        pieces: list[Piece] = []
        if current is None:
            if not self._errors:
                pieces.append(Piece("put the cursor on the statement of a node or a package", _DIM))
            self._view.show((), numbers=False)
        elif current.path is None:
            pieces.append(Piece(current.name, ""))
            problems = tuple(_problem(found.message, found.help) for found in current.problems)
            self._view.show(problems, numbers=False)
        else:
            state, tone = _state(current)
            is_diff = self._shows_diff and bool(current.diff)
            if is_diff and current.origin and current.state is not None:
                state = f"{state}: what differs from {current.origin}"
            pieces += [Piece(_place(current), "bold"), Piece(state, tone)]
            if is_diff and current.diff:
                self._view.show(current.diff, numbers=False)
            else:
                self._view.show(current.lines, numbers=True)
            self.refresh_bindings()
        if self._errors:
            count = counted(self._errors, "problem")
            pieces.append(Piece(f"mend {count} first", "$text-error"))
        parts = [part for text, style in pieces for part in ("  ", (text, style))]
        self._head.update(Content.assemble(*parts[1:]))


def _place(preview: Preview) -> str:
    """Return what a file is called: of one that is not there yet with its folder."""
    state = preview.state
    if preview.path is None or preview.diff == () or state is None or state.value != "create":
        return preview.name
    return f"{preview.path.parent.name}/{preview.name}"


def _state(preview: Preview) -> tuple[str, str]:
    """Return what is said of a file behind its name, and in which style."""
    if preview.diff == ():
        return "as it was loaded: nothing in it changes", _DIM
    state, tone = _NOT_GENERATED if preview.state is None else _STATES[preview.state.value]
    return state, _DIM if tone == "quiet" else f"$text-{tone}"


def _problem(message: str, remedy: str | None) -> Line:
    text = f" {message}" + (f" — {remedy}" if remedy else "")
    return (Piece(text, "error"),)


def make(analysis: Analysis, node: str) -> tuple[Preview, ...]:
    """Make what the panel shows."""
    from .preview import previews_of

    return previews_of(analysis, node)
