"""Running programs about robots without a disk."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from workspaces import LIBRARIES, FakeReader, catalog

from plastron_tui.diagnostics import Diagnostic, Fix
from plastron_tui.language import Document, lower
from plastron_tui.model.context import Setting
from plastron_tui.model.interpreter import Interpretation, interpret
from plastron_tui.model.robots import LoadedRobot, Robot, RobotSource
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Description,
    Inertial,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Tensor,
)
from plastron_tui.ros.robots.macros import Macros

BOX = Box((0.6, 0.6, 0.6))
BODY = Body(BOX, material=Material("blue"))
TENSOR = Tensor(0.3, 0.0, 0.0, 0.3, 0.0, 0.3)
FILE = Description(
    "loaded",
    {
        "base": Link("base"),
        "arm": Link("arm", (BODY,), (Body(BOX),), Inertial(5.0, TENSOR)),
        "hand": Link("hand", (BODY, BODY)),
        "tip": Link("tip", (), (Body(BOX),)),
    },
    {
        "turn": Joint("turn", JointType.REVOLUTE, "base", "arm", limit=Limit(-1.0, 1.0, 5.0, 2.0)),
        "hold": Joint("hold", JointType.FIXED, "arm", "hand"),
        "slide": Joint(
            "slide", JointType.PRISMATIC, "hand", "tip", limit=Limit(0.0, 1.0, 5.0, 2.0)
        ),
    },
    {"blue": Material("blue", (0.0, 0.0, 1.0, 1.0))},
)
"""A robot without faults."""

LOAD = "load_robot 'a.urdf' as r\n"
MADE = "create_robot 'rover' as r\n"


def source(described: Description = FILE, expanded: Description | None = None) -> RobotSource:
    return RobotSource(Path("a.urdf"), b"", described, expanded=expanded)


def with_macros(expanded: Description | None) -> RobotSource:
    return source(FILE, expanded)._replace(macros=Macros())


def expanded() -> Description:
    """Return what macros make of the file: a camera more, held by a joint."""
    camera = Joint("camera_joint", JointType.CONTINUOUS, "hand", "camera")
    return replace(
        FILE,
        links={**FILE.links, "camera": Link("camera")},
        joints={**FILE.joints, "camera_joint": camera},
    )


def run(
    text: str, loaded: RobotSource | None = None, told: tuple[Diagnostic, ...] = ()
) -> Interpretation:
    setting = Setting(
        "rospy",
        LIBRARIES,
        catalog,
        FakeReader(),
        read_robot=lambda *_: LoadedRobot(loaded or source(), told),
    )
    return interpret(lower(Document(text.encode())), setting)


def robot(text: str, loaded: RobotSource | None = None) -> Robot:
    """Run a program without mistakes, and return its robot `r`."""
    found = run(text, loaded)
    assert found.diagnostics == ()
    return found.workspace.robots["r"]


def applied(text: str, fix: Fix) -> str:
    """Return a program after a remedy."""
    for edit in sorted(fix.edits, key=lambda each: -each.span.start):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text
