from __future__ import annotations

import pytest
from workspaces import run

THINGS = """\
create_node 'pilot' as pilot
create_message_type Wheel with float64 left
create_package 'rover' as rover
create_robot 'arm' as arm
create_launch 'all' as all_nodes
create_message go of message_type String and input "go"
"""


@pytest.mark.parametrize(
    ("line", "right"),
    [("generate pilot", "generate_node"),
     ("generate Wheel", "generate_type"),
     ("generate rover", "generate_package"),
     ("generate arm", "generate_robot"),
     ("generate all_nodes", "generate_launch"),
     ("generate go", None),
     ("generate somebody", None),
     ("create pilot", None)],
)  # fmt: skip
def test_what_a_variable_stands_for_decides_between_statements(
    line: str, right: str | None
) -> None:
    text = f"{THINGS}{line}\n"
    (found,) = [each for each in run(text).diagnostics if each.code == "unknown-statement"]
    if right is None:
        assert found.fix is None
    else:
        assert found.help == f"did you mean `{right}`?" and found.fix is not None
        ((span, written),) = found.fix.edits
        assert (text.encode()[span.start : span.end], written) == (line.split()[0].encode(), right)
