"""What a package cannot be built with, or should not be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.diagnostics.code import Code
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.ros.names import NameProblem
from plastron_tui.ros.package_keys import (
    PROPRIETARY,
    find_license,
    find_own_license,
    license_help,
)
from plastron_tui.ros.packages import (
    check_file_name,
    check_mail,
    check_package_name,
    check_text,
    check_version,
)

from .spec import BuildType, PackageSpec


def check_package(spec: PackageSpec) -> tuple[Diagnostic, ...]:
    """Return the mistakes of a package, and what is doubtful; each is at a statement's span.

    Who reads the statements knows better spans, and checks by `ros/packages.py` before.
    """
    return (*_head(spec), *_contents(spec))


def is_refused(diagnostics: Iterable[Diagnostic]) -> bool:
    """Tell whether something among diagnostics keeps a package from being written."""
    return any(each.severity is Severity.ERROR for each in diagnostics)


def _head(spec: PackageSpec) -> Iterator[Diagnostic]:
    yield from _told(codes.BAD_PACKAGE_NAME, check_package_name(spec.name), spec.span)
    yield from _told(codes.BAD_PACKAGE_TEXT, check_version(spec.version), spec.span)
    if spec.description:
        problem = check_text(spec.description, "the description of a package")
        yield from _told(codes.BAD_PACKAGE_TEXT, problem, spec.span)
    if spec.is_bare:
        return
    if spec.maintainer is None:
        message = f"nobody is named as the maintainer of `{spec.name}`"
        help_ = f'write who it is, as in: maintained_by "{"Ada <ada@example.com>"}"'
        yield Diagnostic(codes.MAINTAINER_MISSING, message, spec.span, help=help_)
    else:
        named = check_text(spec.maintainer.name, "the name of a maintainer")
        yield from _told(codes.BAD_MAINTAINER, named, spec.span)
        yield from _told(codes.BAD_MAINTAINER, check_mail(spec.maintainer.mail), spec.span)
    if spec.license is None:
        message = f"no license is named for `{spec.name}`: it is `{PROPRIETARY}`"
        help_ = 'write the license, as in: licensed_under "Apache-2.0"'
        yield Diagnostic(codes.LICENSE_MISSING, message, spec.span, help=help_)
    elif find_license(spec.license) is None and find_own_license(spec.license) is None:
        message = f"`{spec.license}` is no license that SPDX and Plastron know"
        yield Diagnostic(
            codes.UNKNOWN_LICENSE,
            message,
            spec.span,
            help=license_help(spec.license)[0],
        )


class _Named(NamedTuple):
    name: str
    what: str
    span: Span | None


def _contents(spec: PackageSpec) -> Iterator[Diagnostic]:
    is_python = spec.builds in (BuildType.AMENT_PYTHON, BuildType.AMENT_CMAKE_PYTHON)
    groups = (
        [_Named(each.executable, "an executable", each.span) for each in spec.nodes],
        [_Named(each.file, "a node's file", each.span) for each in spec.nodes],
        [_Named(each.name, "a launch file", each.span) for each in spec.launches],
        [_Named(each.name, "a parameter file", each.span) for each in spec.configs],
        [_Named(each.name, "a robot's file", each.span) for each in spec.robots],
    )
    for group in groups:
        there: set[str] = set()
        for name, what, span in group:
            problem = check_file_name(name, what)
            yield from _told(codes.BAD_PACKAGE_FILE, problem, span)
            # Not every file system tells capitals from small letters.
            if problem is None and name.lower() in there:
                message = f"the package has {what} `{name}` already"
                yield Diagnostic(codes.BAD_PACKAGE_FILE, message, span)
            there.add(name.lower())
    for node in spec.nodes if is_python else ():
        if not node.module.isidentifier() or node.language.is_keyword(node.module):
            message = f"no {node.language.title} module can be called `{node.module}`"
            yield Diagnostic(codes.BAD_PACKAGE_FILE, message, node.span)
        elif node.module.startswith("__"):
            message = f"`{node.file}` is a file of the package itself"
            yield Diagnostic(codes.BAD_PACKAGE_FILE, message, node.span)


def _told(code: Code, problem: NameProblem | None, span: Span | None) -> Iterator[Diagnostic]:
    if problem is not None:
        better = problem.suggestion
        help_ = None if better is None else f"a name that is allowed: `{better}`"
        yield Diagnostic(code, problem.message, span, help=help_)
