from __future__ import annotations

import os

import pytest
from hypothesis import settings

# On a developer's machine a test may lack what it needs, a ROS say, and says so by a skip. In CI
# everything is installed, and a skip would hide a failure.
IN_CI = os.environ.get("CI") == "true"


# How long an example takes says more about the machine than about the code.
settings.register_profile("plastron", deadline=None)
settings.load_profile("plastron")


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    reporter = session.config.pluginmanager.get_plugin("terminalreporter")
    if IN_CI and reporter is not None and reporter.stats.get("skipped"):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
