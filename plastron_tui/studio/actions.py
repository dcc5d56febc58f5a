"""Every action of the studio, once: keys, footer, palette and help are made from it.

Terminals, tmux and browsers eat chords, so each action has a key that comes through, and is in the
palette as well. The configuration file binds other keys by the ids.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

from textual.binding import Binding

from .editor.commands import COMMANDS, Command
from .panels.dock import Dock
from .panels.registry import PANELS

if TYPE_CHECKING:
    from .key_conflicts import KeyOwner


class Action(NamedTuple):
    """Something that can be done.

    Attributes:
        id: its name in the configuration file.
        title: what it is called.
        call: the action in Textual's notation, of the main screen.
        keys: its keys, by commas.
        help: a sentence about it.
        group: the heading that it is listed under.
        footer: whether the footer shows it.
        kept: whether the footer shows it however narrow the window is.
        own: whether the editor binds the keys itself.
        chosen: what is done in the place of `call` where it is chosen from the menu.
    """

    id: str
    title: str
    call: str
    keys: str = ""
    help: str = ""
    group: str = "Studio"
    footer: bool = False
    kept: bool = False
    own: bool = False
    chosen: str = ""

    @property
    def binding(self) -> Binding:
        """The binding of its keys."""
        return Binding(
            self.keys, self.call, self.title, show=self.footer, id=self.id, tooltip=self.help
        )


def _of(command: Command) -> Action:
    """Return the action of a command of the editor."""
    call = f"screen.edit('{command.name}')"
    return Action(command.id, command.title, call, command.keys, command.help, "Edit", own=True)


ACTIONS: tuple[Action, ...] = (
    Action("help", "Help", "screen.help", "f1,alt+question_mark",
           "What the word at the cursor means; again, help about the part of the screen that you "
           "are in.", footer=True, kept=True, chosen="screen.help(False)"),
    Action("run", "Run", "screen.run", "f5",
           "Write and start the nodes; while they run, stop them.", footer=True, kept=True),
    Action("run_anew", "Run anew", "screen.run(True)", "alt+r",
           "Stop the nodes, and start them from the text as it is now."),
    Action("stop", "Stop the nodes", "screen.stop", "shift+f5", "Stop the nodes that run."),
    Action(
        "generate", "Generate", "screen.generate", "f6",
        "Show what would be written, then write it.", footer=True,
    ),
    Action("wizard", "Wizard", "screen.wizard", "ctrl+u,alt+w",
           "Build nodes and robots from menus; the statements appear in the text."),
    Action("next_panel", "Panels", "screen.next_panel", "f7", "Go to the next panel.", footer=True),
    Action("panels", "Show or hide the panels", "screen.panels", "f9",
           "Make room for the text, or show the panels again."),
    Action("menu", "Menu", "screen.menu", "f10,ctrl+p",
           "All actions, by their names, and the names of this program.", footer=True, kept=True),
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
    Action("fix", "Fix the problem on this line", "screen.fix", "alt+enter",
           "Change the text as the help of the problem says.", "Edit"),
    Action("names", "Go to a name", "screen.menu('@')", "alt+a",
           "Find a node, topic, service, action, message, parameter, function, link or joint of "
           "this program.", "Edit"),
    Action("back", "Go back", "screen.jump(-1)", "alt+comma",
           "Go to where you were before you jumped, in this program or another.", "Edit"),
    Action("forward", "Go forward", "screen.jump(1)", "alt+full_stop",
           "Go forward again, after going back.", "Edit"),
    Action("code", "Go to the code", "screen.code", "alt+c",
           "Show the file that this is in, or becomes, at its line; from there $EDITOR.", "Edit"),
    Action("new", "New program", "screen.new", "ctrl+n,alt+n", "Start an empty program.", "File"),
    Action("next_tab", "Next program", "screen.turn_tab(1)", "ctrl+pagedown,alt+e",
           "Bring the next program that is open in front.", "File"),
    Action("previous_tab", "Previous program", "screen.turn_tab(-1)", "ctrl+pageup,alt+y",
           "Bring the program before in front.", "File"),
    Action("close_tab", "Close the program", "screen.close_tab", "alt+q",
           "Close the program in front; ask first, where it is not saved.", "File"),
    Action("save", "Save", "screen.save", "ctrl+s", "Write the program to its file.", "File",
           footer=True),
    Action("open", "Open", "screen.open", "ctrl+o", "Open a program, in a tab.", "File",
           footer=True),
    Action("save_as", "Save as", "screen.save_as", "alt+s", "Write the program to another file.",
           "File"),
    Action("welcome", "Welcome", "screen.welcome", "alt+0",
           "Recent programs, examples and the tour.", "File"),
    Action("tour", "Take the tour", "screen.tour", "alt+i", "Two minutes around the screen."),
    Action("trust", "Trust this project", "screen.trust", "alt+u",
           "Let it use its own templates, and files outside of its folder.", "File"),
    Action("theme", "Theme", "app.change_theme", "alt+t", "Choose other colours."),
    Action("keys", "Keys", "screen.keys", "alt+k", "All keys of where you are, at the side."),
    Action("config", "Edit the settings", "screen.config", "alt+o",
           "Keys and other settings, in a file; what is wrong with it, at its line."),
    Action("suspend", "Suspend", "app.suspend_process", "alt+j",
           "Go back to the shell; `fg` returns."),
    Action("quit", "Quit", "screen.quit", "ctrl+q", "Leave the studio.", footer=True, kept=True),
    *(_of(command) for command in COMMANDS if command.help),
)  # fmt: skip

BY_ID = {action.id: action for action in ACTIONS}

KEPT = frozenset(action.id for action in ACTIONS if action.kept)
"""What the footer shows however narrow the window is."""


def bindings() -> list[Binding]:
    """Return the bindings of the main screen."""
    return [action.binding for action in ACTIONS if action.keys and not action.own]


def key_owners() -> tuple[KeyOwner, ...]:
    """Return what has keys, in the place where it has them, for the configuration file."""
    # The studio begins without it, and nearly always without keys of somebody's own.
    from .editor.bars import FindBar
    from .key_conflicts import EDITOR, EVERYWHERE, FIND, KeyOwner

    owners = [
        KeyOwner(action.id, action.title, frozenset({EVERYWHERE}), _split(action.keys))
        for action in ACTIONS
        if not action.own
    ]
    owners += [
        KeyOwner(command.id, command.title, frozenset({EDITOR}), _split(command.binding.key))
        for command in COMMANDS
    ]
    owners += _bound_by(FindBar, FIND)
    for panel in PANELS:
        for base in (*panel.widget_class.__mro__, *Dock.__mro__):
            if base.__module__.startswith(__package__ or ""):
                owners += _bound_by(base, panel.name)
    return tuple(dict.fromkeys(owners))


def _bound_by(widget: type, place: str) -> list[KeyOwner]:
    """Return what a class of widgets itself binds keys to."""
    from .key_conflicts import KeyOwner

    return [
        KeyOwner(each.id or "", each.description, frozenset({place}), _split(each.key))
        for each in widget.__dict__.get("BINDINGS", ())
        if isinstance(each, Binding)
    ]


def _split(keys: str) -> tuple[str, ...]:
    return tuple(key for key in keys.split(",") if key)


def grouped() -> Iterable[tuple[str, list[Action]]]:
    """Return the actions under their headings."""
    groups: dict[str, list[Action]] = {}
    for action in ACTIONS:
        groups.setdefault(action.group, []).append(action)
    return groups.items()
