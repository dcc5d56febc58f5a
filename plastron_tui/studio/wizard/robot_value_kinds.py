"""What links and joints are given: shapes, weights, colours, places, axes, limits."""

from __future__ import annotations

from collections.abc import Mapping

from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.language.sentence import quoted
from plastron_tui.ros.robots.colors import NAMES
from plastron_tui.ros.robots.description import JointType
from plastron_tui.runtime.meshes import KINDS

from ..folder_files import found_files, path_text
from ..robot_words import AXES, SHAPES
from .ask import Ask, Choice
from .form import Cell
from .kind import OF_THE_LIST, Kind
from .parameter_kinds import BoundKind
from .part_rows import VECTOR, Part
from .robot_kinds import NONE, description_of, joint_of
from .values import NUMBER


def _length(name: str, usual: str) -> Part:
    return Part(name, "m", usual, example=usual, is_needed=True)


_PARTS: Mapping[str, tuple[Part, ...]] = {
    "box": (_length("x", "0.4"), _length("y", "0.3"), _length("z", "0.1")),
    "cylinder": (_length("radius", "0.1"), _length("length", "0.05")),
    "sphere": (_length("radius", "0.05"),),
    "mesh": (
        Part("uri", "a path, or package://…", example="", is_needed=True),
        Part("scale", "of the file's lengths", example="0.001"),
    ),
}
"""The values of each shape."""

_PLACE = tuple(Part(name, "m", without="0") for name in "xyz")
_ANGLES = ("roll", "pitch", "yaw")


class ShapeKind(Kind):
    """The shape of a link."""

    def suggest(self, ask: Ask) -> str:
        """Return a box; the first link is a place only, and one that is changed keeps its own."""
        links = description_of(ask).links
        return "box" if links and ask.text(SlotKind.LINK) not in links else ""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all."""
        return [Choice(name, each.about) for name, each in SHAPES.items()]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text in SHAPES else f"no such shape: {OF_THE_LIST}"


class SizeKind(Kind):
    """How large a shape is: a row for each of its values."""

    def parts(self, ask: Ask) -> tuple[Part, ...]:
        """Return the values of the shape."""
        shape = ask.text(SlotKind.SHAPE)
        parts = _PARTS.get(shape, ())
        if shape == "mesh":
            folder = ask.scene.session.folder
            found = ask.scene.surroundings.once("meshes", lambda: found_files(KINDS, folder))
            usual = path_text(found[0], folder) if found else ""
            return (parts[0]._replace(usual=usual), *parts[1:])
        return parts


def _is_place(ask: Ask) -> bool:
    """Tell whether the link has no shape, and none that is there already."""
    there = description_of(ask).links.get(ask.text(SlotKind.LINK))
    return not ask.text(SlotKind.SHAPE) and (there is None or not there.visuals)


class WeightKind(Kind):
    """What a link weighs."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return nothing for a place."""
        return Cell("", "a place weighs nothing") if _is_place(ask) else None

    def suggest(self, ask: Ask) -> str:
        """Return a kilogram, for what is new and carried by something."""
        shape = ask.text(SlotKind.SHAPE)
        return "1" if shape not in ("", "mesh") and description_of(ask).links else ""

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no weight."""
        return None if NUMBER.fullmatch(text) else "it is a number of kilograms, such as 0.5"


class ColorKind(Kind):
    """A colour, by its name or as a code; a code is entered without its quotes."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return nothing for a place."""
        return Cell("", "a place is not seen") if _is_place(ask) else None

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the materials of the robot, and the colours that have names."""
        robot = description_of(ask)
        own = [Choice(name, "of this robot") for name in robot.materials if name not in NAMES]
        there = robot.links.get(ask.text(SlotKind.LINK))
        is_painted = there is not None and any(each.material for each in there.visuals)
        none = [Choice(NONE, "no colour of its own")] if is_painted else []
        return [*own, *(Choice(name, code, swatch=code) for name, code in NAMES.items()), *none]

    def written(self, ask: Ask, text: str) -> str:
        """Return a color as the program has it."""
        return text if text.isascii() and text.isidentifier() else quoted(text)


class PositionKind(Kind):
    """A place: a row for each of its numbers."""

    def parts(self, ask: Ask) -> tuple[Part, ...]:
        """Return the rows; a place that nothing is seen at is where its joint is."""
        if ask.form.declaration.type is st.HasLink and _is_place(ask):
            return ()
        return _PLACE


class RotationKind(Kind):
    """How something is turned: a row for each of three angles."""

    def parts(self, ask: Ask) -> tuple[Part, ...]:
        """Return the rows."""
        if ask.form.declaration.type is st.HasLink and _is_place(ask):
            return ()
        return tuple(Part(name, "angle", without="0", example="90") for name in _ANGLES)


class AngleUnitKind(Kind):
    """What angles are in."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return nothing where nothing is turned."""
        return None if ask.text(SlotKind.ROTATION) else Cell("", "nothing is turned")

    def suggest(self, ask: Ask) -> str:
        """Return degrees."""
        return "deg"

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return both."""
        return [Choice("deg", "degrees: 90 is a right angle"), Choice("rad", "radians")]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text in ("deg", "rad") else "it is `deg` or `rad`"


class AxisKind(Kind):
    """What a joint turns around, or slides along."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return nothing for a joint that has none."""
        type_ = _type_of(ask)
        if type_ is None or type_.has_axis:
            return None
        return Cell("", "it does not move" if type_ is JointType.FIXED else "it has none")

    def suggest(self, ask: Ask) -> str:
        """Return that of a wheel for what turns without end, and else up."""
        if joint_of(ask) is not None:
            return ""
        return "0, 1, 0" if _type_of(ask) is JointType.CONTINUOUS else "0, 0, 1"

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those that most joints have."""
        return [Choice(axis, about) for axis, about in AXES.items()]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no axis."""
        return None if VECTOR.fullmatch(text) else "it is three numbers, such as `0, 0, 1`"


def _type_of(ask: Ask) -> JointType | None:
    """Return the type of the joint that the form is about."""
    text = ask.text(SlotKind.JOINT_TYPE)
    if text:
        return JointType(text) if text in {each.value for each in JointType} else None
    joint = joint_of(ask)
    return None if joint is None else joint.type


class FactorKind(Kind):
    """How far a joint moves for each unit of the one that it follows."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return nothing where it follows none."""
        is_none = ask.text_of("mimicked") in ("", NONE)
        return Cell("", "it follows none") if is_none else None

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no number."""
        return None if NUMBER.fullmatch(text) else "it is a number, such as -1"


_ENDS = {
    JointType.REVOLUTE: {"minimum": "-90", "maximum": "90"},
    JointType.PRISMATIC: {"minimum": "0", "maximum": "0.5"},
}
_STRENGTH = {"effort": "10", "velocity": "1"}


class LimitKind(BoundKind):
    """An end of a parameter's range, or a limit of a joint."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return nothing where a joint has no ends."""
        if ask.form.declaration.type is not st.LimitsJoint:
            return super().fixed(ask)
        is_end = ask.slot.name in ("minimum", "maximum")
        if is_end and _type_of(ask) is JointType.CONTINUOUS:
            return Cell("", "it turns without end")
        return None

    def suggest(self, ask: Ask) -> str:
        """Return what fits a joint; a parameter needs none."""
        if ask.form.declaration.type is not st.LimitsJoint:
            return super().suggest(ask)
        type_ = _type_of(ask)
        ends = {} if type_ is None else _ENDS.get(type_, {})
        return {**ends, **_STRENGTH}.get(ask.slot.name, "")

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no number."""
        if ask.form.declaration.type is not st.LimitsJoint:
            return super().problem(ask, text)
        return None if NUMBER.fullmatch(text) else "it is a number, such as 1.5"


class LimitUnitKind(Kind):
    """What the ends of a joint are in."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return what there is no choice of."""
        if not ask.text_of("minimum") and not ask.text_of("maximum"):
            return Cell("", "it has no ends")
        return Cell("m", "it slides") if _type_of(ask) is JointType.PRISMATIC else None

    def suggest(self, ask: Ask) -> str:
        """Return degrees."""
        return "deg"

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those of angles."""
        return [Choice("deg", "degrees: 90 is a right angle"), Choice("rad", "radians")]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text in ("deg", "rad") else "it is `deg` or `rad`"
