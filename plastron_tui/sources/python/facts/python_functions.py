"""What functions of Python and of the client libraries give, whatever they get."""

from __future__ import annotations

from plastron_tui.model.code_facts import ValueKind
from plastron_tui.ros.interfaces import InterfaceName

BUILTINS = {
    "float": ValueKind.FLOAT,
    "int": ValueKind.INT,
    "len": ValueKind.INT,
    "ord": ValueKind.INT,
    "id": ValueKind.INT,
    "str": ValueKind.TEXT,
    "repr": ValueKind.TEXT,
    "chr": ValueKind.TEXT,
    "hex": ValueKind.TEXT,
    "bin": ValueKind.TEXT,
    "bool": ValueKind.BOOL,
    "isinstance": ValueKind.BOOL,
    "hasattr": ValueKind.BOOL,
    "list": ValueKind.LIST,
    "sorted": ValueKind.LIST,
    "bytes": ValueKind.BYTES,
    "dict": ValueKind.DICT,
    "set": ValueKind.SET,
    "frozenset": ValueKind.SET,
}
"""What the built-in functions give."""

_FLOATS = (
    "acos", "asin", "atan", "atan2", "cos", "degrees", "dist", "exp", "fabs", "fmod", "hypot",
    "log", "log10", "log2", "pow", "radians", "sin", "sqrt", "tan", "tanh", "copysign",
)  # fmt: skip

FUNCTIONS = {
    **{f"math.{name}": ValueKind.FLOAT for name in _FLOATS},
    "math.floor": ValueKind.INT,
    "math.ceil": ValueKind.INT,
    "time.time": ValueKind.FLOAT,
    "time.monotonic": ValueKind.FLOAT,
    "time.time_ns": ValueKind.INT,
    "random.random": ValueKind.FLOAT,
    "random.uniform": ValueKind.FLOAT,
    "random.gauss": ValueKind.FLOAT,
    "random.randint": ValueKind.INT,
    "random.randrange": ValueKind.INT,
    "json.dumps": ValueKind.TEXT,
    "rospy.get_time": ValueKind.FLOAT,
    "rospy.get_name": ValueKind.TEXT,
}
"""What functions of modules give."""

TIMES = {
    "rospy.Time": ValueKind.TIME,
    "rospy.Time.now": ValueKind.TIME,
    "rospy.Time.from_sec": ValueKind.TIME,
    "rospy.get_rostime": ValueKind.TIME,
    "rospy.Duration": ValueKind.TIME,
    "rospy.Duration.from_sec": ValueKind.TIME,
    "rclpy.time.Time": ValueKind.TIME,
    "rclpy.duration.Duration": ValueKind.TIME,
}
"""What makes a time or a duration of the client library."""

TEXT_METHODS = {
    "format": ValueKind.TEXT,
    "join": ValueKind.TEXT,
    "lower": ValueKind.TEXT,
    "upper": ValueKind.TEXT,
    "strip": ValueKind.TEXT,
    "replace": ValueKind.TEXT,
    "title": ValueKind.TEXT,
    "encode": ValueKind.BYTES,
    "split": ValueKind.LIST,
}
"""What methods of a text give."""

FLOATS = frozenset({"math.pi", "math.e", "math.tau", "math.inf", "math.nan", "numpy.pi"})
"""Constants of modules that are floats."""

LIBRARY_METHODS = {
    "cv2_to_imgmsg": InterfaceName("sensor_msgs", "Image"),
    "cv2_to_compressed_imgmsg": InterfaceName("sensor_msgs", "CompressedImage"),
    "lookup_transform": InterfaceName("geometry_msgs", "TransformStamped"),
    "lookup_transform_full": InterfaceName("geometry_msgs", "TransformStamped"),
}
"""What methods of `cv_bridge.CvBridge` and `tf2_ros.Buffer` give, which hardly others have."""
