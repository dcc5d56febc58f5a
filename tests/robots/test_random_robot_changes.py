"""Random programs and random handwork on one robot: what each said is there, and goes again."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from machine import examples
from test_robot_files import LOAD, LOADED, WRITE, run

from plastron_tui.diagnostics import has_errors

STATEMENTS = (
    "arm has_link 'upper' painted red\n",
    "arm has_link 'upper' weighing 2\n",
    "arm has_link 'upper' shaped sphere 0.25\n",
    "arm limits_joint 'shoulder' between -2 and 2 rad\n",
    "arm has_joint 'shoulder' of joint_type revolute from 'base' to 'upper' at 0, 0, 0.1\n",
    "arm has_link 'hand' shaped sphere 0.1 weighing 1\n"
    "arm has_joint 'wrist' of joint_type fixed from 'upper' to 'hand' at 0, 0, 0.5\n",
    "arm has_link 'eye'\narm has_joint 'brow' of joint_type fixed from 'base' to 'eye'\n",
    "arm limits_joint 'shoulder' with effort 20 and velocity 2\n",
)
"""Those that say something of one link or joint are drawn one at a time."""

HANDWORK = (
    ("<!-- An arm. -->", "<!-- My arm. -->"),
    ("<!-- odd -->", ""),
    ("Gazebo/Red", "Gazebo/Blue"),
    ('  <link name="base"/>\n', '  <link name="base">\n  </link>\n'),
    ("</robot>", "  <!-- done -->\n</robot>"),
    (
        "\n  <gazebo",
        '\n\n  <material name="own">\n    <color rgba="1 1 1 1"/>\n  </material>\n  <gazebo',
    ),
)
"""None of them shows another way of writing, in which the program would write as well."""

_programs = st.sets(st.integers(0, len(STATEMENTS) - 1)).filter(
    lambda drawn: len(drawn & {0, 1, 2}) < 2 and len(drawn & {3, 7}) < 2
)
_handwork = st.lists(st.sampled_from(HANDWORK), unique=True)


def program(drawn: set[int]) -> str:
    return LOAD + "".join(STATEMENTS[each] for each in sorted(drawn)) + WRITE


def by_hand(text: str, changes: list[tuple[str, str]]) -> str:
    for old, new in changes:
        text = text.replace(old, new, 1)
    return text


@settings(max_examples=examples(40), deadline=None, suppress_health_check=list(HealthCheck))
@given(_programs, _programs, _handwork)
def test_a_program_comes_and_goes_around_handwork(
    first: set[int], second: set[int], changes: list[tuple[str, str]]
) -> None:
    with TemporaryDirectory() as name:
        folder = Path(name)
        file = folder / "arm.urdf"
        file.write_text(LOADED)
        assert not has_errors(run(program(first), folder, in_place=True))
        file.write_text(by_hand(file.read_text(), changes))
        for drawn in (first, second, second):
            assert not has_errors(run(program(drawn), folder, in_place=True))
        changed = file.read_text()
        run(program(second), folder, in_place=True)
        assert file.read_text() == changed
        assert not has_errors(run(program(set()), folder, in_place=True))
        assert file.read_text() == by_hand(LOADED, changes)
        # What the program makes does not hang on the way there.
        file.write_text(by_hand(LOADED, changes))
        (folder / ".plastron.json").unlink(missing_ok=True)
        run(program(second), folder, in_place=True)
        assert file.read_text() == changed
