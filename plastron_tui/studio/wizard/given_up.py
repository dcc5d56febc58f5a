"""What a node does already, and gives up for a statement that says it anew."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.language import DECLARATIONS, Declaration, SlotKind
from plastron_tui.language import statements as st
from plastron_tui.model.kinds import Timer

from .context import Scene
from .form import laid_out
from .obstacles import driven


class GivenUp(NamedTuple):
    """Statements of the program that give way, and a statement that goes before, "" for none."""

    spans: tuple[Span, ...] = ()
    line: str = ""


def given_up(base: Scene, declaration: Declaration, texts: Mapping[SlotKind, str]) -> GivenUp:
    """Return what gives way to a statement: a timer of the same function, or what drives on.

    Args:
        base: the program without the statement.
        declaration: the statement.
        texts: what stands in its slots.
    """
    node = base.workspace.nodes.get(texts.get(SlotKind.NODE, ""))
    if node is None:
        return GivenUp()
    if declaration.type is st.Repeats:
        function = texts.get(SlotKind.TIMER, "")
        timer = node.of(Timer).get(function)
        if timer is None:
            return GivenUp()
        if timer.span is not None:
            return GivenUp((timer.span,))
        ending = DECLARATIONS[st.StopRepeating]
        return GivenUp(line=laid_out(ending, {"node": texts[SlotKind.NODE], "function": function}))
    if declaration.type is st.Publish and texts.get(SlotKind.CONDITION):
        found = driven(node, texts.get(SlotKind.TOPIC, ""))
        return GivenUp(tuple(each.span for each in found if each.span is not None))
    return GivenUp()
