"""URDF files, read as urdfdom reads them (`model.cpp`)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.ros.robots.description import Body, Description, Joint, Link, Material
from plastron_tui.ros.robots.materials import is_defined
from plastron_tui.sources.xml.document import Element, XmlDocument, read_xml

from .joints import joint_of
from .links import link_of, material_of
from .values import Values, is_computed, is_xacro
from .vocabulary import FIRST_VERSION, LAST_VERSION, second_children, version_of

_LARGEST_KEPT = 500_000
"""Bytes of a text that is kept as it was read."""


@dataclass(frozen=True, slots=True)
class PartPlaces:
    """Where the parts of a robot stand in its file, by their names.

    Visuals, collisions and what else is in a part are the children of its element, in the order
    in which the description has them.
    """

    links: Mapping[str, Element] = field(default_factory=dict)
    joints: Mapping[str, Element] = field(default_factory=dict)
    materials: Mapping[str, Element] = field(default_factory=dict)
    again: Mapping[tuple[str, str], Element] = field(default_factory=dict)
    """The second of those, by element and name, of which a file should have one."""


class UrdfRead(NamedTuple):
    """A robot's file that was read.

    Attributes:
        document: its XML, None where it is not well-formed, or too large or too deep.
        description: the robot, None where the file describes none. Its materials are those that
            stand beside the links.
        places: where its parts stand.
        diagnostics: what is wrong in the file; errors are what urdfdom tells as errors.
    """

    document: XmlDocument | None
    description: Description | None
    places: PartPlaces = PartPlaces()
    diagnostics: tuple[Diagnostic, ...] = ()


def read_urdf(text: bytes, path: Path | None = None) -> UrdfRead:
    """Read a robot's file, and from a file with macros what it says outright.

    What cannot be read is left out, or as it would be if nothing was said; elements that URDF
    does not know are left alone, and only what stands directly in `<robot>` is a link or a joint
    (`<transmission>` and `<gazebo>` have elements of the same names). A text that was read lately
    is not read again.

    Args:
        text: what the file holds.
        path: the file, for diagnostics.
    """
    return _read_again(text, path) if len(text) <= _LARGEST_KEPT else _read(text, path)


def _read(text: bytes, path: Path | None) -> UrdfRead:
    document, diagnostics = read_xml(text, path)
    if document is None:
        return UrdfRead(None, None, diagnostics=diagnostics)
    root = document.root
    if root.name != "robot":
        message = (
            f"the outermost element of a robot's file is `<robot>`, and this is `<{root.name}>`"
        )
        found = Diagnostic(codes.BROKEN_URDF, message, root.name_span, path)
        return UrdfRead(document, None, diagnostics=(found,))
    return _Reader(Values(document, is_xacro(document))).read()


_read_again = lru_cache(maxsize=4)(_read)
"""Who loads a file, changes it and looks at the change reads the same texts one after the other."""


class _Reader:
    """Reads the parts of a robot one by one."""

    def __init__(self, values: Values) -> None:
        self.values = values
        self.materials: dict[str, Material] = {}
        self.links: dict[str, Link] = {}
        self.joints: dict[str, Joint] = {}
        self.places: dict[str, dict[str, Element]] = {"link": {}, "joint": {}, "material": {}}
        self.again: dict[tuple[str, str], Element] = {}

    def read(self) -> UrdfRead:
        document = self.values.document
        root = document.root
        name = None if self._is_part_without_name(root) else self.values.needed(root, "name")
        self._check_version(root)
        for element in root.children:
            if element.name in self.places:
                self._check_second(element)
        for element in root.named("material"):
            self._material(element)
        for element in root.named("link"):
            if (called := self._name(element)) is not None:
                self.links[called] = link_of(element, called, self.values)
        for element in root.named("joint"):
            called = self._name(element)
            joint = None if called is None else joint_of(element, called, self.values)
            if joint is not None:
                self.joints[joint.name] = joint
        self._check_materials()
        robot = Description(name.value if name else "", self.links, self.joints, self.materials)
        links, joints, materials = (self.places[each] for each in ("link", "joint", "material"))
        places = PartPlaces(links, joints, materials, self.again)
        diagnostics = sorted(self.values.diagnostics, key=lambda each: each.span or Span(0, 0))
        if self.values.untold:
            message = f"there are {self.values.untold} mistakes more in the file"
            diagnostics.append(Diagnostic(codes.BROKEN_URDF, message, file=document.file))
        return UrdfRead(document, robot, places, tuple(diagnostics))

    def _is_part_without_name(self, root: Element) -> bool:
        """Tell whether the file is there to be included: its robot has the name of another one."""
        return self.values.is_xacro and root.attribute("name") is None

    def _check_version(self, root: Element) -> None:
        found = root.attribute("version")
        if found is None or (self.values.is_xacro and is_computed(found.value)):
            return
        version = version_of(root)
        if version is None:
            message = f"`{found.value}` is no version of URDF"
            self.values.tell(message, found.value_span, "it is written as in `1.0`")
        elif not FIRST_VERSION <= version <= LAST_VERSION:
            message = f"urdfdom does not read version {found.value} of URDF"
            self.values.tell(message, found.value_span, "it reads 1.0, 1.1 and 1.2")

    def _check_second(self, part: Element) -> None:
        """Tell what stands in a part a second time, where only the first counts."""
        for element in part.walk():
            for second in second_children(element):
                which = f"a second `<{second.name}>` in `<{element.name}>` does not count"
                if element.name == "geometry":
                    which = f"`<{second.name}>` does not count: a geometry has one shape"
                self.values.tell(which, second.name_span, severity=Severity.WARNING)

    def _material(self, element: Element) -> None:
        material = material_of(element, self.values, is_shared=True)
        if material is not None and self._is_first(element, material.name):
            self.materials[material.name] = material

    def _name(self, element: Element) -> str | None:
        """Return the name of a part, None where it has none, or that of an earlier one."""
        found = self.values.needed(element, "name")
        if found is None or not self._is_first(element, found.value):
            return None
        return found.value

    def _is_first(self, element: Element, name: str) -> bool:
        places = self.places[element.name]
        if name not in places:
            places[name] = element
            return True
        found = element.attribute("name")
        span = element.name_span if found is None else found.value_span
        self.again.setdefault((element.name, name), element)
        labels = (Label(places[name].name_span, "first here"),)
        message = f"a {element.name} `{name}` is there already, and this one does not count"
        help_text = "urdfdom reads no file with two of a name: rename one, or take it away"
        self.values.tell(message, span, help_text, labels=labels)
        return False

    def _check_materials(self) -> None:
        """Look for materials that are meant by a name which no material has by then.

        The first of a name is the one that all mean, wherever it stands (`assignMaterial`).
        """
        defined = dict(self.materials)
        for name, element in self.places["link"].items():
            for body, place in _painted(self.links[name], element):
                material = body.material
                if material is None or not material.name:
                    continue
                if is_defined(material):
                    if defined.setdefault(material.name, material) != material:
                        self._shadowed(material, place)
                elif material.name not in defined and not self.values.is_xacro:
                    self._undefined(material, place)

    def _undefined(self, material: Material, place: Element) -> None:
        known = ", ".join(f"`{each}`" for each in list(self.materials)[:5])
        help_text = f"there are {known}" if known else 'give it a `<color rgba="…"/>` of its own'
        message = f"no material is called `{material.name}`"
        self.values.tell(message, _name_span(place), help_text)

    def _shadowed(self, material: Material, place: Element) -> None:
        message = f"another material is called `{material.name}`, and is the one that counts"
        self.values.tell(message, _name_span(place), severity=Severity.WARNING)


def _name_span(place: Element) -> Span:
    """Return where the name of the material in a `visual` stands."""
    material = next(each for each in place.named("material"))
    name = material.attribute("name")
    return material.name_span if name is None else name.value_span


def _painted(link: Link, element: Element) -> Iterator[tuple[Body, Element]]:
    return zip(link.visuals, element.named("visual"), strict=True)
