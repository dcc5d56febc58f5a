"""The one-line bars at the editor's lower edge: find and replace, and a question with an answer."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import Button, Input, Label

from ..key_display import key_name
from .finder import Finder

# A button, what it says, and the action whose key it names.
_BUTTONS = (
    ("#find-regex", ".*", "find.regex"),
    ("#find-case", "Aa", "find.case"),
    ("#find-all", "all", "find.replace_all"),
)


class FindBar(Vertical):
    """Asks what to find, and what to put in its place."""

    DEFAULT_CSS = """
    FindBar { dock: bottom; height: auto; display: none; background: $panel; }
    FindBar Horizontal { height: 1; width: 1fr; }
    FindBar Input { width: 1fr; height: 1; border: none; padding: 0 1; }
    FindBar Label { width: auto; padding: 0 1; }
    FindBar Button { min-width: 4; width: auto; height: 1; border: none; margin: 0 0 0 1; }
    FindBar Button.is-on { background: $accent !important; color: auto !important; }
    FindBar #find-count { min-width: 10; text-align: right; }
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "close", "Close", id="find.close"),
        Binding("down,f3", "step(1)", "Next", id="find.next"),
        Binding("up,shift+f3,f15", "step(-1)", "Previous", id="find.previous"),
        Binding("tab,shift+tab", "other_field", "The other line", show=False, id="find.other"),
        Binding("alt+r,f6", "toggle_regex", "Regular expression", id="find.regex"),
        Binding("alt+c,f7", "toggle_case", "Upper and lower case", id="find.case"),
        Binding("alt+a,f9", "all", "Replace all", id="find.replace_all"),
    ]

    def __init__(self, finder: Finder, leave: Callable[[], object]) -> None:
        """Ask for what a finder finds; `leave` gives the focus back."""
        super().__init__()
        self._finder = finder
        finder.say = self._say
        self._leave = leave
        self._is_regex = False
        self._is_case_sensitive = False

    def on_mount(self) -> None:
        """Leave the focus where something is typed."""
        for button in self.query(Button):
            button.can_focus = False

    def compose(self) -> ComposeResult:
        """Make the two lines."""
        with Horizontal():
            yield Label("find")
            yield Input(id="find-what", compact=True)
            yield Button(".*", id="find-regex", compact=True, tooltip="regular expression")
            yield Button("Aa", id="find-case", compact=True, tooltip="upper and lower case")
            yield Label("", id="find-count", markup=False)
        with Horizontal(id="replace-line"):
            yield Label("with")
            yield Input(id="find-with", compact=True)
            yield Button("replace", id="find-one", compact=True)
            yield Button("all", id="find-all", compact=True)

    @property
    def replacement(self) -> str:
        """What is to be put in the place of what is found."""
        return self.query_one("#find-with", Input).value

    def open(self, what: str, *, replace: bool) -> None:
        """Show the bar, with something to find already there."""
        self.display = True
        self.query_one("#replace-line").display = replace
        field = self.query_one("#find-what", Input)
        if what:
            field.value = what
        # At once: what is typed next is meant for this field.
        self.screen.set_focus(field)
        field.select_all()
        self._name_keys()
        self._find()

    def _name_keys(self) -> None:
        """Write on the buttons which keys press them, as they are bound now."""
        keys = {
            active.binding.id: key_name(active.binding.key)
            for active in reversed(list(self.screen.active_bindings.values()))
        }
        for button, words, action in _BUTTONS:
            key = keys.get(action)
            self.query_one(button, Button).label = f"{words} {key}" if key else words

    def step(self, by: int) -> None:
        """Go to the next match, or with -1 to the one before; the bar need not be in sight."""
        self._finder.step(by)

    def _say(self, text: str) -> None:
        if self.is_mounted:
            self.query_one("#find-count", Label).update(text)

    def _find(self) -> None:
        self._finder.find(
            self.query_one("#find-what", Input).value,
            is_regex=self._is_regex,
            is_case_sensitive=self._is_case_sensitive,
        )

    def _replace(self, *, every: bool) -> None:
        replace = self._finder.replace_all if every else self._finder.replace
        replace(self.replacement)

    def action_close(self) -> None:
        """Close the bar, and go back to the text."""
        self.display = False
        self._finder.stop()
        self._leave()

    def action_step(self, by: int) -> None:
        """Go to another match."""
        self.step(by)

    def action_other_field(self) -> None:
        """Go from what is to be found to what comes in its place, and back."""
        what, with_ = self.query(Input)
        goal = with_ if what.has_focus and self.query_one("#replace-line").display else what
        goal.focus()

    def action_toggle_regex(self) -> None:
        """Take what is to be found for a regular expression, or for plain text."""
        self._is_regex = not self._is_regex
        self.query_one("#find-regex").set_class(self._is_regex, "is-on")
        self._find()

    def action_toggle_case(self) -> None:
        """Tell upper from lower case, or not."""
        self._is_case_sensitive = not self._is_case_sensitive
        self.query_one("#find-case").set_class(self._is_case_sensitive, "is-on")
        self._find()

    def action_all(self) -> None:
        """Replace all matches."""
        self._replace(every=True)

    @on(Input.Changed, "#find-what")
    def _changed(self, event: Input.Changed) -> None:
        event.stop()
        self._find()

    @on(Input.Submitted)
    def _submitted(self, event: Input.Submitted) -> None:
        event.stop()
        if event.input.id == "find-what":
            self.step(1)
        else:
            self._replace(every=False)

    @on(Button.Pressed)
    def _pressed(self, event: Button.Pressed) -> None:
        event.stop()
        match event.button.id:
            case "find-regex":
                self.action_toggle_regex()
            case "find-case":
                self.action_toggle_case()
            case "find-one":
                self._replace(every=False)
            case _:
                self._replace(every=True)


class PromptBar(Horizontal):
    """Asks a question, and hands the answer on."""

    DEFAULT_CSS = """
    PromptBar { dock: bottom; height: 1; display: none; background: $panel; }
    PromptBar Input { width: 1fr; height: 1; border: none; padding: 0 1; }
    PromptBar Label { width: auto; padding: 0 1; }
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "close", "Cancel", id="prompt.close"),
        Binding("tab,shift+tab", "stay", show=False),
    ]

    def __init__(self, leave: Callable[[], object]) -> None:
        """Ask questions; `leave` gives the focus back."""
        super().__init__()
        self._answer: Callable[[str], None] | None = None
        self._leave = leave

    def compose(self) -> ComposeResult:
        """Make the line."""
        yield Label("", markup=False)
        yield Input(compact=True)

    def ask(self, question: str, value: str, answer: Callable[[str], None]) -> None:
        """Show a question; the answer goes to a function."""
        self._answer = answer
        self.query_one(Label).update(question)
        self.display = True
        field = self.query_one(Input)
        field.value = value
        # At once: what is typed next is meant for this field.
        self.screen.set_focus(field)
        field.select_all()

    def action_stay(self) -> None:
        """Keep the focus: there is one field only."""

    def action_close(self) -> None:
        """Close the bar without an answer."""
        self._answer = None
        self.display = False
        self._leave()

    @on(Input.Submitted)
    def _submitted(self, event: Input.Submitted) -> None:
        event.stop()
        answer = self._answer
        self.action_close()
        if answer is not None:
            answer(event.value)
