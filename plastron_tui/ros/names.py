"""Graph names: what ROS takes as the name of a node, a topic, or a service.

Sources: the ROS 1 wiki page "Names"; for ROS 2 the design article "Topic and Service name
mapping to DDS", and the validators of `rcl` and `rmw`. Where the generation of ROS is not
known yet, ROS 1 is the base.

A private name is spelled `~/name`, whatever the client library: see `spelled`.
"""

from __future__ import annotations

import re
from typing import NamedTuple

# What ROS 2 leaves of DDS's 255 characters, less its own prefixes (`rmw`), and ROS 1 does
# without a limit; there a name ends in a file name and a log line, where this is plenty.
MAX_NAME_LENGTH = {1: 1000, 2: 247}
MAX_NODE_NAME_LENGTH = 240
"""The longest name of a node, which is also the stem of the file that it becomes."""

_TOPIC = {
    # An optional `/`, `~` or `~/`, then tokens between single slashes; ROS 1 drops a last one.
    1: re.compile(r"(?:[A-Za-z]\w*|/\w+|~/?\w+)(?:/\w+)*/?", re.ASCII),
    # Tokens hold no `__` and start with no digit; a substitution stands for (part of) a token.
    2: re.compile(
        r"(?:~?/|~/)?(?!\d)(?:(?!__)\w|\{(?:node|ns|namespace)\})+"
        r"(?:/(?!\d)(?:(?!__)\w|\{(?:node|ns|namespace)\})+)*",
        re.ASCII,
    ),
}
_NODE = {1: re.compile(r"[A-Za-z]\w*", re.ASCII), 2: re.compile(r"[A-Za-z_]\w*", re.ASCII)}
_PARAMETER = re.compile(r"\w[\w/]*(?:\.\w[\w/]*)*", re.ASCII)
_SUBSTITUTION = re.compile(r"\{([^{}/]*)\}")
_SUBSTITUTIONS = ("node", "ns", "namespace")
_BAD_CHARACTER = re.compile(r"[^A-Za-z0-9_/~]+")
_BAD_CHARACTER_2 = re.compile(r"[^A-Za-z0-9_/~{}]+")


class NameProblem(NamedTuple):
    """What is wrong with a name.

    Attributes:
        message: lower case, no full stop.
        offset: where the wrong part starts, in characters of the name.
        length: how many characters are wrong; 0 only for an empty name.
        suggestion: a valid name like it, None when there is none to offer.
    """

    message: str
    offset: int
    length: int
    suggestion: str | None = None


def check_topic_name(name: str, ros_version: int) -> NameProblem | None:
    """Return what is wrong with the name of a topic, None when nothing is."""
    return _check_graph_name(name, ros_version, "topic")


def check_service_name(name: str, ros_version: int) -> NameProblem | None:
    """Return what is wrong with the name of a service, None when nothing is."""
    return _check_graph_name(name, ros_version, "service")


def check_parameter_name(name: str, ros_version: int) -> NameProblem | None:
    """Return what is wrong with the name of a parameter, None when nothing is.

    ROS 1 looks parameters up by graph names; ROS 2 takes any, and has dots between their parts
    (`rcl_interfaces`: "alphanumerics, underscores and slashes", besides "." for nesting).
    """
    if ros_version == 1:
        return _check_graph_name(name, ros_version, "parameter")
    if len(name) <= MAX_NAME_LENGTH[2] and _PARAMETER.fullmatch(name):
        return None
    return NameProblem(f"`{name}` cannot be the name of a parameter", 0, len(name))


def check_node_name(name: str, ros_version: int) -> NameProblem | None:
    """Return what is wrong with the name of a node, None when nothing is.

    It is a base name: it has neither `/` nor `~`.
    """
    if len(name) <= MAX_NODE_NAME_LENGTH and _NODE[ros_version].fullmatch(name):
        return None
    message, offset, length = _node_mistake(name, ros_version)
    return NameProblem(message, offset, length, mended_node_name(name, ros_version))


def spelled(name: str) -> str:
    """Return a name of a program in the one spelling for private names: `~scan` is `~/scan`."""
    if name.startswith("~") and name[1:2] not in ("", "/"):
        return f"~/{name[1:]}"
    return name


def name_as_read(name: str, ros_version: int) -> str:
    """Return what a client library makes of a name in a node's code, as programs spell it.

    In ROS 1 `~scan` is private, and `~/scan` is `/scan`: what follows the `~` is joined to the
    node's name unless it is global (`rospy.names.resolve_name`, `rosgraph.names.ns_join`).
    """
    if ros_version == 1 and name.startswith("~/") and len(name) > 2:
        return "/" + name[1:].lstrip("/")
    return spelled(name) if ros_version == 1 else name


def name_as_written(name: str, ros_version: int) -> str:
    """Return how a node's code writes a name that programs spell so."""
    if ros_version == 1 and name.startswith("~/"):
        return f"~{name[2:]}"
    return name


def parameter_name(name: str, ros_version: int) -> str:
    """Return the name of a node's own parameter, as programs spell it.

    Each node of ROS 2 has its own; in ROS 1 a node's own ones are the private ones.
    """
    if ros_version == 1 and not name.startswith(("~", "/")):
        return f"~/{name}"
    return spelled(name) if ros_version == 1 else name


def resolved_name(node: str, name: str, namespace: str = "") -> str:
    """Return the full name of a topic or service, as a node resolves it.

    Source: the ROS wiki page "Names", section 1.2; a slash too many goes, as in `rosgraph.names`.
    The substitutions of ROS 2 are those of `rcl_expand_topic_name`.

    Args:
        node: the node's name.
        name: the name of the topic or service.
        namespace: the node's namespace, such as `/robot1`; "" for the root.
    """
    if name.isidentifier():
        # Most names are one word, and there may be thousands of them.
        return f"{namespace}/{name}"
    if not name.startswith(("/", "{ns}", "{namespace}")):
        name = f"{namespace}/{f'{node}/{name[1:]}' if name.startswith('~') else name}"
    if "{" in name:
        name = name.replace("{node}", node)
        name = name.replace("{ns}", namespace).replace("{namespace}", namespace)
    return "/" + "/".join(part for part in name.split("/") if part)


def _check_graph_name(name: str, ros_version: int, what: str) -> NameProblem | None:
    if len(name) <= MAX_NAME_LENGTH[ros_version] and _TOPIC[ros_version].fullmatch(name):
        return None
    message, offset, length = _graph_mistake(name, ros_version, what)
    return NameProblem(message, offset, length, _mended(name, ros_version, what))


_Mistake = tuple[str, int, int]


def _node_mistake(name: str, ros_version: int) -> _Mistake:
    if not name:
        return "a node needs a name", 0, 0
    if len(name) > MAX_NODE_NAME_LENGTH:
        return _too_long(name, "node", MAX_NODE_NAME_LENGTH)
    for mark in ("/", "~"):
        if mark in name:
            return f"the name of a node has no `{mark}`", name.index(mark), 1
    bad = _BAD_CHARACTER.search(name)
    if bad is not None:
        return _bad_character(bad)
    if name[0].isdigit():
        return "a name starts with a letter", 0, _digits(name, 0)
    assert ros_version == 1, name
    return "a name starts with a letter in ROS 1", 0, 1


def _graph_mistake(name: str, ros_version: int, what: str) -> _Mistake:
    if not name:
        return f"a {what} needs a name", 0, 0
    longest = MAX_NAME_LENGTH[ros_version]
    if len(name) > longest:
        return _too_long(name, what, longest)
    if name in ("/", "~", "~/"):
        return f"`{name}` is a namespace, and names no {what}", 0, len(name)
    bad = (_BAD_CHARACTER if ros_version == 1 else _BAD_CHARACTER_2).search(name)
    if bad is not None:
        return _bad_character(bad)
    if "~" in name[1:]:
        return "`~` comes first in a name or not at all", name.index("~", 1), 1
    if "//" in name:
        return "a name has no empty part between two `/`", name.index("//"), 2
    if ros_version == 1:
        start = 0 if name[0] != "~" else 1
        return "a name starts with a letter, `/` or `~`", start, max(1, _digits(name, start))
    return _ros2_mistake(name)


def _ros2_mistake(name: str) -> _Mistake:
    """Return what only ROS 2 takes for a mistake."""
    if name[0] == "~" and name[1] != "/":
        return "`~` is followed by `/` in ROS 2", 0, 1
    if name.endswith("/"):
        return "a name does not end in `/` in ROS 2", len(name) - 1, 1
    known = _SUBSTITUTION.sub(lambda match: "x" * len(match[0]), name)
    for match in _SUBSTITUTION.finditer(name):
        if match[1] not in _SUBSTITUTIONS:
            listed = ", ".join(f"`{{{word}}}`" for word in _SUBSTITUTIONS)
            return f"ROS 2 substitutes {listed}, and nothing else", match.start(), len(match[0])
    brace = re.search(r"[{}]", known)
    if brace is not None:
        return "this brace has no counterpart", brace.start(), 1
    digits = re.search(r"(?:^|/)([0-9]+)", known)
    if digits is not None:
        return "no part of a name starts with a digit in ROS 2", digits.start(1), len(digits[1])
    underscores = re.search("__+", known)
    assert underscores is not None, name
    return "a name has no `__` in ROS 2", underscores.start(), len(underscores[0])


def _too_long(name: str, what: str, longest: int) -> _Mistake:
    message = f"the name of a {what} has at most {longest} characters, and this one {len(name)}"
    return message, longest, len(name) - longest


def _bad_character(bad: re.Match[str]) -> _Mistake:
    first = bad[0][0]
    if first.isspace():
        shown = "white space"
    elif first.isprintable():
        shown = f"`{first}`"
    else:
        shown = f"the character U+{ord(first):04X}"
    # Others of other kinds would come up one by one; the run of them is one mistake.
    return f"a name has no {shown}", bad.start(), len(bad[0])


def _digits(name: str, start: int) -> int:
    match = re.compile("[0-9]*").match(name, start)
    return len(match[0]) if match else 0


def _plain(name: str) -> str:
    """Return a name in ASCII letters, digits, `_`, `/`, `~`: `é` as `e`, others as `_`."""
    import unicodedata  # a right name needs no other spelling

    folded = unicodedata.normalize("NFKD", name[: MAX_NAME_LENGTH[1]])
    kept = "".join(char for char in folded if not unicodedata.combining(char))
    return re.sub("[^A-Za-z0-9_/~]+", "_", kept.strip())


def mended_node_name(name: str, ros_version: int) -> str | None:
    """Return a valid name for a node that is like this one, None when too little is left."""
    words = re.sub("[/~]+", "_", _plain(name))
    mended = re.sub("__+", "_", words).strip("_")
    if mended and not mended[0].isalpha():
        mended = f"node_{mended}"
    mended = mended[:MAX_NODE_NAME_LENGTH]
    is_valid = mended and _NODE[ros_version].fullmatch(mended)
    return mended if is_valid and mended != name else None


def _mended(name: str, ros_version: int, what: str) -> str | None:
    text = _plain(name)
    start = "~/" if text.startswith("~") else "/" if text.startswith("/") else ""
    parts = [re.sub("__+", "_", part).strip("_") for part in text.replace("~", "/").split("/")]
    parts = [part for part in parts if part]
    if ros_version == 2:
        parts = [f"{what}_{part}" if part[0].isdigit() else part for part in parts]
    elif parts and not start and not parts[0][0].isalpha():
        parts[0] = f"{what}_{parts[0]}"
    mended = (start + "/".join(parts))[: MAX_NAME_LENGTH[ros_version]].rstrip("/_")
    is_valid = mended and _TOPIC[ros_version].fullmatch(mended)
    return mended if is_valid and mended != name else None
