"""Fills in templates in this process: what is in them counts, not the process that has limits."""

from __future__ import annotations

import io
import sys
from types import SimpleNamespace

import pytest

from plastron_tui.limited_process import Limits, Reply
from plastron_tui.targets import template_process


def render_here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let what the process of a template does be done here, with the same request and reply."""

    def answer(start: str, request: bytes, limits: Limits) -> Reply:
        output = io.BytesIO()
        with pytest.MonkeyPatch.context() as here:
            here.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(request)))
            here.setattr(sys, "stdout", SimpleNamespace(buffer=output))
            here.setattr(template_process, "limit_itself", lambda _: None)
            status = template_process.main()
        return Reply(status, output.getvalue())

    monkeypatch.setattr(template_process, "run_limited", answer)
