"""What the clauses of links and joints say, as URDF has it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from math import radians
from typing import Any, NamedTuple

from plastron_tui.diagnostics import (
    Diagnostic,
    Edit,
    Fix,
    Span,
    codes,
    did_you_mean,
    guess,
    write,
)
from plastron_tui.language import statements as st
from plastron_tui.language.inputs import (
    ListValue,
    Literal,
    NamedArgument,
    NestedValue,
    Nothing,
)
from plastron_tui.language.written_numbers import METRES, with_points, without_enclosure
from plastron_tui.ros.robots.changes import NO_MATERIAL
from plastron_tui.ros.robots.colors import NAMES, material_name, rgba_of
from plastron_tui.ros.robots.description import (
    Box,
    Cylinder,
    JointType,
    Material,
    Mesh,
    Shape,
    Sphere,
    Vector,
)

from .mistake import Mistake
from .robot_numbers import FARTHEST, HEAVIEST, LIGHTEST, SHORTEST, as_float, numbers, vector_of
from .robots import Robot


class _Form(NamedTuple):
    """How a shape is written.

    Attributes:
        values: the names of its values, in their order.
        optional: those that need not be there.
        make: makes it of them.
        example: how it is written.
        others: what others call its values.
    """

    values: tuple[str, ...]
    make: Callable[..., Shape]
    example: str
    optional: tuple[str, ...] = ()
    others: Mapping[str, str] = {}


_SHAPES: Mapping[str, _Form] = {
    "box": _Form(
        ("x", "y", "z"),
        lambda x, y, z: Box((x, y, z)),
        "box 0.4, 0.3, 0.1",
        others={"length": "x", "depth": "x", "width": "y", "height": "z"},
    ),
    "cylinder": _Form(
        ("radius", "length"),
        Cylinder,
        "cylinder 0.1, 0.05",
        others={"height": "length", "h": "length", "l": "length", "r": "radius"},
    ),
    "sphere": _Form(("radius",), Sphere, "sphere 0.1", others={"r": "radius"}),
    "mesh": _Form(
        ("uri", "scale"),
        Mesh,
        'mesh "package://rover/meshes/base.stl"',
        ("scale",),
        {"file": "uri", "filename": "uri", "path": "uri", "url": "uri"},
    ),
}


def shape_of(statement: st.HasLink) -> Shape | None:
    """Return the shape that a link is given, None for none.

    Raises:
        Mistake: there is no such shape, or it has other values.
    """
    if statement.shape is None:
        return None
    where = statement.span_of("shape")
    form = _SHAPES.get(statement.shape)
    if form is None:
        near, fix = guess(statement.shape, _SHAPES, where)
        message = f"`{statement.shape}` is no shape"
        help_text = near or "it is `box`, `cylinder`, `sphere` or `mesh`"
        raise Mistake(Diagnostic(codes.BAD_SHAPE, message, where, help=help_text, fix=fix))
    if statement.shape != "mesh":
        _check_writing(statement, form)
    given, wrong = _values(statement, form)
    made: dict[str, Any] = {}
    for name, (value, at) in given.items():
        try:
            make = _MADE_OF.get(name)
            made[name] = _length(name, value, at) if make is None else make(value, at)
        except Mistake as mistake:  # noqa: PERF203 - each value has its own
            wrong += mistake.diagnostics
    if wrong:
        raise Mistake(*wrong)
    return form.make(**made)


def _check_writing(statement: st.HasLink, form: _Form) -> None:
    """Raise a mistake where sizes are written in another way: `box 0,4, 0,3, 0,1`, `box (1, 2)`."""
    size = statement.syntax.child_by_field_name("size")
    if size is None or size.text is None:
        return
    text, message = size.text.decode(), "a fraction has a point, not a comma"
    right = with_points(text)
    if right is None:
        right, message = without_enclosure(text), "sizes stand without brackets, quotes and a name"
    if right is None or len(right.split(",")) != len(form.values) - len(form.optional):
        return
    where = statement.span_of("size")
    fix = write(right, where)
    raise Mistake(Diagnostic(codes.BAD_SHAPE, message, where, help=fix.title, fix=fix))


def _values(
    statement: st.HasLink, form: _Form
) -> tuple[dict[str, tuple[Any, Span]], list[Diagnostic]]:
    """Return the values of a shape by their names, where each stands, and what is wrong."""
    found: dict[str, tuple[Any, Span]] = {}
    wrong: list[Diagnostic] = []
    for place, argument in enumerate(statement.size or ()):
        at = Span(argument.syntax.start_byte, argument.syntax.end_byte).moved(statement.shift)
        if isinstance(argument, NamedArgument):
            name, value = ".".join(argument.path), argument.value
        elif place < len(form.values):
            name, value = form.values[place], argument
        else:
            wrong.append(_bad_shape(f"a {statement.shape} has no more values", at, form))
            break
        if name not in form.values:
            meant = form.others.get(name)
            help_text = did_you_mean(name, form.values)
            message = f"a {statement.shape} has no `{name}`"
            unknown = _bad_shape(message, at, form, help_text)
            if meant is not None:
                where = Span(at.start, at.start + len(name.encode()))
                fix = write(meant, where)
                unknown = unknown._replace(span=where, help=fix.title, fix=fix)
            wrong.append(unknown)
        elif name in found:
            wrong.append(_bad_shape(f"`{name}` is given twice", at, form))
        else:
            found[name] = value, at
    missing = [each for each in form.values if each not in (*found, *form.optional)]
    if missing and not wrong:
        lacking = " and ".join(f"`{each}`" for each in missing)
        message = f"a {statement.shape} needs {lacking}"
        wrong.append(_bad_shape(message, statement.span_of("size"), form))
    return found, wrong


def _bad_shape(message: str, where: Span, form: _Form, help_text: str | None = None) -> Diagnostic:
    help_text = help_text or f"write it as `{form.example}`"
    return Diagnostic(codes.BAD_SHAPE, message, where, help=help_text)


def _length(name: str, value: Any, where: Span) -> float:
    number = _number(value)
    if number is not None and SHORTEST <= number <= FARTHEST:
        return number
    help_text = fix = None
    message = f"`{name}` is a number of metres"
    if number is not None:
        message = f"`{name}` is more than 0"
        if number > 0:
            message = f"`{name}` is between {SHORTEST:.6f} and {FARTHEST:,.0f} m"
        elif SHORTEST <= -number <= FARTHEST:
            written = value.syntax.end_byte - value.syntax.start_byte
            fix = write(f"{-number:.12g}", Span(where.end - written, where.end))
            help_text = f"{fix.title}; a part is turned by `turned`, and moved by `at`"
    raise Mistake(Diagnostic(codes.BAD_SHAPE, message, where, help=help_text, fix=fix))


def _scale(value: Any, where: Span) -> Vector:
    if isinstance(value, NestedValue):
        parts = [None if isinstance(x, NamedArgument) else _number(x) for x in value.arguments]
    else:
        parts = [_number(value)] * 3
    found = tuple(x for x in parts if x is not None and 1 / FARTHEST <= abs(x) <= FARTHEST)
    if len(parts) != 3 or len(found) != 3:
        message = "a scale is a number that is not 0, or three of them, as `(1, 1, 2)`"
        fix = None
        text = value.syntax.text
        if isinstance(value, ListValue) and len(value.items) == 3 and text is not None:
            # It may be a scale in other brackets.
            right = f"({text.decode()[1:-1]})"
            fix = write(right, Span(where.end - len(text), where.end))
        help_text = "leave it out for a mesh in metres" if fix is None else fix.title
        raise Mistake(Diagnostic(codes.BAD_SHAPE, message, where, help=help_text, fix=fix))
    x, y, z = found
    return x, y, z


def _number(value: Any) -> float | None:
    is_number = isinstance(value, Literal) and isinstance(value.value, (int, float))
    return as_float(value.value) if is_number and not isinstance(value.value, bool) else None


def _uri(value: Any, where: Span) -> str:
    if isinstance(value, Literal) and isinstance(value.value, str) and value.value.strip():
        return value.value
    message = "a mesh is named by its URI, in double quotes"
    help_text = 'write it as `mesh "package://rover/meshes/base.stl"`'
    raise Mistake(Diagnostic(codes.BAD_SHAPE, message, where, help=help_text))


_MADE_OF: Mapping[str, Callable[[Any, Span], Any]] = {"uri": _uri, "scale": _scale}
"""How a value of a shape is read that is no length."""


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
