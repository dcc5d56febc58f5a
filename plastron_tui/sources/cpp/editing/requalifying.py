"""Giving a topic of a file another quality of service, in the argument that says it."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.model.kinds import Publisher, Subscription
from plastron_tui.ros.qos import Qos
from plastron_tui.ros.qos_words import gives, latch_of

from .. import qos_code
from .replacing import NotInPlaceError, Replacement

_RMW = re.compile(r"\brmw_qos_profile_(?!t\b)\w+\Z|(?:\.|->)(?:get_)?rmw_qos_profile\(\)\Z")


def requalify(update: Replacement) -> None:
    """Write another quality of service where another one is asked for.

    Raises:
        NotInPlaceError: the call does not say it itself.
    """
    endpoint, site = update.change.endpoint, update.site
    if not isinstance(endpoint, Publisher | Subscription) or endpoint.span is None:
        return
    qos, found = endpoint.qos, site.endpoint.qos or Qos()
    if qos is None or gives(found, qos, update.analysis.ros_version):
        return
    at = site.shape.queue
    if at is None or at >= len(site.arguments):
        raise NotInPlaceError
    if update.analysis.ros_version == 2:
        if qos.depth is None and qos.history is None:
            qos = qos._replace(depth=found.depth)
        written = qos_code.profile(qos)
        if _is_of_rmw(update, site.arguments[at]):
            written += ".get_rmw_qos_profile()"
        update.put(site.place.file, site.arguments[at], written)
        return
    if qos.depth:
        update.put(site.place.file, site.arguments[at], str(qos.depth))
    latch = site.shape.latch
    is_latched = latch_of(qos)
    if latch is None or is_latched is None or is_latched is latch_of(found):
        return
    written = "true" if is_latched else "false"
    if latch < len(site.arguments):
        if latch != len(site.arguments) - 1:
            raise NotInPlaceError
        update.put(site.place.file, site.arguments[latch], written)
    elif latch == len(site.arguments):
        end = site.arguments[-1].end_byte
        update.put_between(site.place.file, end, end, f", {written}")
    else:
        raise NotInPlaceError


def _is_of_rmw(update: Replacement, given: Node) -> bool:
    """Tell whether an argument is an `rmw_qos_profile_t`, which no `rclcpp::QoS` becomes.

    Source: `message_filters::Subscriber` and `image_transport::create_publisher` of Humble.
    """
    place = update.site.place
    text = place.file.syntax.word(given)
    if _RMW.search(text):
        return True
    if given.type not in ("identifier", "field_identifier"):
        return False
    found = update.analysis.unit.lookup(text, place, given.start_byte)
    return found is not None and found.type.endswith("rmw_qos_profile_t")
