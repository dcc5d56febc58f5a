"""Whether what a changed file is to call back is ever called: somebody has to spin.

Sources: `ros/init.h`, `ros/spinner.h`, `ros/callback_queue.h` of Noetic; `rclcpp/executors.hpp` of
Jazzy. Neither library calls anything by itself.
"""

from __future__ import annotations

import re

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.source import EndpointKind

from ..analysis import Analysis
from ..scopes import Function

_SPINNING = re.compile(rb"spin|executor|callback_?queue|callAvailable|callOne", re.IGNORECASE)
# What other files define may spin, if it is called something like this.
_STAYING = re.compile(
    r"exec|run|start|loop|wait|join|serve|listen|main|show|work|add_node|launch"
    r"|play|init_?node|control|monitor|move",
    re.IGNORECASE,
)
_CALLED = frozenset(
    {EndpointKind.SUBSCRIPTION, EndpointKind.SERVICE, EndpointKind.TIMER}
    | {EndpointKind.ACTION_SERVER}
)


def never_called(before: Analysis, after: Analysis, span: Span | None) -> Diagnostic | None:
    """Return what is wrong with callbacks of changed files, None where they may be called.

    Only a file with a `main` that starts ROS is looked at. One that had callbacks before is taken
    to know how.
    """
    main = _starting(before)
    if any(site.endpoint.kind in _CALLED for site in before.sites) or main is None:
        return None
    new = next((site for site in after.sites if site.endpoint.kind in _CALLED), None)
    if new is None or any(_SPINNING.search(each.syntax.code) for each in after.unit.all_files):
        return None
    foreign = before.unit.calls.keys() - before.unit.functions.keys() - {"init", "param"}
    if any(map(_STAYING.search, foreign)):
        return None
    what = f"`{new.endpoint.callback}`" if new.endpoint.callback else "what is called back"
    line = main.node.start_point.row + 1
    message = f"`main` in line {line} does not spin, so that {what} would not be called"
    spin = "ros::spin()" if before.ros_version == 1 else "rclcpp::spin(node)"
    return Diagnostic(codes.EDIT_REFUSED, message, span, help=f"let it spin first, with `{spin}`")


def _starting(analysis: Analysis) -> Function | None:
    """Return the `main` that starts ROS, None for none."""
    starts = [
        call.scope.file.name
        for call in analysis.unit.calls.get("init", ())
        if call.qualifier in ("ros", "rclcpp")
    ]
    mains = (each for each in analysis.unit.functions.get("main", ()) if each.scope is not None)
    found = (each for each in mains if not each.file.is_beside and each.file.name in starts)
    return next(found, None)
