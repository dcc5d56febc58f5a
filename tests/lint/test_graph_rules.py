"""What the rules of the graph tell of nodes that run together, and what they leave alone."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import (
    LISTENER,
    SETUP,
    TALKER,
    alone,
    code_of,
    found_in,
    in_python,
    node_of,
    package_of,
)
from linted import run_over, write_tree

from plastron_tui.lint.rules.one_sided_examples import PUBLISHED

MOVED = code_of(LISTENER).replace("from std_msgs.msg", "from old_msgs.msg")
TYPES = {
    # Nobody knows `old_msgs/String`: the type may have moved.
    "of_a_package_that_is_not_known": ("", MOVED, 0),
    "a_publisher_of_another_type": (code_of(TALKER, type="Int32"), "", 1),
    "a_subscription_of_another_type": ("", code_of(LISTENER, type="Int32"), 1),
    "both_of_another_type": (code_of(TALKER, type="Int32"), code_of(LISTENER, type="Int32"), 0),
    "a_node_that_uses_both_types": (
        code_of(TALKER, more="self.other = self.create_publisher(Int32, 'chatter', 10)"),
        "",
        0,
    ),
    "another_name": (code_of(TALKER, type="Int32", topic="count"), "", 0),
}


@pytest.mark.parametrize(("talker", "listener", "count"), TYPES.values(), ids=TYPES)
@pytest.mark.parametrize("launched", [(), ("talker",), ("talker", "listener")], ids=len)
def test_types_conflict(
    tmp_path: Path, talker: str, listener: str, count: int, launched: tuple[str, ...]
) -> None:
    launches = {"some_py": in_python(*map(node_of, launched))} if launched else {}
    found = found_in(tmp_path, package_of(talker, listener, **launches), "RG101")
    assert [code for code, _, _ in found] == ["RG101"] * count


def test_types_that_conflict_by_a_remap_show_it(tmp_path: Path) -> None:
    talker = code_of(TALKER, type="Int32", topic="words")
    launch = (
        "<launch>\n<node pkg='demo' exec='listener'/>\n<node pkg='demo' exec='talker'>\n"
        "<remap from='noise' to='x'/>\n<remap from='words' to='/chatter'/>\n</node>\n</launch>\n"
    )
    files = package_of(talker, some_xml=launch)
    (found,) = run_over(write_tree(tmp_path, files), "RG101").told
    (label,) = [x for x in found.diagnostic.labels if x.file and x.file.name == "some.launch.xml"]
    assert label.message == "this makes `/chatter` of `words`"
    assert launch.encode()[: label.span.start].count(b"\n") == 4


def test_two_drivers_of_which_one_is_started_do_not_conflict(tmp_path: Path) -> None:
    other = code_of(TALKER, type="Int32").replace("talker", "other")
    more = code_of(LISTENER, type="Int32").replace("listener", "hears")
    files = package_of() | {"demo/demo/other.py": other, "demo/demo/hears.py": more}
    assert found_in(tmp_path, files, "RG101") == []
    both = in_python(
        *map(node_of, ("talker", "listener")), "Node(package='demo', executable='other')"
    )
    files["demo/setup.py"] = SETUP.replace("['talker", "['other = demo.other:main', 'talker")
    found = found_in(tmp_path / "2", files | {"demo/launch/all.launch.py": both}, "RG101")
    assert [(code, name) for code, name, _ in found] == [("RG101", "other.py")]


NAMED = node_of("talker", "name='a'")
ONE = in_python(node_of("talker", "name='a'"))
IN_YAML = "- node: {{pkg: demo, exec: {}, name: a}}\n"
TWICE = {
    "by_name": (
        {"x_py": in_python(node_of("talker", "name='a'"), node_of("listener", "name='a'"))},
        4,
    ),
    "in_xml": (
        {
            "x_xml": '<launch>\n<node pkg="demo" exec="talker" name="a"/>\n<group>\n'
            '<node pkg="demo" exec="listener" name="a"/></group></launch>'
        },
        4,
    ),
    "in_yaml": ({"x_yaml": "launch:\n" + IN_YAML.format("talker") + IN_YAML.format("listener")}, 3),
    "in_a_namespace": (
        {
            "x_py": in_python(
                node_of("talker", "name='a'", "namespace='r'"),
                f"GroupAction([PushRosNamespace('r'), {NAMED}])",
            )
        },
        4,
    ),
    "by_their_own_names": ({"x_py": in_python(node_of("talker"), node_of("talker"))}, 4),
    "by_the_default_of_an_argument": (
        {
            "x_py": in_python(
                "DeclareLaunchArgument('n', default_value='a')",
                node_of("talker", "name=LaunchConfiguration('n')"),
                node_of("listener", "name='a'"),
            )
        },
        5,
    ),
    "in_a_comprehension": (
        {"x_py": in_python("*[" + node_of("talker", "name='a'") + " for _ in range(3)]")},
        3,
    ),
    "in_a_comprehension_with_names": (
        {"x_py": in_python("*[" + node_of("talker", "name=f'a{n}'") + " for n in range(3)]")},
        0,
    ),
    "in_other_namespaces": (
        {"x_py": in_python(node_of("talker", "namespace='r'"), node_of("talker", "namespace='s'"))},
        0,
    ),
    "in_namespaces_that_are_not_known": (
        {
            "x_py": in_python(
                *(
                    f"GroupAction([PushRosNamespace(LaunchConfiguration('{each}')), {NAMED}])"
                    for each in ("one", "other")
                )
            )
        },
        0,
    ),
    "in_one_case_or_the_other": (
        {
            "x_py": in_python(
                "DeclareLaunchArgument('sim', default_value='true')",
                node_of("talker", "name='a'", "condition=IfCondition(LaunchConfiguration('sim'))"),
                node_of(
                    "listener", "name='a'", "condition=UnlessCondition(LaunchConfiguration('sim'))"
                ),
            )
        },
        0,
    ),
}


@pytest.mark.parametrize(("launches", "line"), TWICE.values(), ids=TWICE)
def test_two_nodes_of_one_name(tmp_path: Path, launches: dict[str, str], line: int) -> None:
    found = found_in(tmp_path, package_of(**launches), "RG103")
    assert [at for _, _, at in found] == ([line] if line else [])


def _message(folder: Path) -> str:
    (found,) = run_over(folder / "src", "RG103").told
    return found.diagnostic.message


def test_a_file_that_is_included_twice(tmp_path: Path) -> None:
    source = "PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/one.launch.py'])"
    include = f"IncludeLaunchDescription({source})"
    apart = f"GroupAction([PushRosNamespace('r'), {include}])"
    files = package_of(one_py=ONE, x_py=in_python(include, include))
    assert found_in(tmp_path, files, "RG103") == [("RG103", "x.launch.py", 4)]
    assert _message(tmp_path) == "the file starts another node that is called `/a`, too"
    files = package_of(one_py=ONE, x_py=in_python(include, node_of("listener", "name='a'")))
    assert found_in(tmp_path / "3", files, "RG103") == [("RG103", "x.launch.py", 4)]
    assert _message(tmp_path / "3") == "`x.launch.py` starts another node that is called `/a`, too"
    files = package_of(one_py=ONE, x_py=in_python(include, apart))
    assert found_in(tmp_path / "2", files, "RG103") == []


SLIPS = {
    "of_a_node_that_has_both": ("", "self.create_subscription(String, 'chater', print, 10)", 1),
    "of_a_node_that_sends_to_itself": (
        "self.own = self.create_publisher(String, 'chatter', 10)",
        "self.create_subscription(String, 'chater', print, 10)",
        1,
    ),
    "of_a_node_that_passes_on": ("", "self.create_publisher(String, 'chatters', 10)", 0),
    "of_a_name_with_two_types": (
        "self.own = self.create_publisher(Int32, 'chatter', 10)",
        "self.create_subscription(String, 'chater', print, 10)",
        1,
    ),
}


@pytest.mark.parametrize(("talks", "hears", "count"), SLIPS.values(), ids=SLIPS)
def test_names_one_slip_apart(tmp_path: Path, talks: str, hears: str, count: int) -> None:
    files = package_of(code_of(TALKER), code_of(LISTENER, before=f"{talks or 0}; {hears}"))
    assert len(found_in(tmp_path, files, "RG104")) == count


def test_a_misspelt_name_beside_others_that_are_right(tmp_path: Path) -> None:
    wrong = code_of(LISTENER, topic="chatte").replace("listener", "wrong")
    files = package_of() | {"demo/demo/wrong.py": wrong}
    assert found_in(tmp_path, files, "RG104") == [("RG104", "wrong.py", 10)]
    other = {
        "demo/demo/wrong.py": wrong.replace("'chatte'", "'chattes'").replace("String", "Int32")
    }
    assert found_in(tmp_path / "2", package_of() | other, "RG104") == []


def test_a_publisher_beside_one_that_is_heard(tmp_path: Path) -> None:
    other = code_of(TALKER, topic="chatte").replace("talker", "other")
    files = package_of() | {"demo/demo/other.py": other}
    assert found_in(tmp_path, files, "RG104") == []


UNKNOWN = {
    "a_remap": (node_of("listener", "remappings=[('chater', LaunchConfiguration('to'))]"),),
    "a_remap_of_a_group": ("SetRemap('chater', LaunchConfiguration('to'))", node_of("listener")),
    "a_namespace": ("PushRosNamespace(LaunchConfiguration('to'))", node_of("listener")),
}


@pytest.mark.parametrize("lines", UNKNOWN.values(), ids=UNKNOWN)
def test_a_name_that_gets_one_that_is_not_known(tmp_path: Path, lines: tuple[str, ...]) -> None:
    listener = code_of(LISTENER, topic="chater")
    known = package_of(listener=listener, x_py=in_python(node_of("talker"), node_of("listener")))
    assert found_in(tmp_path, known, "RG104") == [("RG104", "listener.py", 10)]
    files = package_of(listener=listener, x_py=in_python(node_of("talker"), *lines))
    assert found_in(tmp_path / "2", files, "RG104", "RG107") == []


ASKED = {
    "RG107": ("listener.py", 10),
    "never-published": ("listener.py", 10),
    "RG108": ("talker.py", 10),
}


@pytest.mark.parametrize(("word", "place"), ASKED.items(), ids=ASKED)
def test_names_that_may_be_used_outside_are_told_where_it_is_asked_for(
    tmp_path: Path, word: str, place: tuple[str, int]
) -> None:
    files = package_of(code_of(TALKER, topic="text"))
    found = found_in(tmp_path, files, word)
    assert [each[1:] for each in found] == [place]
    assert found_in(tmp_path, files, "RG") == []
    assert found_in(tmp_path / "2", package_of(), word) == []


@pytest.mark.parametrize(("needs", "count"), [("rclpy", 0), ("talks", 1), ("shared", 1)])
def test_types_conflict_between_packages_that_belong_together(
    tmp_path: Path, needs: str, count: int
) -> None:
    files = {
        **alone("talks", "shared", code_of(TALKER, type="Int32")),
        **alone("again", "rclpy", code_of(TALKER, type="Int32")),
        **alone("listens", "rclpy", code_of(LISTENER)),
        **alone("hears", needs, code_of(LISTENER)),
        **alone("shared", "rclpy", code_of(TALKER, topic="other")),
    }
    assert len(found_in(tmp_path, files, "RG101")) == count


def test_a_type_that_may_be_meant_on_the_other_side_is_no_conflict(tmp_path: Path) -> None:
    files = {
        **alone("talks", "rclpy", code_of(TALKER, type="Int32")),
        **alone("takes", "talks", code_of(LISTENER, type="Int32")),
        **alone("hears", "talks", code_of(LISTENER)),
    }
    assert len(found_in(tmp_path, files, "RG101")) == 1
    stars = code_of(TALKER).replace("std_msgs.msg import Int32, String", "shapes.msg import *")
    files |= alone("guessed", "rclpy", stars)
    assert found_in(tmp_path / "2", files, "RG101") == [("RG101", "node.py", 10)]
    files |= alone("guessed", "rclpy", stars.replace("shapes", "std_msgs"))
    assert found_in(tmp_path / "3", files, "RG101") == []


ODD = {
    "a_type_of_one_file": ("talks", "Int32", "", 1),
    "a_variant": ("talks", "StringMultiArray", "", 0),
    "a_type_whose_name_ends_alike": ("talks", "CompressedString", "", 1),
    "a_type_whose_name_begins_alike": ("talks", "Stringent", "", 1),
    "an_old_copy": ("talks_old", "Int32", "", 0),
    "a_partner_of_its_type": ("talks", "Int32", "Int32", 0),
}


@pytest.mark.parametrize(("name", "type_", "heard", "count"), ODD.values(), ids=ODD)
def test_types_conflict_between_packages_that_need_nothing_of_each_other(
    tmp_path: Path, name: str, type_: str, heard: str, count: int
) -> None:
    talker = code_of(TALKER, type=type_).replace("import Int32", f"import {type_}, Int32")
    files = {
        **alone(name, "rclpy", talker),
        **alone("hears", "rclpy", code_of(LISTENER)),
        **alone("speaks", "rclpy", code_of(TALKER)),
    }
    if heard:
        files |= alone("counts", "rclpy", code_of(LISTENER, type=heard))
    assert len(found_in(tmp_path, files, "RG101")) == count


MORE = "condition=IfCondition(LaunchConfiguration('more'))"
SAYS = node_of("talker")
OTHERWISE = "DeclareLaunchArgument('more', default_value='false')"
LONELY = {
    "without_a_launch_file": ((), True),
    "started_with_its_own_name": ((SAYS, node_of("listener")), True),
    "started_otherwise_with_its_own_name": (
        (OTHERWISE, SAYS, node_of("listener", MORE)),
        True,
    ),
    "started_otherwise_with_another_name": (
        (OTHERWISE, SAYS, node_of("listener", "remappings=[('tank_state', 'level')]", MORE)),
        False,
    ),
    "started_with_a_name_that_is_not_known": (
        (SAYS, node_of("listener", "remappings=[('tank_state', LaunchConfiguration('to'))]")),
        False,
    ),
    "started_perhaps": ((SAYS, "OpaqueFunction(function=make)"), False),
}


@pytest.mark.parametrize(("lines", "is_told"), LONELY.values(), ids=LONELY)
def test_a_topic_that_nobody_publishes(
    tmp_path: Path, lines: tuple[str, ...], is_told: bool
) -> None:
    bad = {name: text for name, text in PUBLISHED["bad"].items() if name.startswith("demo_msgs")}
    launches = {"x_py": in_python(*lines)} if lines else {}
    nodes = package_of(PUBLISHED["bad"]["tank.py"], PUBLISHED["bad"]["display.py"], **launches)
    found = found_in(tmp_path, nodes | bad, "RG")
    assert [code for code, _, _ in found] == (["RG107"] if is_told else [])


def test_what_is_a_test_runs_with_no_other_node(tmp_path: Path) -> None:
    other = code_of(LISTENER, type="Int32").replace("listener", "other")
    for place, count in {"demo/demo/other.py": 1, "demo/test/other.py": 0}.items():
        files = package_of() | {place: other}
        assert len(found_in(tmp_path / str(count), files, "RG101")) == count


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("'tank_state'", "'tank_state'", ["RG107"]),
        # What is handed on may publish it.
        ("super().__init__('tank')\n", "super().__init__('tank')\n        helpers.add(self)\n", []),
        # A slip is another rule's to tell.
        ("'tank_state'", "'levle'", ["RG104"]),
        # Whoever starts it may give it the namespace.
        ("'tank_state'", "'tank/level'", []),
    ],
)
def test_a_topic_that_somebody_may_publish(
    tmp_path: Path, old: str, new: str, told: list[str]
) -> None:
    files = {name: text.replace(old, new) for name, text in PUBLISHED["bad"].items()}
    found = found_in(tmp_path, dict(files), "RG")
    assert [code for code, _, _ in found] == told
