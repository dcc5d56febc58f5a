"""What the forms of the live panel show, and what they make of what is entered."""

from __future__ import annotations

from typing import Any, cast

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.runtime.live_graph import LiveField, LiveParameter
from plastron_tui.runtime.observers import ros1_parameters
from plastron_tui.session import Session
from plastron_tui.studio.panels.live_row import Kind, LiveRow
from plastron_tui.studio.wizard.live_orders import form_for
from plastron_tui.studio.wizard.live_rates import RATE, rate_of
from plastron_tui.studio.wizard.parameter_kinds import parameter_entry
from plastron_tui.studio.wizard.sent_values import Wrong, sent_setting, sent_values, shown_setting
from plastron_tui.studio.wizard.values import entries_of

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
     ("float_list", "1e999, inf", None),
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
     ("std_msgs/Float64", [("data", "inf")], {}),
     ("std_msgs/Float64", [("other", "1")], {})],
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
