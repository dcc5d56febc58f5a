"""What packages of programs follow from."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.generating.apply_changes import Library
from plastron_tui.generating.package_spec import package_spec
from plastron_tui.ros.catalog import Catalog
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target
from plastron_tui.targets.packages import PackageSpec


def spec_of(program: str, library: str, folder: Path) -> PackageSpec:
    """Return what the files of the first package that a program writes follow from."""
    options = Options(library, folder / "output")
    session = Session(program.encode(), folder / "a.plastron", options, environ={})
    assert session.diagnostics == ()
    target = find_target(library)
    assert target is not None
    libraries = {library: Library(target, Catalog({"rospy": "noetic", "rclpy": "kilted"}[library]))}
    package = session.workspace.written_packages[0].package
    spec = package_spec(package, session.generated(), libraries, next(iter(libraries.values())))
    assert spec is not None
    return spec
