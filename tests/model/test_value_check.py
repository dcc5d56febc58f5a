from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from workspaces import LIBRARIES, FakeReader, codes, marked, run, workspace

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.language import Document, lower
from plastron_tui.model.context import Setting
from plastron_tui.model.interpreter import Interpretation, interpret
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.primitives import PRIMITIVES


def plain(value: object) -> Any:
    """Return a message's value as dictionaries and lists."""
    if isinstance(value, MessageValue):
        return {name: plain(part) for name, part in value.fields.items()}
    if isinstance(value, tuple):
        return [plain(part) for part in value]
    return value


def fitted(type_: str, values: str, library: str = "rospy") -> Any:
    text = f"create_message m of message_type {type_} and input {values}\n"
    return plain(workspace(text, library).messages["m"].value)


def misfit(type_: str, values: str, library: str = "rospy") -> tuple[str, str, Diagnostic]:
    text = f"create_message m of message_type {type_} and input {values}\n"
    (found,) = run(text, library).diagnostics
    return found.code, marked(text, found), found


TWIST = {"linear": {"x": 1.0, "y": 0.0, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": 0.5}}
POSE = "position=(1, 2, 3), orientation=(0, 0, 0, 1)"

FITS: list[tuple[str, str, Any]] = [
    ("Point", "5,6,7", {"x": 5.0, "y": 6.0, "z": 7.0}),
    ("Point", "none", {}),
    ("Point", "y=2", {"y": 2.0}),
    ("Point", "z=3, x=1", {"x": 1.0, "z": 3.0}),
    ("Point", "1, z=3", {"x": 1.0, "z": 3.0}),
    ("Point", "1, 2, z=3", {"x": 1.0, "y": 2.0, "z": 3.0}),
    ("Point", "-1e-3, .5, 5.", {"x": -0.001, "y": 0.5, "z": 5.0}),
    ("String", '"a\\"b\\\\c\\n{{ x }}"', {"data": 'a"b\\c\n{{ x }}'}),
    ("std_msgs/Bool", "True", {"data": True}),
    ("Char", "65", {"data": 65}),
    ("Twist", "1,0,0,0,0,0.5", TWIST),
    ("Twist", "(1,0,0),(0,0,0.5)", TWIST),
    ("Twist", "linear=(1,0,0), angular=(0,0,z=0.5)", TWIST),
    ("Twist", "(1,0,0), angular.z=0.5", {"linear": TWIST["linear"], "angular": {"z": 0.5}}),
    ("Twist", "linear.x=1.0", {"linear": {"x": 1.0}}),
    ("Twist", "angular.x=1, linear.x=2, angular.y=3",
        {"linear": {"x": 2.0}, "angular": {"x": 1.0, "y": 3.0}}),
    ("Twist", "linear=(), angular=(x=1)", {"linear": {}, "angular": {"x": 1.0}}),
    ("Pose", "1,2,3,0,0,0,1",
        {"position": {"x": 1.0, "y": 2.0, "z": 3.0},
         "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}),
    ("geometry_msgs/PoseStamped", 'header.frame_id="map", pose.position.x=1',
        {"header": {"frame_id": "map"}, "pose": {"position": {"x": 1.0}}}),
    ("sensor_msgs/LaserScan", "ranges=[1.0, 2, -.5], intensities=[]",
        {"ranges": [1.0, 2.0, -0.5], "intensities": []}),
    ("sensor_msgs/JointState", 'name=["a", "b"]', {"name": ["a", "b"]}),
    ("geometry_msgs/PoseArray", "poses=[(), ((1,2,3), ()), (position.x=4)]",
        {"poses": [
            {},
            {"position": {"x": 1.0, "y": 2.0, "z": 3.0}, "orientation": {}},
            {"position": {"x": 4.0}},
        ]}),
    ("std_msgs/UInt8MultiArray", 'layout.dim=[("x", 2, 3)], data=[0, 255]',
        {"layout": {"dim": [{"label": "x", "size": 2, "stride": 3}]}, "data": [0, 255]}),
    ("sensor_msgs/JointState", '(), ["a"], [], [], []',
        {"header": {}, "name": ["a"], "position": [], "velocity": [], "effort": []}),
    ("std_msgs/Time", "1.5", {"data": [1, 500_000_000]}),
    ("std_msgs/Time", "(3, 4)", {"data": [3, 4]}),
    ("std_msgs/Time", "(nsecs=4, secs=3)", {"data": [3, 4]}),
    ("std_msgs/Time", "(3, nsecs=4)", {"data": [3, 4]}),
    ("std_msgs/Time", "data.nsecs=4, data.secs=3", {"data": [3, 4]}),
    ("std_msgs/Time", "data.secs=3", {"data": [3, 0]}),
    ("std_msgs/Time", "()", {"data": [0, 0]}),
    ("std_msgs/Duration", "-1.25", {"data": [-2, 750_000_000]}),
    ("std_msgs/Header", '1, (3, 4), "map"', {"seq": 1, "stamp": [3, 4], "frame_id": "map"}),
]  # fmt: skip

FITS_2: list[tuple[str, str, Any]] = [
    ("std_msgs/Header", '1.5, "map"',
        {"stamp": {"sec": 1, "nanosec": 500_000_000}, "frame_id": "map"}),
    ("std_msgs/Header", '1, 2, "map"', {"stamp": {"sec": 1, "nanosec": 2}, "frame_id": "map"}),
    ("std_msgs/Header", '(1, 2), "map"', {"stamp": {"sec": 1, "nanosec": 2}, "frame_id": "map"}),
    ("std_msgs/Header", "stamp.sec=1", {"stamp": {"sec": 1}}),
    ("std_msgs/Header", "stamp=(nanosec=2)", {"stamp": {"nanosec": 2}}),
    ("builtin_interfaces/Duration", "-1, 5", {"sec": -1, "nanosec": 5}),
    ("trajectory_msgs/JointTrajectoryPoint", "time_from_start=-0.5",
        {"time_from_start": {"sec": -1, "nanosec": 500_000_000}}),
    ("shape_msgs/SolidPrimitive", "dimensions=[1, 2, 3]", {"dimensions": [1.0, 2.0, 3.0]}),
]  # fmt: skip


@pytest.mark.parametrize(("type_", "values", "expected"), FITS)
def test_values_that_fit(type_: str, values: str, expected: Any) -> None:
    assert fitted(type_, values) == expected


@pytest.mark.parametrize(("type_", "values", "expected"), FITS_2)
def test_values_that_fit_in_ros_2(type_: str, values: str, expected: Any) -> None:
    assert fitted(type_, values, "rclpy") == expected


def test_a_float_field_always_has_a_float() -> None:
    assert all(type(value) is float for value in fitted("Point", "1, 2, 3").values())
    assert all(
        type(value) is float for value in fitted("sensor_msgs/LaserScan", "ranges=[1]")["ranges"]
    )


def test_fields_come_in_the_order_of_the_type() -> None:
    assert list(fitted("Quaternion", "w=1, z=2, x=3")) == ["x", "z", "w"]


MISFITS: list[tuple[str, str, str, str, str | None]] = [
    ("Point", "1, 2", "wrong-number-of-values", "1, 2", "in order: x, y, z"),
    ("Point", "1, 2, 3, 4", "wrong-number-of-values", "1, 2, 3, 4", "in order: x, y, z"),
    ("Twist", "1", "wrong-number-of-values", "1", "linear.x, linear.y, linear.z, angular.x"),
    ("Twist", "linear=(1, 2)", "wrong-number-of-values", "(1, 2)", "in order: x, y, z"),
    ("Point", "1, 2, 3, 4, x=1", "wrong-number-of-values", "4", "in order: x, y, z"),
    ("std_msgs/Empty", "1", "wrong-number-of-values", "1", "write `none`"),
    ("Point", "w=1", "unknown-field", "w", None),
    ("Quaternion", "xx=1", "unknown-field", "xx", "did you mean `x`?"),
    ("Twist", "linear.w=1", "unknown-field", "w", None),
    ("Twist", "linaer.x=1", "unknown-field", "linaer", "did you mean `linear`?"),
    ("Twist", "linear_x=1", "unknown-field", "linear_x", "did you mean `linear.x`?"),
    ("Pose", "position_x=1", "unknown-field", "position_x", "did you mean `position.x`?"),
    ("Point", "x.y=1", "unknown-field", "y", None),
    ("sensor_msgs/LaserScan", "ranges.x=1", "unknown-field", "x", None),
    ("std_msgs/Empty", "x=1", "unknown-field", "x", "has no fields"),
    ("Point", "x=1, x=2", "duplicate-field", "x", None),
    ("Point", "1, x=2", "duplicate-field", "x", None),
    ("Twist", "linear=(1,2,3), linear.x=2", "duplicate-field", "linear", None),
    ("Twist", "linear.x=2, linear=(1,2,3)", "duplicate-field", "linear", None),
    ("Twist", "linear.x=2, linear.x=3", "duplicate-field", "x", None),
    ("Point", "x=1, 2", "value-after-named", "2", "name it too"),
    ("Twist", "linear=(x=1, 2)", "value-after-named", "2", None),
    ("Point", 'x="1"', "wrong-kind-of-value", '"1"', "`float64`; write 1 without quotes"),
    ("Point", "x=True", "wrong-kind-of-value", "True", "float64"),
    ("Point", "x=[1]", "wrong-kind-of-value", "[1]", "float64"),
    ("Point", "x=(1)", "wrong-kind-of-value", "(1)", "float64"),
    ("Int32", "1.0", "wrong-kind-of-value", "1.0", "int32"),
    ("Int32", "1e3", "wrong-kind-of-value", "1e3", "int32"),
    ("Int32", "True", "wrong-kind-of-value", "True", "int32"),
    ("String", "5", "wrong-kind-of-value", "5", 'write "5"'),
    ("std_msgs/Bool", "1", "wrong-kind-of-value", "1", "write `True`"),
    ("std_msgs/Bool", "7", "wrong-kind-of-value", "7", "write `True` or `False`"),
    ("std_msgs/Bool", '"off"', "wrong-kind-of-value", '"off"', "write `False`"),
    ("std_msgs/Bool", '"True"', "wrong-kind-of-value", '"True"', "bool"),
    ("Twist", "linear=1", "wrong-kind-of-value", "1", "linear=(x, y, z)"),
    ("Twist", "linear=[1, 2, 3]", "wrong-kind-of-value", "[1, 2, 3]", "linear=(x, y, z)"),
    ("sensor_msgs/LaserScan", "ranges=1.0", "wrong-kind-of-value", "1.0", "ranges=["),
    ("sensor_msgs/LaserScan", "ranges=(1.0)", "wrong-kind-of-value", "(1.0)", "ranges=["),
    ("sensor_msgs/LaserScan", 'ranges=[1, "2"]', "wrong-kind-of-value", '"2"', None),
    ("geometry_msgs/PoseArray", "poses=[1]", "wrong-kind-of-value", "1", None),
    ("std_msgs/Time", '"now"', "wrong-kind-of-value", '"now"', None),
    ("std_msgs/Time", "(1, 2, 3)", "wrong-kind-of-value", "(1, 2, 3)", "seconds"),
    ("std_msgs/Time", "(1.5, 2)", "wrong-kind-of-value", "1.5", "seconds"),
    ("std_msgs/Time", "(sec=1)", "wrong-kind-of-value", "(sec=1)", "seconds"),
    ("std_msgs/Time", "(1, secs=2)", "wrong-kind-of-value", "(1, secs=2)", "seconds"),
    ("std_msgs/Time", "-1", "value-out-of-range", "-1", None),
    ("std_msgs/Time", "5e9", "value-out-of-range", "5e9", None),
    ("std_msgs/Time", "(1, 1000000000)", "value-out-of-range", "1000000000", None),
    ("std_msgs/Time", "(-1, 0)", "value-out-of-range", "-1", None),
    ("Point", "x=1e999", "value-out-of-range", "1e999", None),
    ("Point", "x=" + "9" * 400, "value-out-of-range", "9" * 400, None),
    ("Int32", "9" * 5000, "value-out-of-range", "9" * 5000, None),
    ("Float32", "1e39", "value-out-of-range", "1e39", None),
    ("geometry_msgs/PoseWithCovariance", "covariance=[1, 2]", "wrong-array-length", "[1, 2]", None),
    ("geometry_msgs/PoseWithCovariance", "covariance=[]", "wrong-array-length", "[]", None),
    ("String", '"\\ud800"', "invalid-text", '"\\ud800"', None),
]  # fmt: skip

MISFITS_2: list[tuple[str, str, str, str, str | None]] = [
    ("shape_msgs/SolidPrimitive", "dimensions=[1, 2, 3, 4]", "wrong-array-length",
        "[1, 2, 3, 4]", None),
    ("String", '"\\u0000"', "invalid-text", '"\\u0000"', None),
    ("std_msgs/Header", 'stamp="now"', "wrong-kind-of-value", '"now"', "seconds"),
    ("std_msgs/Header", "stamp=True", "wrong-kind-of-value", "True", "seconds"),
    ("std_msgs/Header", "stamp=3e9", "value-out-of-range", "3e9", None),
    ("std_msgs/Header", "stamp=(1, -1)", "value-out-of-range", "-1", None),
    ("std_msgs/Header", "stamp.secs=1", "unknown-field", "secs", "did you mean `sec`?"),
]  # fmt: skip


@pytest.mark.parametrize("case", MISFITS, ids=[f"{each[0]} {each[1][:40]}" for each in MISFITS])
def test_values_that_do_not_fit(case: tuple[str, str, str, str, str | None]) -> None:
    type_, values, code, where, remedy = case
    found = misfit(type_, values)
    assert found[:2] == (code, where)
    assert remedy is None or remedy in (found[2].help or "")


@pytest.mark.parametrize("case", MISFITS_2, ids=[f"{each[0]} {each[1]}" for each in MISFITS_2])
def test_values_that_do_not_fit_in_ros_2(case: tuple[str, str, str, str, str | None]) -> None:
    type_, values, code, where, remedy = case
    found = misfit(type_, values, "rclpy")
    assert found[:2] == (code, where)
    assert remedy is None or remedy in (found[2].help or "")


def test_a_request_is_fitted_as_a_message_is() -> None:
    node = "create_node 'a' as n\nn client_requests 's' of service_type AddTwoInts with input "
    assert codes(node + "5, 6\n") == []
    assert codes(node + "none\n") == []
    assert codes(node + "5\n") == ["wrong-number-of-values"]
    assert codes(node + "a=5, b=6, sum=7\n") == ["unknown-field"]
    assert codes(node + "5, 6.5\n") == ["wrong-kind-of-value"]


@pytest.fixture(scope="module")
def own_types(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Make a package with a message for each primitive, and for each kind of array."""
    folder = tmp_path_factory.mktemp("types")
    package = folder / "own_msgs"
    (package / "msg").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>own_msgs</name></package>")
    for version, primitives in PRIMITIVES.items():
        for name in primitives:
            (package / "msg" / f"R{version}{name.capitalize()}.msg").write_text(f"{name} data\n")
    (package / "msg" / "Bounded.msg").write_text(
        "string<=3 text\nint8[<=2] few\nint8[2] pair\nstring<=2[<=2] words\n"
    )
    return folder


def run_with_types(text: str, library: str, folder: Path) -> Interpretation:
    catalogs = {1: Catalog("noetic", (folder,)), 2: Catalog("jazzy", (folder,))}
    setting = Setting(library, LIBRARIES, catalogs.__getitem__, FakeReader())
    return interpret(lower(Document(text.encode())), setting)


@pytest.mark.parametrize(
    ("version", "name"), [(version, name) for version in PRIMITIVES for name in PRIMITIVES[version]]
)
def test_the_range_of_every_primitive(version: int, name: str, own_types: Path) -> None:
    library = {1: "rospy", 2: "rclpy"}[version]
    primitive = PRIMITIVES[version][name]

    def found(value: object) -> list[str]:
        type_ = f"own_msgs/R{version}{name.capitalize()}"
        text = f"create_message m of message_type {type_} and input {value}\n"
        return [each.code for each in run_with_types(text, library, own_types).diagnostics]

    if primitive.low is not None and primitive.high is not None:
        assert found(primitive.low) == found(primitive.high) == found(0) == []
        assert found(primitive.low - 1) == ["value-out-of-range"]
        assert found(primitive.high + 1) == ["value-out-of-range"]
        assert found("0.5") == found('"0"') == found("True") == ["wrong-kind-of-value"]
    elif primitive.kind is float:
        assert found(1) == found("0.5") == []
        assert found('"0"') == found("True") == ["wrong-kind-of-value"]
        assert found("1e999") == ["value-out-of-range"]
    elif primitive.kind is str:
        assert found('"a"') == found('""') == []
        assert found(1) == found("False") == ["wrong-kind-of-value"]
    else:
        assert found("True") == found("False") == []
        assert found(1) == found('"True"') == ["wrong-kind-of-value"]


BOUNDS = {
    'text="abc"': [],
    'text="abcd"': ["invalid-text"],
    "few=[1, 2]": [],
    "few=[]": [],
    "few=[1, 2, 3]": ["wrong-array-length"],
    "pair=[1, 2]": [],
    "pair=[1]": ["wrong-array-length"],
    "pair=[1, 300]": ["value-out-of-range"],
    'words=["ab", "cd"]': [],
    'words=["abc"]': ["invalid-text"],
    'words=["a", "b", "c"]': ["wrong-array-length"],
}


@pytest.mark.parametrize(("values", "expected"), BOUNDS.items())
def test_bounds(values: str, expected: list[str], own_types: Path) -> None:
    text = f"create_message m of message_type own_msgs/Bounded and input {values}\n"
    assert [each.code for each in run_with_types(text, "rclpy", own_types).diagnostics] == expected
