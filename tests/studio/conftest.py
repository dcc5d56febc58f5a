from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

import pytest
from drawn_screens import draw_before, render_some
from idle_loop import IdleLoop, wait_for_idle, wait_for_screen
from shared_styles import parse_rules_once
from studio_driver import PROGRAM


@pytest.hookimpl
def pytest_asyncio_loop_factories() -> Mapping[str, Callable[[], asyncio.AbstractEventLoop]]:
    """Run the tests of the studio in a loop that knows when it is idle."""
    return {"idle": IdleLoop}


# For each module and not for each test: four of five tests of the studio start none.
@pytest.fixture(scope="module", autouse=True)
def headless() -> Iterator[None]:
    """Let a studio without a terminal do nothing twice that nobody sees, and wait for no time."""
    with pytest.MonkeyPatch.context() as patch:
        # Textual's pilot goes on as soon as the app has done what it was told, and not later.
        for module in ("textual.app", "textual.pilot"):
            patch.setattr(f"{module}.wait_for_idle", wait_for_idle)
        patch.setattr("textual.pilot.Pilot._wait_for_screen", wait_for_screen)
        # What one studio has read of its style sheets serves those that the next tests start.
        patch.setattr("textual.css.stylesheet.Stylesheet._parse_rules", parse_rules_once)
        # Textual's own returns the same in Python, several hundred times for each widget.
        patch.setattr("textual.css.model.RuleSet.__hash__", object.__hash__)
        # A question hears keys as soon as it is there: a test has read it by then.
        patch.setattr("plastron_tui.studio.key_order.QUIET", 0.0)
        # One of some pictures is drawn, which nobody sees.
        patch.setattr("textual._compositor.Compositor.render_update", render_some)
        patch.setattr("textual.pilot.Pilot._post_mouse_events", draw_before)
        yield


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keep the configuration and what is remembered in a folder of the test's own."""
    folder = tmp_path / "home"
    folder.mkdir()
    monkeypatch.setenv("XDG_CONFIG_HOME", str(folder / "config"))
    monkeypatch.setenv("XDG_STATE_HOME", str(folder / "state"))
    for name in ("NO_COLOR", "ROS_VERSION", "ROS_DISTRO", "VISUAL", "EDITOR"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")
    # No editor of this machine is opened.
    monkeypatch.setattr("plastron_tui.studio.editor.external_editor.USUAL", ())
    return folder


@pytest.fixture
def program(tmp_path: Path) -> Path:
    file = tmp_path / "work" / "talk.plastron"
    file.parent.mkdir()
    file.write_text(PROGRAM)
    return file


@pytest.fixture
def loaded(program: Path, request: pytest.FixtureRequest) -> Path:
    """A program that loads a node file: the test module's `LOADED`, and its `FILE`."""
    program.write_text(request.module.LOADED)
    program.with_name("old.py").write_text(request.module.FILE)
    return program
