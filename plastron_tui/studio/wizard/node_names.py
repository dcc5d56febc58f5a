"""What a new node is called: after what it is to do, as far as that is known."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.model.kinds import INTERFACES
from plastron_tui.ros.motion import COMMAND_TOPIC, LASER_TOPIC, is_distance, is_velocity
from plastron_tui.ros.names import check_node_name

from .ask import MEETINGS, Ask
from .context import free_name
from .form import Form
from .kind import Kind, name_problem

_NAMES = ("talker", "listener", "watcher", "helper")
"""The names of nodes of which nobody knows yet what they are to do."""

# A file is called after its node, with `_server` or `_client` behind it: no node is called that.
_AFTER_PURPOSE: dict[type[Statement], str] = {
    st.Publish: "talker",
    st.Subscribe: "listener",
    st.ClientRequests: "asker",
    st.ProvidesService: "answerer",
    st.SendsGoal: "asker",
    st.ProvidesAction: "worker",
    st.Repeats: "ticker",
}


class NodeNameKind(Kind):
    """The name of a new node."""

    def suggest(self, ask: Ask) -> str:
        """Return what fits the rest of the form and of the program."""
        taken = ask.scene.node_names | ask.scene.taken
        wanted = list(_names(ask.form.purpose))
        free = (name for name in wanted if name not in taken)
        return next(free, free_name(wanted[-1] if ask.form.purpose else "node", taken))

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            return "a node needs a name, such as `talker`"
        return name_problem(check_node_name(text, ask.version))


def _names(purpose: Form | None) -> Iterator[str]:
    """Yield names for a node of a purpose, the best first."""
    name = "" if purpose is None else _AFTER_PURPOSE.get(purpose.declaration.type, "")
    if purpose is None or not name:
        yield from _NAMES
        return
    type_, topic = _entered(purpose, *INTERFACES), _entered(purpose, *MEETINGS).rpartition("/")[2]
    is_driving = is_velocity(type_) or topic == COMMAND_TOPIC
    if purpose.drives or (name == "talker" and is_driving):
        yield "driver"
    if name == "listener" and (is_distance(type_) or topic == LASER_TOPIC):
        # It may drive as well: most robots are driven by what they see.
        yield "watcher"
    yield name


def _entered(form: Form, *kinds: SlotKind) -> str:
    """Return what was entered in a slot."""
    slot = form.slot_of(*kinds)
    return "" if slot is None else form.entered.get(slot.name, "")
