"""From the statements of a package to what its files follow from."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.generating.apply_changes import Library
from plastron_tui.generating.package_spec import package_spec
from plastron_tui.ros.catalog import Catalog
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target
from plastron_tui.targets.packages import PackageSpec, render_package

PROGRAM = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
create_package 'demo' as demo described_as "Says hello" maintained_by "Ada <ada@example.com>" {}
demo contains talker as 'speaker'
generate_package demo
"""


def spec_of(program: str, library: str, folder: Path) -> PackageSpec:
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


@pytest.mark.parametrize(
    ("library", "path"),
    [("rospy", "scripts/speaker.py"), ("rclpy", "demo/speaker.py")],
)
def test_package_of_a_program_is_rendered(library: str, path: str, tmp_path: Path) -> None:
    spec = spec_of(PROGRAM.format('licensed_under "mit"'), library, tmp_path)
    found = render_package(spec)
    assert found.diagnostics == ()
    assert found.files is not None
    assert found.files[path].is_executable
    assert b"Ada" in found.files["LICENSE"].text
    assert spec.license == "MIT"
    if library == "rclpy":
        assert b"'speaker = demo.speaker:main'" in found.files["setup.py"].text
