"""What `shaped` says of links: shapes, and their values in order or by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from plastron_tui.diagnostics import (
    Diagnostic,
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
)
from plastron_tui.language.written_numbers import with_points, without_enclosure
from plastron_tui.ros.robots.description import (
    Box,
    Cylinder,
    Mesh,
    Shape,
    Sphere,
    Vector,
)

from .mistake import Mistake
from .robot_numbers import FARTHEST, SHORTEST, as_float


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
