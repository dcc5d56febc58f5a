"""How entries of panels look: what stands before a name, and how a type is said."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from plastron_tui.model.kinds import EDITABLE, EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind

from .entry import Subject

if TYPE_CHECKING:
    from plastron_tui.ros.interfaces import InterfaceName

SIGNS: dict[Subject | EndpointKind, tuple[str, str]] = {
    Subject.NODE: ("●", "primary"),
    Subject.TOPIC: ("≈", "success"),
    Subject.SERVICE_NAME: ("◆", "warning"),
    Subject.ACTION_NAME: ("★", "warning"),
    Subject.MESSAGE: ("✉", "accent"),
    Subject.PACKAGE: ("▣", "primary"),
    Subject.LAUNCH: ("▶", "success"),
    Subject.TYPE: ("◫", "accent"),
    Subject.ROBOT: ("◈", "primary"),
    Subject.LINK: ("■", "quiet"),
    Subject.JOINT: ("─", "success"),
    **{kind: (kind.facts.sign, kind.facts.tone) for kind in EDITABLE},
}
"""The character before the name, and its tone."""


HUBS = {
    InterfaceKind.MESSAGE: Subject.TOPIC,
    InterfaceKind.SERVICE: Subject.SERVICE_NAME,
    InterfaceKind.ACTION: Subject.ACTION_NAME,
}
"""What an entry is about that stands for what nodes meet at."""


@lru_cache(4096)
def type_text(type_: InterfaceName | None) -> str:
    """Return a type as an entry says it."""
    return "type unknown" if type_ is None else str(type_)
