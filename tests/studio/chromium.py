"""Chromium without a window, by its debugging protocol; and a server of the studio."""

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
async def running(*command: str, cwd: Path, said: Path | None = None) -> AsyncIterator[None]:
    """Run a program; what it says to standard error goes to a file."""
    with Path(said or "/dev/null").open("wb") as stderr:
        process = subprocess.Popen(
            command, cwd=cwd, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=stderr
        )
    try:
        yield
    finally:
        process.terminate()
        with suppress(subprocess.TimeoutExpired):
            process.wait(10)
        process.kill()
        process.wait()


@asynccontextmanager
async def served(folder: Path) -> AsyncIterator[str]:
    """Serve a new program in a folder, and give the URL that is printed."""
    (folder / "mine.plastron").touch()
    command = [sys.executable, "-m", "plastron_tui", "serve", "mine.plastron"]
    said = folder / "said"
    async with running(*command, "--port", str(free_port()), cwd=folder, said=said):
        for _ in range(600):
            if found := re.search(r"http://\S+\?token=\S+", said.read_text()):
                break
            await asyncio.sleep(0.1)
        else:
            raise AssertionError(f"no URL is printed: {said.read_text()}")
        yield found.group()


class Page:
    """A tab of Chromium.

    Attributes:
        received: what the terminal in it was sent, without colours and motions.
        asked: the URLs that it asked for.
    """

    def __init__(self, socket_: Any) -> None:
        self._socket = socket_
        self._number = 0
        self.received = ""
        self.asked: list[str] = []

    async def call(self, method: str, **params: Any) -> dict[str, Any]:
        """Do something, and wait until it is done."""
        self._number += 1
        await self._socket.send_json({"id": self._number, "method": method, "params": params})
        while (event := await self._event()).get("id") != self._number:
            pass
        result: dict[str, Any] = event.get("result", {})
        return result

    async def value(self, expression: str) -> Any:
        """Return the value of an expression of JavaScript, None while a page is being left."""
        done = await self.call(
            "Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True
        )
        return done.get("result", {}).get("value")

    async def text(self, part: str) -> str:
        """Wait until the page shows a text, and return all that it shows."""
        for _ in range(600):
            shown = str(await self.value("document.body ? document.body.innerText : ''") or "")
            if part in shown:
                return shown
            await asyncio.sleep(0.05)
        raise AssertionError(f"the page does not show {part!r}")

    async def open(self, url: str) -> None:
        await self.call("Page.navigate", url=url)

    async def until(self, text: str) -> None:
        """Wait until the terminal in the page was sent a text."""
        while text not in self.received:
            await self._event()

    async def _event(self) -> dict[str, Any]:
        event: dict[str, Any] = await asyncio.wait_for(self._socket.receive_json(), 60)
        if event.get("method") == "Network.webSocketFrameReceived":
            frame = event["params"]["response"]
            data = frame["payloadData"]
            if frame["opcode"] == 2:
                data = base64.b64decode(data).decode("utf-8", "replace")
            self.received += re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", data)
        if event.get("method") == "Network.requestWillBeSent":
            self.asked.append(event["params"]["request"]["url"])
        if event.get("method") == "Network.webSocketCreated":
            self.asked.append(event["params"]["url"])
        return event


@asynccontextmanager
async def browser(folder: Path) -> AsyncIterator[Page]:
    """Start Chromium, in which every name leads to this machine."""
    debug = free_port()
    command = [
        str(CHROMIUM), "--headless", "--no-sandbox", "--disable-gpu",
        f"--remote-debugging-port={debug}", "--remote-allow-origins=*",
        "--host-resolver-rules=MAP * 127.0.0.1",
        f"--user-data-dir={folder / 'browser'}", "about:blank",
    ]  # fmt: skip
    async with running(*command, cwd=folder), aiohttp.ClientSession() as session:
        tabs = await _answer(session, f"http://127.0.0.1:{debug}/json")
        url = next(tab for tab in tabs if tab["type"] == "page")["webSocketDebuggerUrl"]
        async with session.ws_connect(url, max_msg_size=0) as socket_:
            page = Page(socket_)
            await page.call("Network.enable")
            yield page


async def _answer(session: Any, url: str) -> Any:
    for _ in range(600):
        with suppress(aiohttp.ClientError):
            async with session.get(url) as response:
                return await response.json(content_type=None)
        await asyncio.sleep(0.1)
    raise AssertionError(f"{url} does not answer")
