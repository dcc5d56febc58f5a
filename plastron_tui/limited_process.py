"""Work on what strangers wrote, in a process of its own that has limits.

Nothing inside of a process stops what counts for ever or asks for all of the memory. So the process
that does the work limits itself, and what comes back from it is bytes, which nothing executes.
"""

from __future__ import annotations

import math
import os
import signal
import sys
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import subprocess

_LONGEST_PAUSE = 0.05


class Limits(NamedTuple):
    """What a process may use.

    Attributes:
        work: seconds of processor time.
        wait: seconds until it is ended, whatever it does.
        memory: bytes of memory, those of Python itself among them.
        reply: bytes of what it answers.
        processes: how many processes the user may have for it to start another one, None for any
            number. The superuser is not held back by it (setrlimit(2)).
    """

    work: int
    wait: int
    memory: int
    reply: int
    processes: int | None = None


class Reply(NamedTuple):
    """How a process ended.

    Attributes:
        status: its exit status, the negative signal number where a signal ended it.
        text: what it wrote to its standard output, one byte more than may be where it is too much.
    """

    status: int
    text: bytes

    def why(self, limits: Limits) -> str:
        """Say how it ended, where it gave no reason itself."""
        if self.status == -getattr(signal, "SIGXCPU", 0):
            return f"it works for more than {limits.work} s"
        ended = f"signal {-self.status}" if self.status < 0 else f"status {self.status}"
        return f"its process ended with {ended}"


class TimedOutError(Exception):
    """A process that did not end in time; it is gone."""


def starting(module: str) -> str:
    """Return the code that calls the `main` of a module, isolated but for what Plastron imports."""
    return f"import sys; sys.path[:] = sys.argv[1:]; from {module} import main; sys.exit(main())"


def run_limited(
    code: str,
    request: bytes,
    limits: Limits,
    *,
    environ: Mapping[str, str] | None = None,
    folder: Path | None = None,
    modules: tuple[str, ...] = (),
) -> Reply:
    """Run code in a process of its own, which is to limit itself, and return its answer.

    The process leads a session of its own; what it has started is ended with it.

    Args:
        code: what it runs, as `starting` returns it.
        request: what it finds on its standard input.
        limits: how long to wait, and the most that it may answer.
        environ: its whole environment, None for that of this process.
        folder: its working folder, None for that of this process.
        modules: where it finds further modules, behind those of this process.

    Raises:
        TimedOutError: it did not end in time.
        OSError: no process can be started.
    """
    # The process that is limited has no need of them, and others look for them there.
    import subprocess
    import tempfile

    places = [place for place in (*sys.path, *modules) if os.path.isabs(place)]  # noqa: PTH117
    with tempfile.TemporaryFile() as asked, tempfile.TemporaryFile() as reply:
        asked.write(request)
        asked.seek(0)
        process = subprocess.Popen(
            [sys.executable, "-I", "-c", code, *places],
            stdin=asked,
            stdout=reply,
            stderr=subprocess.DEVNULL,
            env=environ,
            cwd=folder,
            start_new_session=True,
        )
        try:
            has_ended = _has_ended(process, limits.wait)
        finally:
            # Until it is waited for, its number cannot become another group's.
            if hasattr(os, "killpg"):
                with suppress(ProcessLookupError, PermissionError):
                    os.killpg(process.pid, signal.SIGKILL)
            else:
                process.kill()
            status = process.wait()
        if not has_ended:
            raise TimedOutError
        reply.seek(0)
        # Never more than may be: it is a stranger's word how much there is.
        return Reply(status, reply.read(limits.reply + 1))


def _has_ended(process: subprocess.Popen[bytes], seconds: float) -> bool:
    """Wait for a process to end, and leave it unreaped where the system can; False if in vain."""
    if not hasattr(os, "waitid"):
        import subprocess

        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            return False
        return True
    end, pause = time.monotonic() + seconds, 0.0005
    while os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None:
        if time.monotonic() > end:
            return False
        pause = min(2 * pause, _LONGEST_PAUSE)
        time.sleep(pause)
    return True


def limit_itself(limits: Limits) -> None:
    """Limit what this process may use from now on; a limit that is tighter already stays."""
    try:
        import resource
    except ImportError:  # Windows has no such limits: there the parent's patience is one
        return
    most = [
        (resource.RLIMIT_AS, limits.memory),
        (resource.RLIMIT_CPU, math.ceil(time.process_time()) + limits.work),
        (resource.RLIMIT_FSIZE, 2 * limits.reply),
        (resource.RLIMIT_CORE, 0),
    ]
    if limits.processes is not None:
        most.append((resource.RLIMIT_NPROC, limits.processes))
    for kind, value in most:
        soft, hard = resource.getrlimit(kind)
        bounds = [each for each in (soft, hard) if each != resource.RLIM_INFINITY]
        # Some systems know a limit, and refuse to set it.
        with suppress(OSError, ValueError):
            resource.setrlimit(kind, (min([value, *bounds]), hard))
