"""What catkin_pkg says of a package.xml, beside what Plastron says."""

from __future__ import annotations

from catkin_pkg.package import InvalidPackage, Package, parse_package_string

from plastron_tui.diagnostics.severity import Severity
from plastron_tui.sources.xml.package_data import COVERS, PackageXml
from plastron_tui.sources.xml.package_xml import read_package

SLOTS = {
    "build": "build_depends",
    "buildtool": "buildtool_depends",
    "build_export": "build_export_depends",
    "buildtool_export": "buildtool_export_depends",
    "exec": "exec_depends",
    "test": "test_depends",
    "doc": "doc_depends",
}


def catkin(text: bytes) -> tuple[Package | None, bool]:
    """Return what catkin_pkg reads, None where it refuses, and whether it warns."""
    warnings: list[str] = []
    try:
        package = parse_package_string(text, warnings=warnings)
        package.evaluate_conditions({})
        package.get_build_type()
    except (InvalidPackage, ValueError, AssertionError):
        return None, bool(warnings)
    return package, bool(warnings)


def plastron(text: bytes) -> tuple[PackageXml | None, bool]:
    """Return what Plastron reads, None where there are errors, and whether it warns."""
    package, diagnostics = read_package(text)
    severities = [one.severity for one in diagnostics]
    return None if Severity.ERROR in severities else package, Severity.WARNING in severities


def facts(package: Package) -> dict[str, object]:
    """Return what both readers tell of a package."""
    return {
        "format": package.package_format,
        "name": package.name,
        "version": package.version,
        "description": " ".join(package.plaintext_description.split()),
        "maintainers": [(one.name, one.email) for one in package.maintainers],
        "authors": [(one.name, one.email) for one in package.authors],
        "licenses": list(package.licenses),
        "urls": [one.url for one in package.urls],
        "groups": {(one.name, one.condition) for one in package.member_of_groups},
        "exports": [(one.tagname, one.attributes) for one in package.exports],
        **{
            need: {(one.name, one.condition, one.version_gte) for one in package[slot]}
            for need, slot in SLOTS.items()
        },
    }


def own_facts(package: PackageXml) -> dict[str, object]:
    """Return the same of what Plastron has read."""
    return {
        "format": package.format,
        "name": package.name,
        "version": package.version,
        "description": package.description,
        "maintainers": [(one.name, one.email) for one in package.maintainers],
        "authors": [(one.name, one.email) for one in package.authors],
        "licenses": list(package.licenses),
        "urls": list(package.urls),
        "groups": {
            (one.name, one.condition) for one in package.groups if one.tag == "member_of_group"
        },
        "exports": [(one.tag, dict(one.attributes)) for one in package.exports],
        **{
            need: {
                (one.name, one.condition, dict(one.versions).get("version_gte"))
                for one in package.dependencies
                if need in COVERS[one.tag]
            }
            for need in SLOTS
        },
    }
