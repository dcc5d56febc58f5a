from __future__ import annotations

import json
import re

import pytest
from graph_workspaces import TRIGGER, Maker, tour, workspaces
from hypothesis import given

from plastron_tui.model.graph import graph_of
from plastron_tui.model.kinds import Client, Rate, Request
from plastron_tui.model.values import MessageValue
from plastron_tui.model.workspace import Workspace
from plastron_tui.output.graphs import FORMATS, dot, mermaid, render
from plastron_tui.output.graphs.identifiers import edges_of

_DOT_TOKEN = re.compile(r'\s*("(?:[^"\\\n]|\\.)*"|->|[][{};=,]|[A-Za-z]\w*|-?[\d.]+)')
_MERMAID_LINE = re.compile(
    r"""flowchart\ LR
    |\ \ classDef\ \w+\ [\w:#,\- ]+
    |\ \ (?P<id>[nts]\d+)(?:\[|\(\[|\{\{)"(?P<label>[^"]*)"(?:\]|\]\)|\}\}):::\w+
    |\ \ (?P<start>[nts]\d+)\ (?:-->|-\.\ calls\ \.->|-\.->)\ (?P<end>[nts]\d+)""",
    re.VERBOSE,
)


def test_text() -> None:
    assert render(graph_of(tour()), "text") == (
        "nodes\n"
        "  camera   cam · rospy\n"
        "  planner\n"
        "  driver   drv · driver_node.py\n"
        "  lonely\n"
        "\n"
        "topics\n"
        "  /image  std_msgs/String\n"
        "    camera   publishes  frame at 30 Hz\n"
        "    planner  listens    on_image\n"
        "  /camera/debug  std_msgs/String  (nobody listens)\n"
        "    camera  publishes  frame at 1 Hz, note at 0.5 Hz\n"
        "  /light  std_msgs/String  (nobody publishes)\n"
        "    camera  listens\n"
        "  /cmd_vel  std_msgs/String\n"
        "    planner  publishes  go at 20 Hz\n"
        "    driver   listens\n"
        "  /odom  std_msgs/String\n"
        "    driver   publishes\n"
        "    planner  listens\n"
        "\n"
        "services\n"
        "  /calibrate  std_srvs/Trigger  (nobody calls)\n"
        "    camera  provides\n"
        "  /enable  std_srvs/Trigger\n"
        "    driver   provides  handle_enable\n"
        "    planner  calls     2 times\n"
        "  /save_map  std_srvs/Trigger  (nobody provides)\n"
        "    planner  calls\n"
    )


def test_text_wraps_what_is_long_and_has_no_control_characters() -> None:
    make = Maker()
    make.publish(make.node("talker"), "t", *((f"message_{at}", 10.0) for at in range(20)))
    make.node("a\x1b[31m\n\u202eb", "odd")
    text = render(graph_of(make.workspace), "text")
    assert max(map(len, text.splitlines())) <= 100
    assert text.count("message_") == 20
    assert "a\\x1b[31m\\n\\u202eb" in text


def test_json() -> None:
    found = json.loads(render(graph_of(tour()), "json"))
    assert found["nodes"][2] == {
        "name": "driver",
        "variable": "drv",
        "library": "rospy",
        "file": "nodes/driver_node.py",
        "generated": False,
        "span": [20, 29],
    }
    assert found["topics"][0] == {
        "name": "/image",
        "type": "std_msgs/String",
        "types": ["std_msgs/String"],
        "missing": None,
        "publishers": [
            {
                "node": "camera",
                "variable": "cam",
                "written": "image",
                "type": "std_msgs/String",
                "span": [30, 39],
                "messages": [{"message": "frame", "rate": 30.0, "pace": "30 Hz", "span": [30, 39]}],
            }
        ],
        "subscribers": [
            {
                "node": "planner",
                "variable": "planner",
                "written": "/image",
                "type": "std_msgs/String",
                "span": [60, 69],
                "callback": "on_image",
            }
        ],
    }
    assert found["services"][1]["clients"][0]["requests"] == [{"data": True}, {}]
    assert found["services"][2]["missing"] == "provider"


def test_requests_say_how_often_they_are_made() -> None:
    make = Maker()
    rates = (None, Rate(0.5), Rate(2, "often"))
    requests = tuple(Request(MessageValue(TRIGGER, {}), rate) for rate in rates)
    make.node("a").put(Client("s", TRIGGER, requests))
    graph = graph_of(make.workspace)
    assert "a  calls  once, at 0.5 Hz, at often\n" in render(graph, "text")
    [service] = json.loads(render(graph, "json"))["services"]
    assert service["clients"][0]["rates"] == [None, 0.5, 2]


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -float("inf")])
def test_json_is_strict(value: float) -> None:
    make = Maker()
    make.call(make.node("a"), "s", {"x": (value, 1.5)})

    def refuse(word: str) -> None:
        raise AssertionError(word)

    found = json.loads(render(graph_of(make.workspace), "json"), parse_constant=refuse)
    assert found["services"][0]["clients"][0]["requests"] == [{"x": [str(value), 1.5]}]


@pytest.mark.parametrize(
    ("name", "label"),
    [
        ("/a_b-1", '"/a_b-1"'),
        ('"]', '"#34;#93;"'),
        ("#quot;", '"#35;quot#59;"'),
        ("<b>&", '"#60;b#62;#38;"'),
        ("`x`", '"#96;x#96;"'),
        ("%%{init}%%", '"#37;#37;#123;init#125;#37;#37;"'),
        ("a\nb", '"a#92;nb"'),
        ("style a:b", '"style a#58;b"'),
    ],
)
def test_mermaid_labels(name: str, label: str) -> None:
    assert mermaid.quoted(name) == label


@pytest.mark.parametrize(
    ("name", "label"),
    [
        ("/a", '"/a"'),
        ('"];x', r'"\"];x"'),
        ("\\", r'"\\"'),
        ("\\N\\G", r'"\\N\\G"'),
        ("&lt;", '"&amp;lt;"'),
        ("a\nb", r'"a\\nb"'),
        ("<b>", '"<b>"'),
    ],
)
def test_dot_labels(name: str, label: str) -> None:
    assert dot.quoted(name) == label
    assert dot.quoted(name, "", "two") == f'{label[:-1]}\\ntwo"'


def _dot_tokens(text: str) -> list[str]:
    tokens, at = [], 0
    while text[at:].strip():
        match = _DOT_TOKEN.match(text, at)
        assert match is not None, text[at : at + 80]
        tokens.append(match[1])
        at = match.end()
    return tokens


@given(workspaces())
def test_dot_says_each_thing_once_whatever_the_names(workspace: Workspace) -> None:
    graph = graph_of(workspace)
    tokens = _dot_tokens(render(graph, "dot"))
    joined = [(tokens[at - 1], tokens[at + 1]) for at, token in enumerate(tokens) if token == "->"]
    assert sorted(joined) == sorted(edge.ends for edge in edges_of(graph))
    declared = [
        tokens[at]
        for at in range(1, len(tokens) - 1)
        if re.fullmatch(r"[nts]\d+", tokens[at])
        and tokens[at + 1] == "["
        and tokens[at - 1] != "->"
    ]
    assert sorted(declared) == _identifiers(graph)


@given(workspaces())
def test_mermaid_says_each_thing_once_whatever_the_names(workspace: Workspace) -> None:
    graph = graph_of(workspace)
    found = []
    for line in render(graph, "mermaid").splitlines():
        match = _MERMAID_LINE.fullmatch(line)
        assert match is not None, line
        found.append(match)
    assert sorted(match["id"] for match in found if match["id"]) == _identifiers(graph)
    assert sorted((match["start"], match["end"]) for match in found if match["start"]) == sorted(
        edge.ends for edge in edges_of(graph)
    )
    for match in found:
        label = re.sub(r"#\d+;|<br/>", "", match["label"] or "")
        assert not re.search("[^\\w /.,()·-]", label), label


@given(workspaces())
def test_every_format_is_printable_text_that_ends_in_a_newline(workspace: Workspace) -> None:
    graph = graph_of(workspace)
    for format_ in FORMATS:
        text = render(graph, format_)
        assert text.endswith("\n")
        assert text.replace("\n", "").isprintable()
        assert text == render(graph_of(workspace), format_)


def test_an_unknown_format() -> None:
    with pytest.raises(ValueError, match="png"):
        render(graph_of(Workspace()), "png")


def _identifiers(graph) -> list[str]:
    parts = (("n", graph.nodes), ("t", graph.topics), ("s", graph.services))
    return sorted(f"{letter}{at}" for letter, things in parts for at in range(len(things)))
