"""What a guarded process may do: read where it may, and nothing else."""

from __future__ import annotations

import os
from typing import Any

import pytest

from plastron_tui.runtime.file_guard import FileGuard

LEADS = "they lead to `/secret/a`, which is neither in the project nor in an installed package"
WRITES = "they write to `/project/a`"


@pytest.mark.parametrize(
    ("event", "arguments", "refused"),
    [
        ("open", ("/project/a", "r", 0), None),
        ("open", (b"/project/a", "rb", 0), None),
        ("open", ("/project/a", None, os.O_RDONLY), None),
        ("open", (os.__file__, "r", 0), None),
        # A file that is open already.
        ("open", (3, "w", 0), None),
        ("open", ("/secret/a", "r", 0), LEADS),
        ("open", ("/project/../secret/a", "r", 0), "they lead to"),
        *(("open", ("/project/a", mode, 0), WRITES) for mode in ("w", "ab", "x", "r+")),
        ("open", ("/project/a", None, os.O_WRONLY), WRITES),
        ("open", ("/project/a", None, os.O_RDONLY | os.O_CREAT), WRITES),
        ("os.listdir", ("/secret/a",), LEADS),
        ("os.scandir", ("/secret/a",), LEADS),
        ("os.scandir", ("/project",), None),
        ("os.scandir", (3,), None),
        ("os.walk", ("/project", True, None, False), None),
        ("os.system", (b"true",), "they ask for `os.system`"),
        ("socket.connect", (None, ("127.0.0.1", 1)), "they ask for `socket.connect`"),
        ("subprocess.Popen", ("true", ["true"], None, None), "they ask for `subprocess.Popen`"),
        ("import", ("subprocess", None, None, None, None), "the module `subprocess`"),
        ("import", ("ctypes.util", None, None, None, None), "the module `ctypes.util`"),
        ("import", ("json", None, None, None, None), None),
        ("compile", (None, "x"), None),
    ],
)
def test_what_is_asked_for_is_allowed_or_refused(
    event: str, arguments: tuple[Any, ...], refused: str | None
) -> None:
    guard = FileGuard(lambda name: os.path.realpath(name).startswith("/project"))
    if refused is None:
        guard(event, arguments)
        assert guard.refused == []
        return
    with pytest.raises(PermissionError):
        guard(event, arguments)
    assert guard.opened == {}
    assert len(guard.refused) == 1
    assert refused in guard.refused[0]


def test_what_is_read_is_remembered_also_where_it_is_not_there() -> None:
    guard = FileGuard(lambda _: True)
    for name in ("/project/a", "/project/none", "/project/a", os.__file__):
        guard("open", (name, "r", 0))
    assert list(guard.opened) == ["/project/a", "/project/none"]
