"""What an expression does besides having a value: nothing, where that is known."""

from __future__ import annotations

from collections.abc import Mapping

from tree_sitter import Node

from .analysis import Analysis
from .imports import is_interface_module
from .references import function_of
from .scopes import BindingKind, Scope
from .syntax import holders, parts_of

FILLING = frozenset({"append", "extend"})
"""Methods that fill a list."""

_PURE_BUILTINS = frozenset(
    {"abs", "all", "any", "bool", "bytearray", "bytes", "chr", "dict", "divmod", "enumerate"}
    | {"float", "format", "getattr", "hasattr", "hex", "int", "isinstance", "len", "list", "max"}
    | {"min", "ord", "pow", "range", "repr", "reversed", "round", "set", "sorted", "str", "sum"}
    | {"tuple", "type", "zip"}
)
_PURE_FUNCTIONS = frozenset(
    {"rospy.Time.now", "rospy.get_rostime", "rospy.get_time", "rospy.Time", "rospy.Duration"}
    | {"rospy.Time.from_sec", "rospy.Duration.from_sec", "rospy.get_name"}
    | {"rospy.get_namespace", "rospy.get_caller_id", "socket.gethostname"}
    | {"rospy.get_param", "rospy.has_param", "rospy.is_shutdown", "rospy.resolve_name"}
    | {"rospy.rostime.get_rostime", "rospy.rostime.get_time", "rospy.Rate"}
    | {"copy.copy", "copy.deepcopy", "json.dumps", "jsonpickle.encode"}
    | {"struct.calcsize", "struct.pack", "struct.unpack", "struct.unpack_from"}
    | {"multiprocessing.cpu_count", "os.getcwd", "os.getenv", "os.getpid"}
    | {"rclpy.callback_groups.MutuallyExclusiveCallbackGroup"}
    | {"rclpy.callback_groups.ReentrantCallbackGroup"}
    | {"rclpy.duration.Duration", "rclpy.qos.QoSProfile", "rclpy.time.Time", "rclpy.ok"}
    | {"cv2.cvtColor", "cv2.imencode", "cv2.resize", "cv_bridge.CvBridge"}
)
# What a node's clock is asked; nothing else of these names changes anything either.
_PURE_METHODS = frozenset(
    {"get_clock", "now", "to_msg", "to_sec", "to_nsec", "seconds_nanoseconds", "from_sec"}
    | {"get_parameter", "get_parameter_value", "get_name", "get_namespace"}
    | {"format", "join", "split", "strip", "lower", "upper", "replace"}
    | {"keys", "values", "items", "index", "count", "copy", "tolist", "tobytes", "astype"}
    | {"flatten", "reshape", "cv2_to_imgmsg", "imgmsg_to_cv2", "GetQuaternion", "GetRPY"}
)
# All of these modules work out and change nothing, but for what is listed below them.
_PURE_MODULES = (
    "base64.", "colorsys.", "datetime.", "itertools.", "math.", "numpy.", "os.path.", "platform.",
    "ros2_numpy.", "ros_numpy.",
    "sensor_msgs.point_cloud2.", "sensor_msgs_py.point_cloud2.", "statistics.", "string.",
    "tf.transformations.", "tf_transformations.", "time.", "transforms3d.", "uuid.",
)  # fmt: skip
_DOING = (
    "numpy.copyto", "numpy.fill_diagonal", "numpy.load", "numpy.memmap", "numpy.place", "numpy.put",
    "numpy.random.", "numpy.save", "numpy.set", "time.sleep", "time.tzset",
)  # fmt: skip
_PURE_TYPES = frozenset(
    {"identifier", "string", "integer", "float", "true", "false", "none", "attribute", "subscript"}
    | {"list", "tuple", "dictionary", "pair", "set", "parenthesized_expression", "binary_operator"}
    | {"unary_operator", "not_operator", "boolean_operator", "comparison_operator", "slice"}
    | {"conditional_expression", "concatenated_string", "interpolation", "string_content"}
    | {"string_start", "string_end", "escape_sequence", "expression_list", "keyword_argument"}
    | {"list_splat", "dictionary_splat", "argument_list", "format_specifier", "type_conversion"}
    | {"comment"}
    | {"list_comprehension", "dictionary_comprehension", "set_comprehension", "if_clause"}
    | {"generator_expression", "for_in_clause", "lambda", "lambda_parameters", "pattern_list"}
    | {"tuple_pattern"}
)
# Nobody knows which numbers come next, unless somebody seeds them.
_DRAWING = ("numpy.random.", "random.")
# A value that some of these have is only worked out at times.
_AT_TIMES = frozenset(
    {"boolean_operator", "conditional_expression", "lambda", "list_comprehension"}
    | {"dictionary_comprehension", "set_comprehension", "generator_expression"}
)
# Functions that call more than these are not looked into.
_MOST_DEEP = 3
# What these have for a value, others may have too.
_SHARED = frozenset({"identifier", "attribute", "subscript", "await"})
_SHARING = frozenset({"get", "getattr", "max", "min", "next", "pop", "setdefault"})


def is_pure(analysis: Analysis, expression: Node, depth: int = 0) -> bool:
    """Whether to evaluate an expression changes nothing; `depth` functions call each other so."""
    pending = [expression]
    while pending:
        node = pending.pop()
        if node.type == "call":
            if not _is_pure_call(analysis, node, depth):
                return False
        elif node.is_named and node.type not in _PURE_TYPES:
            return False
        pending.extend(node.named_children)
    return True


def doing_part(analysis: Analysis, expression: Node) -> Node | None:
    """Return the one call in an expression that may do something besides having a value.

    None where no call does, where several do, or where it depends whether one is made.
    """
    node = expression
    while True:
        if node.type == "call" and not _is_pure_call(analysis, node):
            return node
        doing = [each for each in node.named_children if not is_pure(analysis, each)]
        if len(doing) != 1 or node.type in _AT_TIMES or node.type not in {*_PURE_TYPES, "call"}:
            return None
        node = doing[0]


def is_fresh(analysis: Analysis, value: Node) -> bool:
    """Whether an object is made by an expression, so that nothing else knows of it."""
    callee = value.child_by_field_name("function") if value.type == "call" else None
    function = function_of(callee, analysis) if callee is not None else None
    if function is None:
        return _is_made(analysis, value)
    own = _own_objects(analysis, function)
    pending, returned = [function.node], []
    while pending:
        node = pending.pop()
        pending += node.named_children
        returned += node.named_children if node.type == "return_statement" else []
    return all(own.get(each.text, False) or _is_made(analysis, each) for each in returned)


def _is_made(analysis: Analysis, value: Node) -> bool:
    """Whether an expression makes an object, as far as it says that itself."""
    if value.type == "call":
        return analysis.syntax.called_name(value) not in _SHARING
    if value.type in ("parenthesized_expression", "boolean_operator", "conditional_expression"):
        return all(_is_made(analysis, each) for each in parts_of(value))
    return value.type not in _SHARED


def _is_pure_call(analysis: Analysis, call: Node, depth: int = 0) -> bool:
    callee = call.child_by_field_name("function")
    if callee is None:
        return False
    scope = analysis.scopes.at(call.start_byte)
    if callee.type == "identifier":
        name = analysis.syntax.slice(callee)
        if name in _PURE_BUILTINS and scope.lookup(name) is None:
            return True
    resolver = analysis.resolver
    if resolver.interface(callee, scope) is not None:
        return True
    function = function_of(callee, analysis)
    if function is not None:
        return depth < _MOST_DEEP and _is_pure_function(analysis, function, depth + 1)
    names = resolver.qualified(callee, scope)
    if names:
        return all(
            _is_known(each) or is_interface_module(each) or _draws(analysis, each) for each in names
        )
    method = callee.child_by_field_name("attribute")
    name = analysis.syntax.slice(method) if method is not None else ""
    return name in _PURE_METHODS or (name == "get" and _is_of_mapping(call))


def _is_pure_function(analysis: Analysis, function: Scope, depth: int) -> bool:
    """Whether a function of the file only works out what it returns."""
    parent, body = function.node.parent, function.node.child_by_field_name("body")
    is_decorated = parent is None or parent.type == "decorated_definition"
    is_async = function.node.children[0].type == "async"
    if is_decorated or is_async or function.globals or function.nonlocals or body is None:
        return False
    own = _own_objects(analysis, function)
    pending = parts_of(body)
    while pending:
        statement = pending.pop()
        parts = statement.named_children
        match statement.type:
            case "pass_statement" | "comment":
                continue
            case "block" | "if_statement" | "elif_clause" | "else_clause" | "return_statement":
                pending += parts
            case "for_statement":
                pending += parts[1:]
            case "expression_statement" if len(parts) == 1:
                value = _local_value(analysis, parts[0], own)
                if value is None or not is_pure(analysis, value, depth):
                    return False
            case _ if not is_pure(analysis, statement, depth):
                return False
    return True


def _own_objects(analysis: Analysis, function: Scope) -> dict[bytes | None, bool]:
    """Return what a function assigns: `a`, `a.b`, each with whether nothing else knows of it."""
    own: dict[bytes | None, bool] = {}
    pending = [function.node]
    while pending:
        node = pending.pop()
        pending += node.named_children
        target, value = node.child_by_field_name("left"), node.child_by_field_name("right")
        if node.type == "assignment" and target is not None and value is not None:
            own[target.text] = _is_made(analysis, value) and own.get(target.text, True)
    for name, bindings in function.bindings.items():
        if any(each.kind is BindingKind.PARAMETER for each in bindings):
            own[analysis.syntax.encode(name)] = False
    return own


def _local_value(analysis: Analysis, part: Node, own: Mapping[bytes | None, bool]) -> Node | None:
    """Return what a statement only works out: a local variable, a part of one, a docstring."""
    if part.type == "string":
        return part
    target, value = part.child_by_field_name("left"), part.child_by_field_name("right")
    if part.type == "call" and analysis.syntax.called_name(part) in FILLING:
        target, value = (part.child_by_field_name(each) for each in ("function", "arguments"))
    if target is None or value is None:
        return None
    held = holders(target)
    if part.type == "augmented_assignment" and not held:
        return value if value.type in ("integer", "float", "binary_operator") else None
    root = held[-1] if held else target
    is_own = not held or (root.type == "identifier" and own.get(root.text, False))
    is_own = is_own and all(own.get(each.text, True) for each in held)
    is_own = is_own and root.type == "identifier" and is_pure(analysis, target)
    return value if is_own else None


def _is_known(name: str) -> bool:
    is_pure = name.startswith(_PURE_MODULES) and not name.startswith(_DOING)
    return name in _PURE_FUNCTIONS or is_pure


def _draws(analysis: Analysis, name: str) -> bool:
    """Whether a function only draws a number, in a file that seeds no numbers."""
    is_drawing = name.startswith(_DRAWING) and not name.endswith(("state", "shuffle"))
    return is_drawing and b"seed" not in analysis.syntax.text


def _is_of_mapping(call: Node) -> bool:
    """Whether `get` is asked for a key: that of a queue takes something out."""
    first = next(iter(parts_of(call.child_by_field_name("arguments"))), None)
    return first is not None and first.type in ("string", "identifier", "attribute")
