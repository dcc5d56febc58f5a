"""What a program is interpreted in: its configuration, and what reads the files that it names."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from plastron_tui.model.context import Setting
from plastron_tui.targets import LIBRARIES

from .configuration import Configuration
from .definition_reader import DefinitionReader
from .launch_reader import LaunchReader
from .loader import FilesRead, NodeLoader
from .named_texts import NamedTexts
from .package_reader import PackageReader
from .parameter_reader import ParameterReader
from .robot_files import RobotFiles


class Written(NamedTuple):
    """A program as it is written.

    Attributes:
        path: its file, None for one that has none yet.
        text: its text.
    """

    path: Path | None
    text: bytes


def new_setting(
    configuration: Configuration, loader: NodeLoader, program: Written, files: FilesRead
) -> Setting:
    """Return what a program is interpreted in.

    Args:
        configuration: what holds for the program besides its text.
        loader: reads the nodes that it loads.
        program: the program.
        files: what was made of files until now.
    """
    folder, boundary = configuration.folder, configuration.boundary
    robots = robot_files(configuration, program, files)
    return Setting(
        configuration.ros.library,
        LIBRARIES,
        configuration.catalog,
        loader,
        configuration.ros.is_chosen,
        "" if program.path is None else program.path.stem,
        DefinitionReader(folder, boundary),
        PackageReader(folder, boundary, files.packages),
        LaunchReader(_texts(configuration, program, files)),
        ParameterReader(folder, boundary),
        robots.read,
        robots.sizes.bounds,
        robots.sizes.problem,
        configuration.absent,
    )


def robot_files(configuration: Configuration, program: Written, files: FilesRead) -> RobotFiles:
    """Return what reads the robots' files that a program names; the arguments are as above."""
    texts = _texts(configuration, program, files)
    return RobotFiles(texts, configuration.environ, files.robots)


def _texts(configuration: Configuration, program: Written, files: FilesRead) -> NamedTexts:
    name = "" if program.path is None else program.path.name
    places = configuration.folder, configuration.boundary
    return NamedTexts(*places, name, program.text, files.manifest)
