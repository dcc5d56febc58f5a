"""What the values of fields have besides fields in Python, where no message is meant."""

from __future__ import annotations

from array import array
from collections.abc import Collection
from functools import cache

MESSAGE_ATTRIBUTES = {
    1: frozenset({"serialize", "deserialize", "serialize_numpy", "deserialize_numpy"}),
    2: frozenset({"get_fields_and_field_types", "SLOT_TYPES", "Request", "Response", "Event"}),
}
"""What every message has: those of `genpy.message.Message`, and of the classes that
rosidl_generator_py makes."""

_TIMES = frozenset(
    {"secs", "nsecs", "is_zero", "set", "canon", "to_sec", "to_time", "to_nsec", "from_sec"}
    | {"from_seconds", "now"}
)
"""What `genpy.rostime.Time` and `Duration` have."""

_ARRAYS = frozenset(
    {"T", "all", "any", "argmax", "argmin", "argpartition", "argsort", "astype", "base", "byteswap"}
    | {"choose", "clip", "compress", "conj", "conjugate", "copy", "ctypes", "cumprod", "cumsum"}
    | {"data", "diagonal", "dot", "dtype", "dump", "dumps", "fill", "flags", "flat", "flatten"}
    | {"getfield", "imag", "item", "itemset", "itemsize", "max", "mean", "min", "nbytes", "ndim"}
    | {"newbyteorder", "nonzero", "partition", "prod", "ptp", "put", "ravel", "real", "repeat"}
    | {"reshape", "resize", "round", "searchsorted", "setfield", "setflags", "shape", "size"}
    | {"sort", "squeeze", "std", "strides", "sum", "swapaxes", "take", "tobytes", "tofile"}
    | {"tolist", "tostring", "trace", "transpose", "var", "view"}
)
"""What arrays and numbers of numpy have."""

_PYTHON_2 = frozenset({"decode", "encode"})


def _of(*types: type) -> frozenset[str]:
    return frozenset(name for type_ in types for name in dir(type_) if not name.startswith("_"))


LIST_ATTRIBUTES = _of(list, tuple, bytes, bytearray, str, array) | _ARRAYS | _PYTHON_2
"""What lists, arrays and bytes have, one or another of which a field of several values is."""

_TEXT = _of(str, bytes) | _PYTHON_2


@cache
def attributes_of(primitive: str, ros_version: int) -> Collection[str] | None:
    """Return what a value of a primitive type has, None for a type that is not known."""
    if primitive in ("time", "duration"):
        return _TIMES if ros_version == 1 else None
    if primitive in ("string", "wstring"):
        return _TEXT
    if primitive in ("byte", "char"):
        return _of(int, bytes, bytearray, str) | _ARRAYS
    if primitive.startswith(("int", "uint", "float")) or primitive == "bool":
        return _of(int, float, bool) | _ARRAYS
    return None
