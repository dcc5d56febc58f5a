"""One module says when Python's cycle collector works, and only the entry points call it."""

from __future__ import annotations

import ast
import gc
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import plastron_tui
from plastron_tui.session import Options, Session

PACKAGE = Path(plastron_tui.__file__).parent


# Not at the module's own start: each process that collects tests would do it.
@cache
def _files() -> dict[str, ast.Module]:
    """Return the modules that can import the collector: to parse the others takes seconds."""
    texts = {path: path.read_bytes() for path in PACKAGE.rglob("*.py")}
    return {
        path.relative_to(PACKAGE).as_posix(): ast.parse(text)
        for path, text in texts.items()
        if re.search(rb"\bgc\b|collector", text)
    }


def _imported(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.module or ""
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def test_one_module_knows_the_collector() -> None:
    assert [name for name, tree in _files().items() if "gc" in _imported(tree)] == ["collector.py"]


def test_only_processes_of_its_own_are_tuned() -> None:
    module = "plastron_tui.collector"
    users = {name for name, tree in _files().items() if module in _imported(tree)}
    own = {"project/linting/cache.py", "project/linting/pool.py"}
    assert users > own
    assert {name.split("/")[0] for name in users - own} == {"cli", "studio"}


TEXT = b"""\
create_node 'talker' as talker
create_message text of message_type String and input "hello"
talker publish text to 'chatter' of message_type String
generate_node talker
"""


@pytest.mark.parametrize("is_enabled", [True, False])
def test_a_session_leaves_the_collector_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, is_enabled: bool
) -> None:
    thresholds = gc.get_threshold()
    told: list[str] = []
    for name in ("freeze", "unfreeze"):
        monkeypatch.setattr(gc, name, lambda name=name: told.append(name))
    seen: list[bool] = []
    if not is_enabled:
        gc.disable()
    try:
        session = Session(TEXT, tmp_path / "a.plastron", Options(output=tmp_path), environ={})
        session.interpret(lambda: seen.append(gc.isenabled()))
        session.edit(0, 0, b"\n")
        assert session.plan()[0].files
        assert gc.isenabled() == is_enabled
    finally:
        gc.enable()
    assert set(seen) == {is_enabled}
    assert gc.get_threshold() == thresholds
    assert told == []
