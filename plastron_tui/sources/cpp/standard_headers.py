"""The headers of the standard library, by what a text uses of it.

Source: ISO C++17, the synopses of its headers.
"""

from __future__ import annotations

import re

_HEADERS = {
    "algorithm": "all_of any_of none_of find max min sort",
    "array": "array",
    "atomic": "atomic",
    "chrono": "chrono",
    "cmath": "isfinite isinf isnan",
    "condition_variable": "condition_variable",
    "cstdint": "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t",
    "exception": "exception exception_ptr current_exception",
    "functional": "bind function placeholders",
    "future": "async future future_status launch promise shared_future",
    "limits": "numeric_limits",
    "memory": "make_shared make_unique shared_ptr unique_ptr weak_ptr",
    "mutex": "lock_guard mutex unique_lock",
    "sstream": "ostringstream stringstream",
    "stdexcept": "invalid_argument out_of_range range_error runtime_error",
    "string": "string to_string u16string",
    "thread": "thread this_thread",
    "tuple": "tuple",
    "utility": "forward make_pair move pair",
    "vector": "vector",
}
_HEADER_OF = {name: header for header, names in _HEADERS.items() for name in names.split()}

# What is in a string, or a comment, uses nothing.
_USE = re.compile(
    r'"(?:[^"\\\n]|\\.)*"|//[^\n]*|\bstd::(?P<name>\w+)|\b(?P<integer>u?int(?:8|16|32|64)_t)\b'
)


def standard_headers(text: str) -> list[str]:
    """Return the headers of the standard library that a text of C++ needs, sorted."""
    names = (match["name"] or match["integer"] for match in _USE.finditer(text))
    return sorted({_HEADER_OF[name] for name in names if name in _HEADER_OF})
