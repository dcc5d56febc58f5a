"""Plugin descriptions of pluginlib: which classes a library has for which base classes.

From the page "Plugin Description File" of the ROS wiki and the ROS 2 tutorial "Creating and using
plugins (C++)": a `<library path>` with a `<class type base_class_type>` for each, or several
libraries in `<class_libraries>`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.diagnostics.severity import Severity

from .document import Element, XmlDocument, read_xml
from .edits import XmlEdit, insert_last, remove_element
from .new_element import NewElement


class PluginClass(NamedTuple):
    """A class that is loaded by name.

    Attributes:
        name: what it is loaded by; its type, where the file does not say.
        type: in C++, with its namespaces.
        base: the type of its base class.
        description: one line about it.
    """

    name: str
    type: str
    base: str
    description: str = ""


class Library(NamedTuple):
    """A library and its classes, each with the element where it stands."""

    path: str
    classes: tuple[tuple[PluginClass, Element], ...]
    element: Element


@dataclass(frozen=True, slots=True)
class Plugins:
    """A plugin description."""

    document: XmlDocument
    libraries: tuple[Library, ...]


class PluginsResult(NamedTuple):
    """A plugin description, or why there is none; there may be errors in one that is read."""

    plugins: Plugins | None
    diagnostics: tuple[Diagnostic, ...] = ()


class PluginsEdit(NamedTuple):
    """A plugin description after an edit, or why it is not made."""

    plugins: Plugins | None
    diagnostics: tuple[Diagnostic, ...] = ()


def read_plugins(text: bytes, file: Path | None = None) -> PluginsResult:
    """Read a plugin description.

    Args:
        text: what the file holds.
        file: the file, for diagnostics.
    """
    document, diagnostics = read_xml(text, file)
    if document is None:
        return PluginsResult(None, diagnostics)
    root = document.root
    if root.name not in ("library", "class_libraries"):
        message = f"the outermost element is `<{root.name}>`, not `<library>`"
        return PluginsResult(None, (_told(document, message, root.name_span),))
    return PluginsResult(_parsed(document), tuple(_check(document)))


def add_class(plugins: Plugins, path: str, new: PluginClass) -> PluginsEdit:
    """Describe a class of a library, as the last one; nothing where it is described already.

    Args:
        plugins: the plugin description.
        path: of the library; a file for several libraries may not have it yet.
        new: the class.
    """
    document = plugins.document
    for library in plugins.libraries:
        for old, element in library.classes:
            if old.name != new.name:
                continue
            if (library.path, old.type, old.base) == (path, new.type, new.base):
                return PluginsEdit(plugins)
            message = f"a class called `{new.name}` is described already, as another one"
            return PluginsEdit(None, (_refused(document, message, element.name_span),))
    written = _element(new)
    found = [library for library in plugins.libraries if library.path == path]
    if found:
        return _applied(insert_last(document, found[-1].element, written))
    if document.root.name == "library":
        message = f"the file describes another library than `{path}`"
        place = document.root.attribute("path")
        span = place.value_span if place is not None else document.root.name_span
        return PluginsEdit(None, (_refused(document, message, span),))
    library_element = NewElement("library", (("path", path),), children=(written,))
    return _applied(insert_last(document, document.root, library_element))


def remove_class(plugins: Plugins, name: str) -> PluginsEdit:
    """Take a class away, and its library where that is one of several and has no other class."""
    document = plugins.document
    for library in plugins.libraries:
        for old, element in library.classes:
            if old.name == name:
                is_empty = len(library.classes) == 1 and len(plugins.libraries) > 1
                gone = library.element if is_empty else element
                return _applied(remove_element(document, gone))
    return PluginsEdit(plugins)


def _parsed(document: XmlDocument) -> Plugins:
    libraries = []
    for element in _libraries(document):
        classes = tuple((_class(one), one) for one in element.named("class"))
        libraries.append(Library((element.get("path") or "").strip(), classes, element))
    return Plugins(document, tuple(libraries))


def _libraries(document: XmlDocument) -> tuple[Element, ...]:
    root = document.root
    return (root,) if root.name == "library" else root.named("library")


def _class(element: Element) -> PluginClass:
    kind, base = (element.get("type") or "").strip(), (element.get("base_class_type") or "").strip()
    told = element.named("description")
    description = " ".join(told[0].text.split()) if told else ""
    return PluginClass((element.get("name") or "").strip() or kind, kind, base, description)


def _check(document: XmlDocument) -> Iterator[Diagnostic]:
    seen: set[str] = set()
    for library in _libraries(document):
        if not library.get("path"):
            yield _told(document, "the library has no path", library.name_span)
        for element in library.named("class"):
            for attribute in ("type", "base_class_type"):
                if not element.get(attribute):
                    yield _told(document, f"the class has no `{attribute}`", element.name_span)
            name = _class(element).name
            if name and name in seen:
                message = f"two classes are called `{name}`"
                told = _told(document, message, element.name_span)
                yield told._replace(severity=Severity.WARNING)
            seen.add(name)


def _element(new: PluginClass) -> NewElement:
    name = () if new.name == new.type else (("name", new.name),)
    attributes = (*name, ("type", new.type), ("base_class_type", new.base))
    told = (NewElement("description", text=new.description),) if new.description else ()
    return NewElement("class", attributes, children=told)


def _applied(edit: XmlEdit) -> PluginsEdit:
    if edit.document is None:
        return PluginsEdit(None, edit.diagnostics)
    return PluginsEdit(_parsed(edit.document))


def _told(document: XmlDocument, message: str, span: Span) -> Diagnostic:
    return Diagnostic(codes.BROKEN_PLUGINS, message, span, document.file)


def _refused(document: XmlDocument, message: str, span: Span) -> Diagnostic:
    return Diagnostic(codes.EDIT_REFUSED, message, span, document.file)
