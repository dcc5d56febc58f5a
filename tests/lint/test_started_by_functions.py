"""What is told of nodes that functions and event handlers of launch files start."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import TALKER, code_of, found_in, node_of, package_of

START = "return [Node(package='demo', executable='talker',"
DECLARES = code_of(TALKER, before="self.declare_parameter('rate', 10)")
NAMED = node_of("talker", "name='one'")
AWRY = node_of("talkers")
OPAQUE = "OpaqueFunction(function=made)"


def _launch(*lines: str, actions: str = OPAQUE) -> str:
    """Return a launch file whose function `made` has some lines, from the second one on."""
    body = "".join(f"    {line}\n" for line in lines)
    return (
        f"def made(context):\n{body}\n\ndef generate_launch_description():\n"
        f"    return LaunchDescription([{actions}])\n"
    )


def _on_exit(node: str) -> str:
    return f"RegisterEventHandler(OnProcessExit(target_action=x, on_exit=[{node}]))"


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        (_launch(f"return [{AWRY}]"), "RK506 2"),
        (_launch("nodes = []", "if context:", f"    nodes.append({AWRY})", "return nodes"),
         "RK506 4"),
        (_launch("if context:", f"    return [{AWRY}]", "return []"), "RK506 3"),
        (_launch("return []", actions=_on_exit(AWRY)), "RK506 6"),
        (_launch("return []", actions=f"TimerAction(period=1.0, actions=[{AWRY}])"), "RK506 6"),
        (_launch(START, "    parameters=[{'rates': 5}])]"),
         "RP301 3"),
        (_launch(START, "    parameters=[{'rate': 'much'}])]"),
         "RP303 3"),
        (_launch("return []", actions=_on_exit(node_of("talker", "parameters=[{'rate': 'x'}]"))),
         "RP303 6"),
        (_launch("return [", f"    {NAMED},", f"    {NAMED}]"), "RG103 4"),
        (_launch(START, "    remappings=[('chater', 'a')])]"),
         "RG105 3"),
        # What is not known for sure.
        (_launch("if context:", f"    return [{NAMED}]", f"return [{NAMED}]"), ""),
        (_launch(f"return [{NAMED}]", actions=f"{OPAQUE}, {_on_exit(NAMED)}"), ""),
        (_launch("if context:", "    name = 'talkers'", "else:", "    name = 'talker'",
                 "return [Node(package='demo', executable=name)]"), ""),
        (_launch("name = LaunchConfiguration('which').perform(context)",
                 "return [Node(package='demo', executable=name)]"), ""),
        (_launch("given = {'rate': 5}", "if context:", "    given['rate'] = 'much'",
                 f"return [{node_of('talker', 'parameters=[given]')}]"), ""),
    ],
)  # fmt: skip
def test_what_functions_start_is_looked_at(tmp_path: Path, source: str, expected: str) -> None:
    codes = ("RK506", "RP301", "RP302", "RP303", "RG103", "RG105")
    found = found_in(tmp_path, package_of(talker=DECLARES, x_py=source), *codes)
    assert " ".join(f"{code} {line}" for code, _, line in found) == expected
    assert {name for _, name, _ in found} <= {"x.launch.py"}
