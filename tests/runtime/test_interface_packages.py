"""Interface packages that are made: what is asked for, kept, and said of what fails."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from plastron_tui.diagnostics import codes
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.installations import Origin
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.runtime import installing
from plastron_tui.runtime.build_output import Progress
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.interface_packages import complete

ADD = InterfaceName("example_interfaces", "AddTwoInts")
ADD_ROS1 = InterfaceName("beginner_tutorials", "AddTwoInts")

# An interpreter that has rclpy, and what its first line names; `-c` asks where its headers are.
PYTHON = """\
#!/bin/sh
HAS="{has}"
if [ "$1" = -c ]; then echo '{facts}'; exit; fi
case "$1" in */genpy/*) echo no such type; exit 3;; esac
shift
missing=""
for name; do
  case " $HAS " in *" $name "*) ;; *) missing="$missing,\\"$name\\"";; esac
done
echo "{{\\"missing\\": [${{missing#,}}]}}"
"""
BUILDERS = "ament_package catkin_pkg rosidl_generator_py"


@pytest.fixture
def python(tmp_path: Path) -> Callable[..., Path]:
    """Makes an interpreter that has packages."""

    def make(has: str = BUILDERS) -> Path:
        headers = tmp_path / "include"
        headers.mkdir()
        (headers / "Python.h").touch()
        facts = json.dumps([str(tmp_path), str(tmp_path), str(headers), str(headers)])
        script = tmp_path / "python3"
        script.write_text(PYTHON.format(has=has, facts=facts))
        script.chmod(0o755)
        return script

    return make


@pytest.fixture
def environ(tmp_path: Path) -> dict[str, str]:
    """The environment of a user whose cache is in the folder, with tools that do nothing."""
    tools = tmp_path / "bin"
    tools.mkdir()
    for name in ("cmake", "make", "c++", "colcon"):
        (tools / name).write_text('#!/bin/sh\necho "no rule for $1"\nexit 1\n')
        (tools / name).chmod(0o755)
    return {"PATH": f"{tools}:/usr/bin:/bin", "XDG_CACHE_HOME": str(tmp_path / "cache")}


def is_empty(folder: Path) -> bool:
    return not any(folder.rglob("*"))


@pytest.mark.parametrize(
    ("origin", "type_"),
    [
        # A package that is not of the table, and a type that the table does not have.
        (Origin.EXTRA, InterfaceName("rover_msgs", "Park")),
        (Origin.EXTRA, InterfaceName("example_interfaces", "Int64")),
        # A sourced ROS has a package of it to install.
        (Origin.SOURCED, ADD),
    ],
)
def test_what_is_not_of_the_table_is_missing(
    origin: Origin,
    type_: InterfaceName,
    python: Callable[..., Path],
    environ: dict[str, str],
    tmp_path: Path,
) -> None:
    environment = Environment(origin, 2, "kilted", python())
    told: list[Progress] = []
    made, [found] = complete(
        environment, [type_], Catalog("kilted").table_package, told.append, environ
    )
    assert (made, told, found.code) == (environment, [], codes.MISSING_ROS_PACKAGE)
    assert is_empty(tmp_path / "cache")


def test_a_type_that_the_workspace_defines_is_not_made(tmp_path: Path) -> None:
    assert Catalog("kilted").table_package("example_interfaces")
    definition = tmp_path / "example_interfaces" / "srv" / "Other.srv"
    definition.parent.mkdir(parents=True)
    definition.write_text("---\n")
    (definition.parent.parent / "package.xml").write_text("<name>example_interfaces</name>")
    own = Catalog("kilted", [tmp_path])
    assert own.table_package("example_interfaces") is None
    assert own.table_package("mavros_msgs")
    assert own.table_package("std_msgs") is None


def test_what_is_there_is_not_made(python: Callable[..., Path], environ: dict[str, str]) -> None:
    environment = Environment(Origin.EXTRA, 2, "kilted", python("example_interfaces"))
    catalog = Catalog("kilted")
    assert complete(environment, [ADD], catalog.table_package, pytest.fail, environ) == (
        environment,
        [],
    )


@pytest.mark.parametrize(
    ("lacks", "remedy"),
    [
        ("c++", "install them with `sudo apt install g++`"),
        ("cmake", "install them with `sudo apt install cmake`"),
        ("Python.h", "install them with `sudo apt install python3-dev`"),
        ("ament_package", f"install it with `{installing.extra()}`"),
        ("colcon", f"install it with `{installing.extra()}`"),
    ],
)
def test_a_tool_that_is_missing_is_named(
    lacks: str, remedy: str, python: Callable[..., Path], environ: dict[str, str], tmp_path: Path
) -> None:
    script = python(BUILDERS.replace(lacks, ""))
    (tmp_path / "include" / lacks).unlink(missing_ok=True)
    (tmp_path / "bin" / lacks).unlink(missing_ok=True)
    environ["PATH"] = str(tmp_path / "bin")
    environment = Environment(Origin.EXTRA, 2, "kilted", script)
    catalog = Catalog("kilted")
    made, [found] = complete(environment, [ADD], catalog.table_package, pytest.fail, environ)
    assert (made, found.code, found.help) == (environment, codes.NOT_BUILT, remedy)
    assert is_empty(tmp_path / "cache")


@pytest.mark.parametrize("origin", [Origin.EXTRA, Origin.DEBIAN])
def test_a_build_that_fails_is_told_and_its_words_are_kept(
    origin: Origin, python: Callable[..., Path], environ: dict[str, str], tmp_path: Path
) -> None:
    type_, version, distribution = (
        (ADD, 2, "kilted") if origin is Origin.EXTRA else (ADD_ROS1, 1, "noetic")
    )
    environment = Environment(origin, version, distribution, python())
    catalog = Catalog(distribution)
    for _ in range(2):
        told: list[Progress] = []
        _, [found] = complete(environment, [type_], catalog.table_package, told.append, environ)
        assert found.code == codes.NOT_BUILT
        assert len(told) == 1
        [log] = (tmp_path / "cache").rglob("*.log")
        assert found.help == f"read what the build said in {log}"
        said = "no rule for --log-base" if origin is Origin.EXTRA else "no such type"
        assert said in log.read_text()


def test_a_cache_that_cannot_be_written_is_told(
    python: Callable[..., Path], environ: dict[str, str], tmp_path: Path
) -> None:
    (tmp_path / "cache").touch()
    environment = Environment(Origin.EXTRA, 2, "kilted", python())
    catalog = Catalog("kilted")
    _, [found] = complete(environment, [ADD], catalog.table_package, lambda _: None, environ)
    assert found.code == codes.NOT_BUILT
    assert str(tmp_path / "cache") in found.message
