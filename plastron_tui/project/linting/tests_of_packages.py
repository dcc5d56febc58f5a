"""Which files are tests, by where they are."""

from __future__ import annotations

import os

from plastron_tui.model.package_facts import INSTALLED, BuildFacts, How
from plastron_tui.ros.packages import is_test_folder


def is_test(path: str, package: str, build: BuildFacts | None) -> bool:
    """Tell whether a file is a test, or serves one.

    A package that is called `arm_system_tests` may have nodes that people start as those of any
    other: then something of their folder is installed.

    Args:
        path: the file, below the workspace: it begins with a separator.
        package: the folder of its package, likewise; "" where that is the workspace, or none.
        build: how the package is built, None where that is not known.
    """
    *around, base = path.split(os.sep)
    if base.startswith("test_"):
        return True
    own = package.count(os.sep) if package else -1
    for depth, name in enumerate(around):
        if depth == own and not is_test_folder(name, is_package=True):
            inner = path[len(package) + 1 :].rpartition(os.sep)[0]
            if is_test_folder(name) and (
                build is None or inner not in build.folders_installed((*INSTALLED, How.SCRIPT))
            ):
                return True
        elif is_test_folder(name):
            return True
    return False
