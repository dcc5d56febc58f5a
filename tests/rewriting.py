"""Shares the compiling of test modules among the workers of a run.

Each worker reads all test modules, and pytest rewrites the assertions of those that it has not
compiled yet: from a clean checkout that is half of what reading them takes, and the workers,
who begin at the same time with the same one, would all do it for each.
"""

from __future__ import annotations

import sys
from contextlib import suppress
from pathlib import Path

import pytest
from _pytest.assertion import rewrite


def compile_share(config: pytest.Config, worker: int, workers: int) -> None:
    """Compile those test modules that fall to a worker, where that was not done before.

    Args:
        config: of the worker's run.
        worker: its number, from 0.
        workers: how many there are.
    """
    if sys.dont_write_bytecode or config.getoption("assertmode") != "rewrite":
        return
    modules = sorted(Path(__file__).parent.rglob("test_*.py"))
    # All of it is private to pytest: a release that has it no more reads the tests as ever.
    with suppress(AttributeError, TypeError):
        for module in modules[worker::workers]:
            _compile(module, config)


def _compile(module: Path, config: pytest.Config) -> None:
    folder = rewrite.get_cache_dir(module)
    compiled = folder / (module.stem + rewrite.PYC_TAIL)
    if rewrite._read_pyc(module, compiled) is None and rewrite.try_makedirs(folder):
        source_stat, code = rewrite._rewrite_test(module, config)
        rewrite._write_pyc(config.stash[rewrite.assertstate_key], code, source_stat, compiled)
