"""Values of parameters: how ROS types a text, and the parameter files of ROS 2.

Sources: `rcl_yaml_param_parser` (`parse.c`: which plain scalars are booleans, integers, floats; no
aliases, lists of one type), `rcl/arguments.c` (`-p NAME:=VALUE`), and the ROS 2 documentation,
"About Parameters". ROS 1 gets the same values, so that one text means the same in both.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from .parameters import Setting

LONGEST_VALUE = 100_000
"""The longest value, in characters of an argument; Linux takes one of 131,071 bytes."""

_INTEGER = re.compile(r"[-+]?(?:0[xX][0-9a-fA-F]+|0[0-7]*|[1-9][0-9]*)", re.ASCII)
_FLOAT = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?", re.ASCII)
_NO_NUMBER = re.compile(r"([-+]?)(?:\.(inf|Inf|INF|nan|NaN|NAN)|((?i:inf|infinity|nan)))")
_WORDS = {
    form: value
    for value, words in ((True, ("y", "yes", "true", "on")), (False, ("n", "no", "false", "off")))
    for word in words
    for form in (word, word.capitalize(), word.upper())
}
_NAME = re.compile(r"[A-Za-z_]\w*(?:[./][A-Za-z_]\w*)*", re.ASCII)
_PATTERN_PART = re.compile(r"\*\*?|\w+", re.ASCII)
_NO_XML = re.compile("[^\t\n\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_HALF = re.compile("[\ud800-\udfff]")
SECTION = "ros__parameters"
MIXED_LIST = "a list is of one type"
_STRING = "tag:yaml.org,2002:str"
_QUOTE_IT = 'write a text in quotes, such as `"0.8"`'

_Node = Any
"""A node of PyYAML's tree: its `id` says whether it is a scalar, a sequence or a mapping."""


class Mistake(NamedTuple):
    """What is wrong with a text, and where, in characters of it."""

    message: str
    start: int = 0
    end: int = 0
    help: str | None = None


class Assignment(NamedTuple):
    """A value for a parameter of a node, which goes by its name or a program's variable."""

    node: str
    name: str
    value: Setting


class _NoValueError(Exception):
    """A node of the tree is no value; its argument is the mistake."""


def parse_assignment(text: str) -> Assignment | Mistake:
    """Return what `NODE.NAME=VALUE` says, or what is wrong with it."""
    left, sign, value_text = text.partition("=")
    node, dot, name = left.partition(".")
    if not sign or not dot or not node:
        return Mistake("a parameter is set with `NODE.NAME=VALUE`")
    if (problem := name_problem(name)) is not None:
        return Mistake(problem)
    value = parse_value(value_text)
    return value if isinstance(value, Mistake) else Assignment(node, name, value)


def parse_value(text: str) -> Setting | Mistake:
    """Return the value of a YAML text, with the type that ROS 2 gives it; "" is the empty text."""
    import yaml

    if not text.strip():
        return ""
    try:
        root: _Node = yaml.compose(text, Loader=yaml.BaseLoader)
        if root is None or text[root.end_mark.index :].strip():
            raise _NoValueError(Mistake(f"{_shown(text)} has a comment behind `#`", help=_QUOTE_IT))
        return _value(root, text)
    except _NoValueError as error:
        mistake: Mistake = error.args[0]
        return mistake
    except (ValueError, OverflowError, RecursionError, yaml.YAMLError):
        return Mistake(f"{_shown(text)} is no value in YAML", help=_QUOTE_IT)


def name_problem(name: str, ros_version: int = 2) -> str | None:
    """Return why a parameter of this name cannot be set at the start, None where it can.

    A command line of ROS 2 takes fewer names than a declaration does; in ROS 1 `_NAME` would be
    one of the special names, such as `__name`.
    """
    if len(name) > 247 or _NAME.fullmatch(name) is None:
        return f"{_shown(name)} is no name of a parameter that can be set at the start"
    if ros_version == 1 and name.startswith("_"):
        return f"{_shown(name)} starts with `_`, which names in ROS 1 do not"
    return None


def unfit(value: Setting, ros_version: int) -> str | None:
    """Return why a generation of ROS cannot have a value, None where it can.

    ROS 1 keeps parameters by XML-RPC: integers of 32 bits, and the characters of XML. ROS 2 has
    texts of C.
    """
    for each in value if isinstance(value, tuple) else (value,):
        if isinstance(each, str) and "\0" in each:
            return "a text has no NUL character in ROS"
        if isinstance(each, str) and (half := _HALF.search(each)) is not None:
            return f"U+{ord(half[0]):04X} is half a character, which ROS cannot send"
        if ros_version == 2:
            continue
        if isinstance(each, str) and (bad := _NO_XML.search(each)) is not None:
            return f"a text has no character U+{ord(bad[0]):04X} in ROS 1"
        if type(each) is int and not -(2**31) <= each < 2**31:
            return f"{each} does not fit into the 32 bits of an integer in ROS 1"
    if len(yaml_text(value)) > LONGEST_VALUE:
        return f"a value has at most {LONGEST_VALUE:,} characters"
    return None


def yaml_text(value: Setting) -> str:
    """Return a value in one line of ASCII, which either ROS reads as that value from an argument.

    `:=` is written as an escape: rospy splits its arguments there, inside of quotes too.
    """
    import yaml

    text: str = yaml.dump(
        _Text(value) if isinstance(value, str) else value,
        Dumper=_dumper(),
        width=math.inf,
        allow_unicode=False,
        default_flow_style=True,
    )
    return text.removesuffix("\n").removesuffix("\n...").replace(":=", r"\x3a=")


def params_file(nodes: Mapping[str, Mapping[str, Setting]]) -> str:
    """Return the text of a parameter file of ROS 2.

    Args:
        nodes: the parameters of each node, by its name; a node without any is left out.
    """
    import yaml

    document = {
        f"/{node.removeprefix('/')}": {
            SECTION: {
                name: _Text(value) if isinstance(value, str) else value
                for name, value in of.items()
            }
        }
        for node, of in nodes.items()
        if of
    }
    text: str = (
        yaml.dump(document, Dumper=_dumper(), width=math.inf, sort_keys=False) if document else ""
    )
    return text


class NodeParameters(NamedTuple):
    """The parameters that a file has for the nodes of a pattern, such as `/**` or `/talker`."""

    pattern: str
    values: Mapping[str, Setting]


def params_problem(text: str, ros_version: int) -> Mistake | None:
    """Return the first mistake of a parameter file, None for one that the nodes can take.

    ROS 1 takes any names with their values; ROS 2 wants the nodes that they are for.
    """
    if ros_version == 2:
        found, mistakes = read_params(text)
        nothing = Mistake("it gives no node a parameter", help=f"they stand below `{SECTION}:`")
        return next(iter(mistakes), None if any(each.values for each in found) else nothing)
    root = _composed(text)
    if isinstance(root, Mistake):
        return root
    if root is None or root.id != "mapping" or not root.value:
        return Mistake("it has no parameters", help="write each as `NAME: VALUE`")
    return None


def _composed(text: str) -> _Node | Mistake:
    """Return the tree of a text in YAML, None for an empty one."""
    import yaml

    try:
        return yaml.compose(text, Loader=yaml.BaseLoader)
    except (ValueError, OverflowError, RecursionError, yaml.YAMLError) as error:
        mark = getattr(error, "problem_mark", None)
        at = 0 if mark is None else mark.index
        problem = getattr(error, "problem", None) or "it is nested too deeply, or no text"
        return Mistake(f"this is no YAML: {problem}", at, at + 1)


def read_params(text: str) -> tuple[tuple[NodeParameters, ...], tuple[Mistake, ...]]:
    """Read a parameter file of ROS 2: what is right in it, and what is wrong."""
    root = _composed(text)
    if isinstance(root, Mistake):
        return (), (root,)
    reader = _Reader(text)
    if root is not None and (root.id != "scalar" or root.value):
        reader.nodes(root, "")
    return tuple(reader.found), tuple(reader.mistakes)


def values_of(found: Iterable[NodeParameters], *names: str) -> dict[str, Setting]:
    """Return the parameters of a node that goes by these full names; what comes later wins."""
    values: dict[str, Setting] = {}
    for pattern, of in found:
        if any(is_for(pattern, name) for name in names):
            values |= of
    return values


def is_for(pattern: str, name: str) -> bool:
    """Tell whether the parameters of a pattern are for the node of a full name."""
    return re.fullmatch(_expression(pattern), name, re.ASCII) is not None


def is_node_pattern(text: str) -> bool:
    """Tell whether a text is a name of nodes, with wildcards or not."""
    return text != "" and all(map(_PATTERN_PART.fullmatch, text.split("/")))


def value_of(node: _Node, text: str) -> Setting | Mistake:
    """Return the value of a node of the tree of a text, or why it has none that ROS takes."""
    try:
        return _value(node, text)
    except _NoValueError as error:
        mistake: Mistake = error.args[0]
        return mistake


class _Reader:
    """Reads the tree of a parameter file, and remembers what is wrong."""

    def __init__(self, text: str) -> None:
        self.found: list[NodeParameters] = []
        self.mistakes: list[Mistake] = []
        self._text = text

    def nodes(self, node: _Node, pattern: str) -> None:
        """Read what stands below a part of a node's name."""
        for key, value in self._pairs(node, f"a node's parameters stand below `{SECTION}:`"):
            name = key.value.strip("/")
            if name == SECTION and pattern:
                values: dict[str, Setting] = {}
                self._values(value, "", values)
                self.found.append(NodeParameters(pattern, values))
            elif is_node_pattern(name):
                self.nodes(value, f"{pattern}/{name}")
            else:
                self._report(_at(key, f"{_shown(key.value)} is no name of a node"))

    def _values(self, node: _Node, prefix: str, values: dict[str, Setting]) -> None:
        for key, value in self._pairs(node, "parameters are `name: value` lines"):
            name = f"{prefix}{key.value}"
            if (problem := name_problem(name)) is not None:
                self._report(_at(key, problem))
            elif value.id == "mapping" and value.value:
                self._values(value, f"{name}.", values)
            elif name in values:
                self._report(_at(key, f"`{name}` is set twice"))
            else:
                try:
                    values[name] = _value(value, self._text)
                except _NoValueError as error:
                    self._report(error.args[0])

    def _pairs(self, node: _Node, rule: str) -> Iterator[tuple[_Node, _Node]]:
        try:
            _check_plain(node, self._text)
        except _NoValueError as error:
            self._report(error.args[0])
            return
        if node.id != "mapping":
            self._report(_at(node, rule))
            return
        for key, value in node.value:
            if key.id == "scalar":
                yield key, value
            else:
                self._report(_at(key, rule))

    def _report(self, mistake: Mistake) -> None:
        self.mistakes.append(mistake)


def _value(node: _Node, text: str) -> Setting:
    _check_plain(node, text)
    if node.id == "mapping":
        raise _NoValueError(_at(node, "a value is no mapping", _QUOTE_IT))
    if node.id == "scalar":
        return _scalar(node, text)
    if not node.value:
        message = "an empty list has no type, and ROS 2 takes none at the start"
        raise _NoValueError(_at(node, message))
    if any(each.id != "scalar" for each in node.value):
        raise _NoValueError(_at(node, "a list holds single values, and no lists", _QUOTE_IT))
    values = tuple(_scalar(each, text) for each in node.value)
    kinds = {type(each) for each in values}
    if kinds == {int, float}:
        raise _NoValueError(_at(node, MIXED_LIST, "write each number with a point: `1.0`"))
    if len(kinds) > 1:
        raise _NoValueError(_at(node, MIXED_LIST, _QUOTE_IT))
    return values


def _scalar(node: _Node, text: str) -> bool | int | float | str:
    _check_plain(node, text)
    value: str = node.value
    if node.style is None and not _is_tagged(node, text):
        return _plain(value)
    try:
        value.encode()
    except UnicodeEncodeError:
        raise _NoValueError(_at(node, "a text has no halves of characters")) from None
    return value


def _plain(word: str) -> bool | int | float | str:
    """Return what `rcl_yaml_param_parser` takes a scalar without quotes for."""
    if word in _WORDS:
        return _WORDS[word]
    if _INTEGER.fullmatch(word) and -(2**63) <= (number := _integer(word)) < 2**63:
        return number
    if _FLOAT.fullmatch(word) and not math.isinf(decimal := float(word)):
        return decimal
    special = _NO_NUMBER.fullmatch(word)
    return word if special is None else float(special[1] + (special[2] or special[3]))


def _integer(word: str) -> int:
    digits = word.lstrip("+-")
    base = 16 if digits[1:2] in ("x", "X") else 8 if digits.startswith("0") else 10
    return int(digits, base) * (-1 if word.startswith("-") else 1) if len(digits) < 30 else 2**63


def _is_tagged(node: _Node, text: str) -> bool:
    return text[node.start_mark.index : node.start_mark.index + 1] == "!"


def _check_plain(node: _Node, text: str) -> None:
    """Refuse what ROS has no use for: anchors, the aliases to them, and tags."""
    first = text[node.start_mark.index : node.start_mark.index + 1]
    if first == "&" or (first == "!" and (node.id, node.tag) != ("scalar", _STRING)):
        what = "anchors and aliases" if first == "&" else "tags"
        raise _NoValueError(_at(node, f"ROS takes no {what} of YAML", _QUOTE_IT))


def _at(node: _Node, message: str, remedy: str | None = None) -> Mistake:
    return Mistake(message, node.start_mark.index, node.end_mark.index, remedy)


def _expression(pattern: str) -> str:
    parts = re.sub(r"(?:/\*\*)+", "/**", pattern).split("/")[1:]
    forms = {"*": r"/\w+", "**": r"(?:/\w+)*"}
    return "".join(forms.get(part, f"/{part}") for part in parts)


def _shown(text: str) -> str:
    return f"`{text}`" if len(text) <= 40 else f"`{text[:40]}…`"


class _Text(str):
    """A text that is a value, and is therefore written in quotes."""


@cache
def _dumper() -> Any:
    import yaml

    class Dumper(yaml.SafeDumper):
        """Writes texts in quotes, and lists in a line; nothing twice is an alias."""

        def ignore_aliases(self, data: Any) -> bool:
            return True

    def quoted(dumper: Any, value: str) -> Any:
        return dumper.represent_scalar(_STRING, str(value), style='"')

    def listed(dumper: Any, values: tuple[Any, ...]) -> Any:
        texts = [_Text(each) if isinstance(each, str) else each for each in values]
        return dumper.represent_sequence("tag:yaml.org,2002:seq", texts, flow_style=True)

    Dumper.add_representer(_Text, quoted)
    Dumper.add_representer(tuple, listed)
    return Dumper
