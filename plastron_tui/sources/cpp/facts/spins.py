"""Programs that have callbacks, and end, or go on, without ever calling them.

Sources: `ros/init.h`, `ros/spinner.h`, `ros/callback_queue.h` of Noetic; `rclcpp/executors.hpp` of
Jazzy. Neither library calls anything by itself.
"""

from __future__ import annotations

import re

from plastron_tui.diagnostics import Span
from plastron_tui.sources.cpp.analysis import Analysis
from plastron_tui.sources.cpp.scopes import Function

from .called_back import CALLED
from .closed import has_known_headers, is_unknown, unread_headers
from .places import span_of
from .whole_parameters import is_defined, is_handed_out, knows_bases

_SPINNING = re.compile(
    rb"spin|executor|callback_?queue|callAvailable|callOne|add_node|rclcpp_components|dlopen"
    rb"|class_loader|systemd|run_node|wait_?set",
    re.IGNORECASE,
)
_CREATING = re.compile(
    rb"\bcreate_(?:subscription|wall_timer|timer|service|server)\b|\bnh\w*\.subscribe\("
)


def idle(analysis: Analysis) -> Span | None:
    """Return the name of the `main` of a program that never calls its callbacks."""
    unit = analysis.unit
    main = _starting(analysis)
    if main is None or main.file is not unit.files[0] or not _is_called(analysis):
        return None
    if any(file.syntax.has(_SPINNING) for file in unit.all_files):
        return None
    is_sure = _is_alone(analysis) if analysis.ros_version == 2 else has_known_headers(analysis)
    return span_of(main.declarator) if is_sure else None


def _is_called(analysis: Analysis) -> bool:
    """Tell whether a node of the files has a callback, or one of the sources beside makes some."""
    return any(
        site.endpoint.kind in CALLED
        and site.shape.on in ("node", "handle", "transport", "function")
        and "wait" not in site.call.name
        and not site.endpoint.is_guess
        for site in analysis.sites
    ) or any(file.syntax.has(_CREATING) for file in analysis.unit.all_files if file.is_beside)


def _is_alone(analysis: Analysis) -> bool:
    """Tell whether no other code gets a node, or is a part of one, which may spin it."""
    own = (path for path in unread_headers(analysis) if "/" not in path)
    if not analysis.nodes or any(is_unknown(analysis, path) for path in own):
        # What is started may be of a class that is not read.
        return False
    owners = [node.owner for node in analysis.nodes if node.owner is not None]
    for owner in owners:
        if not (is_defined(analysis, owner, called=True) and knows_bases(analysis, owner)):
            return False
    return not any(is_handed_out(analysis, file) for file in analysis.unit.all_files)


def _starting(analysis: Analysis) -> Function | None:
    """Return the `main` that starts ROS, None for none."""
    starts = [
        call.scope.around
        for call in analysis.unit.calls.get("init", ())
        if call.qualifier in ("ros", "rclcpp")
    ]
    mains = (each for each in analysis.unit.functions.get("main", ()) if each.scope is not None)
    return next((each for each in mains if each in starts), None)
