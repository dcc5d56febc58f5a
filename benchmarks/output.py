"""How long `generate` takes, against writing the same files and nothing else."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

from .programs import many_nodes
from .row import Row

_NODES = 1_000
_RUNS = 7


def rows() -> Iterator[Row]:
    text = many_nodes(_NODES)
    with TemporaryDirectory(dir=Path.cwd()) as folder:
        generated, written = [], []
        for run in range(_RUNS):
            ours = Path(folder, f"ours-{run}")
            start = perf_counter()
            session = Session(text, options=Options(output=ours), environ={})
            assert session.diagnostics == ()
            plan, diagnostics = session.plan()
            assert not diagnostics
            assert len(write(plan).written) == _NODES
            generated.append(perf_counter() - start)
            files = {file.name: file.text for file in plan.files}
            theirs = Path(folder, f"theirs-{run}")
            start = perf_counter()
            _write_alone(theirs, files)
            written.append(perf_counter() - start)
    yield Row(
        f"generate {_NODES:,} nodes / write, sync and rename them",
        median(a / b for a, b in zip(generated, written, strict=True)),
        2,
        detail=f"{median(generated) * 1e3:.0f} ms / {median(written) * 1e3:.0f} ms",
    )


def _write_alone(folder: Path, files: dict[str, bytes]) -> None:
    folder.mkdir()
    for name, text in files.items():
        temporary = folder / f".{name}"
        with temporary.open("wb") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        temporary.rename(folder / name)
    assert shutil.disk_usage(folder).free
