"""What an entry says of an endpoint behind its name."""

from __future__ import annotations

from plastron_tui.model.kinds import Endpoint, Parameter, Publisher, Rate, Subscription, Timer
from plastron_tui.ros.parameters import Setting
from plastron_tui.ros.qos import Qos
from plastron_tui.ros.qos_words import text_of

from .entry_signs import type_text

_BETWEEN = " · "


def noted(text: str, qos: Qos | None, *, is_guess: bool) -> str:
    """Return a text with the quality of service that is known, and whether it is a guess."""
    words = text_of(qos) if qos is not None else ""
    return (f"{text}{_BETWEEN}{words}" if words else text) + (" (a guess)" if is_guess else "")


def endpoint_text(endpoint: Endpoint, *, is_guess: bool) -> str:
    """Return the type of an endpoint, or what there is in its place."""
    match endpoint:
        case Parameter():
            return noted(_parameter_text(endpoint), None, is_guess=is_guess)
        case Timer(rate=rate):
            return noted(_rate_text(rate), None, is_guess=is_guess)
        case Publisher(qos=qos) | Subscription(qos=qos):
            return noted(type_text(endpoint.type), qos, is_guess=is_guess)
        case _:
            return noted(type_text(endpoint.type), None, is_guess=is_guess)


def _parameter_text(parameter: Parameter) -> str:
    parts = [] if parameter.holds is None else [parameter.holds.value]
    if parameter.default is not None:
        parts.append(_shown(parameter.default))
    if parameter.minimum is not None and parameter.maximum is not None:
        parts.append(f"{parameter.minimum:g} to {parameter.maximum:g}")
    return _BETWEEN.join(parts) or "type unknown"


def _shown(value: Setting) -> str:
    if isinstance(value, tuple):
        return f"[{', '.join(map(_shown, value))}]"
    return f'"{value}"' if isinstance(value, str) else str(value)


def _rate_text(rate: Rate | None) -> str:
    return "rate unknown" if rate is None else str(rate)
