"""Changes of a link, of what is in it, and of materials."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from typing import NamedTuple

from plastron_tui.ros.robots.description import (
    ORIGIN,
    Body,
    Box,
    Cylinder,
    Inertial,
    Link,
    Material,
    Mesh,
    Pose,
    Shape,
    Sphere,
    Tensor,
    Vector,
)
from plastron_tui.ros.robots.quaternions import angles_of, quaternion_of
from plastron_tui.sources.xml.document import Element
from plastron_tui.sources.xml.new_element import NewElement

from .equality import same
from .new_elements import (
    body_element,
    inertial_element,
    material_element,
    origin_elements,
    shape_element,
)
from .part_edits import PartEdits, Path
from .vocabulary import QUATERNION


def change_link(part: PartEdits, before: Link, after: Link) -> None:
    """Let a link say what it is to say, by the least changes of its text."""
    _change_bodies(part, "visual", before.visuals, after.visuals)
    _change_bodies(part, "collision", before.collisions, after.collisions)
    _change_inertial(part, before.inertial, after.inertial)


def change_material(part: PartEdits, path: Path, before: Material, after: Material) -> None:
    """Let a material have another name, colour or texture."""
    if before.name != after.name:
        part.set_text(path, "name", after.name)
    color, texture = (*path, ("color", 0)), (*path, ("texture", 0))
    written = {each.name: each for each in material_element(after).children}
    if after.rgba is None or before.rgba is None:
        put(part, color, written.get("color"), was_there=before.rgba is not None)
    else:
        part.set_numbers(color, "rgba", before.rgba, after.rgba)
    if after.texture is None or before.texture is None:
        _tell_texture(part, before, after)
        put(part, texture, written.get("texture"), was_there=before.texture is not None)
    else:
        part.set_text(texture, "filename", after.texture)


def _tell_texture(part: PartEdits, before: Material | None, after: Material | None) -> None:
    """Tell that a texture goes, of which no sentence speaks: with it nobody sees the colour."""
    texture = None if before is None else before.texture
    if texture is not None and (after is None or after.texture is None):
        part.tell(f"the texture `{texture}` goes with the colour that was there")


def change_pose(part: PartEdits, path: Path, before: Pose, after: Pose) -> None:
    """Let something be elsewhere, or be turned otherwise."""
    if same(before, after):
        return
    origin = (*path, ("origin", 0))
    written = next(origin_elements(after), None)
    there = part.find(origin)
    if there is not None and _is_turned_by_quaternion(part, there):
        # It stays, also where what it says is what would be so without.
        part.set_numbers(origin, "xyz", before.position, after.position, ORIGIN)
        _change_quaternion(part, origin, before.rotation, after.rotation)
        return
    says_none = any(part.habits.says_default("origin", each) for each in ("xyz", "rpy"))
    if there is None or (written is None and not says_none):
        put(part, origin, written, was_there=True)
        return
    part.set_numbers(origin, "xyz", before.position, after.position, ORIGIN)
    set_or_drop(part, origin, "rpy", before.rotation, after.rotation, ORIGIN)


def _is_turned_by_quaternion(part: PartEdits, origin: Element) -> bool:
    has_rpy = origin.attribute("rpy") is not None
    return part.has_quaternions and not has_rpy and origin.attribute(QUATERNION) is not None


def _change_quaternion(part: PartEdits, origin: Path, before: Vector, after: Vector) -> None:
    if same(before, after):
        return
    quaternion = quaternion_of(after)
    if not same(angles_of(quaternion), after):
        message = f"`{QUATERNION}` cannot say exactly these angles; write them as `rpy` there"
        raise part.refusal(message)
    part.set_numbers(origin, QUATERNION, quaternion_of(before), quaternion)


def set_or_drop(
    part: PartEdits,
    path: Path,
    name: str,
    was: Sequence[float],
    values: Sequence[float],
    default: Sequence[float],
) -> None:
    """Let an attribute have other numbers; it goes where the author leaves such numbers unsaid."""
    element = part.find(path)
    is_default = same(tuple(values), tuple(default)) and not same(tuple(was), tuple(values))
    if (
        element is not None
        and element.attribute(name) is not None
        and is_default
        and not part.habits.says_default(element.name, name)
    ):
        part.drop(path, name)
    else:
        part.set_numbers(path, name, was, values, default)


class _Change(NamedTuple):
    """A body that is changed, added (before is None) or taken away (after is None).

    Attributes:
        at: its place among those that are there by then.
    """

    at: int
    before: Body | None
    after: Body | None


def _change_bodies(
    part: PartEdits, tag: str, before: Sequence[Body], after: Sequence[Body]
) -> None:
    for change in _changes(before, after):
        path: Path = ((tag, change.at),)
        if change.after is None:
            part.remove(path)
        elif change.before is None:
            part.insert((), body_element(tag, change.after), change.at)
        else:
            _change_body(part, path, change.before, change.after)


def _changes(before: Sequence[Body], after: Sequence[Body]) -> Iterator[_Change]:
    """Yield the changes that make some bodies of others, one after the other."""
    if len(before) == len(after):
        pairs = zip(before, after, strict=True)
        yield from (_Change(at, *pair) for at, pair in enumerate(pairs) if not same(*pair))
        return
    at = 0
    matcher = SequenceMatcher(None, before, after, autojunk=False)
    for _, start, end, new_start, new_end in matcher.get_opcodes():
        old, new = before[start:end], after[new_start:new_end]
        both = min(len(old), len(new))
        for one, other in zip(old[:both], new[:both], strict=True):
            if not same(one, other):
                yield _Change(at, one, other)
            at += 1
        for one in new[both:]:
            yield _Change(at, None, one)
            at += 1
        for one in old[both:]:
            yield _Change(at, one, None)


def _change_body(part: PartEdits, path: Path, before: Body, after: Body) -> None:
    if before.name != after.name:
        if after.name:
            part.set_text(path, "name", after.name)
        else:
            part.drop(path, "name")
    change_pose(part, path, before.pose, after.pose)
    if not same(before.shape, after.shape):
        _change_shape(part, path, before.shape, after.shape)
    material = (*path, ("material", 0))
    if before.material is None or after.material is None:
        new = None if after.material is None else material_element(after.material)
        _tell_texture(part, before.material, after.material)
        put(part, material, new, was_there=before.material is not None)
    else:
        change_material(part, material, before.material, after.material)


def _change_shape(part: PartEdits, path: Path, before: Shape | None, after: Shape | None) -> None:
    geometry = (*path, ("geometry", 0))
    if after is None:
        put(part, geometry, None, was_there=True)
        return
    new = shape_element(after)
    there = part.find(geometry)
    if there is None or not there.children:
        put(part, geometry, NewElement("geometry", children=(new,)), was_there=True)
        return
    inner = (*geometry, (there.children[0].name, 0))
    match before, after:
        case Box(was), Box(size):
            part.set_numbers(inner, "size", was, size)
        case Cylinder(), Cylinder():
            part.set_numbers(inner, "radius", (before.radius,), (after.radius,))
            part.set_numbers(inner, "length", (before.length,), (after.length,))
        case Sphere(old), Sphere(radius):
            part.set_numbers(inner, "radius", (old,), (radius,))
        case Mesh(), Mesh():
            part.set_text(inner, "filename", after.uri)
            set_or_drop(part, inner, "scale", before.scale, after.scale, (1.0, 1.0, 1.0))
        case _:
            part.replace(inner, new)


def _change_inertial(part: PartEdits, before: Inertial | None, after: Inertial | None) -> None:
    path: Path = (("inertial", 0),)
    if same(before, after):
        return
    if before is None or after is None:
        new = None if after is None else inertial_element(after)
        put(part, path, new, was_there=before is not None)
        return
    change_pose(part, path, before.pose, after.pose)
    part.set_numbers((*path, ("mass", 0)), "value", (before.mass,), (after.mass,))
    for name, was, value in zip(Tensor._fields, before.tensor, after.tensor, strict=True):
        part.set_numbers((*path, ("inertia", 0)), name, (was,), (value,))


def put(part: PartEdits, path: Path, new: NewElement | None, *, was_there: bool) -> None:
    """Let an element be there, or not.

    Args:
        part: what is changed.
        path: the element.
        new: what it is to be, None for nothing.
        was_there: whether it said something; what stands there and says nothing that counts is
            left alone unless it is replaced.
    """
    there = part.find(path)
    if new is not None and there is None:
        part.insert(path[:-1], new)
    elif new is not None:
        part.replace(path, new)
    elif there is not None and was_there:
        part.remove(path)
