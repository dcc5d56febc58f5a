"""The folder that the packages around a launch file are in."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.boundary import holds_home

_HIGHEST = 3
"""How far above the folder of a launch file's own package the search goes."""


def packages_root(file: Path) -> Path:
    """Return the folder that the packages around a launch file are in.

    It is the `src` folder of a workspace, else the repository, else the folder that the file's own
    package is in, beside others. Without a package of its own it is the file's folder.

    Args:
        file: the launch file, as a whole path.
    """
    own = own_package(file)
    root = file.parent if own is None else own.parent
    above = (root, *root.parents[:_HIGHEST])
    source = next((each for each in above if each.name == "src"), None)
    if source is not None or own is None:
        return source or root
    # A home folder that is a repository holds more than a workspace.
    repositories = (each for each in above if (each / ".git").exists() and not holds_home(each))
    return next(repositories, root)


def own_package(file: Path) -> Path | None:
    """Return the folder of the package that a launch file is in, None where it is in none."""
    return next((each for each in file.parents if (each / "package.xml").is_file()), None)
