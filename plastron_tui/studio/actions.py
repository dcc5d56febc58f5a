"""Every action of the studio, once: keys, footer, palette and help are made from it.

Terminals, tmux and browsers eat chords, so each action has a key that comes through, and is in the
palette as well. The configuration file binds other keys by the ids.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from textual.binding import Binding
from textual.widget import Widget

from .panels.dock import Dock
from .panels.registry import PANELS


@dataclass(frozen=True, slots=True)
class Action:
    """Something that can be done.

    Attributes:
        id: its name in the configuration file.
        title: what it is called.
        call: the action in Textual's notation, of the main screen.
        keys: its keys, by commas.
        help: a sentence about it.
        group: the heading that it is listed under.
        footer: whether the footer shows it.
        own: whether the editor binds the keys itself.
    """

    id: str
    title: str
    call: str
    keys: str = ""
    help: str = ""
    group: str = "Studio"
    footer: bool = False
    own: bool = False

    @property
    def binding(self) -> Binding:
        """The binding of its keys."""
        return Binding(
            self.keys, self.call, self.title, show=self.footer, id=self.id, tooltip=self.help
        )


def _editor(name: str, title: str, keys: str, help_: str, call: str | None = None) -> Action:
    call = f"screen.edit('{call or name}')"
    return Action(f"editor.{name}", title, call, keys, help_, "Edit", own=True)


ACTIONS: tuple[Action, ...] = (
    Action("help", "Help", "screen.help", "f1,alt+question_mark",
           "Help for what has the focus.", footer=True),
    Action("run", "Run", "screen.run", "f5",
           "Generate the nodes and start them; stop them where they run.", footer=True),
    Action("stop", "Stop the nodes", "screen.stop", "shift+f5", "Stop what runs."),
    Action(
        "generate", "Generate", "screen.generate", "f6",
        "Show what would be written, then write it.", footer=True,
    ),
    Action("wizard", "Wizard", "screen.wizard", "ctrl+u,alt+w",
           "Build nodes from menus and forms; the statements appear in the text."),
    Action("next_panel", "Panels", "screen.next_panel", "f7", "Go to the next panel.", footer=True),
    Action("panels", "Show or hide the panels", "screen.panels", "f9",
           "Make room for the text, or show the panels again."),
    Action("menu", "Menu", "app.command_palette", "f10,ctrl+p",
           "All actions, by their names.", footer=True),
    Action("zoom", "Enlarge the panel", "screen.zoom", "ctrl+t,alt+m",
           "Let the panel have the whole window, or its place again."),
    Action("wider", "Make the panel larger", "screen.resize(4)", "alt+plus,alt+equals_sign",
           "Give the panel more room."),
    Action("narrower", "Make the panel smaller", "screen.resize(-4)", "alt+minus",
           "Give the panel less room."),
    *(
        Action(panel.name, panel.title, f"screen.show('{panel.name}')", panel.keys, panel.summary,
               "Panels")
        for panel in PANELS
    ),
    Action("fix", "Mend the problem at the cursor", "screen.fix", "alt+enter",
           "Apply the remedy of the mistake on this line.", "Edit"),
    Action("new", "New program", "screen.new", "ctrl+n,alt+n", "Start an empty program.", "File"),
    Action("open", "Open", "screen.open", "ctrl+o", "Open a program.", "File", footer=True),
    Action("save", "Save", "screen.save", "ctrl+s", "Write the program to its file.", "File",
           footer=True),
    Action("save_as", "Save as", "screen.save_as", "alt+s", "Write the program to another file.",
           "File"),
    Action("welcome", "Welcome", "screen.welcome", "alt+0",
           "Recent programs, examples and the tour.", "File"),
    Action("tour", "Take the tour", "screen.tour", "alt+i", "Two minutes around the screen."),
    Action("trust", "Trust this project", "screen.trust", "alt+u",
           "Use its templates, and let it lead out of its folder.", "File"),
    Action("theme", "Theme", "app.change_theme", "alt+t", "Choose other colours."),
    Action("keys", "Keys", "screen.keys", "alt+k", "All keys of what has the focus."),
    Action("config", "Edit the configuration", "screen.config", "alt+o",
           "Keys and other settings, in a file."),
    Action("suspend", "Suspend", "app.suspend_process", "alt+j",
           "Go back to the shell; `fg` returns."),
    Action("quit", "Quit", "screen.quit", "ctrl+q", "Leave the studio.", footer=True),
    _editor("undo", "Undo", "ctrl+z", "Take the last edit back."),
    _editor("redo", "Redo", "ctrl+y", "Make the edit again."),
    _editor("cut", "Cut", "ctrl+x", "Cut the selection, or the line."),
    _editor("copy", "Copy", "ctrl+c", "Copy the selection, or the line; over SSH too."),
    _editor("paste", "Paste", "ctrl+v", "Paste what was copied."),
    _editor("select_all", "Select all", "ctrl+a", "Select the whole program."),
    _editor("find", "Find", "ctrl+f", "Find a text or a regular expression."),
    _editor("replace", "Replace", "ctrl+r", "Find and replace."),
    _editor("find_next", "Find next", "f3", "Go to the next place."),
    _editor("find_previous", "Find previous", "shift+f3,alt+p", "Go to the place before."),
    _editor("go_to_line", "Go to line", "ctrl+g", "Go to a line by its number."),
    _editor("complete", "Complete", "ctrl+space,f4", "List what can stand here."),
    _editor("toggle_comment", "Comment lines out or in", "ctrl+underscore",
            "Turn lines into comments and back."),
    _editor("duplicate", "Duplicate lines", "ctrl+d", "Repeat the lines below."),
    _editor("move_up", "Move lines up", "alt+up", "Exchange lines with the one above.",
            "move_lines(-1)"),
    _editor("move_down", "Move lines down", "alt+down", "Exchange lines with the one below.",
            "move_lines(1)"),
    _editor("delete_line", "Delete lines", "ctrl+k", "Delete the lines of the selection."),
    _editor("definition", "Go to definition", "f12",
            "Go to where the variable is created.", "go_to_definition"),
    _editor("rename", "Rename everywhere", "f2", "Give the variable another name."),
    _editor("format", "Format", "ctrl+l", "Lay the program out."),
    _editor("external_editor", "Open in $EDITOR", "ctrl+e", "Edit the text with your own editor."),
    _editor("toggle_wrap", "Wrap long lines", "alt+z", "Break long lines, or let them run on."),
    _editor("next_problem", "Next problem", "f8", "Go to the next mistake."),
    _editor("previous_problem", "Previous problem", "shift+f8", "Go to the mistake before."),
)  # fmt: skip

BY_ID = {action.id: action for action in ACTIONS}


def bindings() -> list[Binding]:
    """Return the bindings of the main screen."""
    return [action.binding for action in ACTIONS if action.keys and not action.own]


def ids() -> Iterator[str]:
    """Yield the names under which the configuration file can bind keys."""
    yield from (action.id for action in ACTIONS)
    widgets: tuple[type[Widget], ...] = (Dock, *(panel.widget for panel in PANELS))
    for widget in widgets:
        for base in widget.__mro__:
            bound = base.__dict__.get("BINDINGS", ())
            yield from (each.id for each in bound if isinstance(each, Binding) and each.id)


def grouped() -> Iterable[tuple[str, list[Action]]]:
    """Return the actions under their headings."""
    groups: dict[str, list[Action]] = {}
    for action in ACTIONS:
        groups.setdefault(action.group, []).append(action)
    return groups.items()
