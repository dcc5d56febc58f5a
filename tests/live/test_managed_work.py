"""Managed nodes that ask others and work for them: they do so while they are active, and only then.

What they talk to (`peer_rclpy.py`, `probe_ros2.py`) knows nothing of Plastron.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from graph import Graph, is_rate, rate_of
from machine import wait_until
from processes import Process, generate_one, own_tracebacks
from test_goals import FEEDBACK, GOAL, RESULT, TYPE, end, outcomes, peer, send, serve, times, told

pytestmark = [pytest.mark.live, pytest.mark.long]

NAME = "worker"
PARTS = {
    "once": "node client_requests 'enable_motor' of service_type SetBool with input True\n",
    "again": "node client_requests 'ready' of service_type Trigger with input none at 5 hz\n",
    "goal": "node sends_goal to 'count' of action_type Fibonacci with input order=5\n",
    "server": "node provides_action 'count' of action_type Fibonacci\n",
}
