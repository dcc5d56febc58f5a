"""What code does with a variable: whether it sets it, or reads it, and which part of it."""

from __future__ import annotations

import re
from typing import NamedTuple

from tree_sitter import Node

from ..analysis import Analysis
from ..scopes import CppFile, Variable

Path = tuple[str, ...]

# Methods that give what they are called on a value, or wake who waits for it.
_SETTING = frozenset(
    {"append", "assign", "emplace", "emplace_back", "emplace_front", "exchange", "insert"}
    | {"notify_all", "notify_one", "push", "push_back", "push_front", "set_value", "store"}
)
CLEARING = frozenset({"clear", "reset"})
"""Methods that leave what they are called on without a value."""
# Functions that only look at what they are given.
_READING = re.compile(
    r"(?:[A-Z][A-Z0-9_]*|(?:\w+::)*(?:make_\w+|to_string|to_yaml|f?abs|fabs|sqrt|pow|sin|cos|tan"
    r"|a?tan2|hypot|min|max|isnan|isfinite|floor|ceil|round|printf|fprintf)|.*(?:\.|->)"
    r"(?:publish|sendTransform|push_back|emplace_back|push|store|at|find|count))(?:<.*>)?\Z",
    re.DOTALL,
)


class Access(NamedTuple):
    """What is done with a variable, or with a part of what it holds.

    Attributes:
        path: the names of the part: `("linear", "x")` of `twist_.linear.x`.
        whole: the expression of the part.
        is_set: whether it gets a value.
        is_handed: whether it may get one, from what it is given to by reference.
        method: the method of it that is called, "" for none.
    """

    path: Path
    whole: Node
    is_set: bool = False
    is_handed: bool = False
    method: str = ""


def access(analysis: Analysis, file: CppFile, node: Node) -> Access:
    """Return what is done with the variable that a node names."""
    whole = node
    outer = node.parent
    if outer is not None and outer.type == "field_expression":
        field = outer.child_by_field_name("field")
        whole = outer if field is not None and field.id == node.id else node
    path: list[str] = []
    is_plain = True
    while (parent := whole.parent) is not None:
        held = parent.child_by_field_name("argument")
        is_held = held is not None and held.id == whole.id
        if parent.type == "field_expression" and is_held:
            field = parent.child_by_field_name("field")
            word = "" if field is None else file.syntax.word(field)
            if _is_callee(parent):
                return Access(tuple(path), parent, word in _SETTING, False, word)
            if is_plain:
                path.append(word)
        elif parent.type == "subscript_expression" and is_held:
            is_plain = False
        elif parent.type == "pointer_expression" and file.syntax.word(parent).startswith("&"):
            return Access(tuple(path), parent, is_handed=True)
        elif parent.type not in ("pointer_expression", "parenthesized_expression"):
            break
        whole = parent
    found = Access(tuple(path), whole)
    if parent is None:
        return found
    match parent.type:
        case "assignment_expression":
            left = parent.child_by_field_name("left")
            return found._replace(is_set=left is not None and left.id == whole.id)
        case "update_expression":
            return found._replace(is_set=True)
        case "field_initializer":
            return found._replace(is_set=parent.named_children[0].id == whole.id)
        case "binary_expression":
            sign = parent.child_by_field_name("operator")
            right = parent.child_by_field_name("right")
            is_read_into = sign is not None and sign.text == b">>" and right == whole
            return found._replace(is_set=is_read_into)
        case "argument_list":
            return found._replace(is_handed=_may_set(analysis, file, parent, whole))
        case "init_declarator":
            declarator = parent.child_by_field_name("declarator")
            is_bound = declarator is not None and declarator.type == "reference_declarator"
            return found._replace(is_handed=is_bound and not _is_const(file, parent))
        case "for_range_loop":
            return found._replace(is_handed=b"const" not in (parent.text or b"")[:40])
    return found


def _is_callee(node: Node) -> bool:
    call = node.parent
    called = None if call is None else call.child_by_field_name("function")
    return called is not None and called.id == node.id


def _is_const(file: CppFile, declarator: Node) -> bool:
    declaration = declarator.parent
    if declaration is None:
        return False
    return "const" in file.syntax.between(declaration.start_byte, declarator.start_byte)


def _may_set(analysis: Analysis, file: CppFile, listed: Node, given: Node) -> bool:
    """Tell whether what is called may change an argument, as `getParam("x", x_)` does."""
    call = listed.parent
    called = None if call is None else call.child_by_field_name("function")
    if call is None or called is None:
        # What is made of it, by `T x(a)` or `new T(a)`, rarely changes it.
        return False
    text = "".join(file.syntax.word(called).split())
    if _READING.fullmatch(text):
        return False
    name = re.split(r"::|\.|->", re.sub(r"<.*", "", text))[-1]
    position = [each.id for each in listed.named_children].index(given.id)
    own = analysis.unit.functions.get(name, ())
    taken = [each.parameters[position] for each in own if position < len(each.parameters)]
    return not taken or any(map(_is_changeable, taken))


def _is_changeable(parameter: Variable) -> bool:
    is_shared = parameter.is_reference or parameter.is_pointer
    return is_shared and "const" not in parameter.file.syntax.word(parameter.node)
