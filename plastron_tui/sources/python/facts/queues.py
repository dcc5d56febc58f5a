"""Publishers of rospy that say no `queue_size`, and endpoints of rclpy that have no profile.

Source: `rclpy.node.Node` of Jazzy, where `qos_profile` has no default.
"""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.unreachable import is_unreachable


def without_queue(analysis: Analysis) -> Iterator[tuple[str, Span]]:
    """Yield the file, "" for the main one, and the place of each call that says none.

    It says none with `None`, too, which is what `rospy.Publisher` takes by itself.
    """
    for site in analysis.first_sites():
        wanted = _wanted(analysis, site)
        if wanted is None or is_unreachable(site.call):
            continue
        arguments = site.arguments
        given = arguments.get(wanted)
        if not arguments.is_open and (given is None or given.type == "none"):
            yield site.endpoint.file, site.endpoint.span


def _wanted(analysis: Analysis, site: Site) -> Argument | None:
    """Return the argument that a call has to have, None where it may do without one."""
    said = site.shape.qos
    if said is None:
        return None
    if analysis.library.module == "rospy":
        return said.queue_size if site.endpoint.kind is EndpointKind.PUBLISHER else None
    return said.profile if said.default is None and _is_of_rclpy(analysis, site) else None


def _is_of_rclpy(analysis: Analysis, site: Site) -> bool:
    """Tell whether a call is one of a method of `Node` itself, and of no class in between."""
    callee = site.call.child_by_field_name("function")
    method = site.scope.enclosing("function")
    owner = None if method is None else method.parent
    if callee is None or method is None or owner is None or owner.kind != "class":
        return False
    name = analysis.syntax.called_name(site.call)
    if analysis.syntax.slice(callee) != f"{method.self_name}.{name}" or name in owner.bindings:
        return False
    bases = [analysis.resolver.qualified(each, owner.parent or owner) for each in owner.bases]
    return bool(bases) and all(
        names and all(each in analysis.library.node_classes for each in names) for names in bases
    )
