"""Programs that have callbacks, and end, or go on, without ever calling them.

Sources: `ros/init.h`, `ros/spinner.h`, `ros/callback_queue.h` of Noetic; `rclcpp/executors.hpp` of
Jazzy. Neither library calls anything by itself.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.arguments import Call
from plastron_tui.sources.cpp.scopes import Function, Scope

from .called_back import CALLED
from .closed import has_known_headers, is_unknown, unread_headers
from .places import span_of
from .whole_parameters import is_defined, is_handed_out, knows_bases

_SPINNING = re.compile(
    rb"spin|executor|callback_?queue|callAvailable|callOne|add_node|rclcpp_components|dlopen"
    rb"|class_loader|systemd|run_node|wait_?set",
    re.IGNORECASE,
)
_SPUN = re.compile(rb"\bspin(?:_\w+|Once)?\s*\(")
_IDLE = re.compile(
    rb"(?:rclcpp::)?(?:executors::)?\w+Executor\s+(\w+)\s*(?:\(\s*\)|\{\s*\})?\s*;"
    rb"|[\w:]+\s+(\w+)\s*=\s*std::make_(?:shared|unique)\s*<\s*(?:rclcpp::)?(?:executors::)?"
    rb"\w+Executor\s*>\s*\(\s*\)\s*;"
    rb"|(?:ros::)?AsyncSpinner\s+(\w+)\s*[({][^(){};]*[)}]\s*;"
)
"""What declares an executor, or a spinner of ROS 1 that is still to be started."""

_LOADING = re.compile(rb"\s*(?:\.|->)\s*(?:add_node|remove_node|stop)\b")
"""What lets an executor, or a spinner, call nothing yet."""

_CREATING = re.compile(
    rb"\bcreate_(?:subscription|wall_timer|timer|service|server)\b|\bnh\w*\.subscribe\("
)


def idle(analysis: Analysis) -> Span | None:
    """Return the name of the `main` of a program that never calls its callbacks."""
    unit = analysis.unit
    main = _starting(analysis)
    if main is None or main.file is not unit.files[0] or not _is_called(analysis):
        return None
    files = [each.syntax for each in unit.all_files]
    if any(each.has(_SPINNING) for each in files) and _may_spin(_without_own(analysis)):
        return None
    is_sure = _is_alone(analysis) if analysis.ros_version == 2 else has_known_headers(analysis)
    return span_of(main.declarator) if is_sure else None


def _may_spin(codes: Sequence[bytes]) -> bool:
    """Tell whether any code may let callbacks be called."""
    if not any(_SPINNING.search(code) for code in codes):
        return False
    if any(_SPUN.search(code) for code in codes):
        return True
    return _SPINNING.search(_without_idle(b"\n".join(codes))) is not None


def _without_own(analysis: Analysis) -> list[bytes]:
    """Return the code of the files without the names of methods of theirs: `display_->spin()`.

    What such a method does itself is in the files, or has no node to spin.
    """
    unit = analysis.unit
    own: dict[int, list[Node]] = {}
    for name, functions in unit.functions.items():
        if _SPINNING.search(name.encode()) is None:
            continue
        for each in functions:
            if unit.class_of_function(each) is not None:
                own.setdefault(id(each.file), []).append(each.declarator)
        for call in unit.calls.get(name, ()):
            if call.name_node is not None and _calls_own(analysis, call):
                own.setdefault(id(call.scope.file), []).append(call.name_node)
    codes = []
    for file in unit.all_files:
        code = bytearray(file.syntax.code)
        for node in own.get(id(file), ()):
            code[node.start_byte : node.end_byte] = b" " * (node.end_byte - node.start_byte)
        codes.append(bytes(code))
    return codes


def _calls_own(analysis: Analysis, call: Call) -> bool:
    """Tell whether a call is one of a method of a class of the files which derives from nothing."""
    if call.receiver is None:
        return False
    type_ = analysis.receivers.type_of(call.receiver, call.scope)
    owner = analysis.unit.find_class(type_, call.scope) if type_ else None
    if owner is None or call.name not in owner.functions:
        return False
    return not any(True for _ in analysis.unit.foreign_bases(owner))


def _without_idle(code: bytes) -> bytes:
    """Return code without the executors that get nodes, and are never told to spin."""
    for found in _IDLE.finditer(code):
        name = re.escape(found[found.lastindex or 0])
        rest = code.replace(found[0], b";")
        rest = re.sub(rb"\b%s%s" % (name, _LOADING.pattern), b"", rest)
        if re.search(rb"\b%s\b" % name, rest) is None:
            code = rest
    return code


def _is_called(analysis: Analysis) -> bool:
    """Tell whether a node of the files has a callback, or one of the sources beside makes some."""
    return any(
        site.endpoint.kind in CALLED
        and site.shape.on in ("node", "handle", "transport", "function")
        and "wait" not in site.call.name
        and not site.endpoint.is_guess
        and _is_made(analysis, site)
        for site in analysis.sites
    ) or any(file.syntax.has(_CREATING) for file in analysis.unit.all_files if file.is_beside)


def _is_made(analysis: Analysis, site: Site) -> bool:
    """Tell whether the files name the class that creates an endpoint elsewhere than in itself.

    A `main` that is still to be written makes no node that anything could spin.
    """
    owner = _class_of(analysis, site.call.scope)
    if owner is None:
        return True
    name = re.escape(owner.name.encode())
    named = re.compile(rb"(?<!::)(?<!~)\b%s\b(?!\s*::)|(?<!\b%s)::\s*%s\b" % (name, name, name))
    return any(
        file is not owner.file or not owner.start <= each.start() < owner.end
        for file in analysis.unit.all_files
        for each in named.finditer(file.syntax.code)
    )


def _class_of(analysis: Analysis, scope: Scope | None) -> Scope | None:
    """Return the class in whose methods a part of the code is, None for none."""
    while scope is not None and scope.kind != "class":
        if scope.kind == "function" and scope.function is not None:
            owner = analysis.unit.class_of_function(scope.function)
            if owner is not None:
                return owner
        scope = scope.parent
    return scope


def _is_alone(analysis: Analysis) -> bool:
    """Tell whether no other code gets a node, or is a part of one, which may spin it."""
    own = (path for path in unread_headers(analysis) if "/" not in path)
    if not analysis.nodes or any(is_unknown(analysis, path) for path in own):
        # What is started may be of a class that is not read.
        return False
    owners = [node.owner for node in analysis.nodes if node.owner is not None]
    if len(owners) == len(analysis.nodes) and not any(map(analysis.callers.makers, owners)):
        # A program that makes no node is not finished, and has none to spin.
        return False
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
