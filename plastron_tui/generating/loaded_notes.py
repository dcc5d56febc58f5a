"""What is to be said of what a program does to a package that it loads."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.launch import StartedNode, items_of, loaded_nodelet
from plastron_tui.sources.launch.reader import read_launch

if TYPE_CHECKING:
    from plastron_tui.model.package_source import InstalledExecutable, PackageSource
    from plastron_tui.model.packages import Contained, Package
    from plastron_tui.output.plan import OutputFile


def file_stays(
    source: PackageSource, file: str, span: Span, installed: InstalledExecutable | None = None
) -> Diagnostic:
    """Tell that a file that was taken out of a package stays there.

    Args:
        source: the package.
        file: the file, by its path in the package.
        span: the statement.
        installed: what installs it still, as it was there before the program put it in.
    """
    message = f"`{file}` of `{source.name}` stays where it is"
    if installed is not None:
        message += f", and line {installed.line} of `{installed.where}`, which was there before "
        message += "the node, installs it"
    help_ = "remove it by hand if nothing else needs it"
    return Diagnostic(codes.FILE_STAYS, message, span, help=help_)


def script_elsewhere(source: PackageSource, contained: Contained) -> Diagnostic:
    """Tell that a package installs its scripts where ROS does not look for them."""
    message = f"`ros2 run {source.name} {contained.name}` does not find it: it goes to `bin`"
    help_ = f"`install_scripts=$base/lib/{source.name}` below `[install]` of `setup.cfg`"
    return Diagnostic(codes.SCRIPT_ELSEWHERE, message, contained.span, help=help_)


def still_started(
    package: Package, files: Iterable[OutputFile], changed: Mapping[str, bytes]
) -> Iterator[Diagnostic]:
    """Warn of launch files of a package that start what the program takes out of it.

    Args:
        package: the package, which was loaded.
        files: the files that the program writes.
        changed: what becomes of files that it loads by themselves, by their real paths.
    """
    source = package.source
    assert source is not None, "the package was loaded"
    back = {each.name for each in package.contents.values()}
    gone = {name: span for name, span in package.removed.items() if name not in back}
    changed = dict(changed)
    for each in files:
        in_output = each.name.removeprefix(f"{source.name}/")
        changed[os.path.realpath(each.path or source.folder / in_output)] = each.text
    for file in source.launches if gone else ():
        if file in package.removed_launches:
            continue
        path = source.folder / file
        text = changed.get(os.path.realpath(path), source.texts.get(file, b""))
        launch = read_launch(text, path).launch
        for node in () if launch is None else items_of(launch.items, StartedNode):
            name = _started(node, source)
            if name not in gone:
                continue
            line = "" if node.place is None else f"line {node.place.line} of "
            verb = "loads" if name in source.plugins else "starts"
            message = f"{line}`{file}` {verb} `{name}` still"
            help_ = f"take it out there too: `load_launch` and `no_longer_starts '{node.called}'`"
            yield Diagnostic(codes.STILL_STARTED, message, gone[name], help=help_)


def _started(node: StartedNode, source: PackageSource) -> str | None:
    """Return what a node in a launch file is called among what a package has, None for others."""
    arguments = next((each.literal for key, each in node.others if key == "args"), None)
    loaded = loaded_nodelet(node.package.literal, arguments or "")
    if loaded is not None:
        return loaded if loaded in source.plugins else None
    if node.package.literal != source.name:
        return None
    name = node.executable.literal
    found = (x for x, each in source.executables.items() if each.loaded and each.loaded == name)
    return next(found, name)
