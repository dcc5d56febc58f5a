"""The quality of service that a program asks for, as an argument of a call."""

from __future__ import annotations

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import Endpoint, Publisher, Subscription
from plastron_tui.ros.qos import Qos
from plastron_tui.ros.qos_words import gives

from .addition import Addition
from .analysis import Site
from .calls import Argument
from .messages import CannotAddError
from .qos_code import keywords, new_keywords, profile
from .replacing import NotInPlaceError, Replacement
from .splices import Splice
from .syntax import parts_of


def asked_qos(endpoint: Endpoint) -> Qos | None:
    """Return the quality of service that a program asks for, None where it asks for none."""
    if not isinstance(endpoint, Publisher | Subscription) or endpoint.span is None:
        return None
    return endpoint.qos


def has_policies(endpoint: Endpoint, found: Qos | None, version: int) -> bool:
    """Tell whether a call gives all policies that are asked for, those of its ROS at least."""
    asked = asked_qos(endpoint)
    return asked is None or gives(found or Qos(), asked, version)


def check_policies(added: Addition, site: Site) -> None:
    """Refuse to send through a publisher of a file that has not what a program asks for.

    Raises:
        CannotAddError: it is to be changed by hand.
    """
    endpoint = added.endpoint
    if not isinstance(endpoint, Publisher) or endpoint.span is not None or endpoint.qos is None:
        return
    found = site.endpoint.qos or Qos()
    if endpoint.qos.over(found) == found:
        return
    if not added.is_rclpy and gives(found, endpoint.qos, version=1):
        return
    message = f"the publisher of `{added.name}` in line {site.endpoint.line} does not show"
    raise CannotAddError(
        codes.EDIT_REFUSED,
        f"{message} the quality of service that is asked for",
        endpoint.span,
        f"change it by hand, or let the node stop publishing to `{added.name}` first",
    )


def requalify(update: Replacement) -> None:
    """Change the quality of service of a call where another one is asked for.

    Raises:
        NotInPlaceError: the call does not say it itself.
    """
    added, site = update.added, update.site
    qos = asked_qos(added.endpoint)
    if qos is None or has_policies(added.endpoint, site.endpoint.qos, added.dialect.ros_version):
        return
    places = site.shape.qos
    if places is None or site.arguments.is_open:
        raise NotInPlaceError
    if not added.is_rclpy:
        is_publisher = isinstance(added.endpoint, Publisher)
        for keyword, value in keywords(qos, is_publisher=is_publisher).items():
            place = places.queue_size if keyword == "queue_size" else places.latch
            if place is not None and (keyword != "latch" or value == "True" or _has(site, place)):
                put_argument(update, place, value)
        return
    if places.profile is None:
        raise NotInPlaceError
    if qos.depth is None and qos.history is None and site.endpoint.qos is not None:
        qos = qos._replace(depth=site.endpoint.qos.depth)
    put_argument(update, places.profile, profile(qos, added.imports.use))


def _has(site: Site, place: Argument) -> bool:
    return site.arguments.get(place) is not None


def put_argument(update: Replacement, argument: Argument, text: str) -> None:
    """Replace an argument of a call, or give it one more.

    Raises:
        NotInPlaceError: nobody knows where it would go.
    """
    given = update.site.arguments.get(argument)
    if given is not None:
        update.put(given, text)
        return
    listed = update.site.call.child_by_field_name("arguments")
    parts = parts_of(listed)
    if not parts or update.site.arguments.is_open:
        raise NotInPlaceError
    end = parts[-1].end_byte
    written = f", {argument.keyword}={text}"
    update.splices.append(Splice(end, end, update.analysis.syntax.encode(written)))


def creation_qos(added: Addition) -> list[tuple[str, str]]:
    """Return the keywords of a new call that say its quality of service; none for none asked."""
    qos = asked_qos(added.endpoint)
    if qos is None:
        return []
    if added.is_rclpy:
        return [("qos_profile", profile(qos, added.imports.use))]
    found = new_keywords(qos, is_publisher=isinstance(added.endpoint, Publisher))
    return [*found.items()]
