"""Who may use the studio that is served: decided from a request's headers alone.

A browser sends requests for any page that is open in it. Three things keep such a page out: it
does not know the token, which only the terminal was told; the browser says by `Origin` and
`Sec-Fetch-Site` (Fetch Metadata, W3C) whose page asks; and a name that was made to lead here (DNS
rebinding) is not among the names of the address that is served.
"""

from __future__ import annotations

import hmac
import re
import secrets
import socket
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from ipaddress import IPv6Address, ip_address

_LOOPBACK_NAMES = ("localhost", "127.0.0.1", "::1")
_AUTHORITY = re.compile(
    r"(?:\[(?P<ipv6>[0-9a-f:.]+)\]|(?P<name>[^\s:@/?#\[\]]+))(?::(?P<port>[0-9]{1,5}))?"
)
_HTTP_PORT = 80


class Refusal(Enum):
    """Why a request is refused, as a person reads it."""

    HOST = "the address in the request is none that this studio is served at"
    ORIGIN = "a page of another origin asked for this"
    TOKEN_MISSING = "this studio opens only for those who have its token"
    TOKEN_WRONG = "this token is not that of the studio which runs now"


@dataclass(frozen=True, slots=True)
class Asked:
    """What a request says of who asks.

    Attributes:
        hosts: the values of `Host`.
        origins: the values of `Origin`, none where a person opened the page.
        site: `Sec-Fetch-Site`, "" where the browser does not say.
        is_page: whether a page is opened, rather than something that a page loads.
        is_socket: whether a WebSocket is opened.
        cookie: the value of the cookie.
    """

    hosts: Sequence[str]
    origins: Sequence[str] = ()
    site: str = ""
    is_page: bool = False
    is_socket: bool = False
    cookie: str | None = None


class Access:
    """The keys and the names of one run of the server.

    Attributes:
        token: what the URL has that opens the studio.
        cookie: what a browser has that came in by the token.
        cookie_name: it has the port in it, because cookies of one host are shared by its ports.
    """

    def __init__(self, host: str, port: int) -> None:
        self.token = secrets.token_urlsafe(32)
        self.cookie = secrets.token_urlsafe(32)
        self.cookie_name = f"plastron-{port}"
        self._host = _canonical(host)
        self._is_any = is_any_address(host)
        names = {self._host}
        if self._is_any or is_loopback(host):
            names.update(_LOOPBACK_NAMES)
        if self._is_any:
            names.update(_machine_names())
        self._names = names

    def refusal(self, asked: Asked) -> Refusal | None:
        """Return why a request is refused, None when it is not."""
        if not self.is_own_address(asked.hosts):
            return Refusal.HOST
        if not self._is_own_page(asked):
            return Refusal.ORIGIN
        if asked.cookie is None:
            return Refusal.TOKEN_MISSING
        return None if _same(asked.cookie, self.cookie) else Refusal.TOKEN_WRONG

    def has_token(self, asked: Asked, token: str) -> bool:
        """Tell whether a request comes in by the token: whoever follows the URL may."""
        return (
            self.is_own_address(asked.hosts)
            and not asked.is_socket
            and self._is_own_page(asked)
            and _same(token, self.token)
        )

    def is_own_address(self, hosts: Sequence[str]) -> bool:
        """Tell whether `Host` is there once, and names this server.

        Where every address of the machine is served, its addresses are not all known: a number
        is as good as another, since only names can be made to lead elsewhere. The port is that of
        the browser's end, which a tunnel may have changed: a page of another port is told by its
        `Origin`, which has to be of this `Host`.
        """
        if len(hosts) != 1 or (place := _place(hosts[0])) is None:
            return False
        name, _ = place
        return name in self._names or (self._is_any and _is_number(name))

    def _is_own_page(self, asked: Asked) -> bool:
        if asked.origins or asked.is_socket:
            return [_origin(one) for one in asked.origins] == [_place(asked.hosts[0])]
        return asked.is_page or asked.site in ("", "same-origin", "none")


def url(host: str, port: int, token: str = "") -> str:
    """Return the URL of a studio that is served."""
    name = f"[{host}]" if ":" in host else host
    place = name if port == _HTTP_PORT else f"{name}:{port}"
    return f"http://{place}/" + (f"?token={token}" if token else "")


def is_loopback(host: str) -> bool:
    """Tell whether an address to listen on lets in nobody but this machine."""
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return host.lower() == "localhost"


def is_any_address(host: str) -> bool:
    """Tell whether it stands for all addresses of the machine: `0.0.0.0` or `::`."""
    try:
        return ip_address(host).is_unspecified
    except ValueError:
        return False


def _machine_names() -> set[str]:
    name = socket.gethostname().lower()
    return {name, f"{name}.local"}


def _place(authority: str) -> tuple[str, int] | None:
    """Return the host and the port of `Host`, None where it is no such thing."""
    match = _AUTHORITY.fullmatch(authority.lower())
    if match is None:
        return None
    return _canonical(match["ipv6"] or match["name"]), int(match["port"] or _HTTP_PORT)


def _origin(value: str) -> tuple[str, int] | None:
    """Return the host and the port of an origin, None for another scheme and for `null`."""
    scheme, _, authority = value.partition("://")
    return _place(authority) if scheme.lower() == "http" else None


def _canonical(host: str) -> str:
    try:
        address = ip_address(host)
    except ValueError:
        return host.lower()
    mapped = address.ipv4_mapped if isinstance(address, IPv6Address) else None
    return str(mapped or address)


def _is_number(host: str) -> bool:
    try:
        ip_address(host)
    except ValueError:
        return False
    return True


def _same(given: str, wanted: str) -> bool:
    return hmac.compare_digest(given.encode("utf-8", "surrogatepass"), wanted.encode())
