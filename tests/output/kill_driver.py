"""Kills a command at each call that changes the disk, and runs the next one.

    kill_driver.py SCENE EVENT FOLDER [CALLS]

EVENT is `kill`; or the name of an error number that each call fails with in turn; or `clean`, for
new texts that vanish before it; or `read`, for a reader that looks, where there are no locks.
CALLS, separated by commas, restricts it to some. Prints how many calls there were, and what went
wrong, as JSON.
"""

from __future__ import annotations

import gc
import json
import os
import shutil
import stat
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import cast

from broken_calls import CALLS, KILLED, break_call
from kill_scenes import SCENES, Outcome, Scene, command

from plastron_tui.output import recovery
from plastron_tui.output.own_files import PREFIX


def snapshot(root: Path) -> dict[str, object]:
    """Return everything that is in a folder: modes and contents."""
    found: dict[str, object] = {}
    for path in sorted(root.rglob("*")):
        mode = path.lstat().st_mode
        text = path.read_bytes().decode() if stat.S_ISREG(mode) else None
        found[str(path.relative_to(root))] = (stat.S_IMODE(mode), text)
    return found


def visible(found: dict[str, object]) -> dict[str, object]:
    """Return what is there without the writer's own files, where removing them is what failed."""
    return {name: what for name, what in found.items() if not Path(name).name.startswith(PREFIX)}


def is_success(outcome: object) -> bool:
    """Tell whether a command, or saving, reports that everything was written."""
    if outcome is None:
        return True
    if isinstance(outcome, str):  # why it was not saved
        return False
    status, _, said = cast("tuple[int, str, str]", outcome)
    return status == 0 and "interrupted-write" not in said


def in_child(folder: Path, act: Callable[[], object]) -> tuple[int, object]:
    """Run something in a process of its own, in a folder; return its status and its result."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        os.chdir(folder)
        status, result = 0, None
        really_write = os.write
        try:
            result = act()
        except BaseException as error:
            status, result = 1, repr(error)
        data = memoryview(json.dumps(result).encode())
        while data:
            data = data[really_write(writing, data) :]
        os._exit(status)
    os.close(writing)
    with open(reading, "rb") as stream:
        data = stream.read()
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return status, json.loads(data) if data else None


def outcomes(scene: Scene, base: Path, root: Path, following: str) -> Iterator[Outcome]:
    """Yield what the next command leads to where nothing is interrupted: after nothing, and all.

    And where there was no crash: what had begun may be taken back as well as finished.
    """
    ways = [(scene, ()), (scene, (scene.act,)), (scene._replace(crash=None), ())]
    for each, acts in ways:
        fresh(base, root, each)
        for act in acts:
            assert in_child(root, act)[0] == 0
        yield in_child(root, scene.following[following]), snapshot(root)


def fresh(base: Path, root: Path, scene: Scene) -> None:
    """Make the scene's folder again."""
    shutil.rmtree(root, ignore_errors=True)
    shutil.copytree(base, root)
    if scene.crash is not None:
        assert in_child(root, scene.crash)[0] == KILLED


def warm_up(scene: Scene, base: Path, folder: Path) -> None:
    """Do all that children will do in this process, so that they need not import it each."""
    shutil.copytree(base, folder)
    os.chdir(folder)
    assert command("check", "a.plastron")[0] == 0
    for act in (scene.act, *scene.following.values()):
        act()


def run(name: str, event: str, folder: Path, calls: tuple[str, ...]) -> tuple[int, list[str]]:
    """Break each call of a scene's command in turn; return their number, and what was wrong."""
    scene, base, root = SCENES[name], folder / "base", folder / "root"
    base.mkdir()
    os.chdir(base)
    scene.prepare()
    warm_up(scene, base, folder / "warm")
    # Children would copy what they share with this process by looking for garbage in it.
    gc.collect()
    gc.freeze()
    os.chdir(folder)
    # After an error everything is old or new, and one command tells.
    commands = list(scene.following)[: None if event == "kill" else 1]
    expected = {each: list(outcomes(scene, base, root, each)) for each in commands}
    fresh(base, root, scene)
    assert is_success(in_child(root, scene.act)[1])
    new = visible(snapshot(root))
    wrong = []
    for at in range(1, 10_000):
        is_over = False
        for following in commands:
            fresh(base, root, scene)

            def act(at: int = at) -> object:
                count = break_call(at, event, calls)
                return count, scene.act()

            status, result = in_child(root, act)
            if status not in (0, KILLED):
                wrong.append(f"call {at}: {result}")
            if status == 0:
                count, outcome = cast("tuple[list[int], object]", result)
                is_over = count[0] < at
                is_new = visible(snapshot(root)) == new
                # Who finishes another's write warns until it is synced, though all is new.
                may_warn = is_new and scene.crash is not None
                if is_success(outcome) != is_new and not may_warn:
                    wrong.append(f"call {at}: the tree is {'' if is_new else 'not '}new: {outcome}")
            found = in_child(root, scene.following[following]), snapshot(root)
            if found not in expected[following]:
                wrong.append(f"call {at}, then {following}: {found}")
        if is_over:
            return at - 1, wrong
    raise AssertionError("it never ends")


if __name__ == "__main__":
    # What was finished is told; a run that was never interrupted has nothing to tell.
    recovery._told = lambda *_: iter(())
    names = tuple(sys.argv[4].split(",")) if len(sys.argv) > 4 else CALLS
    found, wrong = run(sys.argv[1], sys.argv[2], Path(sys.argv[3]), names)
    print(json.dumps({"calls": found, "wrong": wrong}))
