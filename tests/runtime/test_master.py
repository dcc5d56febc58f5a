"""Which master a run uses, as far as nothing has to be started for it."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.ros.installations import Origin
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.master import ensure_master
from plastron_tui.runtime.supervisor import Supervisor


@pytest.mark.parametrize("network", [False, True])
@pytest.mark.parametrize(
    "uri",
    [
        "localhost", "http://", " ", "http://[::1", "http://127.0.0.1:0", "http://127.0.0.1:99999",
        "http://127.0.0.1:one",
    ],
)  # fmt: skip
def test_what_is_no_address_is_a_diagnostic(uri: str, network: bool) -> None:
    environment = Environment(Origin.DEBIAN, 1, "noetic", Path("/usr/bin/python3"))
    master, found = ensure_master(
        Supervisor(lambda _, __: None),
        environment,
        ["talker"],
        network=network,
        environ={"ROS_MASTER_URI": uri},
    )
    assert master is None
    assert [each.code for each in found] == ["no-master"]
    assert found[0].message == f"ROS_MASTER_URI is no address of a master: {uri}"
