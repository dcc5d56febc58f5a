"""What the ROS of a machine has, by its folders, and what is told of types that it lacks."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.project import configuration
from plastron_tui.ros.installations import Installation, Origin
from plastron_tui.ros.installed_packages import InstalledPackages, installed_packages
from plastron_tui.session import Options, Session
from plastron_tui.studio.editor.candidate import Candidate
from plastron_tui.studio.editor.completion import detail_of
from plastron_tui.studio.editor.vocabulary import Vocabulary

PROGRAM = b"create_node 'a' as a\nsubscribe a to 'odom' of message_type Odometry\n"


@pytest.fixture
def environ(tmp_path: Path) -> dict[str, str]:
    """Return the variables of a sourced ROS 2 that has nothing but std_msgs."""
    prefix = tmp_path / "ros"
    (prefix / "share" / "std_msgs").mkdir(parents=True)
    return {"ROS_VERSION": "2", "ROS_DISTRO": "kilted", "AMENT_PREFIX_PATH": str(prefix)}


def test_a_sourced_ros_is_known_by_its_folders(environ: dict[str, str], tmp_path: Path) -> None:
    found = installed_packages(2, environ, (), tmp_path)
    assert found is not None and found.installation.origin is Origin.SOURCED
    assert found.has("std_msgs") and not found.has("nav_msgs")
    (tmp_path / "python" / "nav_msgs").mkdir(parents=True)
    more = environ | {"PYTHONPATH": str(tmp_path / "python")}
    found = installed_packages(2, more, (), tmp_path)
    assert found is not None and found.has("nav_msgs")


def test_nothing_is_known_of_a_ros_whose_messages_are_not_found(tmp_path: Path) -> None:
    environ = {"ROS_VERSION": "1", "ROS_PACKAGE_PATH": str(tmp_path)}
    assert installed_packages(1, environ, (), tmp_path) is None


def test_a_session_tells_of_it_where_somebody_wants_to_know(
    environ: dict[str, str], tmp_path: Path
) -> None:
    file = tmp_path / "work" / "a.plastron"
    quiet = Session(PROGRAM, file, environ=environ)
    assert "missing-ros-package" not in [each.code for each in quiet.diagnostics]
    session = Session(PROGRAM, file, Options(tells_absent=True), environ)
    (found,) = [each for each in session.diagnostics if each.code == "missing-ros-package"]
    assert found.message == "`nav_msgs` is not installed in ROS 2 kilted (sourced)"
    assert found.help == "install it with `sudo apt install ros-kilted-nav-msgs`"
    assert found.span is not None and PROGRAM[slice(*found.span)] == b"Odometry"


def lacking(text: str, file: Path, environ: dict[str, str]) -> list[str]:
    """Return the warnings of packages that are not installed."""
    session = Session(text.encode(), file, Options("rclpy", tells_absent=True), environ)
    found = session.diagnostics
    return [each.message for each in found if each.code == "missing-ros-package"]


def test_a_package_of_the_projects_own_types_need_not_be_installed(
    environ: dict[str, str], tmp_path: Path
) -> None:
    own = tmp_path / "mine_msgs" / "msg"
    own.mkdir(parents=True)
    (own / "Mark.msg").write_text("float64 x\n")
    text = "create_node 'a' as a\nsubscribe a to 'm' of message_type mine_msgs/Mark\n"
    assert lacking(text, tmp_path / "a.plastron", environ) == []


@pytest.mark.parametrize("origin", [Origin.EXTRA, Origin.SOURCED])
def test_a_package_of_the_languages_table_is_built_where_no_ros_is_sourced(
    origin: Origin, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    nothing = InstalledPackages(Installation(origin, 2, "kilted"), ())
    monkeypatch.setattr(configuration, "installed_packages", lambda *_: nothing)
    text = (
        "create_node 'a' as a\n"
        "a provides_service 'add' of service_type example_interfaces/AddTwoInts\n"
        "subscribe a to 'odom' of message_type Odometry\n"
    )
    packages = [words.split("`")[1] for words in lacking(text, tmp_path / "a.plastron", {})]
    built = [] if origin is Origin.EXTRA else ["example_interfaces"]
    assert packages == [*built, "nav_msgs"]


def test_completion_says_so_beside_the_type(environ: dict[str, str], tmp_path: Path) -> None:
    from plastron_tui.language.expectations import expected_at

    file = tmp_path / "work" / "a.plastron"
    session = Session(PROGRAM, file, Options(tells_absent=True), environ)
    expected = expected_at(session.document, len(PROGRAM) - 1)
    names = Vocabulary(session.program, session.workspace)
    said = {
        text: detail_of(Candidate(text), expected, names, session) for text in ("Odometry", "Bool")
    }
    assert said["Odometry"].startswith("not installed here; header: ")
    assert said["Bool"] == "data: bool"
