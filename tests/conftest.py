from __future__ import annotations

import gc
import os
import signal
from collections.abc import Generator, Iterator
from pathlib import Path

import pytest
from command_line import Copies, copies
from cpp_builds import describe_rclcpp
from hypothesis import settings
from long_modules import is_left_out, overlooked
from machine import IN_CI, be_quick, examples
from rewriting import compile_share
from suite_order import in_order, minutes
from watchdog import Watchdog
from worker_reports import ShortReports

from plastron_tui.ros import installations

# A shell starts what is in its background with SIGINT ignored, `nohup` with SIGHUP, and every
# program that the tests end by them would inherit it.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


# Readline says in the environment how large the terminal is that the tests were started in, and
# the workers would pass it on to programs that have terminals of their own.
for size in ("COLUMNS", "LINES"):
    os.environ.pop(size, None)


# A program that names no ROS is for the one that is here: to the tests that is Debian's ROS 1,
# whatever is sourced or installed on this machine. What talks to a real ROS sees the real ones.
@pytest.fixture(autouse=True)
def the_ros_that_is_here(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if request.node.get_closest_marker("live") is None:
        here = installations.Installation(installations.Origin.DEBIAN, 1, "noetic")
        monkeypatch.setattr(installations, "installed", lambda: (here,))
        for name in ("ROS_VERSION", "ROS_DISTRO", "ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"):
            monkeypatch.delenv(name, raising=False)


@pytest.fixture(scope="session")
def copied(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Copies]:
    """The process that plastron is run in copies of, for all tests."""
    with copies(tmp_path_factory.mktemp("copies")) as made:
        yield made


def pytest_report_header() -> str:
    return f"C++ nodes of ROS 2: compiled with {describe_rclcpp()}"


# How long an example takes says more about the machine than about the code. CI tries the same
# examples each time, so that what it says is about the change; new ones are tried at home.
# Without `long` tests each property is tried on fewer examples; with them only, on all.
def pytest_configure(config: pytest.Config) -> None:
    if "not long" in config.option.markexpr:
        be_quick()
    settings.register_profile(
        "plastron", deadline=None, derandomize=IN_CI, max_examples=examples(100)
    )
    settings.load_profile("plastron")
    config.pluginmanager.register(Watchdog(), "watchdog")
    if hasattr(config, "workerinput"):
        config.pluginmanager.register(ShortReports(config), "short_reports")


def pytest_sessionstart(session: pytest.Session) -> None:
    given = getattr(session.config, "workerinput", None)
    if given is not None:
        worker = int(given["workerid"].removeprefix("gw"))
        compile_share(session.config, worker, given["workercount"])


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    return True if config.option.markexpr == "long" and is_left_out(collection_path) else None


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(
    config: pytest.Config, items: list[pytest.Item]
) -> Generator[None, object, object]:
    is_long = config.option.markexpr == "long"
    for item in items if is_long else ():
        if getattr(getattr(item, "obj", None), "is_hypothesis_test", False):
            item.add_marker("long")
    if lost := overlooked(items):
        raise pytest.UsageError(f"what makes these long is not in long_modules.py: {lost}")
    result = yield
    # By now the others are left out.
    if is_long:
        workers = getattr(config, "workerinput", {}).get("workercount", 1)
        items[:] = in_order(items, workers, minutes, lambda item: item.location[0])
    return result


# Thousands of tests and all modules stay to the end: to walk among them again and again took half
# of the processor's time.
gc.set_threshold(200_000, 10, 10)
gc.disable()


def pytest_collection_finish() -> None:
    gc.freeze()
    gc.enable()


# In CI everything is installed, and a skip, whoever made it, would hide a failure.
@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    reporter = session.config.pluginmanager.get_plugin("terminalreporter")
    if IN_CI and reporter is not None and reporter.stats.get("skipped"):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
