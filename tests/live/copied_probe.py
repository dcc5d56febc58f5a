"""Runs a probe in copies of a process that has its modules: most of a question's time is theirs.

Started as a program with the probe's file, it forks for each line of standard input, which says as
JSON what is asked. What comes of it is in two files, the output and then the exit status. It is run
by the Python of a ROS, and knows nothing but that.
"""

import gc
import importlib
import json
import os
import signal
import sys
import traceback
from pathlib import Path


def main():
    file = Path(sys.argv[1])
    sys.path.insert(0, str(file.parent))
    probe = importlib.import_module(file.stem)
    # What all copies share is not to be copied by looking for garbage in it.
    gc.freeze()
    # Nobody waits for those that wait for the copies.
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    for line in sys.stdin:
        asked = json.loads(line)
        if os.fork() == 0:
            _watch(probe, asked)


def _watch(probe, asked):
    """Run a copy that answers, and say how it ended; never return."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    os.setsid()
    child = os.fork()
    if child == 0:
        _answer(probe, asked)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    partial = Path(asked["status"] + ".part")
    partial.write_text(str(status))
    partial.replace(asked["status"])
    os._exit(0)


def _answer(probe, asked):
    """Ask the graph, and print what it says; never return."""
    status = 1
    try:
        signal.alarm(asked["seconds"])
        os.environ.clear()
        os.environ.update(asked["environ"])
        output = os.open(asked["output"], os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o666)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.dup2(output, 1)
        os.dup2(output, 2)
        sys.argv[1:] = asked["arguments"]
        probe.main()
        status = 0
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else 1
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


if __name__ == "__main__":
    main()
