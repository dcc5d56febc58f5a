"""What the clauses of links and joints say, as URDF has it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from math import radians
from typing import Any

from plastron_tui.diagnostics import (
    Diagnostic,
    Edit,
    Fix,
    Span,
    codes,
    guess,
    write,
)
from plastron_tui.language import statements as st
from plastron_tui.language.inputs import (
    Nothing,
)
from plastron_tui.language.written_numbers import METRES
from plastron_tui.ros.robots.changes import NO_MATERIAL
from plastron_tui.ros.robots.colors import NAMES, material_name, rgba_of
from plastron_tui.ros.robots.description import (
    JointType,
    Material,
    Vector,
)

from .mistake import Mistake
from .robot_numbers import FARTHEST, HEAVIEST, LIGHTEST, as_float, numbers, vector_of
from .robots import Robot


def weight_of(statement: st.HasLink) -> float | None:
    """Return what a link weighs, None where nothing is said."""
    if statement.weight is None:
        return None
    weight = as_float(statement.weight)
    if not LIGHTEST <= weight <= HEAVIEST:
        message = "a weight is more than 0 kg"
        help_text = None if weight > 0 else "leave it out for a link without a mass"
        if weight > 0:
            message = f"a weight is between {LIGHTEST:.6f} and {HEAVIEST:,.0f} kg"
        where = statement.span_of("weight")
        raise Mistake(Diagnostic(codes.BAD_WEIGHT, message, where, help=help_text))
    return weight


def material_of(statement: st.HasLink, robot: Robot | None) -> Material | None:
    """Return the material that paints a link, None where nothing is said.

    A name is that of a material which the robot has, or else of a colour.
    """
    if statement.color is None:
        return None
    if isinstance(statement.color, Nothing):
        return NO_MATERIAL
    shared = {} if robot is None else robot.description.materials
    own = {} if robot is None else robot.own_materials
    if statement.color in shared:
        return Material(statement.color)
    if statement.color in own:
        return own[statement.color]
    rgba = rgba_of(statement.color)
    if rgba is None:
        where = statement.span_of("color")
        near, fix = guess(statement.color, (*shared, *own, *NAMES), where)
        if statement.color in ("nothing", "null", "unpainted"):
            fix = write("none", where)
            near = fix.title
        message = f"`{statement.color}` is no colour"
        help_text = near or 'write a name as `blue`, or a code as `"#3060ff"`'
        raise Mistake(Diagnostic(codes.UNKNOWN_COLOR, message, where, help=help_text, fix=fix))
    return Material(material_name(statement.color), rgba)


def position_of(statement: st.HasLink | st.HasJoint) -> Vector | None:
    """Return what stands behind `at`, in metres; None where nothing is said."""
    return vector_of(statement, "position")


def rotation_of(statement: st.HasLink | st.HasJoint) -> Vector | None:
    """Return what stands behind `turned`, in radians; None where nothing is said."""
    if statement.rotation is None or statement.unit is None:
        return None
    if statement.unit not in _ANGLES:
        raise bad_unit(statement, statement.unit, tuple(_ANGLES))
    turned = vector_of(statement, "rotation")
    if turned is None:
        return None
    x, y, z = map(_ANGLES[statement.unit], turned)
    return x, y, z


_ANGLES: Mapping[str, Callable[[float], float]] = {"deg": radians, "rad": float}


def axis_of(statement: st.HasJoint, type_: JointType | None) -> Vector | None:
    """Return what stands behind `with axis`, None where nothing is said.

    Args:
        statement: the statement.
        type_: how the joint moves, None where that is not known.
    """
    if statement.axis is None:
        return None
    where = statement.span_of("axis")
    axis = vector_of(statement, "axis")
    if axis is None or max(map(abs, axis)) < 1 / FARTHEST:
        message = "an axis of 0, 0, 0 points nowhere"
        help_text = "`0, 0, 1` points up, `1, 0, 0` forward, `0, 1, 0` to the left"
        raise Mistake(Diagnostic(codes.BAD_AXIS, message, where, help=help_text))
    if type_ is not None and not type_.has_axis:
        message = f"a joint that is {type_.value} has no axis"
        raise Mistake(Diagnostic(codes.BAD_AXIS, message, where))
    return axis


_JOINT_TYPES = (
    "what turns between two angles is `revolute`, without end `continuous`; what slides is "
    "`prismatic`; the others are `fixed`, `planar` and `floating`"
)


def joint_type_of(statement: st.HasJoint) -> JointType | None:
    """Return how a joint moves, None where nothing is said."""
    if statement.type is None:
        return None
    names = [each.value for each in JointType]
    if statement.type in names:
        return JointType(statement.type)
    where = statement.span_of("type")
    near, fix = guess(statement.type, names, where)
    message = f"`{statement.type}` is no joint type"
    help_text = near or _JOINT_TYPES
    raise Mistake(Diagnostic(codes.UNKNOWN_JOINT_TYPE, message, where, help=help_text, fix=fix))


def range_of(statement: st.LimitsJoint, type_: JointType | None) -> tuple[float, float] | None:
    """Return what stands behind `between`, in radians or metres; None where nothing is said.

    Args:
        statement: the statement.
        type_: how the joint moves, None where that is not known.
    """
    if statement.minimum is None or statement.maximum is None or statement.unit is None:
        return None
    right = (*_ANGLES, "m")
    if type_ is not None:
        right = tuple(_ANGLES) if type_.turns else ("m",)
    wrong = [*_bad_ends(statement)]
    if statement.unit not in right:
        wrong += bad_unit(statement, statement.unit, right).diagnostics
    if wrong:
        raise Mistake(*wrong)
    convert = _ANGLES.get(statement.unit, float)
    return convert(as_float(statement.minimum)), convert(as_float(statement.maximum))


def _bad_ends(statement: st.LimitsJoint) -> Iterator[Diagnostic]:
    """Yield what is wrong with the least and the greatest place of a joint."""
    ends = [*numbers(statement, "minimum"), *numbers(statement, "maximum")]
    far = [each for each in ends if not abs(each.value) <= FARTHEST]
    yield from (Diagnostic(codes.BAD_LIMITS, _OUT_OF_RANGE, each.span) for each in far)
    least, most = ends
    if far or least.value < most.value:
        return
    where = Span(least.span.start, most.span.end)
    if least.value == most.value:
        message = f"between {least.value:.12g} and {most.value:.12g} it moves nowhere"
        help_text = "a joint that holds two links as they are is `fixed`"
        yield Diagnostic(codes.BAD_LIMITS, message, where, help=help_text)
        return
    message = f"{least.value:.12g} is more than {most.value:.12g}"
    edits = (
        Edit(least.span, str(statement.maximum)),
        Edit(most.span, str(statement.minimum)),
    )
    fix = Fix("write the least first", edits)
    yield Diagnostic(codes.BAD_LIMITS, message, where, help="the least comes first", fix=fix)


_OUT_OF_RANGE = f"a limit is between -{FARTHEST:,.0f} and {FARTHEST:,.0f}"


def _in_metres(statement: st.LimitsJoint, factor: float, unit: Span) -> Fix:
    """Return the fix that writes limits, and their unit, in metres."""
    ends = [*numbers(statement, "minimum"), *numbers(statement, "maximum")]
    edits = [Edit(each.span, f"{each.value * factor:.12g}") for each in ends]
    least, most = (edit.text for edit in edits)
    return Fix(f"write `between {least} and {most} m`", (*edits, Edit(unit, "m")))


def bad_unit(statement: Any, unit: str, right: tuple[str, ...]) -> Mistake:
    """Return the mistake of a unit that is not one of those that are right."""
    where = statement.span_of("unit")
    near, fix = guess(unit, right, where)
    if isinstance(statement, st.LimitsJoint):
        if unit in METRES and right == ("m",):
            fix = _in_metres(statement, METRES[unit], where)
            near = fix.title
        elif unit == "m":
            near = "a joint that slides, and is in `m`, is `prismatic`"
        elif unit in _ANGLES:
            near = "a joint that turns between two angles is `revolute`"
    words = " or ".join(f"`{each}`" for each in right)
    what = "the limits of this joint are" if isinstance(statement, st.LimitsJoint) else "a turn is"
    message = f"{what} in {words}, not in `{unit}`"
    return Mistake(Diagnostic(codes.BAD_UNIT, message, where, help=near, fix=fix))
