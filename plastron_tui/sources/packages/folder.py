"""Which executables a package has, from the build files in its folder."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from itertools import islice
from pathlib import Path

from plastron_tui.model.package_source import InstalledExecutable
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.setup_py.reader import read_setup
from plastron_tui.sources.splices import line_number

from .files import BUILD_FILES, MOST_FILES, package_files
from .reading import PACKAGE_XML, SETUP_PY, PackageFiles, read_package_files

_LARGEST = 500_000


def read_executables(
    folder: Path, allows: Callable[[Path], bool] = lambda _: True
) -> Mapping[str, InstalledExecutable]:
    """Return what a package installs for people to start, by what they start it by.

    Of one that is not followed these are the console scripts of its setup.py.

    Args:
        folder: the folder of the package.
        allows: whether a file may be read.
    """
    texts: dict[str, bytes] = {}
    for name in BUILD_FILES:
        path = folder / name
        with suppress(OSError, ValueError):
            if os.path.lexists(path) and allows(path):
                texts[name] = read_regular(path, _LARGEST)
    names = frozenset(islice(package_files(folder), MOST_FILES))
    if PACKAGE_XML in texts:
        source = read_package_files(PackageFiles(folder, names, texts, is_whole=False), 2).source
        if source is not None:
            return source.executables
    return dict(_scripts(folder, texts.get(SETUP_PY, b"")))


def _scripts(folder: Path, text: bytes) -> Iterator[tuple[str, InstalledExecutable]]:
    setup = read_setup(text, folder / SETUP_PY).setup
    if setup is None:
        return
    for each in setup.console_scripts:
        file = "/".join((setup.root or "", *each.target.partition(":")[0].split("."))) + ".py"
        line = line_number(text, each.span.start)
        yield each.name, InstalledExecutable(file.lstrip("/"), SETUP_PY, line, each.target)
