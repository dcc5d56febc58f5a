"""A `load` and a `generate_node … using` another client library, as a program has them."""

from __future__ import annotations

import re
from pathlib import Path

from ported_nodes import (
    LISTENER_1,
    LISTENER_2,
    endpoints,
    source,
)

from plastron_tui.model.source import EndpointKind
from plastron_tui.output.plan import FileState
from plastron_tui.session import Options, Session


class TestThroughAProgram:
    """A `load` and a `generate_node … using`, as a program has them."""

    def session(self, folder: Path, program: str, output: Path | None = None) -> Session:
        (folder / "listener.py").write_text(LISTENER_1)
        return Session(program.encode(), folder / "p.plastron", Options(output=output), environ={})

    def test_the_file_is_of_the_same_name_in_the_output_folder(self, tmp_path: Path) -> None:
        session = self.session(tmp_path, "load listener as x\ngenerate_node x using rclpy\n")
        assert session.diagnostics == ()
        [made] = session.generated()
        assert made.files is not None
        assert made.files.name == "listener.py"
        assert made.files.files.main.decode() == LISTENER_2
        assert not made.diagnostics

    def test_a_warning_says_the_line_of_the_new_file(self, tmp_path: Path) -> None:
        session = self.session(tmp_path, "load listener as x\ngenerate_node x using rclpy\n")
        marked = LISTENER_1.replace("rospy.spin()", "rospy.AnyMsg\n    rospy.spin()")
        (tmp_path / "listener.py").write_text(marked)
        [made] = session.generated()
        assert made.files is not None
        assert [found.span is not None for found in made.diagnostics] == [True, True]
        lines = made.files.files.main.decode().split("\n")
        for found in made.diagnostics:
            match = re.match(r"`(.*)` in line (\d+) of the new file", found.message)
            assert match is not None
            assert match[1] in lines[int(match[2]) - 2]

    def test_what_the_program_changes_is_in_it(self, tmp_path: Path) -> None:
        session = self.session(
            tmp_path,
            "load listener as x\n"
            "unsubscribe x from 'chatter'\n"
            "subscribe x to 'other' of message_type String\n"
            "generate_node x using rclpy\n",
        )
        assert session.diagnostics == ()
        [made] = session.generated()
        assert made.files is not None
        found = endpoints(source(made.files.files.main, "rclpy"))
        assert found == {(EndpointKind.SUBSCRIPTION, "other"): 1}

    def test_a_loaded_node_keeps_its_library_otherwise(self, tmp_path: Path) -> None:
        session = self.session(tmp_path, "load listener as x\ngenerate_node x\n")
        session.options = session.options._replace(target="rclpy")
        [made] = session.generated()
        assert made.files is not None
        assert made.files.files.main.decode() == LISTENER_1

    def test_the_file_that_was_loaded_is_never_overwritten(self, tmp_path: Path) -> None:
        program = "load listener as x\ngenerate_node x using rclpy\n"
        session = self.session(tmp_path, program, tmp_path)
        plan, _ = session.plan()
        assert [file.state for file in plan.files] == [FileState.CONFLICT]
