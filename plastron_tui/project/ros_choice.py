"""Which ROS a program is for where its nodes name none: the client library, and the distribution.

What is said goes first, then what is sourced, then what is installed, then the ROS 2 of the extra.
Everybody who has to know asks here, so that all say the same.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from enum import Enum
from typing import NamedTuple

from plastron_tui.model.libraries import Libraries, default_library
from plastron_tui.ros.catalog.distributions import DISTRIBUTIONS, stand_in, usual_distribution
from plastron_tui.ros.installations import Origin, present


class Why(Enum):
    """Why a program is for a ROS; the value says it of that ROS."""

    OPTION = "the command line says so"
    PROJECT = "plastron.yaml says so"
    SOURCED = "it is sourced"
    INSTALLED = "it is installed"
    ABSENT = "no ROS is found here"


class Said(NamedTuple):
    """What somebody says of the ROS; None where nothing is said.

    Attributes:
        why: who says it.
        library: the client library.
        distribution: the distribution.
    """

    why: Why
    library: str | None
    distribution: str | None


class RosChoice(NamedTuple):
    """The ROS of nodes that name none.

    Attributes:
        library: the client library.
        ros_version: the generation of ROS of that library.
        distribution: the distribution of the catalog whose types count for it.
        why: why it is this library.
    """

    library: str
    ros_version: int
    distribution: str
    why: Why

    @property
    def is_chosen(self) -> bool:
        """Whether somebody chose it; otherwise it is what there is on this machine."""
        return self.why in (Why.OPTION, Why.PROJECT, Why.SOURCED)

    @property
    def name(self) -> str:
        """What it is called: `ROS 2 kilted`."""
        return f"ROS {self.ros_version} {self.distribution}"

    @property
    def words(self) -> str:
        """What nodes are written for, with the library: `rclpy (ROS 2 kilted)`."""
        return f"{self.library} ({self.name})"


def choose_ros(
    said: tuple[Said, ...], libraries: Libraries, environ: Mapping[str, str] = os.environ
) -> RosChoice:
    """Choose the ROS of nodes that name none.

    Args:
        said: what is said, first what overrules the rest.
        libraries: the client libraries that there are.
        environ: the environment variables that say which ROS is sourced.
    """
    library, why = _choose_library(said, libraries, environ)
    version = libraries[library].ros_version
    return RosChoice(library, version, choose_distribution(version, said, environ), why)


def choose_distribution(
    ros_version: int, said: tuple[Said, ...], environ: Mapping[str, str] = os.environ
) -> str:
    """Choose the distribution of the catalog for a generation of ROS, whatever nodes name it."""
    for each in said:
        if each.distribution is not None and DISTRIBUTIONS[each.distribution] == ros_version:
            return each.distribution
    for found in present(environ):
        if found.ros_version == ros_version and found.distribution:
            return stand_in(found.distribution, ros_version)
    return usual_distribution(ros_version)


def _choose_library(
    said: tuple[Said, ...], libraries: Libraries, environ: Mapping[str, str]
) -> tuple[str, Why]:
    for each in said:
        if each.library is not None:
            return each.library, each.why
        if each.distribution is not None:
            return default_library(libraries, DISTRIBUTIONS[each.distribution]), each.why
    for found in present(environ):
        why = Why.SOURCED if found.origin is Origin.SOURCED else Why.INSTALLED
        return default_library(libraries, found.ros_version), why
    return default_library(libraries, 2), Why.ABSENT
