"""What the tests of the command line share."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryFile

from as_plastron import become

PLASTRON = [sys.executable, "-c", "from plastron_tui.cli import main; main()"]

Run = Callable[..., subprocess.CompletedProcess[bytes]]


class Copies:
    """Runs plastron in copies of a process that has its modules."""

    def __init__(self, server: subprocess.Popen[str], folder: Path) -> None:
        self._server = server
        self._files = {name: folder / name for name in ("stdin", "stdout", "stderr", "imported")}

    def run(
        self,
        arguments: Sequence[str],
        folder: Path,
        stdin: bytes,
        environ: Mapping[str, str],
        *,
        is_debian: bool,
    ) -> subprocess.CompletedProcess[bytes]:
        """Run a command line.

        Args:
            arguments: of the command line.
            folder: the working folder.
            stdin: its input.
            environ: what its environment has besides that of this process.
            is_debian: whether the ROS that is here is Debian's ROS 1, whatever is installed.
        """
        assert self._server.stdin is not None
        assert self._server.stdout is not None
        files = self._files
        for name, data in (("stdin", stdin), ("stdout", b""), ("stderr", b"")):
            files[name].write_bytes(data)
        asked = {
            "arguments": arguments,
            "folder": str(folder),
            "environ": {**os.environ, **environ},
            "is_debian": is_debian,
            **{name: str(file) for name, file in files.items()},
        }
        print(json.dumps(asked), file=self._server.stdin, flush=True)
        status = json.loads(self._server.stdout.readline())
        out, err = files["stdout"].read_bytes(), files["stderr"].read_bytes()
        return subprocess.CompletedProcess(["plastron", *arguments], status, out, err)


@contextmanager
def copies(folder: Path) -> Iterator[Copies]:
    """Start the process that is copied; its files are in a folder of its own."""
    command = [sys.executable, str(Path(__file__).with_name("copied.py"))]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, text=True, stdin=pipe, stdout=pipe, cwd=folder) as server:
        yield Copies(server, folder)
        # The end of its input is the end of it.


def run_in_copy(
    arguments: Sequence[str], folder: Path, stdin: bytes, environ: Mapping[str, str]
) -> subprocess.CompletedProcess[bytes]:
    """Run plastron in a copy of this process, with what a test has patched in it."""
    with TemporaryFile() as given, TemporaryFile() as out, TemporaryFile() as err:
        given.write(stdin)
        given.seek(0)
        child = os.fork()
        if child == 0:
            streams = [given.fileno(), out.fileno(), err.fileno()]
            become(arguments, lambda: _prepare(folder, environ, streams))
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        out.seek(0)
        err.seek(0)
        return subprocess.CompletedProcess(["plastron", *arguments], status, out.read(), err.read())


def _prepare(folder: Path, environ: Mapping[str, str], streams: Sequence[int]) -> None:
    os.chdir(folder)
    os.environ.update(environ)
    for number, stream in enumerate(streams):
        os.dup2(stream, number)


TALKER = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String
generate_node talker
"""

LISTENER = """\
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
generate_node listener
"""

BROKEN = """\
create_node 'a' as node1
subscribe node1 to 'chatter' of message_type String
subscribe nod1 to 'other' of message_type String
generate_node node1
"""


def snapshot(folder: Path) -> dict[str, bytes | str | None]:
    """Return everything that is in a folder."""
    found: dict[str, bytes | str | None] = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if path.is_symlink():
            found[name] = str(path.readlink())
        else:
            found[name] = path.read_bytes() if path.is_file() else None
    return found


def write(folder: Path, text: str, name: str = "a.plastron") -> None:
    (folder / name).write_text(text)


def endpoints(run: Run, file: Path) -> dict[str, list[str]]:
    """Return the names of what a file holds, by kind."""
    result = run("inspect", "--format", "json", file)
    assert result.returncode == 0, result.stderr.decode()
    (node,) = json.loads(result.stdout)["nodes"]
    kinds = {"publishers": "topic", "subscriptions": "topic", "services": "service"}
    return {kind: [found[key] for found in node[kind]] for kind, key in kinds.items() if node[kind]}


def fill_in(file: Path, more: str = "") -> str:
    """Fill in a callback as a user does, and add a function of the user's own."""
    text = file.read_text()
    assert "def on_chatter(" in text
    head, tail = text.split("\n\n\ndef ", 1)
    text = f"{head}\n        self.heard = message.data  # mine{more}\n\n\n"
    text += f"def own():\n    return 'mine'\n\n\ndef {tail}"
    file.write_text(text)
    return text
