"""Runs plastron in copies of a process that has its modules: most of a command's time is theirs.

Started as a program, it forks for each line of standard input, which says as JSON what is run. The
answer is a line as well, the exit status. It is a process of its own because a worker of the tests
is large: a copy of one takes longer than what is run in it. What a copy has imported all the
same, this process imports too, for the copies to come.
"""

from __future__ import annotations

import gc
import json
import os
import sys
from collections.abc import Mapping, Sequence
from contextlib import redirect_stderr, redirect_stdout
from importlib import import_module
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from as_plastron import become

from plastron_tui.cli.group import cli
from plastron_tui.ros import installations


def main() -> None:
    """Answer each line with the status of what was run."""
    with TemporaryDirectory() as folder:
        _warm_up(Path(folder))
    for line in sys.stdin:
        asked = json.loads(line)
        names = Path(asked["imported"])
        names.unlink(missing_ok=True)
        child = os.fork()
        if child == 0:
            _become(asked)
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        if names.exists():
            _import(names.read_text().split())
        print(json.dumps(status), flush=True)


def _warm_up(folder: Path) -> None:
    """Parse and write a program, so that the copies find compiled what is compiled once."""
    home, program = Path.cwd(), folder / "a.plastron"
    program.write_text("create_node 'a' as a\ngenerate_node a\n")
    os.chdir(folder)
    said = StringIO()
    with redirect_stdout(said), redirect_stderr(said):
        for arguments in (["fmt", "--check"], ["generate", "--target", "rospy"]):
            cli.main([*arguments, program.name], standalone_mode=False)
    os.chdir(home)


def _import(names: Sequence[str]) -> None:
    """Import modules, as a copy has done."""
    for name in names:
        module = import_module(name)
        # A name that a package finds when it is asked for may be that of its module, too.
        package = sys.modules.get(name.rpartition(".")[0])
        last = name.rpartition(".")[2]
        is_own = package is not None and name.startswith("plastron_tui.")
        if is_own and last in getattr(package, "__all__", ()) and vars(package)[last] is module:
            delattr(package, last)
    if names:
        gc.freeze()


def _own_folders() -> list[str]:
    """Return the folders of the environment's Python path that this process does not know."""
    given = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    return [folder for folder in given if folder and folder not in sys.path]


def _is_in(module: object, folders: Sequence[str]) -> bool:
    """Tell whether a module's file is in one of some folders, which no other copy has."""
    file = getattr(module, "__file__", None) or ""
    return any(file.startswith(f"{folder}{os.sep}") for folder in folders)


def _become(asked: Mapping[str, Any]) -> None:
    """Run a command line in its folder and environment; never return."""
    before = set(sys.modules)
    own: list[str] = []

    def prepare() -> None:
        os.chdir(asked["folder"])
        os.environ.clear()
        os.environ.update(asked["environ"])
        own.extend(_own_folders())
        sys.path[:0] = own
        if asked["is_debian"]:
            debian = installations.Installation(installations.Origin.DEBIAN, 1, "noetic")
            setattr(installations, "installed", lambda: (debian,))  # noqa: B010
        for number, (name, flags) in enumerate(
            [("stdin", os.O_RDONLY), *[(each, os.O_RDWR) for each in ("stdout", "stderr")]]
        ):
            os.dup2(os.open(asked[name], flags), number)

    def leave() -> None:
        modules = sys.modules.items()
        new = (name for name, each in modules if name not in before and not _is_in(each, own))
        Path(asked["imported"]).write_text("\n".join(new))

    become(asked["arguments"], prepare, leave)


if __name__ == "__main__":
    main()
