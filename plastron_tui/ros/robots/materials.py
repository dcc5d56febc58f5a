"""Which material a name means.

The first material of a name that has a colour or a texture is the one that all mean, be it beside
the links or within one (urdfdom: `assignMaterial`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

from .description import Body, Description, Link, Material


def is_defined(material: Material) -> bool:
    """Tell whether a material says how it looks, and not only what it is called."""
    return material.rgba is not None or material.texture is not None


def defined_materials(robot: Description) -> dict[str, Material]:
    """Return what each name means, in a robot whose links are in the order of its file."""
    found = dict(robot.materials)
    for material in painted(robot):
        if material.name and is_defined(material):
            found.setdefault(material.name, material)
    return found


def painted(robot: Description) -> Iterator[Material]:
    """Yield the materials of what is seen."""
    for link in robot.links.values():
        for body in link.visuals:
            if body.material is not None:
                yield body.material


def meant(material: Material, defined: Mapping[str, Material]) -> Material:
    """Return the material that one within a link stands for."""
    return defined.get(material.name, material) if material.name else material


def kept_apart(before: Description, after: Description) -> Description:
    """Return a changed robot in which all that is not changed looks as before.

    A colour that would change others of its name gets another name; a material that others mean
    and whose own link lost it goes on to the first of them.
    """
    meanings = _kept_meanings(before, after)
    names = {*meanings, *defined_materials(before), *defined_materials(after)}
    renamed: dict[Material, Material] = {}

    def own_name(body: Body, is_kept: bool) -> Body:
        material = body.material
        if is_kept or material is None or not (material.name and is_defined(material)):
            return body
        if meanings.setdefault(material.name, material) == material:
            return body
        if material not in renamed:
            renamed[material] = material._replace(name=_free(material.name, names))
        return body._replace(material=renamed[material])

    apart = _with_bodies(before, after, own_name)
    defined = set(defined_materials(apart))

    def handed_on(body: Body, is_kept: bool) -> Body:
        del is_kept
        material = body.material
        if material is None or is_defined(material) or material.name in defined:
            return body
        defined.add(material.name)
        return body._replace(material=meanings.get(material.name, material))

    return _with_bodies(before, apart, handed_on)


def said_as_before(before: Description, after: Description) -> Description:
    """Return a changed robot that says its new colours where it has the others.

    Where all that links have stand beside them, so do the new ones. Else a link that is painted
    says its colour once, and what else of it has that colour means it by its name.
    """
    materials = dict(after.materials)
    names = [each for each in painted(before) if each.name]
    is_shared = bool(names) and all(
        each.name in before.materials and not is_defined(each) for each in names
    )
    links: dict[str, Link] = {}
    for name, link in after.links.items():
        was, said = _visuals(before, name), set[Material]()
        visuals = []
        for body in link.visuals:
            material = body.material
            if material is not None and material.name and is_defined(material):
                if is_shared and body not in was:
                    is_said = materials.setdefault(material.name, material) == material
                else:
                    is_said = material in said and body not in was
                said.add(material)
                body = body._replace(material=Material(material.name)) if is_said else body
            visuals.append(body)
        links[name] = link._replace(visuals=tuple(visuals))
    return replace(after, links=links, materials=materials)


def _with_bodies(
    before: Description, after: Description, change: Callable[[Body, bool], Body]
) -> Description:
    """Return a robot with what is seen changed, each by itself and by whether it was so before."""
    links: dict[str, Link] = {}
    for name, link in after.links.items():
        was = _visuals(before, name)
        visuals = tuple(change(body, body in was) for body in link.visuals)
        links[name] = link if visuals == link.visuals else link._replace(visuals=visuals)
    return replace(after, links=links)


def _kept_meanings(before: Description, after: Description) -> dict[str, Material]:
    """Return what the names mean of which something says or means that is not changed."""
    defined = defined_materials(before)
    found = {name: each for name, each in after.materials.items() if is_defined(each)}
    for name, link in after.links.items():
        was = _visuals(before, name)
        for body in link.visuals:
            if body.material is not None and body in was:
                material = meant(body.material, defined)
                if material.name and is_defined(material):
                    found.setdefault(material.name, material)
    return found


def _visuals(robot: Description, name: str) -> frozenset[Body]:
    link = robot.links.get(name)
    return frozenset(() if link is None else link.visuals)


def _free(name: str, names: set[str]) -> str:
    at = 2
    while (other := f"{name}_{at}") in names:
        at += 1
    names.add(other)
    return other


def shared(robot: Description) -> Description:
    """Return a robot whose links mean their materials by name, wherever that means the same."""
    materials = {name: each for name, each in defined_materials(robot).items() if is_defined(each)}

    def named(body: Body) -> Body:
        material = body.material
        if material is None or not material.name or materials.get(material.name) != material:
            return body
        return body._replace(material=Material(material.name))

    links = {
        name: link._replace(visuals=tuple(map(named, link.visuals)))
        for name, link in robot.links.items()
    }
    return replace(robot, links=links, materials={**robot.materials, **materials})
