"""The server of the studio in the test's own process, on loopback."""

from __future__ import annotations

import gc
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest
from machine import free_port

pytest.importorskip("textual_serve", reason="the extra [web] is not installed")

from aiohttp import web

from plastron_tui.web.server import StudioServer

ECHO_TERMINAL = """\
import os, sys
names = ("TERM", "COLORTERM", "TEXTUAL_COLOR_SYSTEM")
said = " ".join(os.environ.get(name, "-") for name in names).encode()
sys.stdout.buffer.write(b"__GANGLION__\\nD" + len(said).to_bytes(4, "big") + said)
sys.stdout.flush()
sys.stdin.buffer.read(1)
"""
"""An app in the protocol of Textual's web driver, which shows what terminal it is told of."""


@asynccontextmanager
async def serving(
    host: str = "127.0.0.1", *, is_shown: bool = False
) -> AsyncIterator[StudioServer]:
    """Serve at a port that is free; the address listened on is that of loopback in any case.

    Args:
        host: the address that the server takes for its own.
        is_shown: whether a page opens its socket, for which a process is started.
    """
    port = free_port()
    server = StudioServer([sys.executable, "-c", ECHO_TERMINAL], host, port)
    runner = web.AppRunner(server.application(), access_log=None)
    await runner.setup()
    try:
        await web.TCPSite(runner, "127.0.0.1", port).start()
        yield server
    finally:
        await runner.cleanup()
        # textual-serve leaves the pipes of its processes to the collector, which is too late
        # when the loop is closed. After thousands of tests it has far to walk.
        if is_shown:
            gc.collect()
