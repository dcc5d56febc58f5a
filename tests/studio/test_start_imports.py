"""What the studio does without until its first text is on the screen: it would come later."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

LATER = (
    "jinja2",
    "tree_sitter_cpp",
    "tree_sitter_python",
    "yaml",
    "plastron_tui.boundary",
    "plastron_tui.diagnostics.codes",
    "plastron_tui.generating",
    "plastron_tui.language.declaration",
    "plastron_tui.language.lowering",
    "plastron_tui.language.statements",
    "plastron_tui.model",
    "plastron_tui.output.graphs",
    "plastron_tui.output.plan",
    "plastron_tui.project.configuration",
    "plastron_tui.project.loader",
    "plastron_tui.ros",
    "plastron_tui.runtime",
    "plastron_tui.sources",
    "plastron_tui.studio.analysis",
    "plastron_tui.studio.cards",
    "plastron_tui.studio.code_places",
    "plastron_tui.studio.config_reader",
    "plastron_tui.studio.editor.bars",
    "plastron_tui.studio.editor.completion",
    "plastron_tui.studio.editor.finder",
    "plastron_tui.studio.editor.program_commands",
    "plastron_tui.studio.main.run_actions",
    "plastron_tui.studio.panels.graph_panel",
    "plastron_tui.studio.panels.live_panel",
    "plastron_tui.studio.panels.output",
    "plastron_tui.studio.panels.robot_panel",
    "plastron_tui.studio.screens",
    "plastron_tui.studio.wizard",
    "plastron_tui.targets",
)

STUDIO = """\
import asyncio, sys
from pathlib import Path
from plastron_tui.cli import entry
from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.analysis_worker import AnalysisWorker

AnalysisWorker.preload = lambda worker: None  # what comes after the first text

async def main():
    app = StudioApp(Path("a.plastron"))
    async with app.run_test(size=(160, 50)) as pilot:
        await pilot.press("Z")
        await pilot.pause()
        print(app.main.editor.text.decode())

asyncio.run(main())
print(*sys.modules)
"""


def test_what_a_program_means_is_imported_after_it_is_shown(tmp_path: Path) -> None:
    (tmp_path / "a.plastron").write_text("create_node 'talker' as talker\n")
    folders = {"XDG_CONFIG_HOME": str(tmp_path), "XDG_STATE_HOME": str(tmp_path)}
    command = [sys.executable, "-c", STUDIO]
    done = subprocess.run(
        command, cwd=tmp_path, env={**os.environ, **folders}, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    text, modules = done.stdout.rstrip().rsplit("\n", 1)
    assert text.startswith("Zcreate_node")
    later = tuple(f"{each}." for each in LATER)
    assert " ".join(each for each in modules.split() if f"{each}.".startswith(later)) == ""
