"""Values of a robot's file that macros compute: nobody knows them without expanding the file.

A description has a default in their place, which may happen to be what a program asks for: then
nothing would be different, and the file would keep what it computes.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement

from .mistake import Mistake
from .robots import Robot

_BODIES = ("visual", "collision")
_SLOTS: Mapping[type[Statement], tuple[str, Mapping[str, tuple[str, ...]]]] = {
    st.HasJoint: (
        "joint",
        {
            "position": ("origin/xyz",),
            "rotation": ("origin/rpy",),
            "axis": ("axis/xyz",),
            "mimicked": ("mimic/joint",),
            "factor": ("mimic/multiplier",),
        },
    ),
    st.LimitsJoint: (
        "joint",
        {
            "minimum": ("limit/lower",),
            "maximum": ("limit/upper",),
            "effort": ("limit/effort",),
            "velocity": ("limit/velocity",),
            "damping": ("dynamics/damping",),
            "friction": ("dynamics/friction",),
        },
    ),
    st.HasLink: (
        "link",
        {
            "weight": ("inertial/mass/value",),
            "position": tuple(f"{each}/origin/xyz" for each in _BODIES),
            "rotation": tuple(f"{each}/origin/rpy" for each in _BODIES),
        },
    ),
    st.NoLongerHasJoint: ("joint", {}),
    st.NoLongerHasLink: ("link", {}),
}
"""Where the values of statements stand: elements, one within the other, and an attribute.

What takes a part away says none of its values, and changes all.
"""


def check_not_computed(robot: Robot, statement: Any) -> None:
    """Check that a statement changes, and takes away, nothing that macros compute.

    Raises:
        Mistake: it does.
    """
    kind, slots = _SLOTS[type(statement)]
    part = kind, getattr(statement, kind)
    source = robot.source
    computed = {} if source is None else source.computed.get(part, {})
    asked = [
        (slot, path)
        for slot, paths in slots.items()
        for path in paths
        if path in computed and getattr(statement, slot) is not None
    ]
    if computed and not slots:
        # All of it would go; the first in the file is told.
        asked = [(kind, min(computed, key=lambda path: computed[path][1]))]
    if source is None or not asked:
        return
    slot, path = asked[0]
    value, line = computed[path]
    *_, element, name = path.split("/")
    where = f"`{source.path.name}`"
    if source.origin is None:
        where = f"line {line} of {where}"
    message = f"`{name}` of `<{element}>` is computed by a macro: `{value}` (in {where})"
    help_ = "change it in the file"
    raise Mistake(Diagnostic(codes.EDIT_REFUSED, message, statement.span_of(slot), help=help_))
