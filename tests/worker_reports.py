"""What the workers of a run tell the process that started them: of most tests only the result.

Of each test a worker of xdist sends six messages, among them that it begins and ends, and how it
was set up and taken down. Where all of that went well nobody looks at it, and with twenty thousand
tests to pack and unpack it is a part of the time of them all.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest


def is_told(report: dict[str, Any]) -> bool:
    """Tell whether a report has something to say: a result, or that something went wrong."""
    return report.get("when") == "call" or report.get("outcome") != "passed"


class ShortReports:
    """Leaves out what goes well around the tests of a worker."""

    def __init__(self, config: pytest.Config) -> None:
        # How long each step took is asked for with `--durations`.
        self._send: Callable[..., None] | None = None
        self._leaves_out = config.getoption("durations", None) is None
        # This is private to xdist: a release that has it no more sends all, as ever.
        plugins = config.pluginmanager.get_plugins()
        interactors = [each for each in plugins if type(each).__name__ == "WorkerInteractor"]
        for each in interactors:
            self._send = getattr(each, "sendevent", None)
            if self._leaves_out and self._send is not None:
                each.sendevent = self._send_some

    def _send_some(self, name: str, **data: Any) -> None:
        is_left_out = name in ("logstart", "logfinish")
        if not is_left_out and (name != "testreport" or is_told(data["data"])):
            assert self._send is not None
            self._send(name, **data)

    @pytest.hookimpl(tryfirst=True)
    def pytest_report_to_serializable(self, report: object) -> dict[str, Any] | None:
        """Pack nothing of a report that is not sent."""
        if self._leaves_out and isinstance(report, pytest.TestReport):
            said = {"when": report.when, "outcome": report.outcome}
            return None if is_told(said) else said
        return None
