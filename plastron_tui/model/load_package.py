"""The statement that reads a package that exists, and what it means for those that follow."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Label, codes, either
from plastron_tui.language import statements as st

from .mistake import Mistake
from .packages import BUILT_FOLDER, Package
from .workspace import Home

if TYPE_CHECKING:
    from .package_source import PackageSource
    from .run import Run
    from .workspace import Node


def load_package(run: Run, statement: st.LoadPackage) -> None:
    """Read a package, to change it."""
    run.checks.new_variable(statement, statement.variable)
    where = statement.span_of("source")
    loaded = run.setting.read_package(statement.source, run.checks.version(None))
    found = [each if each.file else each._replace(span=where) for each in loaded.diagnostics]
    source = loaded.source
    if source is None:
        raise Mistake(*found)
    for other in run.workspace.packages.values():
        if other.name == source.name:
            message = f"a package `{source.name}` exists already"
            help_ = "a workspace takes one package of a name"
            labels = (Label(other.span, "first here"),)
            raise Mistake(
                Diagnostic(codes.PACKAGE_EXISTS, message, where, help=help_, labels=labels)
            )
    for each in found:
        run.report(statement, each)
    run.workspace.packages[statement.variable] = Package(
        source.name, statement.variable, statement.span, source=source
    )


def home_in(run: Run, statement: st.Contains, package: Package, node: Node, name: str) -> Home:
    """Return where a node is in a package; in a loaded one nothing else may be started so.

    Args:
        run: the program's run.
        statement: what puts it there.
        package: the package.
        node: the node.
        name: what one starts it by.
    """
    source = package.source
    if source is None:
        return Home(package.name, name)
    _check_version(run, statement, source, node)
    has_to_be_built = is_built(run, node)
    folder = BUILT_FOLDER if has_to_be_built else source.node_folder
    if has_to_be_built:
        _check_builder(statement, source)
    if folder is None:
        message = f"`{source.name}` has no folder of Python modules that its `setup.py` installs"
        help_ = f"make a folder `{source.name}` with an `__init__.py`, and name it in `packages`"
        where = statement.span_of("package")
        raise Mistake(Diagnostic(codes.EDIT_REFUSED, message, where, help=help_))
    home = Home(package.name, name, folder)
    stem = f"{folder}/{home.stem}".lstrip("/")
    key = source.executable(name)
    there = None if key is None else source.executables[key]
    files = () if there is None else (*there.sources, there.file or "")
    is_own = any(each.rpartition(".")[0] == stem for each in files)
    if there is not None and key not in package.removed and not is_own:
        slot = "item" if statement.executable is None else "executable"
        raise Mistake(
            Diagnostic(
                codes.ALREADY_CONTAINED,
                f"the package `{source.name}` has an executable `{key}` already: line "
                f"{there.line} of `{there.where}`",
                statement.span_of(slot),
                help="name it otherwise: `contains … as 'other_name'`",
            )
        )
    return home


def is_built(run: Run, node: Node) -> bool:
    """Tell whether a package has to build a node before it can be started."""
    library = node.library or run.setting.library
    libraries = run.setting.libraries
    return library in libraries and libraries[library].is_built


def _check_builder(statement: st.Contains, source: PackageSource) -> None:
    """Check that a package has a build that compiles."""
    if source.build_type == "ament_python":
        message = f"`{source.name}` is a package of `ament_python`, which compiles nothing"
        help_ = "put the node into a package of `ament_cmake`"
        where = statement.span_of("package")
        raise Mistake(Diagnostic(codes.EDIT_REFUSED, message, where, help=help_))


def _check_version(run: Run, statement: st.Contains, source: PackageSource, node: Node) -> None:
    """Check that a node is for the ROS of the package that it is put into."""
    version = run.checks.version_of(node)
    if version == source.ros_version:
        return
    libraries = run.setting.libraries.values()
    fitting = [each.name for each in libraries if each.ros_version == source.ros_version]
    raise Mistake(
        Diagnostic(
            codes.OTHER_ROS,
            f"the package `{source.name}` is for ROS {source.ros_version}, and "
            f"`{node.variable}` is a node for ROS {version}",
            statement.span_of("item"),
            help=f"generate it for {either(fitting)}: `ros: {source.ros_version}` in "
            "`plastron.yaml`, or `--target`",
        )
    )
