"""What else is written along with what was asked for, where that is wanted."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from plastron_tui.diagnostics import listed
from plastron_tui.language import DECLARATIONS, Statement
from plastron_tui.language import statements as st
from plastron_tui.session import Session

from .context import Scene, free_name, variables_of
from .extra import Extra
from .filling import Filled
from .form import laid_out
from .obstacles import is_near
from .program_trial import Placed, check
from .robot_followers import ABOUT_ROBOTS, robot_extras

STOP = "stop"
"""The key of what stops a robot that drives as long as its way is free."""

_MANY = 4
"""So many names are not listed."""


def extras_of(filled: Filled) -> list[Extra]:
    """Return what may follow a statement, in the order of the program."""
    declaration = filled.form.declaration.type
    if declaration is st.CreatePackage:
        return list(_of_package(filled.scene, filled.cells["variable"].text))
    if declaration is st.CreateLaunch:
        return list(_of_launch(filled.scene, filled.cells["variable"].text))
    if declaration is st.Publish:
        return list(_stopping(filled))
    return list(robot_extras(filled)) if declaration in ABOUT_ROBOTS else []


def _of_package(scene: Scene, package: str) -> Iterator[Extra]:
    workspace = scene.workspace
    held = {name for each in workspace.packages.values() for name in each.contents}
    nodes = [name for name in workspace.nodes if name not in held]
    launches = [name for name in workspace.launches if name not in held]
    robots = [name for name in workspace.robots if name not in held]
    names = [*nodes, *launches, *robots]
    if names:
        lines = [_line(st.Contains, package=package, item=name) for name in names]
        yield Extra("contents", f"put in {_said(names)}", tuple(lines))
    if nodes and not launches:
        taken = {*variables_of(workspace), package}
        variable = free_name("bringup", taken)
        lines = [
            _line(st.CreateLaunch, name=variable, variable=variable),
            *(_line(st.Starts, launch=variable, started=name) for name in nodes),
            _line(st.Contains, package=package, item=variable),
        ]
        yield Extra("launch", "with a launch file that starts them", tuple(lines))
    if names:
        line = _line(st.GeneratePackage, package=package)
        yield Extra("write", "write it to its folder", (line,))


def _of_launch(scene: Scene, launch: str) -> Iterator[Extra]:
    nodes = list(scene.workspace.nodes)
    if nodes:
        lines = [_line(st.Starts, launch=launch, started=name) for name in nodes]
        yield Extra("starts", f"let it start {_said(nodes)}", tuple(lines))
        line = _line(st.GenerateLaunch, launch=launch)
        yield Extra("write", "write it to its file", (line,))


def _stopping(filled: Filled) -> Iterator[Extra]:
    """Yield what stops a robot that drives only as long as the way is free."""
    texts = {name: cell.text for name, cell in filled.cells.items()}
    near = is_near(texts["type"], texts["condition"])
    if near is None:
        return
    condition, metres = near
    halt = free_name("halt", {*variables_of(filled.scene.workspace), texts["message"]})
    lines = (
        _line(st.CreateMessage, variable=halt, type=texts["type"],
              input="linear.x=0.0, angular.z=0.0"),
        _line(st.Publish, node=texts["node"], message=halt, topic=texts["topic"],
              type=texts["type"], trigger=texts["trigger"], condition=condition),
    )  # fmt: skip
    words = f"stop when something is within {metres} m"
    yield Extra(STOP, words, lines, texts["node"])


def _said(names: list[str]) -> str:
    """Return what is put somewhere, in so many words as there is room for."""
    return listed(names) if len(names) < _MANY else f"all {len(names)} that there are"


def _line(type_: type[Statement], **texts: str) -> str:
    return laid_out(DECLARATIONS[type_], texts)


def followed(filled: Filled) -> list[Placed]:
    """Return the statements of a form, with all that may follow them."""
    placed, _ = chosen(filled.base.session, filled.written, extras_of(filled), {})
    return placed


def chosen(
    session: Session, placed: list[Placed], extras: list[Extra], wanted: Mapping[str, bool]
) -> tuple[list[Placed], list[Extra]]:
    """Return the statements with those that follow them, and what of that can be had.

    Args:
        session: the program.
        placed: the statements that were asked for.
        extras: what may follow them.
        wanted: by key, whether somebody wants it; what is not there is wanted.
    """
    offered = []
    for extra in extras:
        more = [Placed(None, line, node=extra.node) for line in extra.lines]
        # What would be wrong is not offered: the one who asked for a package cannot mend it here.
        if len(check(session, [*placed, *more]).findings) > len(check(session, placed).findings):
            continue
        offered.append(extra)
        if wanted.get(extra.key, True):
            placed = [*placed, *more]
    return placed, offered
