"""What is to be said of what a program does to a package that it loads."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Span, codes

if TYPE_CHECKING:
    from plastron_tui.model.package_source import Executable, PackageSource
    from plastron_tui.model.packages import Contained


def file_stays(
    source: PackageSource, file: str, span: Span, installed: Executable | None = None
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
