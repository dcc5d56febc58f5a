"""What a merge makes of a file as a whole: parameters, other libraries, other names."""

from __future__ import annotations

import json
import re
from pathlib import Path

from merging_driver import (
    EMPTY,
    KEEP,
    KEPT,
    PROVIDE,
    PUBLISH,
    PUBLISH_INT,
    SUBSCRIBE,
    SUBSCRIBE_INT,
    Folder,
    check,
)

from plastron_tui.output.manifest import NAME


def test_topic_from_a_parameter_is_the_same_topic(folder: Folder) -> None:
    folder.generate(KEEP, SUBSCRIBE)
    folder.fill()
    expression = "rospy.get_param('~topic', 'a')"
    if folder.library == "rclpy":
        expression = "self.declare_parameter('topic', 'a').value"
    folder.edit('"a", ', f"{expression}, ")
    assert folder.generate(KEEP, SUBSCRIBE).states == {"robot_node.py": "identical"}


def test_other_library_is_a_conflict(tmp_path: Path) -> None:
    Folder(tmp_path, "rospy").generate(KEEP)
    Folder(tmp_path, "rospy").fill()
    (conflict,) = Folder(tmp_path, "rclpy").generate(KEEP).conflicts
    assert conflict.endswith("was changed by hand, and it is a node of `rospy`")


def test_file_that_is_no_node_any_more_is_a_conflict(folder: Folder) -> None:
    folder.generate(KEEP)
    folder.file().write_text("mine = 1\n")
    (conflict,) = folder.generate(KEEP, PUBLISH).conflicts
    assert conflict.endswith("was changed by hand, and it holds no node that can be read")
    assert folder.file().read_text() == "mine = 1\n"


def test_reverted_handwork_is_ours_again(folder: Folder) -> None:
    folder.generate(KEEP)
    ours = folder.file().read_bytes()
    folder.fill()
    folder.generate(KEEP, PUBLISH)
    folder.file().write_bytes(ours)
    assert folder.generate(KEEP, SUBSCRIBE).warnings == []
    fresh = Folder(folder.path / "other", folder.library)
    fresh.generate(KEEP, SUBSCRIBE)
    assert folder.file().read_bytes() == fresh.file().read_bytes()


def test_manifest_of_an_older_version(folder: Folder) -> None:
    """Without a base, endpoints are added only: what the file has besides may be the user's."""
    folder.generate(KEEP, SUBSCRIBE)
    manifest = folder.path / "output" / NAME
    digest = re.search(r"sha256:\w+", manifest.read_text())
    assert digest is not None
    old = f'{{"generator": "plastron", "version": 1, "files": {{"robot_node.py": "{digest[0]}"}}}}'
    manifest.write_text(old)
    mine = folder.fill()
    (conflict,) = folder.generate(KEEP).conflicts
    assert conflict.endswith("it has the subscription `a`, which the program does not have")
    assert manifest.read_text() == old
    assert folder.generate(KEEP, SUBSCRIBE, PROVIDE).conflicts == []
    assert folder.generate(KEEP, PROVIDE).conflicts == []
    check(folder, mine, [*KEPT, ("services", "s", EMPTY)])


def test_twice_created_endpoint_is_not_taken_out(folder: Folder) -> None:
    folder.generate(KEEP, PUBLISH)
    (line,) = [each for each in folder.file().read_text().split("\n") if "a_publisher = " in each]
    folder.edit(line, f"{line}\n{line.replace('a_publisher', 'mine')}")
    before = folder.file().read_bytes()
    for other in ("", PUBLISH_INT):
        (conflict,) = folder.generate(KEEP, other).conflicts
        assert re.search(r"the publisher `a` is created in lines \d+ and \d+$", conflict)
    assert folder.file().read_bytes() == before


def test_a_node_keeps_its_file(folder: Folder) -> None:
    assert folder.generate(SUBSCRIBE).states == {"robot_sub1.py": "create"}
    assert folder.generate(SUBSCRIBE, PROVIDE) == ({"robot_sub1.py": "changed"}, [], [])
    fresh = Folder(folder.path / "other", folder.library)
    fresh.generate(SUBSCRIBE, PROVIDE)
    assert folder.file("robot_sub1.py").read_bytes() == fresh.file().read_bytes()
    folder.file("robot_sub1.py").unlink()
    assert folder.generate(SUBSCRIBE, PROVIDE).states == {"robot_node.py": "create"}


def test_a_node_keeps_the_file_that_an_older_version_gave_it(folder: Folder) -> None:
    folder.generate(SUBSCRIBE)
    manifest = folder.path / "output" / NAME
    known = json.loads(manifest.read_text())
    known["files"]["robot_node.py"] = known["files"]["robot_sub1.py"]
    old = {**known["files"]["robot_sub1.py"]["base"], "superseded_by": "robot_node.py"}
    known["files"]["robot_sub1.py"] = {"base": old}
    manifest.write_text(json.dumps(known))
    folder.file("robot_node.py").write_bytes(folder.file("robot_sub1.py").read_bytes())
    assert folder.generate(SUBSCRIBE, PROVIDE).states == {"robot_node.py": "changed"}


def test_node_of_the_same_name_in_another_program_is_another(folder: Folder) -> None:
    folder.generate(SUBSCRIBE)
    folder.fill("robot_sub1.py")
    other = Folder(folder.path, folder.library, "other.plastron")
    assert other.generate(PUBLISH) == ({"robot_pub.py": "create"}, [], [])
    assert len(folder.generate(SUBSCRIBE).warnings) == 1


def test_callback_is_not_made_a_second_time_elsewhere(tmp_path: Path) -> None:
    """The file's other subscription is in `main`, from where the method cannot be called.

    The call cannot be changed in place: a constant says its type.
    """
    folder = Folder(tmp_path, "rospy")
    folder.generate(SUBSCRIBE)
    folder.fill("robot_sub1.py")
    mine = '    rospy.Subscriber("mine", rospy.AnyMsg, print)\n    rospy.spin()'
    folder.edit("    rospy.spin()", mine, "robot_sub1.py")
    folder.edit('rospy.Subscriber("a", String', 'rospy.Subscriber("a", KIND', "robot_sub1.py")
    folder.edit("\n\nclass ", "KIND = String\n\n\nclass ", "robot_sub1.py")
    before = folder.file("robot_sub1.py").read_bytes()
    (conflict,) = folder.generate(SUBSCRIBE_INT).conflicts
    assert conflict.endswith("`on_a` cannot be called from where endpoints are added")
    assert folder.file("robot_sub1.py").read_bytes() == before
