"""The interface types of each ROS distribution, read from YAML when first needed.

So are the modules that read them: many who import this want to know no more than which
distributions there are.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .distributions import DISTRIBUTIONS, usual_distribution

if TYPE_CHECKING:
    from .catalog import Catalog
    from .folders import installed_folders
    from .moved import moved

__all__ = ["DISTRIBUTIONS", "Catalog", "installed_folders", "moved", "usual_distribution"]

_MODULES = {"Catalog": "catalog", "installed_folders": "folders", "moved": "moved"}


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = getattr(import_module(f".{_MODULES[name]}", __name__), name)
    # To import a module gives its package an attribute of its name, and two names are the same.
    globals()[name] = found
    return found
