"""Whether a long day grows the memory: rounds of load, edit and generate, and random keys.

As rows of the table both are short. `python -m benchmarks.memory rounds 20000` does as many
rounds as one likes, `python -m benchmarks.memory keys 20000` presses keys in the studio, and both
print the memory (resident, of a process with the collector's policy) as they go and how much of it
there is at the end against 5 % of the way, or against where the work was done once if that is
later: all that is kept is there then.
"""

from __future__ import annotations

import asyncio
import gc
import os
import random
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from plastron_tui import collector
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

from .programs import program
from .row import Row

if TYPE_CHECKING:
    from textual.pilot import Pilot

_FILES = 200
_BOUND = 1.2
_LONGEST_PROGRAM = 4_000
_WARM_KEYS = 750
"""Or half of the way, where that is less."""

_KEYS_IN_A_ROW = 100
_LONGEST_REST = 10.0


class Growth:
    """The memory of this process over the steps of a long work."""

    def __init__(self, steps: int, warm: int) -> None:
        """Start; after `warm` steps everything was done once, and what is kept is there."""
        self._steps = steps
        self._begin = min(max(warm, steps // 20), steps)
        self._first = 0.0

    def after(self, step: int) -> None:
        """Look at the memory where it counts from, and say it at each twentieth of the way."""
        if step == self._begin:
            self._first = _memory()
        if step % max(1, self._steps // 20) == 0:
            print(f"{step} of {self._steps}: {_memory():.1f} MB", file=sys.stderr, flush=True)

    @property
    def ratio(self) -> float:
        return _memory() / self._first


def _memory() -> float:
    """Return the resident memory in MB."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1024 / 1024


def rows() -> Iterator[Row]:
    for work, steps in (("rounds", 1_200), ("keys", 1_500)):
        command = [sys.executable, "-m", "benchmarks.memory", work, str(steps)]
        done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
        yield Row(f"memory after {steps:,} {work} / when warm", float(done.stdout), _BOUND)


# Load, edit, generate.


def _node(number: int) -> str:
    """Write a node by hand, as large as nodes are, with other names in each."""
    rng = random.Random(number)
    topics = [f"joint_{number}_{each}" for each in range(rng.randint(1, 12))]
    return (_ros1 if number % 2 else _ros2)(f"node_{number}", topics)


def _ros1(name: str, topics: list[str]) -> str:
    pubs = "".join(
        f"        self.pub_{each} = rospy.Publisher({each!r}, Float32, queue_size=10)\n"
        f"        rospy.Subscriber('{each}/command', Float32, self.on_{each})\n"
        for each in topics
    )
    callbacks = "".join(
        f"\n    def on_{each}(self, msg):\n"
        f"        self.pub_{each}.publish(max(-1.5, min(1.5, msg.data)))\n"
        for each in topics
    )
    return (
        "#!/usr/bin/env python3\nimport rospy\nfrom std_msgs.msg import Float32\n\n\n"
        f"class Arm:\n    def __init__(self):\n{pubs}{callbacks}\n\n"
        f"if __name__ == '__main__':\n    rospy.init_node('{name}')\n    Arm()\n    rospy.spin()\n"
    )


def _ros2(name: str, topics: list[str]) -> str:
    pubs = "".join(
        f"        self.pub_{each} = self.create_publisher(Float32, {each!r}, 10)\n"
        f"        self.create_subscription(Float32, '{each}/command', self.on_{each}, 10)\n"
        for each in topics
    )
    callbacks = "".join(
        f"\n    def on_{each}(self, msg):\n        self.pub_{each}.publish(msg)\n"
        for each in topics
    )
    return (
        "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import Float32\n\n\n"
        f"class Arm(Node):\n    def __init__(self):\n        super().__init__('{name}')\n"
        f"{pubs}{callbacks}\n\ndef main():\n    rclpy.init()\n    rclpy.spin(Arm())\n\n\n"
        "if __name__ == '__main__':\n    main()\n"
    )


def rounds(folder: Path, count: int) -> float:
    """Load, edit and generate files of two hundred; return how much larger the memory gets.

    A round is one of a session that goes on, as in the studio, or of a session of its own, as in
    a server; it writes a copy, the file itself, or a file for the other client library.
    """
    files = [folder / f"node_{number}.py" for number in range(_FILES)]
    for number, file in enumerate(files):
        file.write_text(_node(number))
    lasting = {way: Session(b"", folder / "a.plastron", way, environ={}) for way in _ways(folder)}
    growth = Growth(count, 2 * _FILES)
    for number in range(1, count + 1):
        file = files[number % _FILES]
        way = list(lasting)[number % len(lasting)]
        text = _program(file, number).encode()
        if number % 5:
            session = lasting[way]
            session.edit(0, len(session.document.text), text)
        else:
            session = Session(text, folder / "a.plastron", way, environ={})
        plan, problems = session.plan()
        assert plan.files, (session.diagnostics, problems)
        write(plan)
        session.files_changed()
        growth.after(number)
    return growth.ratio


def _ways(folder: Path) -> list[Options]:
    return [Options(output=folder / "out", force=True), Options(in_place=True, force=True)]


def _program(file: Path, number: int) -> str:
    library = "" if number % 3 else " using rclpy" if file.stem[-1] in "13579" else " using rospy"
    heard = number // _FILES % 7
    return (
        f"load '{file.name}' as node\n"
        f"subscribe node to 'heard_{heard}' of message_type String\n"
        f"unsubscribe node from 'heard_{heard - 1}'\n"
        f"generate_node node{library}\n"
    )


# Random keys.

_KEYS = """
    up down left right home end pageup pagedown ctrl+left ctrl+right shift+up shift+down enter
    backspace delete tab ctrl+w ctrl+k ctrl+d alt+up alt+down ctrl+z ctrl+y ctrl+x ctrl+c ctrl+v
    f1 f2 f3 f6 f7 f8 f9 f10 f12 ctrl+f ctrl+g ctrl+r ctrl+t alt+1 alt+2 alt+3 alt+4 alt+5 alt+6
    alt+7 alt+8 alt+plus alt+minus alt+z
"""


async def keys(folder: Path, count: int) -> float:
    """Press random keys in the studio; return how much larger the memory gets.

    A step is a key, or a line of a program, typed; a text that has become long is begun anew, for
    a longer text may take more memory. Every hundred steps the hands rest until the studio has let
    go of what Textual leaves behind: some 700 objects a key, which take up to 50 MB till then.
    """
    # The rounds do without Textual, and so take less memory, of which more counts.
    from textual import events

    from plastron_tui.studio.app import StudioApp

    for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME"):
        os.environ[name] = str(folder)
    file = folder / "a.plastron"
    file.write_bytes(program(40))
    names = _KEYS.split()
    lines = program(40).decode().splitlines(keepends=True)
    rng, growth = random.Random(1), Growth(count, min(_WARM_KEYS, count // 2))
    app = StudioApp(file)
    async with app.run_test(size=(160, 50)) as pilot:
        main = app.main

        async def press(name: str) -> None:
            await pilot.press(name)
            await pilot.pause()
            while app.screen is not main:
                await pilot.press("escape")
                await pilot.pause()

        # What a key needs is imported when it is pressed first: that is no growth.
        for name in names:
            await press(name)
        for number in range(1, count + 1):
            if rng.random() < 0.4:
                await _type(pilot, rng.choice(lines))
            else:
                await press(rng.choice(names))
            if len(main.open.text) > _LONGEST_PROGRAM:
                await pilot.press("ctrl+end", "ctrl+a")
                app.post_message(events.Paste("".join(lines)))
                await pilot.pause()
            if number % _KEYS_IN_A_ROW == 0:
                await _rest()
            growth.after(number)
    main.feed.worker.join(5)
    return growth.ratio


async def _rest() -> None:
    """Give the studio the time in which it collects garbage of its own accord, but no more."""
    for _ in range(int(_LONGEST_REST / 0.1)):
        if gc.get_count()[0] < collector.DUE:
            return
        await asyncio.sleep(0.1)


async def _type(pilot: Pilot[None], line: str) -> None:
    from textual import events

    from .editor import key_name

    for character in line:
        name, text = ("enter", "\r") if character == "\n" else (key_name(character), character)
        pilot.app.post_message(events.Key(name, text))
    await pilot.pause()


def measure(work: str, count: int) -> None:
    collector.look_seldom()
    with TemporaryDirectory() as folder:
        place = Path(folder)
        print(rounds(place, count) if work == "rounds" else asyncio.run(keys(place, count)))


if __name__ == "__main__":
    measure(sys.argv[1], int(sys.argv[2]))
