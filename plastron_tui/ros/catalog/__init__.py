"""The interface types of each ROS distribution, read from YAML when first needed."""

from .catalog import Catalog
from .distributions import DISTRIBUTIONS, default_distribution
from .folders import installed_folders
from .moved import moved

__all__ = ["DISTRIBUTIONS", "Catalog", "default_distribution", "installed_folders", "moved"]
