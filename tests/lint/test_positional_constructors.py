"""What RM204 tells of constructors that take values by position, and how they are mended."""

from __future__ import annotations

import pytest
from message_programs import fixed, marked, script, tick, told

_UNKNOWN = "from acme_msgs.msg import Wheel\nfrom acme.msg import Rim\n"
_IMPORTED, _OLD = f"import rclpy\n{_UNKNOWN}", f"import rospy\n{_UNKNOWN}"
POSITIONAL = {
    "in rclpy": tick("""
        String('a')  # wrong
        Twist(Vector3(1.0, 0.0, 0.0))  # wrong
        Point(1.0, y=2.0)  # wrong
        self.client.call_async(SetBool.Request(True))  # wrong
        Header(Time(), 'map')  # wrong
        String(data='a')
        String(**{'data': 'a'})
    """),
    "of a package of types that is not known": tick("""
        Wheel(1.0)  # wrong
        Wheel(radius=1.0)
        Rim(1.0)
    """).replace("import rclpy\n", _IMPORTED, 1),
    "of answers, in rospy": script("""
        def on_list(request):
            return [True]  # wrong

        def on_values(request):
            if request.data:
                return True, 'a', 3  # wrong
            return True, 'a'

        def on_none(request):
            return []

        def on_more(request):
            return [True, *more]

        rospy.Service('a', SetBool, on_list)
        rospy.Service('b', SetBool, on_values)
        rospy.Service('c', SetBool, on_none)
        rospy.Service('d', SetBool, on_more)
    """),
    "of one that is not known, in rospy": script("Wheel(1.0)").replace("import rospy\n", _OLD, 1),
    "in rospy": script("""
        String('a')
        Vector3(1, 2, 3)
        Vector3(1, 2)  # wrong
        Twist(Vector3(), angular=Vector3())  # wrong
        Empty()
        SetBoolResponse(True)  # wrong
        SetBoolResponse(True, 'a')
        points = rospy.Publisher('point', Point, queue_size=1)
        points.publish(1, 2)  # wrong
        points.publish(1, 2, 3)
        rospy.ServiceProxy('a', Trigger)()
    """),
}


@pytest.mark.parametrize("text", POSITIONAL.values(), ids=POSITIONAL)
def test_named_are_constructors_that_do_not_take_values_so(text: str) -> None:
    assert told(text, "RM204") == marked(text)


def test_values_get_names() -> None:
    text = tick("Twist(Vector3(1.0, 0.0))\nHeader(Time(), 'map')")
    after = fixed(text, "RM204")
    assert "Twist(linear=Vector3(x=1.0, y=0.0))" in after
    assert "Header(stamp=Time(), frame_id='map')" in after


@pytest.mark.parametrize(
    ("text", "is_mended"),
    [
        (tick("Point(1.0, 0.0)"), True),
        (tick("Point(1.0, self.y)"), True),
        (tick("Twist(1.0, 0.0)"), False),
        (tick("Point(1.0, 0)"), False),
        (tick("Header(Time(), 3)"), False),
        (tick("String(None)"), False),
        (script("Vector3(1, 2)"), True),
        (script("Vector3('1', 2)"), False),
    ],
)
def test_values_get_names_of_fields_that_hold_them(text: str, is_mended: bool) -> None:
    assert len(told(text, "RM204")) == 1
    assert (fixed(text, "RM204") != text) is is_mended
    if is_mended or "import rclpy" in text:
        # Nothing is said of a value before its field is known.
        assert told(text, "RM202") == told(text, "RM203") == []
