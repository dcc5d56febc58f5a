"""The interface packages of the language's table, built once for all workers."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

import pytest

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.runtime.builds import overlay
from plastron_tui.runtime.environment import Environment, node_environ
from plastron_tui.runtime.interface_packages import table_package

NEEDED_ON_ROS2 = ("example_interfaces", "mavros_msgs")
"""Those of the nodes that the tests run. `basics` a test of `plastron run` has built by that."""


def shared_cache(factory: pytest.TempPathFactory) -> Path:
    """Return a folder of the user's cache, the same for all workers."""
    base = factory.getbasetemp()
    cache = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "cache"
    cache.mkdir(exist_ok=True)
    return cache


def made_packages(
    environment: Environment, cache: Path, only: Collection[str] = ()
) -> dict[str, str]:
    """Return the environment of nodes with the packages of the language's table.

    They are made once for all workers, in the folder. No ROS waits for what another one builds.

    Args:
        environment: the ROS.
        cache: the folder.
        only: which packages are needed, where not all are: in ROS 2 each takes 20 s of a processor.
    """
    environ = {**os.environ, "XDG_CACHE_HOME": str(cache)}
    catalog = Catalog(environment.distribution)
    kinds = (InterfaceKind.SERVICE, InterfaceKind.ACTION)
    packages = {package for kind in kinds for package in catalog.packages(kind)}
    needed = packages & set(only) if only else packages
    definitions = {name: catalog.table_package(name) for name in needed}
    with (cache / f"{environment.distribution}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        overlays: list[Path] = []
        for name, each in sorted(definitions.items()):
            if each is not None:
                package = table_package(environment, name, each)
                made, problems = overlay(environment, [package], print, environ)
                assert not problems, problems
                overlays += made.overlays
    return node_environ(replace(environment, overlays=tuple(overlays)), environ)
