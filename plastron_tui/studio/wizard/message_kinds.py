"""The message that is sent: one of the program, or a new one."""

from __future__ import annotations

from plastron_tui.language import SlotKind
from plastron_tui.model.kinds import Publisher
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.motion import COMMAND_TOPIC
from plastron_tui.ros.names import spelled

from .ask import Ask, Choice
from .form import NEW
from .kind import OF_THE_LIST, Kind
from .obstacles import driven, is_to_drive
from .trials import closed_by, first_that_works


class MessageKind(Kind):
    """A message of the program."""

    def suggest(self, ask: Ask) -> str:
        """Return what fits the rest of the form and of the program."""
        workspace = ask.scene.workspace
        sent = {
            publication.message.variable
            for node in workspace.nodes.values()
            for publisher in node.of(Publisher).values()
            for publication in publisher.publications
        }
        wanted = [name for name in reversed(workspace.messages) if name not in sent]
        if is_to_drive(ask):
            # By the same message as before: that line of the program then gives way.
            moving = driven(workspace.nodes.get(ask.node), COMMAND_TOPIC)
            wanted = [*(each.message.variable for each in moving), *wanted]
        wanted = list(dict.fromkeys([*_sent_to(ask), *wanted]))
        return first_that_works(ask, wanted[:3]) or NEW

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return what there is, and what is closed."""
        found = [Choice(NEW, "", "a later screen asks for its values", label="a new message")]
        messages = ask.scene.workspace.messages
        names = list(dict.fromkeys([*_sent_to(ask), *reversed(messages)]))
        reasons = closed_by(ask, names)
        for variable in names:
            type_ = str(messages[variable].value.type)
            found.append(Choice(variable, type_, closed=reasons.get(variable, "")))
        return found

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if text in ask.scene.workspace.messages:
            return None
        if ask.scene.resolve(text, InterfaceKind.MESSAGE, ask.version) is not None:
            return f"`{text}` is a type: take `a new message` here, and the type comes further down"
        if not text or not ask.scene.workspace.messages:
            return "a message is needed: take `a new message`, or another one of the list"
        return f"there is no message `{text}`: {OF_THE_LIST}"


def _sent_to(ask: Ask) -> list[str]:
    """Return the messages that nodes send already to the topic that was entered."""
    slot = ask.form.slot_of(SlotKind.TOPIC)
    topic = "" if slot is None else ask.form.entered.get(slot.name, "")
    return [
        publication.message.variable
        for node in ask.scene.workspace.nodes.values()
        for publisher in node.of(Publisher).values()
        for publication in publisher.publications
        if topic and spelled(topic) == publisher.name
    ]
