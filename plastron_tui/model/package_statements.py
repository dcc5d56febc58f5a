"""The statements that make packages, fill them, and write them."""

from __future__ import annotations

from pathlib import PurePath
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Label, Severity, Span, codes, guess, write
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.text_places import span_in_text
from plastron_tui.ros.names import NameProblem
from plastron_tui.ros.package_keys import find_license, find_own_license, license_help
from plastron_tui.ros.packages import (
    check_file_name,
    check_package_name,
    check_text,
    parse_maintainer,
    taken_package_name,
)

from .launches import Launch
from .load_package import home_in, is_built
from .mistake import Mistake
from .other_things import another
from .packages import SCRIPTS_FOLDER, Contained, Package, PackageGeneration, nodes_folder
from .robots import Robot
from .run import Run
from .workspace import Generation, Home, Node


def create_package(run: Run, statement: st.CreatePackage) -> None:
    """Make a package."""
    run.checks.new_variable(statement, statement.variable)
    check_package_named(run, statement)
    check_description(run, statement)
    check_maintainer(run, statement)
    check_license(run, statement)
    taken = taken_package_name(statement.name)
    if taken is None and run.types.is_of_ros(statement.name, run.checks.version(None)):
        taken = "ROS has a package of this name"
    if taken is not None:
        message = f"the name `{statement.name}` is taken: {taken}"
        where = statement.span_of("name")
        run.report(statement, Diagnostic(codes.TAKEN_PACKAGE_NAME, message, where))
    run.workspace.packages[statement.variable] = Package(
        statement.name,
        statement.variable,
        statement.span,
        statement.description or "",
        statement.maintainer or "",
        statement.license or "",
    )


def check_package_named(run: Run, statement: st.CreatePackage) -> None:
    """Check that a package may have its name, and that no other has it."""
    where = statement.span_of("name")
    problem = check_package_name(statement.name)
    if problem is not None:
        right = problem.suggestion
        raise Mistake(
            Diagnostic(
                codes.BAD_PACKAGE_NAME,
                problem.message,
                _place(statement, "name", problem),
                help=None if right is None else f"write '{right}'",
                fix=None if right is None else write(f"'{right}'", where),
            )
        )
    for other in run.workspace.packages.values():
        if other.name == statement.name:
            raise Mistake(
                Diagnostic(
                    codes.PACKAGE_EXISTS,
                    f"a package `{statement.name}` exists already",
                    where,
                    help="a workspace takes one package of a name; choose another",
                    labels=(Label(other.span, "first here"),),
                )
            )


def check_description(_: Run, statement: st.CreatePackage) -> None:
    """Check what a package says of itself."""
    if statement.description:
        problem = check_text(statement.description, "the description of a package")
        if problem is not None:
            where = _place(statement, "description", problem)
            raise Mistake(Diagnostic(codes.BAD_PACKAGE_TEXT, problem.message, where))


def _place(statement: Statement, slot: str, problem: NameProblem) -> Span:
    """Return where something wrong stands in a text of a statement."""
    start, end = problem.offset, problem.offset + problem.length
    is_whole = end - start >= len(getattr(statement, slot))
    return statement.span_of(slot) if is_whole else span_in_text(statement, slot, start, end)


def check_maintainer(_: Run, statement: st.CreatePackage) -> None:
    """Check who looks after a package: a name, and an address as build tools take it."""
    if statement.maintainer is None:
        return
    where = statement.span_of("maintainer")
    maintainer, problem = parse_maintainer(statement.maintainer)
    if maintainer is None or problem is not None:
        message = "this names nobody" if problem is None else problem.message
        if problem is not None:
            where = _place(statement, "maintainer", problem)
        help_ = 'write "Ada <ada@example.com>"'
        raise Mistake(Diagnostic(codes.BAD_MAINTAINER, message, where, help=help_))


def check_license(_: Run, statement: st.CreatePackage) -> None:
    """Check that a license is one that SPDX knows, or stands for one of somebody's own."""
    name = statement.license
    if name is None or find_license(name) is not None or find_own_license(name) is not None:
        return
    where = statement.span_of("license")
    remedy, right = license_help(name)
    raise Mistake(
        Diagnostic(
            codes.UNKNOWN_LICENSE,
            f"`{name}` is no license that SPDX and Plastron know",
            where,
            help=remedy,
            fix=None if right is None else write(f'"{right}"', where),
        )
    )


def contains(run: Run, statement: st.Contains) -> None:
    """Put a node, a launch file or a robot into a package."""
    package = check_package_there(run, statement)
    item = check_item(run, statement)
    check_executable(run, statement)
    _check_place(run, statement, package)
    _check_ros(run, statement, package, item)
    contained = Contained(item, statement.executable, statement.span)
    for other in package.contents.values():
        is_alike = type(other.item) is type(item) and other.name == contained.name
        if is_alike:
            slot = "item" if statement.executable is None else "executable"
            raise Mistake(
                Diagnostic(
                    codes.ALREADY_CONTAINED,
                    f"`{package.variable}` contains a `{contained.name}` already",
                    statement.span_of(slot),
                    help="name it otherwise: `contains … as 'other_name'`",
                    labels=(Label(other.span, "first here"),),
                )
            )
    home = None
    if isinstance(item, Node):
        home = home_in(run, statement, package, item, contained.name)
    package.contents[statement.item] = contained
    if isinstance(item, Node):
        item.home = home
    elif isinstance(item, Robot):
        item.home = package.name


def check_item(run: Run, statement: st.Contains) -> Node | Launch | Robot:
    """Return the node, the launch file or the robot that a statement puts into a package."""
    workspace, variable = run.workspace, statement.item
    item = (
        workspace.nodes.get(variable)
        or workspace.launches.get(variable)
        or workspace.robots.get(variable)
    )
    if item is None:
        raise _unknown_item(run, statement)
    return item


def check_executable(run: Run, statement: st.Contains) -> None:
    """Check what one starts a node of a package by: files are called by it."""
    node = run.workspace.nodes.get(statement.item)
    robot = run.workspace.robots.get(statement.item)
    if robot is not None and statement.executable is not None:
        message = f"nobody starts a robot by a name; its files are called `{robot.stem}`"
        where = statement.span_of("executable")
        help_ = f"leave out `as '{statement.executable}'`"
        raise Mistake(Diagnostic(codes.BAD_PACKAGE_FILE, message, where, help=help_))
    name = statement.executable or ("" if node is None else node.name)
    problem = check_file_name(name, "an executable") if name else None
    if problem is not None:
        slot = "item" if statement.executable is None else "executable"
        where = (
            _place(statement, slot, problem) if slot == "executable" else statement.span_of(slot)
        )
        remedy = None if statement.executable else "name it otherwise: `contains … as 'other_name'`"
        raise Mistake(Diagnostic(codes.BAD_PACKAGE_FILE, problem.message, where, help=remedy))


def _check_place(run: Run, statement: st.Contains, package: Package) -> None:
    """Check that what is put into a package is in none yet: it is one file, in one folder."""
    for other in run.workspace.packages.values():
        earlier = other.contents.get(statement.item)
        if earlier is not None:
            where = "already" if other is package else f"in `{other.variable}` already"
            raise Mistake(
                Diagnostic(
                    codes.ALREADY_CONTAINED,
                    f"`{statement.item}` is {where}"
                    if other is not package
                    else f"`{package.variable}` contains `{statement.item}` already",
                    statement.span_of("item"),
                    help=f"take it out first: `{other.variable} no_longer_contains "
                    f"{statement.item}`",
                    labels=(Label(earlier.span, "put there here"),),
                )
            )


def _check_ros(
    run: Run, statement: st.Contains, package: Package, item: Node | Launch | Robot
) -> None:
    """Check that a package has nodes of one generation of ROS alone: it is built by one of them."""
    if not isinstance(item, Node):
        return
    version = run.checks.version_of(item)
    for other in package.contents.values():
        if isinstance(other.item, Node) and run.checks.version_of(other.item) != version:
            raise Mistake(
                Diagnostic(
                    codes.MIXED_PACKAGE,
                    f"`{statement.item}` is of ROS {version}, and `{package.variable}` has nodes "
                    f"of ROS {3 - version}",
                    statement.span_of("item"),
                    help="make a package for each",
                    labels=(Label(other.span, "one of them"),),
                )
            )


def _unknown_item(run: Run, statement: st.Contains) -> Mistake:
    variable = statement.item
    if run.consequences.declares(variable):
        return Mistake()
    where = statement.span_of("item")
    known = run.workspace.what(variable)
    if known is not None:
        message, remedy, fix = f"a package contains no {known[0]}", None, None
        if known[0] == "type":
            remedy = "a type is written with the nodes that use it"
    else:
        message = f"no node, launch file or robot `{variable}`"
        workspace = run.workspace
        known_items = [*workspace.nodes, *workspace.launches, *workspace.robots]
        remedy, fix = guess(variable, known_items, where)
        remedy = remedy or f"make it first: `create_node '{variable}' as {variable}`"
    return Mistake(Diagnostic(codes.UNKNOWN_ITEM, message, where, help=remedy, fix=fix))


def no_longer_contains(run: Run, statement: st.NoLongerContains) -> None:
    """Take something out of a package."""
    package = check_package_there(run, statement)
    item = statement.item
    if not item.startswith("'"):
        if item not in package.contents:
            raise _not_contained(run, statement, package, list(package.contents))
        _take_out(package, item)
        return
    name = item[1:-1]
    held = [key for key, each in package.contents.items() if each.name == name]
    for key in held:
        _take_out(package, key)
    there = None if package.source is None else package.source.node(name)
    launch = None if package.source is None else package.source.launch(name)
    if there is not None:
        package.removed[there] = statement.span
    elif launch is not None:
        package.removed_launches[launch] = statement.span
    elif not held:
        _tell_not_contained(run, statement, package, name)


def _tell_not_contained(
    run: Run, statement: st.NoLongerContains, package: Package, name: str
) -> None:
    """Say that a package does not contain something; an earlier run may have taken it out.

    That has left its file there.
    """
    names = [each.name for each in package.contents.values()]
    source = package.source
    if source is None:
        raise _not_contained(run, statement, package, names)
    stems = {PurePath(file).stem for file in source.texts}
    if name.removesuffix(".py") not in stems:
        names += [*source.executables, *source.plugins]
        for each in _not_contained(run, statement, package, names).diagnostics:
            run.report(statement, each._replace(severity=Severity.WARNING))


def _take_out(package: Package, variable: str) -> None:
    item = package.contents.pop(variable).item
    if isinstance(item, Node):
        item.home = None
    elif isinstance(item, Robot):
        item.home = ""


def _not_contained(
    run: Run, statement: st.NoLongerContains, package: Package, names: list[str]
) -> Mistake:
    name = statement.item.strip("'")
    if run.consequences.declares(name) or run.consequences.mentions(name):
        return Mistake()
    where = statement.span_of("item")
    remedy, fix = guess(name, names, where, is_quoted=statement.item.startswith("'"))
    message = f"`{package.variable}` does not contain `{name}`"
    return Mistake(Diagnostic(codes.NOT_CONTAINED, message, where, help=remedy, fix=fix))


def generate_package(run: Run, statement: st.GeneratePackage) -> None:
    """Note that a package is to be written as it is now."""
    package = check_package_there(run, statement)
    workspace = run.workspace
    for each in package.contents.values():
        if isinstance(each.item, Node):
            library = each.item.library or run.setting.library
            node = each.item.snapshot()
            node.home = _home(run, package, each, node)
            generation = Generation(node, library, statement.span)
            workspace.generations.append(generation)
    workspace.written_packages.append(PackageGeneration(package.snapshot(), statement.span))


def _home(run: Run, package: Package, contained: Contained, node: Node) -> Home | None:
    """Return where a node of a package is, which all that the package contains decides."""
    if package.source is not None or is_built(run, node) or run.checks.version_of(node) == 1:
        return node.home
    others = (each.item for each in package.contents.values())
    if any(isinstance(each, Node) and is_built(run, each) for each in others):
        return Home(package.name, contained.name, SCRIPTS_FOLDER)
    if _has_types(run, package):
        return Home(package.name, contained.name, nodes_folder(package.name))
    return node.home


def _has_types(run: Run, package: Package) -> bool:
    """Tell whether a package that is created is to build types of ROS 2."""
    own = run.types.own_package(2)
    made = (each for each in run.workspace.types.values() if each.source is None)
    return any(2 in each.definitions and (each.package or own) == package.name for each in made)


def check_package_there(run: Run, statement: Any) -> Package:
    """Return the package that a statement is about."""
    variable: str = statement.package
    package = run.workspace.packages.get(variable)
    if package is not None:
        return package
    if run.consequences.declares(variable):
        raise Mistake
    where = statement.span_of("package")
    near = guess(variable, run.workspace.packages, where)
    remedy, fix = another(run.workspace, statement, variable) or near
    remedy = remedy or f"make it first: `create_package '{variable}' as {variable}`"
    message = f"no package `{variable}`"
    raise Mistake(Diagnostic(codes.UNKNOWN_PACKAGE, message, where, help=remedy, fix=fix))
