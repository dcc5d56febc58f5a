"""The studio in a browser: textual-serve on loopback, Chromium without a window."""

from __future__ import annotations

import asyncio
import base64
import re
import shutil
import subprocess
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any

import pytest
from machine import free_port

aiohttp = pytest.importorskip("aiohttp", reason="the extra [web] is not installed")
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")


@asynccontextmanager
async def running(*command: str, cwd: Path) -> AsyncIterator[None]:
    process = subprocess.Popen(
        command, cwd=cwd, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )  # fmt: skip
    try:
        yield
    finally:
        process.terminate()
        with suppress(subprocess.TimeoutExpired):
            process.wait(10)
        process.kill()


async def answer(session: Any, url: str) -> Any:
    for _ in range(200):
        with suppress(aiohttp.ClientError):
            async with session.get(url) as response:
                return await response.json(content_type=None) if "json" in url else True
        await asyncio.sleep(0.1)
    raise AssertionError(f"{url} does not answer")


class Page:
    """A tab of Chromium, by its debugging protocol."""

    def __init__(self, socket_: Any) -> None:
        self._socket = socket_
        self._number = 0
        self.received = ""

    async def call(self, method: str, **params: Any) -> None:
        """Do something, and wait until it is done."""
        self._number += 1
        await self._socket.send_json({"id": self._number, "method": method, "params": params})
        while (await self._event()).get("id") != self._number:
            pass

    async def _event(self) -> dict[str, Any]:
        event: dict[str, Any] = await asyncio.wait_for(self._socket.receive_json(), 30)
        if event.get("method") == "Network.webSocketFrameReceived":
            frame = event["params"]["response"]
            data = frame["payloadData"]
            if frame["opcode"] == 2:
                data = base64.b64decode(data).decode("utf-8", "replace")
            self.received += re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", data)
        return event

    async def until(self, text: str) -> None:
        """Wait until the terminal in the page was sent a text."""
        while text not in self.received:
            await self._event()


@pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium")
async def test_a_statement_typed_in_a_browser_shows_its_node(tmp_path: Path) -> None:
    port, debug = free_port(), free_port()
    (tmp_path / "mine.plastron").touch()
    server = [sys.executable, "-m", "plastron_tui", "serve", "mine.plastron", "--port", str(port)]
    browser = [
        str(CHROMIUM), "--headless", "--no-sandbox", "--disable-gpu",
        f"--remote-debugging-port={debug}", "--remote-allow-origins=*",
        f"--user-data-dir={tmp_path / 'browser'}", "about:blank",
    ]  # fmt: skip
    async with (
        running(*server, cwd=tmp_path),
        aiohttp.ClientSession() as session,
        running(*browser, cwd=tmp_path),
    ):
        await answer(session, f"http://127.0.0.1:{port}/")
        tabs = await answer(session, f"http://127.0.0.1:{debug}/json")
        url = next(tab for tab in tabs if tab["type"] == "page")["webSocketDebuggerUrl"]
        async with session.ws_connect(url, max_msg_size=0) as socket_:
            page = Page(socket_)
            await page.call("Network.enable")
            await page.call("Page.navigate", url=f"http://127.0.0.1:{port}/")
            await page.until("no nodes yet")
            await page.call(
                "Runtime.evaluate", expression="document.querySelector('textarea').focus()"
            )
            page.received = ""
            for character in "create_node 'arm' as arm":
                await page.call("Input.insertText", text=character)
            await page.until("does nothing")
            assert "arm" in page.received


def test_it_listens_on_this_machine_only_unless_told() -> None:
    from plastron_tui.cli.serve import command

    (host,) = [parameter for parameter in command.params if parameter.name == "host"]
    assert host.default == "127.0.0.1"
