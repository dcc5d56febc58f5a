"""Builds in the user's cache: when one is started, what it starts from, and what it leaves."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import threading
from dataclasses import replace
from pathlib import Path

import pytest
from machine import mostly_long, wait_until
from supervised import all_gone

from plastron_tui.diagnostics import Span, codes
from plastron_tui.ros.installations import Origin
from plastron_tui.runtime import builds
from plastron_tui.runtime.build_output import Progress
from plastron_tui.runtime.builds import BuiltPackage, overlay
from plastron_tui.runtime.environment import Environment

SOURCED = Environment(Origin.SOURCED, 2, "kilted", Path(sys.executable))
FILES = {"package.xml": b"<package/>", "msg/Level.msg": b"float64 value\n"}

# Installs the sources, and what was there before a build, as a file whose time it is.
COLCON = """\
#!/bin/sh
echo started >> "$CALLS"
echo "Starting >>> demo"
echo "[ 50%] Generating"
mkdir -p install/python build
rm -rf install/python/demo
cp -Rp src/demo install/python/demo
if [ -e build/object ]; then touch install/python/demo/was_incremental; fi
touch build/object
"""


@pytest.fixture
def environ(tmp_path: Path) -> dict[str, str]:
    """The environment of a sourced ROS whose tools are fakes."""
    tools = tmp_path / "bin"
    tools.mkdir()
    for name in ("cmake", "make", "c++", "colcon"):
        (tools / name).write_text(COLCON if name == "colcon" else "#!/bin/sh\n")
        (tools / name).chmod(0o755)
    return {
        "PATH": f"{tools}:/usr/bin:/bin",
        "XDG_CACHE_HOME": str(tmp_path / "cache"),
        "CALLS": str(tmp_path / "calls"),
    }


def calls(environ: dict[str, str]) -> int:
    file = Path(environ["CALLS"])
    return file.read_text().count("started") if file.exists() else 0


def write_colcon(environ: dict[str, str], text: str) -> None:
    write_tool(environ, "colcon", text)


def write_tool(environ: dict[str, str], name: str, text: str) -> None:
    file = Path(environ["PATH"].partition(":")[0]) / name
    file.write_text(text)
    file.chmod(0o755)


def build(environ: dict[str, str], **files: bytes) -> Path:
    changed = {f"msg/{name}.msg": text for name, text in files.items()}
    made, found = overlay(SOURCED, [BuiltPackage("demo", FILES | changed)], lambda _: None, environ)
    assert not found
    [folder] = made.overlays
    return folder / "python" / "demo"


def test_nothing_is_built_where_nothing_is_to_be(environ: dict[str, str]) -> None:
    assert overlay(SOURCED, [], pytest.fail, environ) == (SOURCED, [])
    assert calls(environ) == 0


def test_what_is_unchanged_starts_no_build(environ: dict[str, str]) -> None:
    told: list[Progress] = []
    packages = [BuiltPackage("demo", FILES, frozenset({"package.xml"}))]
    made, _ = overlay(SOURCED, packages, told.append, environ)
    assert told == [
        Progress("demo", "configure"),
        Progress("demo", "build", 50),
    ]
    [folder] = made.overlays
    assert os.access(folder / "python" / "demo" / "package.xml", os.X_OK)
    assert overlay(SOURCED, packages, pytest.fail, environ) == (made, [])
    assert calls(environ) == 1


def test_a_change_builds_in_the_same_workspace(environ: dict[str, str]) -> None:
    first = build(environ, Speed=b"float64 x\n")
    second = build(environ, Speed=b"float64 y\n")
    assert (second / "was_incremental").exists()
    assert not (first / "was_incremental").exists()
    assert (first / "msg/Speed.msg").read_bytes() == b"float64 x\n"
    assert (second / "msg/Speed.msg").read_bytes() == b"float64 y\n"
    times = [(each / "msg/Level.msg").stat().st_mtime_ns for each in (first, second)]
    assert times[0] == times[1]
    assert not (build(environ) / "msg/Speed.msg").exists()
    # All three are kept.
    assert build(environ, Speed=b"float64 x\n") == first
    assert calls(environ) == 3


def test_what_was_made_of_a_file_that_is_gone_is_not_built_upon(environ: dict[str, str]) -> None:
    build(environ, Speed=b"float64 x\n")
    assert not (build(environ) / "was_incremental").exists()
    assert (build(environ, Axle=b"float64 x\n") / "was_incremental").exists()


def test_what_the_user_has_set_for_builds_of_his_own_does_not_count(
    environ: dict[str, str],
) -> None:
    said = '#!/bin/sh\nmkdir -p install/python/demo\necho "$DESTDIR-$CMAKE_GENERATOR" > {}\n'
    write_colcon(environ, said.format("install/python/demo/said"))
    folder = build({**environ, "DESTDIR": "/elsewhere", "CMAKE_GENERATOR": "Ninja"})
    assert (folder / "said").read_text() == "-Unix Makefiles\n"


def test_a_workspace_is_not_removed_while_it_is_built_in(
    environ: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(builds, "MOST_WORKSPACES", 0)
    folder = Path(environ["XDG_CACHE_HOME"]) / "plastron" / "builds" / "workspaces"
    other = folder / "other"
    other.mkdir(parents=True)
    with builds._locked(other, pytest.fail):
        build(environ)
        assert other.is_dir()
    [first] = [each for each in folder.iterdir() if each != other]
    build({**environ, "AMENT_PREFIX_PATH": "/opt/other"})
    assert not other.exists()
    assert not first.exists()


def test_who_waits_for_a_workspace_that_is_removed_makes_it_anew(tmp_path: Path) -> None:
    folder = tmp_path / "workspace"
    waits = threading.Event()
    entered: list[bool] = []

    def wait() -> None:
        with builds._locked(folder, waits.set):
            entered.append((folder / "lock").exists())

    with builds._locked(folder, pytest.fail):
        waiting = threading.Thread(target=wait)
        waiting.start()
        assert waits.wait(10)
        shutil.rmtree(folder)
    waiting.join(10)
    assert entered == [True]


def test_each_ros_has_its_own(environ: dict[str, str]) -> None:
    first = build(environ)
    assert build({**environ, "AMENT_PREFIX_PATH": "/opt/other"}) != first
    assert calls(environ) == 2


@pytest.mark.parametrize(
    "changed",
    [
        "share/base_msgs/msg/Base.msg",
        "share/std_msgs/msg/Header.msg",
        "share/rosidl_generator_c/package.xml",
        "lib/libbase_msgs__rosidl_generator_c.so",
        "bin/python3",
    ],
)
@pytest.mark.parametrize(
    "variable",
    mostly_long(["AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", ""], ["AMENT_PREFIX_PATH"]),
)
def test_what_packages_are_built_upon_counts(
    variable: str, changed: str, environ: dict[str, str], tmp_path: Path
) -> None:
    prefix = tmp_path / "prefix"
    for name, text in {
        "share/base_msgs/msg/Base.msg": "std_msgs/Header header\n",
        "share/std_msgs/msg/Header.msg": "string frame_id\n",
        "share/other_msgs/msg/Other.msg": "string other\n",
        "share/rosidl_generator_c/package.xml": "<version>1.0.0</version>\n",
        "lib/libbase_msgs__rosidl_generator_c.so": "string changes\n",
        "bin/python3": "string changes\n",
    }.items():
        (prefix / name).parent.mkdir(parents=True, exist_ok=True)
        (prefix / name).write_text(text)
    package = BuiltPackage("demo", {"msg/Level.msg": b"base_msgs/Base base\n"})
    environment = replace(
        SOURCED,
        python=prefix / "bin" / "python3",
        overlays=() if variable else (prefix,),
    )
    environ |= {variable: str(prefix)} if variable else {}

    def made() -> Path:
        return overlay(environment, [package], lambda _: None, environ)[0].overlays[-1]

    first = made()
    (prefix / "share/other_msgs/msg/Other.msg").write_text("string others\n")
    assert made() == first
    (prefix / changed).write_text("string changed\n")
    assert made() != first
    assert calls(environ) == 2


def test_definitions_among_the_sources_of_catkin_count(
    environ: dict[str, str], tmp_path: Path
) -> None:
    source = tmp_path / "src" / "group" / "base_msgs"
    (source / "msg").mkdir(parents=True)
    (source / "package.xml").write_text("<package><name>base_msgs</name></package>")
    environ["ROS_PACKAGE_PATH"] = str(tmp_path / "src")
    package = BuiltPackage("demo", {"msg/Level.msg": b"base_msgs/Base base\n"})
    ros = Environment(Origin.SOURCED, 1, "noetic", Path(sys.executable))
    made = []
    write_tool(environ, "catkin_make", COLCON)
    for text in ("float64 a\n", "float64 b\n"):
        (source / "msg" / "Base.msg").write_text(text)
        made.append(overlay(ros, [package], lambda _: None, environ)[0].overlays)
    assert made[0] != made[1]


@pytest.mark.parametrize("name", ["CC", "CXX", "CFLAGS", "CXXFLAGS", "LDFLAGS"])
def test_what_is_set_for_compilers_counts(name: str, environ: dict[str, str]) -> None:
    assert build({**environ, name: "-O2"}) != build(environ)


@pytest.mark.parametrize("name", ["c++", "cmake", "colcon"])
def test_tools_count_and_no_other_part_of_the_path_does(
    name: str, environ: dict[str, str], tmp_path: Path
) -> None:
    first = build(environ)
    assert build({**environ, "PATH": f"{tmp_path}:{environ['PATH']}"}) == first
    other = tmp_path / "other"
    other.mkdir()
    shutil.copy2(Path(environ["PATH"].partition(":")[0], name), other)
    assert build({**environ, "PATH": f"{other}:{environ['PATH']}"}) != first


def test_what_can_be_started_counts(environ: dict[str, str]) -> None:
    both = [
        overlay(SOURCED, [BuiltPackage("demo", FILES, each)], lambda _: None, environ)[0].overlays
        for each in (frozenset(), frozenset({"package.xml"}))
    ]
    assert both[0] != both[1]


def test_overlays_count_by_their_place(environ: dict[str, str], tmp_path: Path) -> None:
    both = [
        overlay(each, [BuiltPackage("demo", FILES)], lambda _: None, environ)[0].overlays[-1]
        for each in (SOURCED, replace(SOURCED, overlays=(tmp_path,)))
    ]
    assert both[0] != both[1]


def test_a_failure_is_told_at_the_statement_and_built_again(environ: dict[str, str]) -> None:
    said = "$PWD/src/demo/a.cpp:2:1: error: no such thing"
    write_colcon(environ, f'#!/bin/sh\necho "{said}"\nexit 1\n')
    package = BuiltPackage("demo", FILES, spans={"a.cpp": {0: Span(0, 4), 2: Span(4, 8)}})
    made, [found] = overlay(SOURCED, [package], lambda _: None, environ)
    assert (made, found.code, found.span) == (SOURCED, codes.NOT_BUILT, Span(4, 8))
    assert found.message == "`demo/a.cpp:2` could not be built: no such thing"
    [log] = Path(environ["XDG_CACHE_HOME"]).rglob("build.log")
    assert found.help == f"read what the build said in {log}"
    write_colcon(environ, COLCON)
    assert build(environ).is_dir()


def test_what_a_killed_build_left_is_not_built_upon(environ: dict[str, str]) -> None:
    build(environ)
    [lock] = Path(environ["XDG_CACHE_HOME"]).rglob("lock")
    (lock.parent / "unfinished").touch()
    assert not (build(environ, Speed=b"float64 x\n") / "was_incremental").exists()
    assert (build(environ, Speed=b"float64 y\n") / "was_incremental").exists()


def test_a_workspace_that_was_moved_is_made_anew(environ: dict[str, str], tmp_path: Path) -> None:
    build(environ, Speed=b"float64 x\n")
    (tmp_path / "cache").rename(tmp_path / "moved")
    environ["XDG_CACHE_HOME"] = str(tmp_path / "moved")
    assert (build(environ, Speed=b"float64 y\n") / "was_incremental").exists() is False
    assert (build(environ, Speed=b"float64 z\n") / "was_incremental").exists()


def test_two_runs_at_once_build_once(environ: dict[str, str]) -> None:
    made: list[Path] = []
    runs = [threading.Thread(target=lambda: made.append(build(environ))) for _ in range(3)]
    for each in runs:
        each.start()
    for each in runs:
        each.join()
    assert len(made) == 3
    assert len(set(made)) == calls(environ) == 1


def test_cache_is_bounded(environ: dict[str, str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(builds, "MOST_OVERLAYS", 2)
    made = []
    for number in range(4):
        made.append(build(environ, Speed=b"float64 x%d\n" % number))
        os.utime(made[-1].parents[1], ns=(number * 10**9, number * 10**9))
    assert [each.exists() for each in made] == [False, False, True, True]


def test_what_is_used_is_not_forgotten(
    environ: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(builds, "MOST_OVERLAYS", 2)
    first, second = build(environ), build(environ, Speed=b"float64 x\n")
    for each in (first, second):
        os.utime(each.parents[1], ns=(0, 0))
    assert build(environ) == first
    build(environ, Speed=b"float64 y\n")
    assert (first.exists(), second.exists()) == (True, False)


def test_a_full_disk_is_told_whatever_a_tool_makes_of_it(environ: dict[str, str]) -> None:
    write_colcon(environ, "#!/bin/sh\necho 'write(): No space left on device'\nexit 2\n")
    _, [found] = overlay(SOURCED, [BuiltPackage("demo", FILES)], lambda _: None, environ)
    place = f"{environ['XDG_CACHE_HOME']}/plastron"
    assert found.message == f"`demo` could not be built in {place}: no space left on device"
    assert found.help is not None and found.help.startswith("free some space there")


def test_cache_that_cannot_be_written_is_told(environ: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "cache").touch()
    _, [found] = overlay(SOURCED, [BuiltPackage("demo", FILES)], lambda _: None, environ)
    assert found.code == codes.NOT_BUILT
    assert str(tmp_path / "cache") in found.message


DRIVER = """
import sys
from pathlib import Path
from plastron_tui.ros.installations import Origin
from plastron_tui.runtime.builds import BuiltPackage, overlay
from plastron_tui.runtime.environment import Environment
environment = Environment(Origin.SOURCED, 2, "kilted", Path(sys.executable))
overlay(environment, [BuiltPackage("demo", {"package.xml": b""})], print)
"""


@pytest.mark.parametrize("signum", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_a_build_that_is_ended_leaves_no_process(
    signum: signal.Signals, environ: dict[str, str]
) -> None:
    pids = Path(environ["CALLS"])
    write_colcon(environ, '#!/bin/sh\nsleep 600 &\necho "$$ $! ." > "$CALLS"\nwait\n')
    with subprocess.Popen(
        [sys.executable, "-c", DRIVER], env=environ, stderr=subprocess.DEVNULL
    ) as run:
        wait_until(lambda: pids.exists() and "." in pids.read_text(), "the build runs", 30)
        run.send_signal(signum)
        assert run.wait(30) == -signum
    built = [int(each) for each in pids.read_text().split()[:2]]
    all_gone(*built)
    # It does not count as done, and what it left is not built upon.
    assert not any((Path(environ["XDG_CACHE_HOME"]) / "plastron/builds/overlays").iterdir())
    pids.unlink()
    write_colcon(environ, COLCON)
    assert build(environ).is_dir()


def test_a_build_that_is_interrupted_in_the_background_is_not_told_as_failed(
    environ: dict[str, str],
) -> None:
    write_colcon(environ, '#!/bin/sh\necho started > "$CALLS"\nexec sleep 600\n')
    command = [sys.executable, "-c", DRIVER]
    # A shell that starts a process in the background lets it ignore what Ctrl-C sends.
    ignoring = ["/bin/sh", "-c", 'trap "" INT; exec "$@"', "sh", *command]
    with subprocess.Popen(ignoring, env=environ, stderr=subprocess.PIPE, text=True) as run:
        wait_until(lambda: calls(environ) == 1, "the build runs", 30)
        run.send_signal(signal.SIGINT)
        _, said = run.communicate(timeout=30)
    assert run.returncode != 0
    assert said.rstrip().endswith("KeyboardInterrupt")
    assert list(Path(environ["XDG_CACHE_HOME"]).rglob("unfinished"))
