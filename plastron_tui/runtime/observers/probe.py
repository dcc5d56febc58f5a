"""Prints, as JSON, what of ROS the running Python could import. It imports nothing of it.

Arguments: further packages to look for.
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import json
import os
import sys
from pathlib import Path


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("rclpy")
    except PackageNotFoundError:
        return ""


def _has(name: str) -> bool:
    try:
        return importlib.util.find_spec(name) is not None
    except (ImportError, ValueError):
        return False


def _has_rclpy() -> bool:
    """Tell whether rclpy is there with its compiled part for this very Python."""
    spec = importlib.util.find_spec("rclpy") if _has("rclpy") else None
    if spec is None or spec.submodule_search_locations is None:
        return False
    return any(
        (Path(folder) / f"_rclpy_pybind11{suffix}").exists()
        for folder in spec.submodule_search_locations
        for suffix in importlib.machinery.EXTENSION_SUFFIXES
    )


def _middlewares() -> list[str]:
    """Return the RMW implementations that the ament index lists."""
    prefixes = os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep)
    found: set[str] = set()
    for prefix in [*prefixes, sys.prefix]:
        folder = Path(prefix, "share", "ament_index", "resource_index", "rmw_typesupport")
        if prefix and folder.is_dir():
            found.update(entry.name for entry in folder.iterdir())
    return sorted(found - {"rmw_implementation"})


def probe(packages: list[str]) -> dict[str, object]:
    """Look for what each client library needs."""
    return {
        "rclpy": _has_rclpy(),
        "rclpy_version": _version(),
        "middlewares": _middlewares(),
        "rospy": _has("rospy"),
        "rosmaster": _has("rosmaster"),
        "missing": [name for name in packages if not _has(name)],
    }


if __name__ == "__main__":
    print(json.dumps(probe(sys.argv[1:])))
