"""A loaded package in the output folder: whole, so that it is built from there."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from loaded_packages import AMENT_PYTHON, IN, KINDS, OUT, TALKER, lay, run, texts

from plastron_tui.project import package_copy

NOTHING = f"{TALKER}generate_package demo\n"
BINARY = bytes(range(256)) * 8


def package(folder: Path) -> Path:
    """Lay a package with files of every sort."""
    made = lay(folder, AMENT_PYTHON)
    (folder / ".git").mkdir()
    lay(folder, {"meshes/wheel.stl": BINARY, "resource/demo": b"", "demo/log/__init__.py": b""})
    lay(folder, {"scripts/go.sh": b"#!/bin/sh\r\n", "config/a.yaml": b"\xef\xbb\xbfa: 1\r\n"})
    lay(folder, {"worlds/.a.wbproj": b"Webots"})
    (made / "scripts/go.sh").chmod(0o755)
    (made / "setup.py").chmod(0o755)
    return made


def lay_others(made: Path) -> None:
    """Lay beside the files what is no part of a package."""
    for name in (
        *(
            ".git/config",
            ".gitignore",
            ".plastron-1.new",
            ".vscode/a.json",
            "build/lib/x.py",
            "install/x",
            "log/x",
        ),
        *("demo/__pycache__/a.pyc", "inner/package.xml", "inner/a.py"),
    ):
        (made / name).parent.mkdir(parents=True, exist_ok=True)
        (made / name).write_bytes(b"no")


def test_output_has_what_the_package_has(tmp_path: Path) -> None:
    made = package(tmp_path)
    before = texts(made)
    lay_others(made)
    assert run(IN, tmp_path, "rclpy") == ()
    output = tmp_path / "output/demo"
    after = texts(output)
    assert set(after) == {*before, "demo/talker.py"}
    assert {each for each in before if after[each] != before[each]} == {"setup.py", "package.xml"}
    for name in before:
        assert os.access(output / name, os.X_OK) == os.access(made / name, os.X_OK), name
    assert run(IN, tmp_path, "rclpy") == ()
    assert texts(output) == after


@pytest.mark.parametrize("kind", KINDS)
def test_a_package_is_copied_that_nothing_is_changed_of(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    made = lay(tmp_path, files)
    assert run(NOTHING, tmp_path, library) == ()
    assert texts(tmp_path / "output/demo") == texts(made)


def test_links_become_what_they_lead_to_within_the_project(tmp_path: Path) -> None:
    project = tmp_path / "project"
    made = package(project)
    (tmp_path / "secret").mkdir()
    (tmp_path / "secret/key").write_text("secret")
    lay(project, {"near.yaml": b"near", "deep/far.yaml": b"far"}, "shared")
    for name, to in {
        "config/near.yaml": project / "shared/near.yaml",
        "shared": project / "shared",
        "again": made,
        "demo/up": project,
        "nowhere": project / "nothing",
        "key": tmp_path / "secret/key",
        "secret": tmp_path / "secret",
    }.items():
        (made / name).symlink_to(to)
    os.mkfifo(made / "pipe")
    told = run(NOTHING, project, "rclpy")
    output = project / "output/demo"
    after = texts(output)
    assert [each.code for each in told] == ["not-copied"]
    assert "`again`, `demo/up`, `key` and 3 more" in told[0].message
    assert after["config/near.yaml"] == after["shared/near.yaml"] == b"near"
    assert after["shared/deep/far.yaml"] == b"far"
    assert not any(b"secret" in each for each in after.values())
    assert not any(each.is_symlink() for each in output.rglob("*"))


def test_an_output_folder_in_the_package_is_no_part_of_it(tmp_path: Path) -> None:
    made = lay(tmp_path, AMENT_PYTHON)
    program = IN.replace("'demo' as", "'.' as")
    for _ in range(2):
        assert run(program, made, "rclpy") == ()
    assert set(texts(made / "output")) == {f"demo/{each}" for each in AMENT_PYTHON} | {
        "demo/demo/talker.py"
    }


def test_a_package_in_the_output_folder_is_changed_there(tmp_path: Path) -> None:
    made = lay(tmp_path / "output", AMENT_PYTHON)
    assert run(IN.replace("'demo' as", "'output/demo' as"), tmp_path, "rclpy") == ()
    assert set(texts(made)) == {*AMENT_PYTHON, "demo/talker.py"}
    assert not (tmp_path / "output/demo/output").exists()


@pytest.mark.parametrize(
    ("limit", "value"), [("MOST_FILES", 5), ("MOST_BYTES", 2_000), ("_MOST_NAMES", 4)]
)
def test_what_is_too_large_is_told(
    limit: str, value: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = package(tmp_path)
    monkeypatch.setattr(package_copy, limit, value)
    [told] = run(IN, tmp_path, "rclpy")
    assert (told.code, told.severity.value) == ("not-copied", "warning")
    assert "too large" in told.message
    output = set(texts(tmp_path / "output/demo"))
    assert output == {"demo/talker.py", "setup.py", "package.xml"}
    assert run(IN, tmp_path, "rclpy", in_place=True) == ()
    assert "demo/talker.py" in texts(made)


def test_handwork_in_a_copy_is_kept(tmp_path: Path) -> None:
    made = package(tmp_path)
    run(IN, tmp_path, "rclpy")
    copy = tmp_path / "output/demo/config/a.yaml"
    copy.write_text("mine")
    for _ in range(2):
        assert run(IN, tmp_path, "rclpy") == ()
        assert copy.read_text() == "mine"
    (made / "config/a.yaml").write_text("theirs")
    [told] = run(IN, tmp_path, "rclpy")
    assert told.code == "file-conflict"
    assert copy.read_text() == "mine"


def test_a_copy_follows_the_package(tmp_path: Path) -> None:
    made = package(tmp_path)
    run(IN, tmp_path, "rclpy")
    (made / "config/a.yaml").write_text("theirs")
    assert run(IN, tmp_path, "rclpy") == ()
    assert (tmp_path / "output/demo/config/a.yaml").read_text() == "theirs"
    (made / "config/a.yaml").unlink()
    [told] = run(IN, tmp_path, "rclpy")
    assert (told.code, "demo/config/a.yaml" in told.message) == ("file-stays", True)


def test_a_file_that_is_there_already_is_not_written_over(tmp_path: Path) -> None:
    package(tmp_path)
    lay(tmp_path / "output", {"config/a.yaml": b"mine"})
    before = texts(tmp_path)
    [told] = run(IN, tmp_path, "rclpy")
    assert told.code == "file-conflict"
    assert texts(tmp_path) == before


def test_what_cannot_be_read_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made = package(tmp_path)
    deep = made / "/".join(["a"] * 200)
    deep.mkdir(parents=True)
    (deep / "x").write_text("deep")

    def read(path: Path, limit: int) -> bytes:
        if path.suffix == ".stl":
            raise PermissionError(13, "Permission denied", os.fspath(path))
        return path.read_bytes()

    monkeypatch.setattr(package_copy, "read_regular", read)
    [told] = run(IN, tmp_path, "rclpy")
    assert (told.code, told.severity.value) == ("not-copied", "warning")
    assert "`meshes/wheel.stl`" in told.message
    assert "`a/a/a" in told.message
    assert set(texts(made)) - set(texts(tmp_path / "output/demo")) == {
        "meshes/wheel.stl",
        f"{'a/' * 200}x",
    }


def test_what_was_put_in_place_is_copied_too(tmp_path: Path) -> None:
    made = package(tmp_path)
    run(IN, tmp_path, "rclpy", in_place=True)
    assert run(IN, tmp_path, "rclpy") == ()
    assert texts(tmp_path / "output/demo") == texts(made)
    assert [each.code for each in run(OUT, tmp_path, "rclpy")] == ["file-stays"]
    assert b"talker" not in texts(tmp_path / "output/demo")["setup.py"]


_LISTENER = """\
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('listener')
node.create_subscription(String, 'chatter', print, 10)
rclpy.spin(node)
"""
_LAUNCH = '<launch>\n  <node pkg="demo" exec="listener"/>\n</launch>\n'
ALONE = """\
load 'demo/demo/listener.py' as ears
subscribe ears to 'other' of message_type String
generate_node ears
load_type 'demo/msg/A.msg' as A
A has_field "int32 y"
generate_type A
load_launch 'demo/launch/b.launch.xml' as b
b starts 'other/ear'
generate_launch b
load_package 'demo' as demo
generate_package demo
"""


def test_the_copy_has_what_becomes_of_files_that_are_loaded_alone(tmp_path: Path) -> None:
    package(tmp_path)
    lay(tmp_path, {"demo/listener.py": _LISTENER, "msg/A.msg": "int32 x\n"})
    lay(tmp_path, {"launch/b.launch.xml": _LAUNCH})
    for _ in range(2):
        assert run(ALONE, tmp_path, "rclpy") == ()
        made, before = texts(tmp_path / "output"), texts(tmp_path / "demo")
        for file, alone in {
            "demo/listener.py": "listener.py",
            "launch/b.launch.xml": "b.launch.xml",
            "msg/A.msg": "demo/msg/A.msg",
        }.items():
            assert made[f"demo/{file}"] == made[alone] != before[file], file


@pytest.fixture
def deep(tmp_path: Path) -> Iterator[Path]:
    """Lay a package of folders in each other, more than what calls itself gets through."""
    made = package(tmp_path)
    here = Path.cwd()
    os.chdir(made)
    for _ in range(1_200):
        Path("a").mkdir()
        os.chdir("a")
    os.chdir(here)
    yield made
    # Nor would pytest, which removes folders by what calls itself.
    subprocess.run(["rm", "-rf", made / "a"], check=True)


@pytest.mark.parametrize("in_place", [False, True])
def test_folders_may_be_in_many_others(in_place: bool, deep: Path, tmp_path: Path) -> None:
    told = run(IN, tmp_path, "rclpy", in_place=in_place)
    assert [each.code for each in told] == ([] if in_place else ["not-copied"])
    output = deep if in_place else tmp_path / "output/demo"
    assert (output / "demo/talker.py").is_file()
    assert (output / "config/a.yaml").is_file()


def test_a_copy_is_no_rest_of_an_earlier_run_when_the_package_is_changed_itself(
    tmp_path: Path,
) -> None:
    package(tmp_path)
    for in_place in (False, True, False):
        assert run(IN, tmp_path, "rclpy", in_place=in_place) == ()
