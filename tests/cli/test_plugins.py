"""Targets that other distributions register, installed here as pip leaves them on the disk."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import Run

PROGRAM = """\
create_node 'talker' as talker{using}
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String
generate_node talker
"""
MODULE = """\
from pathlib import Path

from plastron_tui.model.source import FileSet, SourceUnit, SourceNode
from plastron_tui.sources.base import Language, ReadResult, Rendered
from plastron_tui.targets.base import Target


class Lisp(Language):
    name = "common-lisp"
    title = "Lisp"
    suffixes = (".lisp",)

    def read(self, path, files, library=None):
        name = files.main.split()[1].decode()
        return ReadResult(SourceUnit(path, files, "roslisp", (SourceNode(name, name, ()),)))


class RoslispTarget(Target):
    api_version = 4
    name = "roslisp"
    ros_version = {ros_version}
    language = Lisp()

    def __init__(self, template_folder=None):
        self.templates = template_folder

    def render(self, node, catalog):
        text = f";; {{node.name}} for ROS {{catalog.ros_version}}\\n"
        rendered = Rendered(FileSet.single(".lisp", text.encode()))
        return rendered
"""
NAMES = "'rospy', 'rclpy', 'roscpp', 'nodelet', 'rclcpp', 'component', 'roslisp'"


Plastron = Callable[..., "subprocess.CompletedProcess[str]"]


def install(site: Path, module: str, entry: str = "roslisp_target:RoslispTarget") -> None:
    site.mkdir()
    site.joinpath("roslisp_target.py").write_text(module)
    metadata = site / "plastron_roslisp-1.0.dist-info"
    metadata.mkdir()
    metadata.joinpath("METADATA").write_text("Metadata-Version: 2.1\nName: plastron-roslisp\n")
    metadata.joinpath("entry_points.txt").write_text(f"[plastron.targets]\nroslisp = {entry}\n")


@pytest.fixture
def plastron(run: Run) -> Plastron:
    """Run plastron in a folder, with what is installed beside the program."""

    def plastron(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
        done = run(*arguments, env={"PYTHONPATH": str(folder / "site")}, cwd=folder)
        out, err = done.stdout.decode(), done.stderr.decode()
        return subprocess.CompletedProcess(done.args, done.returncode, out, err)

    return plastron


def program(folder: Path, using: str = "") -> None:
    folder.joinpath("a.plastron").write_text(PROGRAM.format(using=using))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder that has the target beside it."""
    install(tmp_path / "site", MODULE.format(ros_version=1))
    return tmp_path


@pytest.mark.parametrize("where", ["using", "--target", "project file"])
@pytest.mark.parametrize("ros_version", [1, 2])
def test_a_registered_target_is_named_like_plastrons_own(
    tmp_path: Path, where: str, ros_version: int, plastron: Plastron
) -> None:
    install(tmp_path / "site", MODULE.format(ros_version=ros_version))
    program(tmp_path, " using roslisp" if where == "using" else "")
    if where == "project file":
        tmp_path.joinpath("plastron.yaml").write_text("target: roslisp\n")
    options = ["--target", "roslisp"] if where == "--target" else []
    result = plastron(tmp_path, "generate", "a.plastron", *options)
    assert (result.stderr, result.returncode) == ("", 0)
    written = tmp_path / "output" / "talker_pub.lisp"
    assert written.read_text() == f";; talker for ROS {ros_version}\n"


def test_a_file_that_is_no_python_is_not_run(folder: Path, plastron: Plastron) -> None:
    program(folder, " using roslisp")
    result = plastron(folder, "run", "a.plastron")
    assert result.returncode == 1
    assert "`run` cannot start Lisp nodes, such as `talker_pub.lisp`" in result.stderr
    assert not folder.joinpath("output").exists()


def test_a_registered_target_reads_the_files_that_plastron_cannot(
    folder: Path, plastron: Plastron
) -> None:
    folder.joinpath("driver.lisp").write_text(";; driver\n")
    result = plastron(folder, "inspect", "driver.lisp")
    assert (result.stderr, result.returncode) == ("", 0)
    assert "driver" in result.stdout
    assert "roslisp" in result.stdout


def test_a_registered_target_is_listed_where_a_name_is_wrong(
    folder: Path, plastron: Plastron
) -> None:
    program(folder, " using elisp")
    result = plastron(folder, "check", "a.plastron")
    assert result.returncode == 1
    assert "did you mean `roslisp`?" in result.stderr
    result = plastron(folder, "check", "a.plastron", "--target", "elisp")
    assert (result.returncode, f"'elisp' is not one of {NAMES}" in result.stderr) == (2, True)
    folder.joinpath("plastron.yaml").write_text("target: elisp\n")
    assert "did you mean `roslisp`?" in plastron(folder, "check", "a.plastron").stderr


@pytest.mark.parametrize(
    ("module", "entry", "reason"),
    [
        ("import no_such_module", "roslisp_target:RoslispTarget", "ModuleNotFoundError"),
        ("RoslispTarget = 5", "roslisp_target:RoslispTarget", "is no class of a target"),
        (
            MODULE.format(ros_version=1).replace("    api_version = 4\n", ""),
            "roslisp_target:RoslispTarget",
            "is for version 1 of the interface of targets, and this Plastron has version 4",
        ),
        (
            MODULE.format(ros_version=1).replace("    language = Lisp()\n", ""),
            "roslisp_target:RoslispTarget",
            "the `language` of `roslisp_target:RoslispTarget` is none",
        ),
        (
            MODULE.format(ros_version=1).replace('(".lisp",)', '".lisp"'),
            "roslisp_target:RoslispTarget",
            "has no `title`, or no tuple of `suffixes`",
        ),
        (MODULE.format(ros_version=3), "roslisp_target:RoslispTarget", "neither 1 nor 2"),
        (MODULE.format(ros_version=1), "roslisp_target:NoSuchTarget", "AttributeError"),
        ("import sys; sys.exit(3)", "roslisp_target:RoslispTarget", "SystemExit: 3"),
        (
            MODULE.format(ros_version=1).replace(", template_folder=None", ""),
            "roslisp_target:RoslispTarget",
            "TypeError",
        ),
        (
            MODULE.format(ros_version=1).replace('"roslisp"', '"roseus"'),
            "roslisp_target:RoslispTarget",
            "is another",
        ),
    ],
)
def test_a_target_that_cannot_be_loaded_is_a_diagnostic(
    tmp_path: Path, module: str, entry: str, reason: str, plastron: Plastron
) -> None:
    install(tmp_path / "site", module, entry)
    program(tmp_path, " using roslisp")
    result = plastron(tmp_path, "generate", "a.plastron")
    assert result.returncode == 1
    assert "error[unsupported-target]: the target `roslisp` cannot be used" in result.stderr
    assert reason in result.stderr


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        (
            "return rendered",
            "raise KeyError('broken')",
            "KeyError: 'broken'",
        ),
        (
            "return rendered",
            "raise SystemExit(1)",
            "SystemExit: 1",
        ),
        (
            "return rendered",
            "pass",
            "it gives a NoneType, and no Rendered",
        ),
        ("text.encode()", "text", "the text that it gives is no bytes"),
    ],
)
def test_a_target_that_fails_is_a_diagnostic(
    tmp_path: Path, old: str, new: str, reason: str, plastron: Plastron
) -> None:
    install(tmp_path / "site", MODULE.format(ros_version=1).replace(old, new))
    program(tmp_path, " using roslisp")
    result = plastron(tmp_path, "generate", "a.plastron")
    assert result.returncode == 1
    assert f"error[unsupported-target]: the target `roslisp` failed: {reason}" in result.stderr


def test_a_target_that_fails_keeps_no_file_of_others_from_being_read(
    tmp_path: Path, plastron: Plastron
) -> None:
    module = MODULE.format(ros_version=1).replace('".lisp"', '".py"')
    install(
        tmp_path / "site", module.replace("name = files", "raise ValueError\n        name = files")
    )
    tmp_path.joinpath("driver.py").write_text("print('no node')\n")
    result = plastron(tmp_path, "inspect", "driver.py")
    assert "error[no-node]: the file imports neither rospy nor rclpy" in result.stderr


def test_plastrons_own_names_look_up_no_entry_points(tmp_path: Path) -> None:
    code = (
        "import sys\n"
        "from plastron_tui.targets import LIBRARIES, find_target, has_target\n"
        "assert LIBRARIES['rclpy'].ros_version == 2\n"
        "assert 'roscpp' in LIBRARIES and has_target('rospy')\n"
        "assert find_target('rospy') is not None\n"
        "sys.exit('plastron_tui.targets.plugins' in sys.modules)\n"
    )
    assert subprocess.run([sys.executable, "-c", code], cwd=tmp_path).returncode == 0
