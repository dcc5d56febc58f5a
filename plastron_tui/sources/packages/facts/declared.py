"""The dependencies of a package.xml."""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.model.package_facts import Declared
from plastron_tui.sources.splices import line_end, line_start
from plastron_tui.sources.xml.conditions import holds
from plastron_tui.sources.xml.package_data import COVERS, PackageXml

_VERSIONS = (1, 2)


def declared(package: PackageXml) -> tuple[Declared, ...]:
    """Return the dependencies that a package.xml declares; one that never holds is left out."""
    text = package.document.text
    found = []
    for one in package.dependencies:
        versions = tuple(
            version
            for version in _VERSIONS
            if holds(one.condition, {"ROS_VERSION": str(version)}) is not False
        )
        if one.name and versions:
            span, line = one.element.value_span(text), _line(text, one.element.span)
            is_plain = one.condition is None
            covers = COVERS[one.tag]
            found.append(Declared(one.name, one.tag, covers, versions, is_plain, span, line))
    return tuple(found)


def _line(text: bytes, span: Span) -> Span | None:
    """Return the line of an element that stands alone in it, None where it does not."""
    start, end = line_start(text, span.start), line_end(text, span.end)
    is_alone = not text[start : span.start].strip() and not text[span.end : end].strip()
    return Span(start, end) if is_alone and line_end(text, span.start) == end else None
