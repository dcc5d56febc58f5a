"""The parts of the main screen, put together: each gets what it works on, and whom it tells."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from textual.screen import Screen

from ..config import Profile
from ..panels.entry import Entry
from ..panels.panel import PanelWidgets
from ..panels.registry import PANELS
from .active_program import ActiveProgram
from .code_actions import CodeActions
from .disk_watch import DiskWatch
from .dock_layout import DockLayout
from .entry_actions import EntryActions
from .file_actions import FileActions
from .node_runs import NodeRuns
from .panel_feed import PanelFeed
from .recovery import Recovery
from .tab_actions import TabActions
from .trust_prompt import TrustPrompt
from .wizard_host import WizardHost


class Hooks(NamedTuple):
    """What parts call of the screen.

    Attributes:
        on_open: called when another program is there.
        on_change: called when something is the case with it that the title says.
        key_of: returns the key of an action, as a person writes it.
        show_code: shows the file that an entry is in.
    """

    on_open: Callable[[], object]
    on_change: Callable[[], object]
    key_of: Callable[[str], str]
    show_code: Callable[[Entry], object]


class Parts(NamedTuple):
    """What the main screen hands keys and messages to.

    Attributes:
        panels: the widget of each panel, by the panel's name, made when it is first shown.
        dock_layout: brings panels in sight.
        feed: finds out what the text means, and shows it.
        recovery: keeps what is typed.
        files: opens and saves.
        disk: looks at what others write.
        trust: asks whether a project is trusted.
        runs: runs nodes.
        tabs: goes from program to program.
        entries: does what is asked about an entry of a panel.
        code: shows the code of something.
        wizard: builds statements from menus and forms.
    """

    panels: PanelWidgets
    dock_layout: DockLayout
    feed: PanelFeed
    recovery: Recovery
    files: FileActions
    disk: DiskWatch
    trust: TrustPrompt
    runs: NodeRuns
    tabs: TabActions
    entries: EntryActions
    code: CodeActions
    wizard: WizardHost


def parts_of(screen: Screen[None], program: ActiveProgram, profile: Profile, hooks: Hooks) -> Parts:
    """Make the parts of a screen.

    Args:
        screen: the screen, which shows dialogs and gets messages.
        program: the programs that are open.
        profile: what belongs to the user.
        hooks: what they call of the screen.
    """
    on_open, on_change, key_of, show_code = hooks
    panels = PanelWidgets(PANELS)
    layout = DockLayout(PANELS, panels, program.editor, profile.remembered, lambda: feed.refresh())
    feed = PanelFeed(screen, program, layout, panels)
    recovery = Recovery(screen, program, profile.journals)
    files = FileActions(screen, program, profile, recovery, on_open, on_change)
    trust = TrustPrompt(screen, program, key_of)
    runs = NodeRuns(screen, program, files, layout, panels, trust, on_change)
    return Parts(
        panels,
        layout,
        feed,
        recovery,
        files,
        DiskWatch(screen, program, files, recovery, feed.ask_anew, on_change),
        trust,
        runs,
        TabActions(screen, program, files, runs.forget, on_open),
        EntryActions(screen, program, show_code),
        CodeActions(screen, program),
        WizardHost(screen, program),
    )
