"""Wrong lines that make types, and what is said of each."""

from __future__ import annotations

EXAMPLE = "for example: create_message_type WheelSpeed with float64 left, float64 right"
BEFORE = "the type of a field comes before its name, without a `:`"
BEHIND = "the brackets of an array stand behind its type, which comes before the name"
ACTION = "create_action_type A with int32 bay"

# A line, the code, the text of the span, the message, what the help says.
FIELDS: list[tuple[str, str, str, str, str | None]] = [
    ("create_message_type T with left: float64", "syntax-error", "left: float64", BEFORE,
     "write `float64 left`"),
    ("create_message_type T with left:float64[3], bool b", "syntax-error", "left:float64[3]",
     BEFORE, "write `float64[3] left`"),
    ("create_message_type T with bool b, p: geometry_msgs/Point", "syntax-error",
     "p: geometry_msgs/Point", BEFORE, "write `geometry_msgs/Point p`"),
    ("create_message_type T with float64 left[3]", "syntax-error", "[", BEHIND, "`float64[3] x`"),
    ("create_message_type T with left float64[]", "syntax-error", "[", BEHIND, "`float64[] x`"),
    ("create_message_type T float64 left", "syntax-error", "float64", "expected `with`", EXAMPLE),
    ("create_message_type T with", "syntax-error", "", "expected fields", EXAMPLE),
    ("create_message_type T with float64", "syntax-error", "", "the name of the field", EXAMPLE),
    ("create_message_type T", "syntax-error", "", "expected `with` here",
     "write `with none`, or fields for `none`, such as `float64 x, float64 y`"),
    ("create_service_type S with int32 bay", "syntax-error", "", "expected `returning` here",
     "write `returning none`, or fields"),
    (f"{ACTION} returning bool docked", "syntax-error", "", "expected `reporting` here",
     "write `reporting none`, or fields"),
    (ACTION, "syntax-error", "", "expected `returning` here",
     "write `returning none reporting none`"),
]  # fmt: skip

MENDED = {
    "create_message_type T with left: float64": "create_message_type T with float64 left",
    "create_service_type S with int32 bay": "create_service_type S with int32 bay returning none",
    ACTION: f"{ACTION} returning none reporting none",
    f"{ACTION} returning none": f"{ACTION} returning none reporting none",
    "create_message_type T": None,
}
"""What the fix of a line makes of it, None where there is none."""
