"""What the forms of the live panel show, and what they make of what is entered."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import Any, cast

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from studio_driver import studio

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.runtime.live_graph import LiveField
from plastron_tui.runtime.live_parts import LiveParameter
from plastron_tui.runtime.observers import ros1_parameters
from plastron_tui.session import Session
from plastron_tui.studio.panels.live_row import Kind, LiveRow
from plastron_tui.studio.wizard.live_form import notes_of
from plastron_tui.studio.wizard.live_orders import form_for
from plastron_tui.studio.wizard.live_rates import RATE, rate_of
from plastron_tui.studio.wizard.parameter_kinds import parameter_entry
from plastron_tui.studio.wizard.rows import Row
from plastron_tui.studio.wizard.sent_values import Wrong, sent_setting, sent_values, shown_setting
from plastron_tui.studio.wizard.values import Entry, Path, entries_of

INF = float("inf")
CATALOG = Catalog("kilted")
SENT: list[tuple[str, str, dict[tuple[str, ...], str], Any]] = [
    ("msg", "std_msgs/String", {("data",): "hi, you"}, {"data": "hi, you"}),
    ("msg", "geometry_msgs/Twist", {("linear", "x"): "1"}, {"linear": {"x": 1.0}}),
    ("msg", "geometry_msgs/Twist", {}, {}),
    ("msg", "std_msgs/Int32MultiArray", {("data",): "1, 2"}, {"data": [1, 2]}),
    ("msg", "builtin_interfaces/Time", {("sec",): "5"}, {"sec": 5}),
    ("srv", "std_srvs/SetBool", {("data",): "yes"}, {"data": True}),
    ("msg", "geometry_msgs/Polygon", {("points",): "(x=1, y=2)"},
     {"points": [{"x": 1.0, "y": 2.0}]}),
    ("msg", "geometry_msgs/Twist", {("linear", "x"): "fast"},
     Wrong("x takes a number, such as 0.5", ("linear", "x"))),
    ("msg", "std_msgs/UInt8", {("data",): "300"}, ("data",)),
    ("msg", "std_msgs/Float64", {("data",): "received.data"}, ("data",)),
    ("msg", "geometry_msgs/Polygon", {("points",): "(q=1)"}, None),
    ("msg", "std_msgs/Float64", {("data",): "-inf"}, {"data": -INF}),
    ("msg", "std_msgs/Float32", {("data",): "Inf"}, {"data": INF}),
    ("msg", "geometry_msgs/Twist", {("linear", "x"): "inf", ("angular", "z"): "1"},
     {"linear": {"x": INF}, "angular": {"z": 1.0}}),
    ("msg", "sensor_msgs/LaserScan", {("ranges",): "2, inf, -inf, 0.3", ("range_max",): "inf"},
     {"range_max": INF, "ranges": [2.0, INF, -INF, 0.3]}),
    ("msg", "std_msgs/Float64", {("data",): "info"},
     Wrong("data takes a number, such as 0.5", ("data",))),
    ("msg", "sensor_msgs/LaserScan", {("ranges",): "inf, far"},
     Wrong("`far`, value 2 of the list: ranges takes a number, such as 0.5", ("ranges",))),
    ("msg", "sensor_msgs/LaserScan", {("ranges",): "inf, parameter 'inf'"}, ("ranges",)),
    ("msg", "std_msgs/Int32", {("data",): "inf"}, ("data",)),
    ("msg", "builtin_interfaces/Duration", {("sec",): "nan"}, ("sec",)),
    ("msg", "std_msgs/String", {("data",): "inf"}, {"data": "inf"}),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "type_", "given", "wanted"), SENT)
def test_what_is_entered_is_checked_and_becomes_values(
    kind: str, type_: str, given: dict[tuple[str, ...], str], wanted: Any
) -> None:
    interface = CATALOG.find(InterfaceName(*type_.split("/")), InterfaceKind(kind))
    assert interface is not None
    found = sent_values(interface, CATALOG, entries_of(interface, CATALOG), given)
    if wanted is None or (isinstance(wanted, tuple) and not isinstance(wanted, Wrong)):
        assert isinstance(found, Wrong) and found.path == wanted
    else:
        assert found == wanted


@pytest.mark.parametrize(
    ("type_", "text", "value"),
    [("float", "1", 1.0), ("int", "-3", -3), ("bool", "off", False), ("string", "a, b", "a, b"),
     ("float_list", "[1, 2.5]", [1.0, 2.5]), ("string_list", '"a, b", c', ["a, b", "c"]),
     ("int", "1.5", None), ("float", "fast", None), ("int", str(2**63), None),
     ("float", "parameter 'x'", None), ("float", "1e999", None),
     ("float_list", "1e999, inf", None), ("float_list", "1, parameter 'x'", None),
     ("string", r'"a\nb"', "a\nb"), ("string", r'"C:\dir"', r"C:\dir"),
     ("string", r"C:\dir", r"C:\dir"),
     ("string", r'"\u0000"', None)],
)  # fmt: skip
def test_a_parameter_gets_a_value_of_its_type(type_: str, text: str, value: Any) -> None:
    kind = ParameterType(type_)
    found = sent_setting(parameter_entry("p", kind), kind, text, 2)
    assert isinstance(found, Wrong) if value is None else found == value


TEXTS = st.text(
    st.sampled_from(list("a \t\n\x1b\"',\\[]=()é\u3042\U0001f600\u202e")), max_size=6
) | st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"), max_size=5)
SCALARS: dict[ParameterType, st.SearchStrategy[Any]] = {
    ParameterType.BOOL: st.booleans(),
    ParameterType.INT: st.integers(-(2**63), 2**63 - 1),
    ParameterType.FLOAT: st.floats(),
    ParameterType.STRING: TEXTS,
}


def settings_of(kind: ParameterType) -> st.SearchStrategy[Any]:
    scalars = SCALARS[kind.element]
    if kind is ParameterType.FLOAT_LIST:
        # ROS 1 keeps whole numbers among others.
        scalars |= st.integers(-(2**53), 2**53)
    return st.lists(scalars, max_size=4).map(tuple) if kind.is_list else scalars


@settings(max_examples=300, deadline=None)
@given(
    st.sampled_from(ParameterType).flatmap(lambda kind: st.tuples(st.just(kind), settings_of(kind)))
)
@example((ParameterType.FLOAT, float("inf")))
@example((ParameterType.FLOAT_LIST, (float("-inf"), float("nan"), -0.0, 1)))
@example((ParameterType.STRING, "received.data"))
@example((ParameterType.STRING_LIST, ("",)))
@example((ParameterType.STRING_LIST, ("parameter 'a'", '"a', "b", "[", "c]")))
def test_a_value_that_is_shown_is_taken_back_as_it_was(case: tuple[ParameterType, Any]) -> None:
    kind, value = case
    shown = shown_setting(value)
    assert shown.isprintable()
    found = sent_setting(parameter_entry("p", kind), kind, shown, 2)
    assert repr(found) == repr([*map(as_kind(kind), value)] if kind.is_list else value)


def as_kind(kind: ParameterType) -> type:
    return {"bool": bool, "int": int, "float": float}.get(kind.element.value, str)


@pytest.mark.parametrize(
    ("value", "kind"),
    [(True, "bool"), (1, "int"), (0.5, "float"), ("a", "string"), ([1, 2.5], "float_list"),
     ([True, False], "bool_list"), ([True, 1], ""), ([], ""), ([[1]], ""), (None, ""), (b"a", "")],
)  # fmt: skip
def test_what_a_master_keeps_has_a_type_where_a_form_can_hold_it(value: Any, kind: str) -> None:
    (row,) = ros1_parameters.rows_of({"a": {"b": value}})
    assert (row["name"], row["type"]) == ("a/b", kind)
    assert row["value"] == (value if kind else str(value))


@pytest.mark.parametrize(
    ("type_", "value"),
    [("string_list", ("a, b", "c")), ("string_list", ("[a]", 'b"c')), ("string_list", ("",)),
     ("string_list", (" x ", "\\n", "a\nb", "\u202e", "received.data", '"q"')),
     ("string_list", ()), ("string_list", ("a b", "/map", "1")), ("bool_list", (True, False)),
     ("float_list", (1e22, -0.5)), ("float", float("inf")), ("int", -3), ("bool", False),
     ("string", "parameter 'x'"), ("string", "two\nlines"), ("string", "")],
)  # fmt: skip
def test_a_parameter_that_nobody_touched_stays_as_it_is(type_: str, value: Any) -> None:
    parameter = LiveParameter("p", value, type_)
    row = LiveRow("k", Kind.PARAMETER, "p", "/a", parameter=parameter)
    form = form_for(row, cast(Session, None), {})
    assert not isinstance(form, str)
    wanted = list(value) if isinstance(value, tuple) else value
    assert form.order(form.dialog.given)["value"] == wanted


@pytest.mark.parametrize(
    ("type_", "seen", "given"),
    [("geometry_msgs/Twist", [("linear.x", "0.3"), ("linear.y", "0"), ("angular.z", "-1e-05")],
      {("linear", "x"): "0.3", ("angular", "z"): "-1e-05"}),
     ("std_msgs/Bool", [("data", "True")], {("data",): "True"}),
     # Of a text or a list only the beginning may be known; a stamp is when it is sent.
     ("sensor_msgs/JointState", [("header.stamp", "5.0"), ("position", "[1.0, … 9 in all]")], {}),
     ("rosgraph_msgs/Clock", [("clock", "5.0")], {}),
     ("sensor_msgs/JointState", [("position", "1.0")], {}),
     ("sensor_msgs/JointState", [("header.stamp", "5.0"), ("header.frame_id", '"base"')], {}),
     ("std_msgs/Float64", [("data", "inf")], {("data",): "inf"}),
     ("std_msgs/Float64", [("other", "1")], {}),
     ("sensor_msgs/LaserScan", [("angle_min", "-1.57"), ("ranges", "[2, 0.3, inf]"),
                                ("intensities", "[]")],
      {("angle_min",): "-1.57", ("ranges",): "2, 0.3, inf"}),
     # Of many ranges the nearest and the farthest are known: it begins with some, not with none.
     ("sensor_msgs/LaserScan", [("range_max", "10"), ("ranges", "360 numbers, 0.4…3.2")],
      {("range_max",): "10", ("ranges",): "2.0, 1.0, 2.0"}),
     ("sensor_msgs/LaserScan", [("range_max", "0"), ("ranges", "[]")], {}),
     # None came yet: it begins as in the wizard.
     ("geometry_msgs/Twist", [], {("linear", "x"): "0.2", ("angular", "z"): "0.0"}),
     ("sensor_msgs/LaserScan", [],
      {("angle_min",): "-0.5", ("angle_max",): "0.5", ("angle_increment",): "0.5",
       ("range_min",): "0.1", ("range_max",): "8.0", ("ranges",): "2.0, 1.0, 2.0"})],
)  # fmt: skip
def test_a_message_that_is_sent_begins_with_the_last_one_that_came(
    type_: str, seen: list[tuple[str, str]], given: dict[tuple[str, ...], str]
) -> None:
    row = LiveRow("k", Kind.TOPIC, "/a", "/a", type=type_)
    fields = [LiveField(*each) for each in seen]
    form = form_for(row, Session(b""), {}, fields)
    assert not isinstance(form, str) and form.dialog.given == given
    # What was sent the last time comes before that.
    before = {next(iter(given), ("data",)): "1"}
    form = form_for(row, Session(b""), before, fields)
    assert not isinstance(form, str) and form.dialog.given == before


DRIVING = b"""\
create_node 'driver' as driver
subscribe driver to 'scan' of message_type LaserScan
create_message halt of message_type Twist and input none
driver publish halt to 'cmd' of message_type Twist for_each 'scan' when any received.ranges < 0.5
"""


@pytest.mark.parametrize(
    ("owner", "type_", "at", "edited", "start"),
    [("/scan", "sensor_msgs/LaserScan", (), (), ("ranges",)),
     ("/robot1/scan", "sensor_msgs/LaserScan", (), ("range_max",), ("ranges",)),
     ("/scan", "sensor_msgs/LaserScan", ("angle_min",), (), ("angle_min",)),
     # What is filled in when it is sent is no field of the form.
     ("/scan", "sensor_msgs/LaserScan", ("header", "stamp"), (), ("ranges",)),
     ("/other", "sensor_msgs/LaserScan", (), ("range_max",), ("range_max",)),
     ("/scan", "sensor_msgs/Range", (), (), None),
     ("/cmd", "geometry_msgs/Twist", (), ("angular", "z"), ("angular", "z"))],
)  # fmt: skip
def test_a_form_begins_at_what_is_meant(
    owner: str, type_: str, at: Path, edited: Path, start: Path | None
) -> None:
    row = LiveRow("k", Kind.TOPIC, owner, owner, type=type_)
    form = form_for(row, Session(DRIVING), {}, (), at, edited)
    assert not isinstance(form, str) and form.dialog.start == start


@pytest.mark.parametrize(
    ("text", "rate"),
    [("", 0), ("once", 0), (" Once ", 0), ("10", 10), ("10hz", 10), ("0.5 Hz", 0.5), ("500", 500),
     ("501", None), ("0", None), ("-1", None), ("often", None), ("10 hz 2", None), ("1e999", None),
     ("nan", None)],
)  # fmt: skip
def test_a_message_is_sent_once_or_at_a_rate(text: str, rate: float | None) -> None:
    row = LiveRow("k", Kind.TOPIC, "/a", "/a", type="std_msgs/Float64")
    form = form_for(row, Session(b""), {})
    assert not isinstance(form, str)
    given = {RATE.path: text, ("data",): "1"}
    found = rate_of(given)
    if rate is None:
        assert isinstance(found, Wrong) and found.path == RATE.path
        assert form.dialog._check(given) == found
    else:
        assert found == rate
        assert form.order(given) == {"do": "publish", "name": "/a", "type": row.type,
                                     "rate": rate, "values": {"data": 1.0}}  # fmt: skip


def test_a_goal_has_its_fields_and_no_rate() -> None:
    row = LiveRow("k", Kind.ACTION, "/a", "/a", type="example_interfaces/Fibonacci")
    form = form_for(row, Session(b""), {})
    assert not isinstance(form, str)
    assert form.order({("order",): "5"}) == {"do": "goal", "name": "/a", "type": row.type,
                                             "values": {"order": 5}}  # fmt: skip
    assert isinstance(form.dialog._check({("order",): "x"}), Wrong)


def test_units_and_types_stand_in_columns_of_their_own() -> None:
    interface = CATALOG.find(InterfaceName("sensor_msgs", "LaserScan"), InterfaceKind.MESSAGE)
    assert interface is not None
    fields = [each for each in entries_of(interface, CATALOG) if isinstance(each, Entry)]
    notes = {path[-1]: note for path, note in notes_of([*fields, RATE]).items()}
    assert notes["angle_min"] == "rad  float32"
    assert notes["range_max"] == "m    float32"
    # What there is no room for is below the form, where the focus is.
    assert notes["ranges"] == "m    float32[]"
    assert notes["frame_id"] == "     string"
    assert notes["how often"] == "     once, or 10 hz"
    assert list(notes_of([RATE]).values()) == ["once, or 10 hz"]
    assert notes_of([]) == {}


async def test_the_rows_of_a_form_have_the_same_columns(program: FilePath) -> None:
    async with studio(program, (60, 16)) as driver:
        row = LiveRow("k", Kind.TOPIC, "/scan", "/scan", 2, "sensor_msgs/LaserScan")
        form = form_for(row, Session(), {})
        assert not isinstance(form, str)
        driver.app.push_screen(form.dialog)
        await driver.dialog("LiveForm")
        rows = list(form.dialog.query(Row))
        await driver.until(lambda: all(each.box.region.width for each in rows))
        for part in (".wizard-label", "TextBox", ".wizard-note"):
            found = [each.query_one(part) for each in rows]
            assert len({(each.region.x, each.region.width) for each in found}) == 1, part
