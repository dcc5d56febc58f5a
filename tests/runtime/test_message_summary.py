"""What a monitor tells of a message, whichever ROS it is of."""

from __future__ import annotations

import array
import ast
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import plastron_tui.runtime.observers as observers


@pytest.fixture(autouse=True)
def as_scripts(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The scripts find each other as they do where they run: they stand alone."""
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    yield


class Rclpy(SimpleNamespace):
    """A message as those of rclpy: it says which fields it has."""

    def get_fields_and_field_types(self) -> dict[str, str]:
        return dict.fromkeys(vars(self), "")


def rospy(*types: str, **fields: Any) -> Any:
    """Return a message as those of rospy: its slots are its fields."""
    made = type("Message", (), {"__slots__": list(fields), "_slot_types": list(types)})()
    for name, value in fields.items():
        setattr(made, name, value)
    return made


class Time(SimpleNamespace):
    pass


def vector(x: float, y: float, z: float) -> Rclpy:
    return Rclpy(x=x, y=y, z=z)


def scan(*ranges: float, low: float = 0.1, high: float = 10.0) -> Rclpy:
    return Rclpy(ranges=array.array("f", ranges), range_min=low, range_max=high)


INF, NAN = float("inf"), float("nan")


SUMMARIES = [
    (Rclpy(data="hello"), "std_msgs/String", '"hello"', None),
    (rospy("int32", data=3), "std_msgs/Int32", "3", 3.0),
    (Rclpy(data=True), "std_msgs/Bool", "True", 1.0),
    (Rclpy(), "std_msgs/Empty", "empty", None),
    (Rclpy(data=float("nan")), "std_msgs/Float64", "nan", None),
    (Rclpy(x=1.0, y=2.5), "a/Two", "x: 1, y: 2.5", 1.0),
    # Of many fields those that say something.
    (Rclpy(linear=vector(0.5, 0, 0), angular=vector(0, 0, 0)), "geometry_msgs/Twist",
     "linear.x: 0.5", 0.5),
    (Rclpy(linear=vector(0, 0, 0), angular=vector(0, 0, 0)), "geometry_msgs/Twist", "all: 0", 0.0),
    # The number of a header is none of the message's.
    (Rclpy(header=Rclpy(seq=7, frame_id="map"), range=2.0), "sensor_msgs/Range", "2", 2.0),
    (Rclpy(width=640, height=480, encoding="rgb8", data=bytes(921_600)), "sensor_msgs/Image",
     "640x480 rgb8, 922 KB", None),
    (Rclpy(format="jpeg", data=bytes(1_500)), "sensor_msgs/CompressedImage", "jpeg, 1.5 KB", None),
    (scan(*[0.4] * 359, 3.2), "sensor_msgs/LaserScan", "360 ranges, nearest 0.4 m", None),
    (scan(float("inf"), 0.0), "sensor_msgs/LaserScan", "2 ranges, nothing in reach", None),
    (Rclpy(fields=[Rclpy(name="x"), Rclpy(name="y")], width=100, height=20, data=bytes(16_000)),
     "sensor_msgs/PointCloud2", "2,000 points (x y), 16 KB", None),
    (Rclpy(info=Rclpy(width=4, height=3, resolution=0.05)), "nav_msgs/OccupancyGrid",
     "4x3 cells of 0.05 m", None),
    (Rclpy(poses=[1, 2]), "nav_msgs/Path", "2 poses", None),
    (Rclpy(transforms=[Rclpy(header=Rclpy(frame_id="odom"), child_frame_id="base")]),
     "tf2_msgs/TFMessage", "1 transform: odom → base", None),
    (Rclpy(data=[1.0] * 5000), "a/Long", "5000 numbers, 1…1", None),
    (Rclpy(data=["a"] * 9), "a/Words", "9 values", None),
    (Rclpy(data=[1, 2]), "a/Short", "[1, 2]", None),
    (Rclpy(parts=[Rclpy(x=1)] * 3), "a/Parts", "3 × Rclpy", None),
    (Rclpy(data="x" * 5000), "std_msgs/String", f'"{"x" * 120}…"', None),
]  # fmt: skip


@pytest.mark.parametrize(("message", "type_name", "text", "number"), SUMMARIES)
def test_a_message_is_told_in_a_line(
    message: Any, type_name: str, text: str, number: float | None
) -> None:
    from message_summary import summary_of

    found = summary_of(message, type_name)
    assert (found.text, found.number) == (text, number)


@pytest.mark.parametrize(
    ("message", "text"),
    [
        (scan(2, 0.3, 4), "3 ranges, nearest 0.3 m"),
        (scan(2, 0.3, 4, high=0), "3 ranges, nearest 0.3 m"),
        (scan(2, 0.3, 4, low=0, high=0), "3 ranges, nearest 0.3 m"),
        (scan(2, 0.3, 4, low=1, high=0), "3 ranges, nearest 2 m"),
        (scan(2, 0.3, 4, low=9, high=1), "3 ranges, nearest 0.3 m"),
        (scan(2, 0.3, 4, low=NAN, high=NAN), "3 ranges, nearest 0.3 m"),
        (scan(2, 0.3, 4, low=-INF, high=INF), "3 ranges, nearest 0.3 m"),
        (scan(2, 0.3, 4, low=INF, high=-1), "3 ranges, nearest 0.3 m"),
        (scan(2, 0.3, 4, low=1, high=3), "3 ranges, nearest 2 m"),
        (scan(0, 0.3, high=0, low=0), "2 ranges, nearest 0 m"),
        (scan(NAN, INF, -INF, 0.7, high=INF), "4 ranges, nearest 0.7 m"),
        (scan(NAN, INF, -INF, high=INF), "3 ranges, nothing in reach"),
        (scan(-1, high=0), "1 range, nothing in reach"),
        (scan(), "0 ranges"),
    ],
)
def test_a_scan_is_told_by_what_is_nearest(message: Any, text: str) -> None:
    from message_summary import summary_of

    assert summary_of(message, "sensor_msgs/LaserScan").text == text


def test_fields_are_told_by_their_paths() -> None:
    from message_summary import MOST_FIELDS, fields_of

    message = Rclpy(stamp=Time(sec=2, nanosec=500_000_000), linear=vector(1.0, 0, 0), name="arm")
    assert [tuple(each) for each in fields_of(message)] == [
        ("stamp", "2.500 s", None), ("linear.x", "1", 1.0), ("linear.y", "0", 0.0),
        ("linear.z", "0", 0.0), ("name", '"arm"', None),
    ]  # fmt: skip
    many = fields_of(Rclpy(**{f"f{number}": number for number in range(MOST_FIELDS + 5)}))
    assert len(many) == MOST_FIELDS + 1 and many[-1].text == "more fields"


def test_a_topic_is_decoded_once_a_report(monkeypatch: pytest.MonkeyPatch) -> None:
    import monitor_topics

    now = [100.0]
    monkeypatch.setattr(monitor_topics.time, "monotonic", lambda: now[0])
    decoded: list[int] = []

    def decode(raw: int) -> Rclpy:
        decoded.append(raw)
        # It takes a tenth of a second.
        now[0] += 0.1
        return Rclpy(data=raw)

    topic = monitor_topics.WatchedTopic("std_msgs/Int32", decode)
    assert topic.report() == {"count": 0, "rate": 0.0}
    assert topic.report() is None
    for number in range(20):
        topic.see(number, 100 + number / 10)
    now[0] = 102.0
    assert topic.report() == {"count": 20, "rate": 10.0, "text": "19", "number": 19.0}
    # What takes long is not done again at once, but in the end.
    topic.see(20, 102.0)
    assert topic.report()["text"] == "19"
    now[0] += 2
    topic.is_full = True
    assert topic.report() == {
        "count": 21, "rate": 0.0, "text": "20", "number": 20.0, "fields": [("data", "20", 20.0)],
    }  # fmt: skip
    assert decoded == [19, 20]


def test_what_cannot_be_decoded_is_said() -> None:
    from monitor_topics import WatchedTopic

    topic = WatchedTopic("a/B", lambda raw: raw.none)
    topic.see(b"")
    assert topic.report()["text"].startswith("cannot be read: ")


class Duration:
    def __init__(self, secs: int = 0, nsecs: int = 0) -> None:
        self.secs, self.nsecs = secs, nsecs


@pytest.mark.parametrize(
    "name",
    ["arrivals", "message_filling", "message_summary", "monitor_pipes", "monitor_ros1",
     "monitor_services", "monitor_subscriptions", "monitor_topics", "plastron_text",
     "ros1_parameters", "watch"],
)  # fmt: skip
def test_the_python_of_ros_1_can_read_it(name: str) -> None:
    """Noetic has Python 3.8."""
    text = Path(observers.__file__).with_name(f"{name}.py").read_text()
    ast.parse(text, feature_version=(3, 8))
    assert "strict=" not in text and "from __future__ import annotations" in text


def test_messages_are_filled_with_what_came_as_json() -> None:
    from message_filling import fill, has_stamp

    message = rospy("float64", "duration", "uint8[]", x=0.0, wait=Duration(), data=[])
    fill(message, {"x": 1.5, "wait": [2, 3], "data": [1, 2]})
    assert (message.x, message.wait.secs, message.wait.nsecs, message.data) == (1.5, 2, 3, [1, 2])
    with pytest.raises(AttributeError):
        fill(message, {"z": 1})
    # rclpy wants bytes for its octets.
    octets = rospy("octet", "octet[]", one=b"\0", more=[])
    fill(octets, {"one": 7, "more": [8, 9]})
    assert (octets.one, octets.more) == (b"\x07", [b"\x08", b"\x09"])
    stamped = Rclpy(header=Rclpy(stamp=Time(sec=0, nanosec=0)))
    assert has_stamp(stamped, {}) and not has_stamp(stamped, {"header": {"stamp": {"sec": 1}}})
    assert not has_stamp(message, {})


@pytest.mark.parametrize(
    ("listening", "reached", "words"),
    [(0, 0, "sent to /a; nobody listens there"), (1, 1, "sent to /a"), (2, 3, "sent to /a"),
     (1, 0, "sent to /a, but who listens there does not take it"),
     (3, 1, "sent to /a, but 2 of 3 who listen there do not take it"),
     (2, -1, "sent to /a, but 2 of 2 who listen there do not take it")],
)  # fmt: skip
def test_who_did_not_get_a_message_is_said(listening: int, reached: int, words: str) -> None:
    from monitor_pipes import sent_words

    assert sent_words("/a", listening, reached) == words
