"""Modules come from where Python is installed, never from the folder that one happens to be in.

Python looks there first with `-m` and with `-c`, and wherever `PYTHONPATH` has an empty part
(`:/opt/…`, of a variable that was not set); in a folder of somebody else's lies whatever they
like. This runs first, with that folder still in the path: it imports nothing that is not loaded.
"""

import os
import sys


def command(entry: str, python: str | None = None) -> list[str]:
    """Return the command that calls a function in a Python of its own.

    Args:
        entry: the function, as `module:function`; its arguments follow as those of the program.
        python: the interpreter; None for this one.
    """
    return [python or sys.executable, __file__.rpartition("/")[0] + "/start.py", entry]


def leave_out_current_folder() -> None:
    """Take the current folder off the path of this process, and of those that it starts.

    Where `PYTHONPATH` has the folder by its full name it stays: that was somebody's wish.
    """
    parts = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    wanted = [part for part in parts if part not in ("", os.curdir)]
    if wanted:
        os.environ["PYTHONPATH"] = os.pathsep.join(wanted)
    else:
        os.environ.pop("PYTHONPATH", None)
    try:
        here = os.getcwd()  # noqa: PTH109 - pathlib may not be loaded
    except OSError:  # it is gone
        here = ""
    if here in wanted:
        return
    # What comes after the standard library is from `site`, such as a checkout that is installed.
    library = os.path.dirname(os.__file__)  # noqa: PTH120
    before = sys.path.index(library) if library in sys.path else len(sys.path)
    sys.path[:before] = [entry for entry in sys.path[:before] if entry not in ("", here)]
