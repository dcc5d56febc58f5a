"""Changing the parameters and the timers of a file where they stand."""

from __future__ import annotations

import math
from collections.abc import Sequence

from plastron_tui.model.endpoint_details import ParameterDetails, TimerDetails
from plastron_tui.model.kinds import Parameter, Timer
from plastron_tui.model.source import Update
from plastron_tui.ros.catalog import Catalog

from .addition import Addition
from .analysis import Analysis, Site
from .details import Details
from .dialect import Dialect
from .new_parameter import has_asked, reads, redeclare
from .place import beside
from .rates import timer_rate
from .repeating import set_rate
from .replacing import NotInPlaceError, Replacement


def plan_other(
    analysis: Analysis,
    sites: Sequence[Site],
    change: Update,
    catalog: Catalog,
    dialect: Dialect,
) -> Replacement:
    """Plan what changes all that the calls say of a parameter or a timer.

    Raises:
        NotInPlaceError: no call says what differs itself.
        CannotAddError: it is to be changed by hand.
    """
    endpoint, details = change.endpoint, Details(analysis)
    if isinstance(endpoint, Parameter):
        sites = [each for each in sites if reads(each, analysis)]
    place = beside(analysis, sites[0]) if sites else None
    if place is None:
        raise NotInPlaceError
    added = Addition.at(place, analysis, change.kind, endpoint, catalog, dialect)
    update = Replacement(added, sites[0])
    for site in sites:
        update.site = site
        match endpoint, details.of(site).details:
            case Parameter(), ParameterDetails() as found:
                redeclare(update, endpoint, found)
            case Timer(), TimerDetails():
                set_rate(update, endpoint)
            case _:
                raise NotInPlaceError
    update.notes = list(dict.fromkeys(update.notes))
    return update


def is_as_asked(analysis: Analysis, sites: Sequence[Site], change: Update) -> bool:
    """Tell whether calls say what is asked for, now that they are read again."""
    endpoint, details = change.endpoint, Details(analysis)
    match endpoint:
        case Parameter():
            found = [details.of(each).details for each in sites if reads(each, analysis)]
            version = analysis.library.ros_version
            return bool(found) and all(
                isinstance(each, ParameterDetails) and has_asked(endpoint, each, version)
                for each in found
            )
        case Timer(rate=rate) if rate is not None:
            rates = [timer_rate(analysis, each) for each in sites]
            return all(each is not None and math.isclose(each, rate.hertz) for each in rates)
        case _:
            return False
