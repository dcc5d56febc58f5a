"""What runs, watched: 200 topics and 1,000 messages a second in all, by a real node of rclpy.

The studio is the real one, in a window that has room for all panels, with the real monitor. Keys
come as from a fast writer while the table is in sight; then the processor time of the studio and of
the monitor is taken while nothing is looked at.
"""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager
from pathlib import Path
from statistics import median, quantiles
from tempfile import TemporaryDirectory
from time import perf_counter, process_time, thread_time
from typing import NamedTuple

from textual import events
from textual.geometry import Region
from textual.pilot import Pilot
from textual.strip import Strip

from plastron_tui.runtime.environment import Environment, find_environments
from plastron_tui.runtime.environment import node_environ as environ_of
from plastron_tui.runtime.monitor import MonitorCommand, monitor_commands
from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.main.live_actions import LiveActions
from plastron_tui.studio.panels.live_panel import LivePanel

from .row import Row

_SIZE = (200, 50)
_KEYS = 60
_KEYS_A_SECOND = 15
_IDLE_SECONDS = 10
_DOMAIN = "93"
_TEXT = b"create_node 'talker' as talker\n"
_TICK = os.sysconf("SC_CLK_TCK")


@contextmanager
def _many_topics(environment: Environment) -> Iterator[MonitorCommand]:
    """Run the node, and yield what starts its monitor."""
    os.environ["ROS_DOMAIN_ID"] = _DOMAIN
    environ = environ_of(environment)
    script = Path(__file__).with_name("live_nodes.py")
    node = subprocess.Popen([environment.python, script], env=environ)
    try:
        yield monitor_commands([(environment, ())], lambda _: environ)[0]
    finally:
        node.terminate()
        node.wait(20)


@asynccontextmanager
async def _studio(command: MonitorCommand, folder: Path) -> AsyncIterator[_Watched]:
    path = folder / "work" / "talk.plastron"
    path.parent.mkdir()
    path.write_bytes(_TEXT)
    app = StudioApp(path)
    async with app.run_test(size=_SIZE) as pilot:
        watched = _Watched(pilot, app)
        watched.actions.watch([command])
        app.main.dock_layout.bring("live")
        app.main.editor.focus()
        await watched.until_known()
        yield watched
        watched.actions.close()


class _Keys(NamedTuple):
    """Milliseconds from each key until it is drawn, and those in which the main thread worked."""

    passed: list[float]
    worked: list[float]

    @staticmethod
    def most(times: list[float]) -> float:
        return quantiles(times, n=20)[18]

    def __str__(self) -> str:
        return (
            f"median {median(self.passed):.1f} ms, of the processor {median(self.worked):.1f} ms "
            f"and {self.most(self.worked):.1f} ms"
        )


class _Watched:
    """A studio that watches nodes."""

    def __init__(self, pilot: Pilot[None], app: StudioApp) -> None:
        self.pilot = pilot
        self.main = app.main
        panel = self.main.panels["live"]
        assert isinstance(panel, LivePanel)
        self.panel = panel
        self.actions: LiveActions = self.main.runner.watched.live
        self.drawn = 0.0
        self.is_drawn = asyncio.Event()
        draw = self.main.editor.view.render_lines

        def render_lines(crop: Region) -> list[Strip]:
            strips = draw(crop)
            self.drawn = perf_counter()
            self.is_drawn.set()
            return strips

        self.main.editor.view.render_lines = render_lines  # type: ignore[method-assign]

    async def until_known(self) -> None:
        """Wait until all topics are there, and those in sight have messages."""
        end = perf_counter() + 60
        while perf_counter() < end:
            await asyncio.sleep(0.1)
            lines = self.panel.lines[1 : self.panel.size.height]
            if len(self.panel.lines) > 200 and all(" Hz " in line for line in lines):
                return
        raise RuntimeError("the topics do not come")

    async def write(self) -> _Keys:
        """Let keys come, and return what each takes; the first ones do not count."""
        passed, worked = [], []
        for _ in range(_KEYS):
            start, begun = perf_counter(), thread_time()
            self.is_drawn.clear()
            self.pilot.app.post_message(events.Key("x", "x"))
            await self.is_drawn.wait()
            passed.append(1e3 * (self.drawn - start))
            worked.append(1e3 * (thread_time() - begun))
            await asyncio.sleep(1 / _KEYS_A_SECOND)
        return _Keys(passed[5:], worked[5:])

    @property
    def monitor(self) -> int:
        """The process of the monitor."""
        (monitor,) = self.actions._monitors.values()
        return monitor._process.pid


def _processor_seconds(process: int) -> float:
    """Return the processor time that a process has taken (proc(5): utime and stime)."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / _TICK


async def _measured(command: MonitorCommand, folder: Path) -> list[Row]:
    async with _studio(command, folder) as watched:
        await asyncio.sleep(3)
        own, theirs, start = process_time(), _processor_seconds(watched.monitor), perf_counter()
        await asyncio.sleep(_IDLE_SECONDS)
        passed = perf_counter() - start
        looked = 100 * (process_time() - own) / passed
        listened = 100 * (_processor_seconds(watched.monitor) - theirs) / passed
        times = await watched.write()
        watched.main.dock_layout.bring("preview")
        await asyncio.sleep(3)
        plain = await watched.write()
        own, theirs, start = process_time(), _processor_seconds(watched.monitor), perf_counter()
        await asyncio.sleep(_IDLE_SECONDS)
        passed = perf_counter() - start
        idle = 100 * (process_time() - own) / passed
        monitor = 100 * (_processor_seconds(watched.monitor) - theirs) / passed
    return [
        Row("a key while 200 topics run, 1,000 messages a second, 95th percentile",
            times.most(times.passed), 16, "ms", f"{times}; with the table out of sight {plain}"),
        Row("studio and monitor with the table out of sight, of a core", idle + monitor, 5, "%",
            f"studio {idle:.1f} %, monitor {monitor:.1f} %"),
        Row("studio and monitor with the table in sight, of a core", looked + listened, 40, "%",
            f"studio {looked:.1f} %, monitor {listened:.1f} %"),
    ]  # fmt: skip


def rows() -> Iterator[Row]:
    environment, _ = find_environments().choose(2)
    if environment is None:
        print("     no ROS 2: what runs is not watched")
        return
    with TemporaryDirectory(prefix="plastron-live-") as name, _many_topics(environment) as command:
        os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_STATE_HOME"] = name
        yield from asyncio.run(_measured(command, Path(name)))


if __name__ == "__main__":
    sys.exit("run it by: python -m benchmarks live")
