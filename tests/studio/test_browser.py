"""The studio in a browser: textual-serve on loopback, Chromium without a window."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from chromium import CHROMIUM, browser, served
from machine import free_port

pytest.importorskip("aiohttp", reason="the extra [web] is not installed")
from aiohttp import web

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium")

# What a page tries: to draw from the socket, to read the page, and to have its script.
ATTACK = """\
(async () => {
  const socket = new Promise((done) => {
    const socket = new WebSocket("ws://PLACE/ws?width=80&height=24");
    socket.onopen = () => done("open");
    socket.onerror = () => done("refused");
  });
  const read = fetch("http://PLACE/", {credentials: "include"})
    .then((answer) => answer.status, () => "refused");
  const script = new Promise((done) => {
    const script = document.createElement("script");
    script.src = "http://PLACE/static/js/textual.js";
    script.onload = () => done("loaded");
    script.onerror = () => done("refused");
    document.head.append(script);
  });
  return (await Promise.all([socket, read, script])).join(" ");
})()
"""


@asynccontextmanager
async def another_site(body: str) -> AsyncIterator[int]:
    """Serve a page of somebody else's, and give its port."""

    async def page(_: web.Request) -> web.Response:
        return web.Response(text=f"<body>{body}</body>", content_type="text/html")

    application = web.Application()
    application.add_routes([web.get("/", page)])
    runner = web.AppRunner(application)
    await runner.setup()
    port = free_port()
    await web.TCPSite(runner, "127.0.0.1", port).start()
    try:
        yield port
    finally:
        await runner.cleanup()


async def test_a_statement_typed_in_a_browser_shows_its_node(tmp_path: Path) -> None:
    async with served(tmp_path) as url, browser(tmp_path) as page:
        await page.open(url)
        await page.until("no nodes yet")
        await page.value("document.querySelector('textarea').focus()")
        page.received = ""
        for character in "create_node 'arm' as arm":
            await page.call("Input.insertText", text=character)
        await page.until("does nothing")
        assert "arm" in page.received
        assert await page.value("document.fonts.check(\"16px 'Roboto Mono'\")")

        assert await page.value("location.href") == f"http://{urlsplit(url).netloc}/"
        assert await page.value("history.length") == 2  # with about:blank
        assert await page.value("document.cookie") == ""
        places = {urlsplit(asked) for asked in page.asked}
        assert {place.netloc for place in places if place.scheme != "data"} == {
            urlsplit(url).netloc
        }


@pytest.mark.long
async def test_without_the_token_a_browser_is_told_why(tmp_path: Path) -> None:
    async with served(tmp_path) as url, browser(tmp_path) as page:
        parts = urlsplit(url)
        await page.open(f"http://{parts.netloc}/")
        shown = await page.text("Refused")
        assert "only for those who have its token" in shown
        assert "Open the URL that plastron serve wrote in its terminal" in shown
        await page.open(f"http://{parts.netloc}/?token=wrong")
        await page.text("this token is not that of the studio which runs now")
        await page.value(f"document.querySelector('input').value = '{parts.query[6:]}'")
        await page.value("document.querySelector('form').submit()")
        await page.until("no nodes yet")


@pytest.mark.long
async def test_other_pages_in_the_browser_stay_out(tmp_path: Path) -> None:
    async with (
        served(tmp_path) as url,
        browser(tmp_path) as page,
        another_site(f"<p>a site</p><a href='{url}'>to the studio</a>") as port,
    ):
        parts = urlsplit(url)
        # From a link on another site the token works: a terminal may be in a page.
        await page.open(f"http://evil.example:{port}/")
        await page.text("a site")
        await page.value("document.querySelector('a').click()")
        await page.until("no nodes yet")
        assert await page.value("location.search") == ""
        # The browser has the cookie from now on.
        for site in (f"evil.example:{port}", f"127.0.0.1:{port}"):
            await page.open(f"http://{site}/")
            await page.text("a site")
            tried = await page.value(ATTACK.replace("PLACE", parts.netloc))
            assert tried == "refused refused refused"
        # A name that leads here is no name of this server's (DNS rebinding).
        await page.open(f"http://evil.example:{parts.port}/?{parts.query}")
        assert f"http://127.0.0.1:{parts.port}/" in await page.text("none that this studio")


def test_it_listens_on_this_machine_only_unless_told() -> None:
    from plastron_tui.cli.serve import command

    (host,) = [parameter for parameter in command.params if parameter.name == "host"]
    assert host.default == "127.0.0.1"
