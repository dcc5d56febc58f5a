"""A folder full of files that are named like modules: none of them is ever imported."""

from __future__ import annotations

import asyncio
import os
import re
import subprocess
import sys
import threading
from collections.abc import Callable, Iterable
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest
from command_line import TALKER
from machine import find_ros, free_port, graph_environ, wait_until

from plastron_tui import import_path
from plastron_tui.runtime import guard
from plastron_tui.session import Options

SCRIPT = [sys.executable, str(Path(sys.executable).with_name("plastron"))]
MODULE = [sys.executable, "-m", "plastron_tui"]
OTHERS = {"rospy", "rosmaster", "rosgraph", "rclpy", "sitecustomize", "usercustomize"}

TRAP = """\
import sys
with open({marker!r}, "a") as file:
    print({name!r}, "in", sys.argv, file=file)
"""


def loaded_by(code: str) -> set[str]:
    """Return the modules that a Python has loaded before anything of Plastron's."""
    command = [sys.executable, "-c", f"{code}; import sys; print(*sys.modules)"]
    return set(subprocess.run(command, capture_output=True, check=True, text=True).stdout.split())


def set_trap(folder: Path, name: str) -> None:
    """Write a file that tells when it is imported."""
    if name.isidentifier() and name != "plastron_tui":
        marker = str(folder.parent / "imported")
        folder.joinpath(f"{name}.py").write_text(TRAP.format(marker=marker, name=name))


def set_traps(folder: Path, names: Iterable[str]) -> None:
    """Write a file for each module, a plugin, and a Python."""
    for name in {*names, "trap"}:
        set_trap(folder, name)
    plugin = folder / "trap-1.0.dist-info"
    plugin.mkdir()
    plugin.joinpath("METADATA").write_text("Metadata-Version: 2.1\nName: trap\nVersion: 1.0\n")
    entry = "[plastron.targets]\ntrap = trap:Target\nrospy = trap:Target\n"
    plugin.joinpath("entry_points.txt").write_text(entry)
    python = folder / "python3"
    python.write_text(f"#!/bin/sh\necho python3 >> '{folder.parent}/imported'\n")
    python.chmod(0o755)


@pytest.fixture(scope="module")
def names() -> set[str]:
    installed = set(packages_distributions())
    return set(sys.stdlib_module_names) | installed | OTHERS


@pytest.fixture
def traps(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, names: set[str]) -> Path:
    """Go to the folder, in which Python itself finds nothing that it needs to start."""
    folder = tmp_path / "traps"
    folder.mkdir()
    folder.joinpath("a.plastron").write_text(TALKER)
    folder.joinpath("node.py").write_text("import rospy\nrospy.init_node('n')\n")
    set_traps(folder, names - loaded_by("import runpy"))
    for name in ("ROS_VERSION", "ROS_DISTRO", "ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.chdir(folder)
    return folder


def imported(folder: Path) -> str:
    marker = folder.parent / "imported"
    return marker.read_text() if marker.exists() else ""


COMMANDS = [
    ("--help",),
    ("check", "a.plastron"),
    ("check", "a.plastron", "--format", "json"),
    ("generate", "a.plastron", "--diff"),
    ("generate", "a.plastron"),
    ("generate", "a.plastron", "--target", "trap"),
    ("fmt", "a.plastron", "--check"),
    ("graph", "a.plastron", "--format", "svg"),
    ("inspect", "node.py"),
    ("types", "String"),
    ("describe",),
    ("shell",),
    ("completion", "bash"),
    ("wizard", "a.plastron"),
    ("run", "a.plastron", "nobody"),
]


FEW = [("check", "a.plastron"), ("generate", "a.plastron"), ("run", "a.plastron", "nobody")]


@pytest.mark.parametrize(
    ("start", "commands"),
    [
        pytest.param(SCRIPT, COMMANDS, marks=pytest.mark.long, id="plastron"),
        pytest.param(MODULE, FEW, id="-m"),
    ],
)
def test_no_command_imports_from_the_current_folder(
    traps: Path, start: list[str], commands: list[tuple[str, ...]]
) -> None:
    for command in commands:
        done = subprocess.run(
            [*start, *command], capture_output=True, text=True, input="help\n", timeout=100
        )
        assert "Traceback" not in done.stderr, done.stderr
        assert imported(traps) == "", command


def test_an_empty_part_of_a_path_is_not_the_current_folder(
    traps: Path, names: set[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    # What Python needs for itself it would take from there before anything of Plastron's runs.
    own = {"sitecustomize", "usercustomize"} | loaded_by("pass")
    for name in set(sys.stdlib_module_names) | own:
        traps.joinpath(f"{name}.py").unlink(missing_ok=True)
    monkeypatch.setenv("PYTHONPATH", ":")
    monkeypatch.setenv("PATH", ":" + os.environ["PATH"])
    monkeypatch.setenv("ROS_VERSION", "1")
    for command in FEW:
        subprocess.run([*SCRIPT, *command], capture_output=True, input=b"", timeout=100)
        assert imported(traps) == "", command


def test_the_nodes_that_the_studio_runs(traps: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from plastron_tui.studio.running import Running

    find_ros(2)
    for name, value in graph_environ(traps).items():
        monkeypatch.setenv(name, value)
    said: list[str] = []
    is_told = threading.Event()
    run = Running(traps / "a.plastron", Options(target="rclpy"), is_told.set)
    try:
        wait_until(lambda: said.extend(run.take()) or is_running(said, run.status), "a node")
    finally:
        run.stop()
        wait_until(lambda: run.status is not None, "the end")
    assert imported(traps) == ""
    assert any("running rclpy nodes" in line for line in said), said


def is_running(said: list[str], status: int | None) -> bool:
    return status is not None or any("talker_pub.py" in line for line in said)


async def test_the_studio_that_is_served(traps: Path) -> None:
    aiohttp = pytest.importorskip("aiohttp", reason="the extra [web] is not installed")
    port = free_port()
    server = await asyncio.create_subprocess_exec(
        *SCRIPT, "serve", "a.plastron", "--port", str(port), stderr=asyncio.subprocess.PIPE
    )
    try:
        assert server.stderr is not None
        assert await server.stderr.readline() == b"the studio is at\n"
        line = (await server.stderr.readline()).decode()
        found = re.fullmatch(r"  (http://\S+)\?token=(\S+)\n", line)
        assert found is not None, line
        async with aiohttp.ClientSession(cookie_jar=aiohttp.CookieJar(unsafe=True)) as session:
            await session.get(found.group().strip())
            origin = found[1].rstrip("/")
            async with session.ws_connect(f"{origin}/ws", headers={"Origin": origin}) as socket:
                shown = b""
                while b"talker" not in shown:
                    message = await socket.receive_bytes(timeout=60)
                    shown += message
    finally:
        server.terminate()
        await server.wait()
    assert imported(traps) == ""


@pytest.mark.parametrize(
    "command",
    [
        import_path.command("plastron_tui.cli:main"),
        guard.command(),
        import_path.command("rosmaster:rosmaster_main"),
    ],
    ids=["plastron", "the guard", "the master"],
)
def test_a_python_that_plastron_starts(traps: Path, names: set[str], command: list[str]) -> None:
    for name in names & loaded_by("import runpy"):
        set_trap(traps, name)
    subprocess.run([*command, "--help"], stdin=subprocess.DEVNULL, capture_output=True, timeout=100)
    assert imported(traps) == ""


def test_importing_the_command_line_changes_nothing() -> None:
    code = "import gc, sys; before = [*sys.path], gc.get_threshold(); import plastron_tui.cli.group"
    code += "; sys.exit(before != ([*sys.path], gc.get_threshold()))"
    subprocess.run([sys.executable, "-c", code], check=True)


PATHS: list[tuple[str, Callable[[str], list[str]], Callable[[str], list[str]]]] = [
    ("", lambda here: [here, "/lib"], lambda here: ["/lib"]),
    (":/opt/ros", lambda here: [here, "/opt/ros", "/lib"], lambda here: ["/opt/ros", "/lib"]),
    (".", lambda here: ["", "/lib"], lambda here: ["/lib"]),
    ("HERE", lambda here: [here, here, "/lib"], lambda here: [here, here, "/lib"]),
    ("", lambda here: [here, "/lib", here], lambda here: ["/lib", here]),
]


@pytest.mark.parametrize(("variable", "before", "after"), PATHS)
def test_what_is_left_out(
    variable: str,
    before: Callable[[str], list[str]],
    after: Callable[[str], list[str]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    here, library = str(tmp_path), str(Path(os.__file__).parent)

    def real(entries: list[str]) -> list[str]:
        return [library if entry == "/lib" else entry for entry in entries]

    monkeypatch.setattr(sys, "path", real(before(here)))
    monkeypatch.setenv("PYTHONPATH", variable.replace("HERE", here))
    import_path.leave_out_current_folder()
    assert sys.path == real(after(here))
    parts = os.environ.get("PYTHONPATH", "/none").split(":")
    assert not {"", "."} & set(parts)
