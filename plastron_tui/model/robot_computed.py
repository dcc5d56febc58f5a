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
}
"""Where the values of statements stand: elements, one within the other, and an attribute."""


def check_not_computed(robot: Robot, statement: Any) -> None:
    """Check that a statement changes nothing of a part that macros compute.

    Raises:
        Mistake: it does.
    """
    kind, slots = _SLOTS[type(statement)]
    part = kind, getattr(statement, kind)
    source = robot.source
    if source is None or part in robot.taken:
        return
    computed = source.computed.get(part, {})
    for slot, paths in slots.items() if computed else ():
        found = next((each for each in paths if each in computed), None)
        if found is None or getattr(statement, slot) is None:
            continue
        value, line = computed[found]
        *_, element, name = found.split("/")
        where = f"`{source.path.name}`"
        if source.origin is None:
            where = f"line {line} of {where}"
        message = f"`{name}` of `<{element}>` is computed by a macro: `{value}` (in {where})"
        where_said = statement.span_of(slot)
        help_ = "change it in the file"
        raise Mistake(Diagnostic(codes.EDIT_REFUSED, message, where_said, help=help_))
