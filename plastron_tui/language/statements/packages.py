"""The statements about packages."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement

PACKAGE_HELP = "the package"


@statement(
    "create_package_statement",
    "create_package {name} as {variable} [described_as {description}]"
    " [maintained_by {maintainer}] [licensed_under {license}]",
    summary="Make a new package.",
    example="create_package 'rover' as rover",
    purpose="make a package",
    ros_term="package",
    about="A package is a folder that a robot's workspace takes: nodes, and all that they need.",
)
class CreatePackage(Statement):
    """Make a new package."""

    name: str = slot(SlotKind.PACKAGE_NAME, "what the package is called")
    variable: str = slot(SlotKind.NEW_PACKAGE, "what the program calls the package")
    description: str | None = slot(SlotKind.TEXT, "what is in it, in a sentence")
    maintainer: str | None = slot(SlotKind.MAINTAINER, "who looks after it")
    license: str | None = slot(SlotKind.LICENSE, "what others may do with it")


@statement(
    "load_package_statement",
    "load_package {source} as {variable}",
    summary="Read a package, to change it.",
    example="load_package 'src/rover' as rover",
    purpose="change a package that exists",
    ros_term="package",
    about="Only the lines that you ask for change; everything else stays.",
)
class LoadPackage(Statement):
    """Read a package, to change it."""

    source: str = slot(SlotKind.PACKAGE_FOLDER, "its folder, from the program's folder")
    variable: str = slot(SlotKind.NEW_PACKAGE, "what the program calls the package")


@statement(
    "contains_statement",
    "{package} contains {item} [as {executable}]",
    summary="Put a node, a launch file or a robot into a package.",
    example="rover contains talker",
    purpose="put something into a package",
    ros_term="executable",
    about="What a package contains is installed with it, and others can start it by its name.",
)
class Contains(Statement):
    """Put a node, a launch file or a robot into a package."""

    package: str = slot(SlotKind.PACKAGE, PACKAGE_HELP)
    item: str = slot(SlotKind.ITEM, "what is put into it")
    executable: str | None = slot(SlotKind.EXECUTABLE, "what one starts it by; else its name")


@statement(
    "no_longer_contains_statement",
    "{package} no_longer_contains {item}",
    summary="Take a node, a launch file or a robot out of a package.",
    example="rover no_longer_contains talker",
    purpose="take something out of a package",
    ros_term="executable",
    about="Takes it out again, with the lines that only it needed.",
    undoes=Contains,
)
class NoLongerContains(Statement):
    """Take a node, a launch file or a robot out of a package."""

    package: str = slot(SlotKind.PACKAGE, PACKAGE_HELP)
    item: str = slot(SlotKind.HELD, "what is taken out of it")


@statement(
    "generate_package_statement",
    "generate_package {package}",
    summary="Write a package with all that it contains.",
    example="generate_package rover",
    purpose="write a package to its folder",
    ros_term="package",
    about="The folder is one that `colcon build` or `catkin_make` takes as it is.",
    writes_file=True,
)
class GeneratePackage(Statement):
    """Write a package with all that it contains."""

    package: str = slot(SlotKind.PACKAGE, PACKAGE_HELP)
