"""The server of the studio: textual-serve's terminal in a page, behind a check of who asks.

The application is put together here, so that no route of textual-serve is without the check;
of its server only the handlers of the WebSocket and of downloads are used, and its files.
"""

from __future__ import annotations

import shlex
from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path

import textual_serve
from aiohttp import hdrs, web
from textual_serve.server import Server

from . import pages
from .access import Access, Asked, Refusal, url

_STATIC = Path(textual_serve.__file__).with_name("static")
_OWN = Path(__file__).with_name("static")
_FONT_SIZES = range(6, 73)
_FONT_SIZE = 16
_PATIENCE = 2.0
"""Seconds that open pages have at the end, before their studios are told to quit."""

# The terminal is the browser's, whatever the one is that the server was started in.
_TERMINAL = {"TERM": "xterm-256color", "COLORTERM": "truecolor"}

_HEADERS = {
    # xterm.js makes style elements, and nothing else needs more than what lies here.
    "Content-Security-Policy": (
        "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; "
        "font-src 'self'; img-src 'self' data:; connect-src 'self' {socket}; "
        "base-uri 'none'; form-action 'self'; frame-ancestors 'none'"
    ),
    "Cache-Control": "no-store",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}

_Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


class StudioServer(Server):
    """Serves a command that shows a Textual app, to whoever has the token.

    Attributes:
        access: who may come in.
    """

    def __init__(self, command: Sequence[str], host: str, port: int) -> None:
        """Take what is served, and where.

        Args:
            command: the program and its arguments; started anew for each page.
            host: the address to listen on.
            port: its port.
        """
        terminal = " ".join(f"{name}={value}" for name, value in _TERMINAL.items())
        super().__init__(f"{terminal} {shlex.join(command)}", host=host, port=port)
        self.access = Access(host, port)

    def application(self) -> web.Application:
        """Return the application, in which every request passes the check."""

        @web.middleware
        async def check(request: web.Request, handler: _Handler) -> web.StreamResponse:
            return await self._checked(request, handler)

        application = web.Application(middlewares=[check])
        application.on_response_prepare.append(self._add_headers)
        application.add_routes(
            [
                web.get("/", self.handle_index),
                web.get("/ws", self.handle_websocket),
                web.get("/download/{key}", self.handle_download),
                web.static("/static", _STATIC),
                web.static("/own", _OWN),
            ]
        )
        return application

    def run(self, on_start: Callable[[], None]) -> None:
        """Serve until Ctrl-C.

        Args:
            on_start: called once, when the server listens.

        Raises:
            OSError: nobody can listen there.
        """
        # The log of requests would have the token in it, and what strangers send.
        web.run_app(
            self.application(),
            host=self.host,
            port=self.port,
            access_log=None,
            shutdown_timeout=_PATIENCE,
            print=lambda *_: on_start(),
        )

    async def handle_index(self, request: web.Request) -> web.Response:
        """Show the terminal; the WebSocket is at the address that the page was opened at."""
        size = request.query.get("fontsize", "")
        is_size = size.isdecimal() and len(size) < 3 and int(size) in _FONT_SIZES
        page = pages.studio(f"{_socket(request)}/ws", int(size) if is_size else _FONT_SIZE)
        return web.Response(text=page, content_type="text/html")

    async def _checked(self, request: web.Request, handler: _Handler) -> web.StreamResponse:
        """Let in who may come in, and say to others why they may not."""
        asked = _asked(request, self.access.cookie_name)
        token = request.query.get("token")
        if request.path == "/" and token is not None and self.access.has_token(asked, token):
            return self._welcome(request)
        refusal = self.access.refusal(asked)
        if refusal is Refusal.TOKEN_MISSING and token is not None:
            refusal = Refusal.TOKEN_WRONG
        if refusal is not None:
            page = pages.refused(refusal, url(self.host, self.port))
            return web.Response(status=403, text=page, content_type="text/html")
        return await handler(request)

    def _welcome(self, request: web.Request) -> web.Response:
        """Give the cookie, and go on at a URL that does not have the token.

        From a link on another site a browser follows a redirect without a cookie that is
        `SameSite=Strict`, but a page's own refresh with it.
        """
        rest = {name: value for name, value in request.query.items() if name != "token"}
        target = str(request.rel_url.with_query(rest))
        if request.headers.get("Sec-Fetch-Site") in ("cross-site", "same-site"):
            response = web.Response(text=pages.moving_on(target), content_type="text/html")
        else:
            response = web.Response(status=303, headers={hdrs.LOCATION: target})
        response.set_cookie(
            self.access.cookie_name, self.access.cookie, httponly=True, samesite="Strict"
        )
        return response

    async def _add_headers(self, request: web.Request, response: web.StreamResponse) -> None:
        is_own = self.access.is_own_address(request.headers.getall(hdrs.HOST, []))
        socket = _socket(request) if is_own else ""
        for name, value in _HEADERS.items():
            response.headers[name] = value.format(socket=socket)


def _socket(request: web.Request) -> str:
    return f"ws://{request.headers[hdrs.HOST]}"


def _asked(request: web.Request, cookie_name: str) -> Asked:
    return Asked(
        hosts=request.headers.getall(hdrs.HOST, []),
        origins=request.headers.getall(hdrs.ORIGIN, []),
        site=request.headers.get("Sec-Fetch-Site", ""),
        is_page=request.headers.get("Sec-Fetch-Mode") == "navigate",
        is_socket=hdrs.UPGRADE in request.headers or request.path == "/ws",
        cookie=request.cookies.get(cookie_name),
    )
