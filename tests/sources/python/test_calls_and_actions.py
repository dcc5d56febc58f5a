"""What a loaded node asks of others, and does for them: it is written, read back, and taken out."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_nodes import FILES, loaded

from plastron_tui.model.source import EndpointKind
from plastron_tui.session import Session

CALM = "driver client_requests 'calm' of service_type Trigger with input none"
HELLO, HI = (
    f"create_message {name} of message_type Twist and input none\n"
    f"driver publish {name} to 'out' of message_type Twist"
    for name in ("hello", "hi")
)
GOAL = "driver sends_goal to 'fib' of action_type Fibonacci with input order=5"
STOP_GOAL = "driver stop_goal to 'fib'"
ACTION = "driver provides_action 'fib' of action_type Fibonacci"
STOP_ACTION = "driver stop_action 'fib'"
STOP_CALM = "driver stop_request 'calm'"


def after(folder: Path, text: str, statements: str, *codes: str) -> str:
    """Return a node's file after statements against which nothing is said but some codes."""
    (folder / "driver.py").write_text(text)
    program = f"load driver as driver\n{statements}\ngenerate_node driver\n"
    session = Session(program.encode(), folder / "program.plastron")
    plan, found = session.plan()
    assert [str(each.code) for each in (*session.diagnostics, *found)] == [*codes]
    return plan.files[0].text.decode() if plan.files else text


# What is added, what takes it out again, and what a reader finds in between.
ROWS = {
    "a call at a rate": (f"{CALM} at 2 hz", STOP_CALM, EndpointKind.CLIENT, "calm"),
    "a goal": (GOAL, STOP_GOAL, EndpointKind.ACTION_CLIENT, "fib"),
    "an action": (ACTION, STOP_ACTION, EndpointKind.ACTION_SERVER, "fib"),
    "messages at two rates": (
        f"{HELLO} at 2 hz\n{HI} at 3 hz",
        "driver stop_publishing to 'out'",
        EndpointKind.PUBLISHER,
        "out",
    ),
    "a call once and at two rates": (
        f"{CALM}\n{CALM} at 2 hz\n{CALM} at 3 hz",
        STOP_CALM,
        EndpointKind.CLIENT,
        "calm",
    ),
}
CASES = [
    pytest.param(file, *row, id=f"{what} | {file}")
    for what, row in ROWS.items()
    for file in FILES
    if (what, file) != ("an action", "rclpy script")
]


@pytest.mark.parametrize(("file", "add", "stop", "kind", "name"), CASES)
def test_what_is_added_is_read_back_and_taken_out(
    tmp_path: Path, file: str, add: str, stop: str, kind: EndpointKind, name: str
) -> None:
    before = FILES[file]
    text = after(tmp_path, before, add)
    compile(text, "driver.py", "exec")
    found, had = loaded(tmp_path, text), loaded(tmp_path, before)
    assert name in found.names(kind)
    # The timers that serve it are no functions that the node repeats.
    assert [*found.names(EndpointKind.TIMER)] == [*had.names(EndpointKind.TIMER)]
    assert after(tmp_path, text, stop) == before


@pytest.mark.parametrize("file", FILES)
def test_another_rate_is_one_line(tmp_path: Path, file: str) -> None:
    text = after(tmp_path, FILES[file], f"{CALM} at 2 hz")
    faster = after(tmp_path, text, f"{STOP_CALM}\n{CALM} at 5 hz")
    lines = zip(text.splitlines(), faster.splitlines(), strict=True)
    [(old, new)] = [(one, other) for one, other in lines if one != other]
    assert old.replace("0.5", "0.2") == new


@pytest.mark.parametrize("file", FILES)
def test_a_call_at_a_rate_becomes_one_that_is_made_once(tmp_path: Path, file: str) -> None:
    again, once = f"{CALM} at 2 hz", CALM
    text = after(tmp_path, FILES[file], again)
    assert after(tmp_path, text, f"{STOP_CALM}\n{once}") == after(tmp_path, FILES[file], once)


LIFECYCLE = """\
from rclpy.lifecycle import LifecycleNode


class Driver(LifecycleNode):
    def __init__(self):
        super().__init__('driver')

    def on_configure(self, state):
        self.pub = self.create_publisher(String, 'a', 10)
        return super().on_configure(state)
"""


def refusal(folder: Path, text: str, statements: str) -> str:
    """Return what is said against statements, and what to do instead."""
    (folder / "driver.py").write_text(text)
    program = f"load driver as driver\n{statements}\ngenerate_node driver\n"
    session = Session(program.encode(), folder / "program.plastron")
    _, found = session.plan()
    [said] = [*session.diagnostics, *found]
    return f"{said.code}: {said.message}; {said.help}"


def test_a_managed_node_makes_its_actions_by_hand(tmp_path: Path) -> None:
    said = refusal(tmp_path, LIFECYCLE, GOAL)
    assert "`on_configure` would make the action `fib` in each cycle; make it by hand" in said


@pytest.mark.parametrize("file", FILES)
def test_a_client_that_sends_goals_gets_no_other(tmp_path: Path, file: str) -> None:
    text = after(tmp_path, FILES[file], GOAL)
    said = refusal(tmp_path, text, GOAL)
    assert "may be at work on another goal; send the goal by hand" in said


@pytest.mark.parametrize("file", FILES)
def test_what_somebody_wrote_into_a_function_stays(tmp_path: Path, file: str) -> None:
    text = after(tmp_path, FILES[file], GOAL)
    last = "_timer.cancel()" if file.startswith("rclpy") else "('fib: %s', state)"
    assert text.count(last) == 1
    text = text.replace(last, f"{last}; print('sent')")
    assert refusal(tmp_path, text, STOP_GOAL).startswith("endpoint-in-use: the action client `fib`")


@pytest.mark.parametrize("stop", [STOP_GOAL, STOP_ACTION])
@pytest.mark.parametrize("file", [each for each in FILES if each.endswith("class")])
def test_of_two_actions_one_goes(tmp_path: Path, file: str, stop: str) -> None:
    both = {STOP_GOAL: GOAL, STOP_ACTION: ACTION}[stop]
    first = after(tmp_path, FILES[file], both.replace("'fib'", "'first'"))
    second = after(tmp_path, first, both)
    assert second.count("    async def sleep(") == (
        file.startswith("rclpy") and stop == STOP_ACTION
    )
    assert after(tmp_path, second, stop) == first


def test_an_action_of_a_script_gets_its_function_by_hand(tmp_path: Path) -> None:
    said = refusal(tmp_path, FILES["rclpy script"], ACTION)
    assert said.startswith("edit-refused: what works on the goals of `fib` is only written into a")
    assert said.endswith("node; write it by hand, and name it with `calling`")


def test_what_works_on_a_goal_has_the_types_that_the_file_says(tmp_path: Path) -> None:
    text = FILES["rclpy class"].replace("(self, msg)", "(self, msg: LaserScan) -> None")
    text = text.replace("def tick(self)", "def tick(self) -> None")
    text = text.replace("def __init__(self)", "def __init__(self) -> None").replace(
        "(self, request, response)",
        "(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response",
    )
    typed = after(tmp_path, text, ACTION)
    assert "execute_fib(self, goal_handle: ServerGoalHandle) -> Fibonacci.Result:" in typed
    assert "accept_cancel(self, goal_handle: ServerGoalHandle) -> CancelResponse:" in typed
    assert "async def sleep(self, seconds: float) -> None:" in typed
    assert after(tmp_path, typed, STOP_ACTION) == text
    asking = after(tmp_path, text, GOAL)
    assert "def fib_goal_callback(self, future: Future) -> None:" in asking
    assert after(tmp_path, asking, STOP_GOAL) == text


@pytest.mark.parametrize("file", FILES)
def test_a_function_of_the_file_works_on_goals(tmp_path: Path, file: str) -> None:
    self_name, indent = ("self, ", "    ") if file.endswith("class") else ("", "")
    work = f"{indent}def work({self_name}goal):\n{indent}    print(goal)\n\n\n{indent}def tick("
    before = FILES[file].replace(f"{indent}def tick(", work)
    text = after(tmp_path, before, f"{ACTION} calling work")
    node = loaded(tmp_path, text)
    assert [*node.names(EndpointKind.ACTION_SERVER)] == ["fib"]
    assert "cancel" not in text
    stopped = after(tmp_path, text, STOP_ACTION, "uncalled-function")
    assert stopped == before


def test_what_a_helper_makes_goes_too(tmp_path: Path) -> None:
    first = "        self.cmd_pub ="
    text = FILES["rclpy class"].replace(
        first, f"        self.set_up()\n\n    def set_up(self):\n{first}"
    )
    added = after(tmp_path, text, ACTION)
    assert "        self.fib_goal = None\n" in added.partition("def set_up(")[2]
    assert after(tmp_path, added, STOP_ACTION) == text


def test_imports_of_the_client_library_stand_together(tmp_path: Path) -> None:
    sorted_, jumbled = "from geometry_msgs.msg import Twist\n", "from rclpy.node import Node\n"
    text = FILES["rclpy class"].replace(sorted_, "").replace(jumbled, jumbled + sorted_, 1)
    text = text.replace("import rclpy\n", "import sys\nimport rclpy\nimport os\n", 1)
    added = after(tmp_path, text, ACTION)
    actions = (
        "from rclpy.action import ActionServer, CancelResponse\nfrom rclpy.task import Future\n"
    )
    assert actions in added.partition(jumbled)[2]
    assert after(tmp_path, added, STOP_ACTION) == text


@pytest.mark.parametrize(
    ("add", "stop"),
    [
        (ACTION, STOP_ACTION),
        (GOAL, STOP_GOAL),
        (CALM, STOP_CALM),
        ("subscribe driver to 'x' of message_type String", "unsubscribe driver from 'x'"),
    ],
)
def test_the_lines_that_part_methods_go_with_them(tmp_path: Path, add: str, stop: str) -> None:
    text = FILES["rclpy class"]
    for method in ("scan_callback", "reset_callback", "tick"):
        text = text.replace(f"    def {method}(", f"    # {'=' * 20}\n    def {method}(")
    added = after(tmp_path, text, add)
    assert added.count("# ====") > 3
    assert after(tmp_path, added, stop) == text
