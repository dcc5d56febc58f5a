"""What a node has a name for, the name that it has, and another one."""

from __future__ import annotations

from plastron_tui.diagnostics.wording import listed
from plastron_tui.language import SlotKind
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.model.rename import RENAMED

from .ask import Ask, Choice
from .context import Meeting, free_name
from .form import Cell
from .kind import Kind


def _kinds(ask: Ask) -> tuple[EndpointKind, ...]:
    return RENAMED.get(ask.text(SlotKind.NAMED), ())


def _names(ask: Ask, kinds: tuple[EndpointKind, ...]) -> list[str]:
    node = ask.scene.workspace.nodes.get(ask.node)
    if node is None:
        return []
    names = (kind.written(name) for kind in kinds for name in node.names(kind))
    return list(dict.fromkeys(names))


class NamedKind(Kind):
    """What has a name: a topic, a service, an action, a parameter."""

    def suggest(self, ask: Ask) -> str:
        """Return the first that the node has."""
        return next((word for word, kinds in RENAMED.items() if _names(ask, kinds)), "topic")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all, and close what the node has none of."""
        return [
            Choice(word, closed="" if _names(ask, kinds) else f"the node has no {word}")
            for word, kinds in RENAMED.items()
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text in RENAMED else f"it is one of {listed(RENAMED)}"


class OldNameKind(Kind):
    """A name that the node has."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return the only one that there is: nobody has to choose then."""
        names = _names(ask, _kinds(ask))
        entered = ask.form.entered.get(ask.slot.name, "")
        if len(names) != 1 or entered not in ("", *names):
            return None
        return Cell(names[0], f"the only {ask.text(SlotKind.NAMED)} of `{ask.node}`")

    def suggest(self, ask: Ask) -> str:
        """Return the first."""
        return next(iter(_names(ask, _kinds(ask))), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all."""
        return [Choice(name) for name in _names(ask, _kinds(ask))]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if text in _names(ask, _kinds(ask)):
            return None
        what = ask.text(SlotKind.NAMED)
        return f"`{ask.node}` has no {what} `{text}`" if text else f"`{ask.node}` has no {what}"


class NewNameKind(Kind):
    """Another name: one at which others wait, or a new one."""

    def suggest(self, ask: Ask) -> str:
        """Return a name that lacks the node's side, or one like the old one."""
        lonely = next((each.name for each in self._others(ask) if each.is_lonely), "")
        taken = _names(ask, _kinds(ask))
        return lonely or free_name(ask.text(SlotKind.OLD_NAME) or "name", taken)

    def _others(self, ask: Ask) -> list[Meeting]:
        interface = next((kind.facts.interface for kind in _kinds(ask)), None)
        if interface is None:
            return []
        known = ask.scene.meetings(interface, ask.version).values()
        return [each for each in known if ask.node not in (*each.senders, *each.takers)]

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return where other nodes meet."""
        return [
            Choice(each.name, "" if each.type is None else str(each.type))
            for each in self._others(ask)
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            return "it needs a name"
        kind = next(iter(_kinds(ask)), EndpointKind.PUBLISHER)
        found = kind.facts.check_name(text, ask.version)
        return None if found is None else found.message
