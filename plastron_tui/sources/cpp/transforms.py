"""The objects of tf and tf2 that hear of transforms or tell them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import EndpointKind, SourceEndpoint
from plastron_tui.ros.qos import DEFAULT

from .analysis import Site
from .shapes import TRANSFORM_OBJECTS, TRANSFORMS, Shape

if TYPE_CHECKING:
    from .analysis import Analysis


_MOVING = DEFAULT._replace(depth=100)
_QOS = {
    (EndpointKind.SUBSCRIPTION, "/tf"): _MOVING,
    (EndpointKind.SUBSCRIPTION, "/tf_static"): _MOVING._replace(durability="transient_local"),
    (EndpointKind.PUBLISHER, "/tf"): _MOVING,
    (EndpointKind.PUBLISHER, "/tf_static"): DEFAULT._replace(depth=1, durability="transient_local"),
}
"""What `tf2_ros/qos.hpp` of Jazzy gives those that say nothing else."""


def transforms(analysis: Analysis) -> Iterator[Site]:
    """Yield the objects, one endpoint for each topic; each is made once."""
    short = {name.rpartition("::")[2] for name in TRANSFORM_OBJECTS}
    seen: set[tuple[int, int]] = set()
    for made, calls in analysis.callers.made.items():
        if not analysis.types.may_be(made, short):
            continue
        for call in calls:
            if call.scope.file.is_beside:
                continue
            type_ = analysis.receivers.plain(call.qualified, call.scope)
            name = type_.partition("<")[0]
            if name.rpartition("::")[2] not in short or name not in TRANSFORM_OBJECTS:
                continue
            key = id(call.scope.file), call.node.start_byte
            if key in seen:
                continue
            seen.add(key)
            kind, topics = TRANSFORM_OBJECTS[name]
            for topic in topics:
                place = call.node
                endpoint = SourceEndpoint(
                    kind=kind,
                    name=topic,
                    expression=call.scope.file.syntax.slice(call.name_node or place),
                    span=Span(place.start_byte, place.end_byte),
                    line=place.start_point.row + 1,
                    type=TRANSFORMS,
                    file=call.scope.file.name,
                    qos=_QOS[kind, topic] if analysis.ros_version == 2 else None,
                )
                owner = analysis.unit.class_of(call.scope)
                yield Site(endpoint, call, Shape(kind, on="object"), call.arguments, owner)
