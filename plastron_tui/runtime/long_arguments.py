"""Parameters that are too long for a command line, in files.

Source: `execve(2)`: a single argument has at most 128 KiB (`MAX_ARG_STRLEN`). The description of a
robot is longer as soon as it has a hundred parts.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager, ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory
from types import TracebackType

_LONGEST = 32 * 1024
"""Bytes: far below the limit, as all arguments together are limited too."""


class ArgumentFiles(AbstractContextManager["ArgumentFiles"]):
    """The files of the long parameters of ROS 2 nodes; they are there as long as it is open."""

    def __init__(self) -> None:
        self._stack = ExitStack()
        self._folder: Path | None = None
        self._count = 0

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
        /,
    ) -> None:
        """Take the files away."""
        self._stack.close()

    def placed(self, arguments: Sequence[str]) -> tuple[str, ...]:
        """Return the arguments of a node, with the long values of its parameters in files.

        They are where they were among the others: of two values for a parameter the later holds.

        Args:
            arguments: what the node is started with; the value of a `-p` is YAML on one line.

        Raises:
            OSError: a file cannot be written.
        """
        found: list[str] = []
        for each in arguments:
            name, is_, value = each.partition(":=")
            if found[-1:] == ["-p"] and is_ and len(each.encode()) > _LONGEST:
                found[-1:] = ["--params-file", str(self._written(name, value))]
            else:
                found.append(each)
        return tuple(found)

    def _written(self, name: str, value: str) -> Path:
        if self._folder is None:
            temporary = TemporaryDirectory(prefix="plastron-", ignore_cleanup_errors=True)
            self._folder = Path(self._stack.enter_context(temporary))
        self._count += 1
        path = self._folder / f"{self._count}.yaml"
        text = f"/**:\n  ros__parameters:\n    {name}: {value}\n"
        path.write_text(text, encoding="utf-8")
        return path
