"""Who is let in by the server of the studio: a script that lies about who it is."""

from __future__ import annotations

import asyncio
import re
from typing import NamedTuple

import aiohttp
import pytest
from web_server import serving

from plastron_tui.web.server import StudioServer

LOOPBACK = "127.0.0.1"


class Case(NamedTuple):
    """A request, with `{port}`, `{token}` and `{cookie}` in its parts; what comes back."""

    name: str
    status: int
    path: str = "/"
    headers: tuple[tuple[str, str], ...] = ()
    cookie: str = ""
    says: str = ""
    host: str = LOOPBACK


OWN = "http://127.0.0.1:{port}"
MINE = "plastron-{port}={cookie}"
NO_TOKEN, BAD_TOKEN = "only for those who have its token", "not that of the studio"
BAD_HOST, BAD_ORIGIN = "none that this studio is served at", "of another origin"

PAGES = [
    Case("nothing to show", 403, says=NO_TOKEN),
    Case("the token", 303, "/?token={token}"),
    Case("the token, from a link on another site", 200, "/?token={token}",
         (("Sec-Fetch-Site", "cross-site"), ("Sec-Fetch-Mode", "navigate"))),
    Case("the cookie", 200, cookie=MINE),
    Case("the cookie, among others", 200, cookie="a=b; " + MINE + "; plastron-1=x"),
    Case("a wrong token", 403, "/?token=wrong", says=BAD_TOKEN),
    Case("a token that is no text", 403, "/?token=%ed%a0%80%ff", says=BAD_TOKEN),
    Case("an empty token", 403, "/?token=", says=BAD_TOKEN),
    Case("the cookie as a token", 403, "/?token={cookie}", says=BAD_TOKEN),
    Case("the token as a cookie", 403, cookie="plastron-{port}={token}", says=BAD_TOKEN),
    Case("the cookie of an earlier run", 403, cookie="plastron-{port}=earlier", says=BAD_TOKEN),
    Case("the cookie of another port", 403, cookie="plastron-1={cookie}", says=NO_TOKEN),
    Case("the token where it is not taken", 403, "/ws?token={token}", says=BAD_ORIGIN),
    Case("the token with a file", 403, "/static/js/textual.js?token={token}", says=BAD_TOKEN),
    Case("localhost", 200, headers=(("Host", "localhost:{port}"),), cookie=MINE),
    Case("LOCALHOST", 200, headers=(("Host", "LOCALHOST:{port}"),), cookie=MINE),
    Case("IPv6", 200, headers=(("Host", "[::1]:{port}"),), cookie=MINE),
    Case("IPv6 at length", 200, headers=(("Host", "[0:0:0:0:0:0:0:1]:{port}"),), cookie=MINE),
    Case("a name that leads here", 403, headers=(("Host", "evil.example:{port}"),), cookie=MINE,
         says=BAD_HOST),
    Case("such a name with the token", 403, "/?token={token}",
         (("Host", "evil.example:{port}"),), says=BAD_HOST),
    Case("a name that begins well", 403, headers=(("Host", "localhost.evil.example:{port}"),),
         cookie=MINE, says=BAD_HOST),
    Case("a name with a user in it", 403, headers=(("Host", "localhost:{port}@evil.example"),),
         cookie=MINE, says=BAD_HOST),
    Case("another number", 403, headers=(("Host", "192.168.1.1:{port}"),), cookie=MINE,
         says=BAD_HOST),
    # A tunnel's other end may have another port.
    Case("another port", 200, headers=(("Host", "127.0.0.1:1"),), cookie=MINE),
    Case("no port", 200, headers=(("Host", "127.0.0.1"),), cookie=MINE),
    Case("another port, a page of it", 200, cookie=MINE,
         headers=(("Host", "127.0.0.1:1"), ("Origin", "http://127.0.0.1:1"))),
    Case("another port, a page of this one", 403, cookie=MINE, says=BAD_ORIGIN,
         headers=(("Host", "127.0.0.1:1"), ("Origin", OWN))),
    Case("another port of a name that leads here", 403, cookie=MINE, says=BAD_HOST,
         headers=(("Host", "evil.example:1"), ("Origin", "http://evil.example:1"))),
    Case("a port of 5,000 digits", 403, headers=(("Host", "localhost:" + "1" * 5000),),
         cookie=MINE, says=BAD_HOST),
    Case("a port of other digits", 403, headers=(("Host", "localhost:\u0661"),), cookie=MINE,
         says=BAD_HOST),
    Case("an origin of 5,000 digits", 403, cookie=MINE, says=BAD_ORIGIN,
         headers=(("Origin", "http://localhost:" + "1" * 5000),)),
    Case("two hosts", 400, headers=(("Host", "127.0.0.1:{port}"), ("Host", "evil.example")),
         cookie=MINE),
    Case("an empty host", 403, headers=(("Host", ""),), cookie=MINE, says=BAD_HOST),
    Case("its own origin", 200, headers=(("Origin", OWN),), cookie=MINE),
    Case("another origin", 403, headers=(("Origin", "http://evil.example"),), cookie=MINE,
         says=BAD_ORIGIN),
    Case("another origin with the token", 403, "/?token={token}",
         (("Origin", "http://evil.example"),)),
    Case("the origin of another port", 403, headers=(("Origin", "http://127.0.0.1:1"),),
         cookie=MINE, says=BAD_ORIGIN),
    Case("its own names mixed", 403, headers=(("Origin", "http://localhost:{port}"),),
         cookie=MINE, says=BAD_ORIGIN),
    Case("the origin of a page without one", 403, headers=(("Origin", "null"),), cookie=MINE,
         says=BAD_ORIGIN),
    Case("an https origin", 403, headers=(("Origin", "https://127.0.0.1:{port}"),), cookie=MINE,
         says=BAD_ORIGIN),
    Case("a picture on another site", 403, headers=(("Sec-Fetch-Site", "cross-site"),),
         cookie=MINE, says=BAD_ORIGIN),
    Case("a picture from another port", 403, headers=(("Sec-Fetch-Site", "same-site"),),
         cookie=MINE, says=BAD_ORIGIN),
    Case("a file without the cookie", 403, "/static/js/textual.js", says=NO_TOKEN),
    Case("a file", 200, "/static/js/textual.js", cookie=MINE),
    Case("a file of Plastron's", 200, "/own/studio.css", cookie=MINE),
    Case("a file beside them", 404, "/own/%2e%2e/server.py", cookie=MINE),
    Case("a list of files", 403, "/static/", cookie=MINE),
    Case("a download without the cookie", 403, "/download/x", says=NO_TOKEN),
    Case("a download that is none", 404, "/download/x", cookie=MINE),
    Case("what is not there, without the cookie", 403, "/x", says=NO_TOKEN),
    Case("any address: a number", 200, headers=(("Host", "192.168.1.1:{port}"),), cookie=MINE,
         host="0.0.0.0"),
    Case("any address: localhost", 200, headers=(("Host", "localhost:{port}"),), cookie=MINE,
         host="::"),
    Case("any address: a name", 403, headers=(("Host", "evil.example:{port}"),), cookie=MINE,
         says=BAD_HOST, host="0.0.0.0"),
    Case("any address: no token", 403, headers=(("Host", "192.168.1.1:{port}"),),
         says=NO_TOKEN, host="0.0.0.0"),
    Case("one address: a name of this machine", 403, headers=(("Host", "localhost:{port}"),),
         cookie=MINE, says=BAD_HOST, host="192.168.1.1"),
]  # fmt: skip


def filled(text: str, keys: dict[str, str]) -> str:
    return re.sub(r"\{(port|token|cookie)\}", lambda match: keys[match[1]], text)


@pytest.mark.parametrize("host", sorted({case.host for case in PAGES}))
async def test_requests(host: str) -> None:
    async with serving(host) as server:
        for case in PAGES:
            if case.host == host:
                await check_request(server, case)


async def check_request(server: StudioServer, case: Case) -> None:
    access = server.access
    keys = {"port": str(server.port), "token": access.token, "cookie": access.cookie}
    lines = [f"GET {filled(case.path, keys)} HTTP/1.1", "Connection: close"]
    headers = dict(case.headers)
    lines += [f"Host: 127.0.0.1:{server.port}"] if "Host" not in headers else []
    lines += [f"{name}: {filled(value, keys)}" for name, value in case.headers]
    lines += [f"Cookie: {filled(case.cookie, keys)}"] if case.cookie else []
    head, body = await exchange(server.port, lines)
    assert int(head.split()[1]) == case.status, (case.name, head)
    assert case.says in body, case.name
    if case.status == 403 and case.says:
        assert "evil" not in body, case.name
    if case.status == 403:
        assert access.cookie not in head + body, case.name
        assert access.token not in head + body, case.name
    if case.status != 400:
        assert "frame-ancestors 'none'" in head, case.name
        assert "Referrer-Policy: no-referrer" in head, case.name


async def exchange(port: int, lines: list[str]) -> tuple[str, str]:
    """Send a request as it is written, and return the head and the body of the answer."""
    reader, writer = await asyncio.open_connection(LOOPBACK, port)
    writer.write("\r\n".join([*lines, "", ""]).encode())
    answer = (await reader.read()).decode("utf-8", "replace")
    writer.close()
    head, _, body = answer.partition("\r\n\r\n")
    return head, body


SOCKETS = [
    ("the page's own", 101, OWN, MINE),
    ("without a cookie", 403, OWN, ""),
    ("with the cookie of an earlier run", 403, OWN, "plastron-{port}=earlier"),
    ("from another site", 403, "http://evil.example", MINE),
    ("from another port", 403, "http://127.0.0.1:1", MINE),
    ("from a page without an origin", 403, "null", MINE),
    ("from something that is no page", 403, "", MINE),
]


@pytest.mark.parametrize(
    ("name", "status", "origin", "cookie"), SOCKETS, ids=lambda part: str(part)
)
async def test_a_web_socket(name: str, status: int, origin: str, cookie: str) -> None:
    is_let_in = status == 101
    async with serving(is_shown=is_let_in) as server, aiohttp.ClientSession() as session:
        access = server.access
        keys = {"port": str(server.port), "token": access.token, "cookie": access.cookie}
        headers = {"Origin": filled(origin, keys), "Cookie": filled(cookie, keys)}
        given = {name: value for name, value in headers.items() if value}
        address = f"ws://127.0.0.1:{server.port}/ws"
        if not is_let_in:
            for query in ("", f"?token={access.token}"):
                with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
                    await session.ws_connect(address + query, headers=given)
                assert refused.value.status == status
            return
        async with session.ws_connect(address, headers=given) as socket:
            assert await socket.receive_bytes()


@pytest.mark.parametrize("term", ["linux", "dumb", ""])
async def test_the_terminal_is_the_browsers(term: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", term)
    monkeypatch.delenv("COLORTERM", raising=False)
    async with serving(is_shown=True) as server, aiohttp.ClientSession() as session:
        own = f"http://127.0.0.1:{server.port}"
        headers = {"Origin": own, "Cookie": f"{server.access.cookie_name}={server.access.cookie}"}
        async with session.ws_connect(f"{own}/ws", headers=headers) as socket:
            assert await socket.receive_bytes() == b"xterm-256color truecolor truecolor"


async def test_the_cookie_of_a_token() -> None:
    async with serving() as server:
        access = server.access
        lines = [
            f"GET /?token={access.token}&fontsize=20 HTTP/1.1",
            f"Host: localhost:{server.port}",
        ]
        head, _ = await exchange(server.port, [*lines, "Connection: close"])
        (cookie,) = [line for line in head.splitlines() if line.startswith("Set-Cookie:")]
        assert cookie.startswith(f"Set-Cookie: plastron-{server.port}={access.cookie};")
        assert {"HttpOnly", "SameSite=Strict", "Path=/"} <= set(cookie.split("; "))
        assert "Location: /?fontsize=20" in head.splitlines()
        assert access.token not in head


async def test_the_page_names_no_other_host() -> None:
    async with serving() as server:
        own = f"127.0.0.1:{server.port}"
        for path in ("/", "/own/studio.css", "/own/studio.js", "/static/css/xterm.css"):
            lines = [f"GET {path} HTTP/1.1", f"Host: {own}", "Connection: close"]
            lines.append(f"Cookie: {server.access.cookie_name}={server.access.cookie}")
            head, body = await exchange(server.port, lines)
            assert " 200 " in head.splitlines()[0]
            loaded = re.findall(r"(?:https?|wss?)://[^\s\"']+|url\(([^)]*)\)", body)
            assert not {one for one in loaded if one and "/static/" not in one}
            named = set(re.findall(r"(?:https?|wss?)://([^\s/\"']+)", body))
            assert named <= {own, "github.com", "bellard.org"}  # the latter in a licence
            assert f"connect-src 'self' ws://{own};" in head
