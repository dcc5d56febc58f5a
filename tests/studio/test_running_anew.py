"""Nodes that are to run while those of before still do."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import studio

from plastron_tui.studio import running
from plastron_tui.studio.main import run_actions
from plastron_tui.studio.wizard.done_menu import RUN

PROGRAM = "create_node 'a' as a\nsubscribe a to 'b' of message_type String\ngenerate_node a\n"


class Nodes:
    """Nodes that end when they are asked to, and not before."""

    made: list[Nodes]
    monitors = ()
    is_started = True
    has_more = False

    def __init__(self, path: Path, options: object, news: object) -> None:
        self.status: int | None = None
        self.was_stopped = False
        self._news = news
        self.made.append(self)

    def take(self) -> list[str]:
        return []

    def stop(self) -> None:
        self.status, self.was_stopped = 130, True
        self._news()  # type: ignore[operator]

    close = stop


@pytest.mark.parametrize(
    ("action", "count"), [(RUN, 2), ("screen.run(True)", 2), ("screen.run", 1)]
)
async def test_running_nodes_are_started_anew(
    action: str, count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Nodes, "made", [], raising=False)
    monkeypatch.setattr(running, "Running", Nodes)
    monkeypatch.setattr(run_actions, "TWICE", 0.0)
    path = tmp_path / "a.plastron"
    path.write_text(PROGRAM)
    async with studio(path) as driver:
        runner = driver.main.runner
        await driver.press("f5")
        await driver.until(lambda: runner.is_running)
        # Who runs what is typed goes on typing, and reads how to see it.
        assert driver.main.focused is driver.main.editor.view
        await driver.until(lambda: "Alt-V Live" in driver.main._keys.text)
        await driver.main.run_action(action)
        await driver.until(lambda: Nodes.made[0].status is not None)
        await driver.until(lambda: runner.is_running == (count == 2))
        assert [each.status for each in Nodes.made] == [130, None][:count]
        await driver.until(
            lambda: ("Alt-V Live" in driver.main._keys.text) == (action != RUN and count == 2)
        )
        # The wizard's way to run leads to what runs.
        assert (driver.main.dock_layout.focused_dock is not None) == (action == RUN)


class Talkative(Nodes):
    """Nodes that have ended with more lines than are shown at once."""

    def __init__(self, path: Path, options: object, news: object) -> None:
        super().__init__(path, options, news)
        self.status = 0
        self.left = ["n | a", "n | b", "n | c"]

    @property
    def has_more(self) -> bool:  # type: ignore[override]
        return bool(self.left)

    def take(self) -> list[str]:
        return [self.left.pop(0)] if self.left else []


async def test_all_that_nodes_have_printed_is_shown_before_their_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Nodes, "made", [], raising=False)
    monkeypatch.setattr(running, "Running", Talkative)
    path = tmp_path / "a.plastron"
    path.write_text(PROGRAM)
    async with studio(path) as driver:
        await driver.press("f5")
        await driver.until(lambda: len(Nodes.made) == 1)
        Nodes.made[0]._news()  # type: ignore[operator]
        output = driver.main.panels["output"]
        await driver.until(lambda: "ended" in output.text)
        assert output.text.splitlines()[1:] == ["n | a", "n | b", "n | c", "ended with status 0"]
