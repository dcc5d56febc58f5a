"""From rospy to rclpy: what Python 2 has, and Python 3, which ROS 2 is of, writes otherwise."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.sources.python.compiling import syntax_error
from plastron_tui.sources.python.syntax import parse, parts_of

from .kinds import kind_of
from .port_state import Work, walk
from .python_2_names import mark_python_2, port_lists, port_names

_METHODS = {"iteritems": "items", "itervalues": "values", "iterkeys": "keys"}
_TABS = "inconsistent use of tabs"
_VIEWS = frozenset({"keys", "values", "items"})
_ITERATORS = frozenset({"map", "filter", "zip"})
_OCTAL = re.compile(r"0[0-7]*[1-7][0-7]*")


def port_python_2(work: Work) -> None:
    """Rewrite the functions, methods, operators and numbers of Python 2.

    A function or method of the file's own stays, whatever its name.
    """
    is_old = syntax_error(work.analysis.syntax.text) is not None
    for node in walk(work.analysis.syntax.root):
        if node.type == "integer":
            _port_number(work, node)
        elif node.type == "binary_operator" and is_old:
            _port_division(work, node)
        elif node.type == "subscript":
            _port_part(work, node)
        elif node.type == "comparison_operator":
            for operator in node.children:
                if operator.type == "<>":
                    work.replace(operator, "!=")
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is None or work.is_gone(call):
            continue
        if callee.type == "attribute":
            _port_method(work, call, callee)
    has_names = port_names(work)
    if mark_python_2(work, has_names=has_names):
        port_lists(work)


def without_tabs(text: bytes) -> bytes:
    """Indent by spaces a file that mixes them with tabs: a tab of Python 2 goes to a column of 8.

    What is inside of a string stays.
    """
    problem = syntax_error(text)
    if problem is None or _TABS not in problem.reason:
        return text
    kept: set[int] = set()
    for node in walk(parse(text).root):
        if node.type == "string":
            kept.update(range(node.start_point.row + 1, node.end_point.row + 1))
    lines = text.split(b"\n")
    for row, line in enumerate(lines):
        code = line.lstrip(b" \t")
        if row not in kept:
            lines[row] = line[: len(line) - len(code)].expandtabs(8) + code
    return b"\n".join(lines)


def port_statements(work: Work) -> None:
    """Rewrite the statements that Python 3 has not, around all that is rewritten inside of them."""
    text = work.analysis.syntax.text
    statements = list(walk(work.analysis.syntax.root))
    # `print` alone, and `print ("a"), b`, are something else in Python 3.
    is_old = syntax_error(text) is not None and not any(
        each.type == "future_import_statement" and "print_function" in work.slice(each)
        for each in statements
    )
    for statement in statements:
        if work.is_gone(statement) or work.is_rewritten(statement):
            continue
        match statement.type:
            case "print_statement":
                _port_print(work, statement)
            case "expression_statement" if is_old and _prints(statement):
                _port_print(work, statement)
            case "except_clause":
                _port_except(work, statement)
            case "raise_statement":
                _port_raise(work, statement)
            case "exec_statement":
                _port_exec(work, statement)


def _prints(statement: Node) -> bool:
    """Tell whether the grammar read a print statement as an expression, and no call of it."""
    first = statement.children[0]
    is_alone = first.type == "call" and len(statement.children) == 1
    if is_alone and first.children[0].type == "identifier":
        return False
    while first.children:
        first = first.children[0]
    return first.type == "identifier" and first.text == b"print"


def _port_print(work: Work, statement: Node) -> None:
    """Write `print >>out, a,` as `print(a, end=" ", file=out)`."""
    start = statement.start_byte + len(b"print")
    end = statement.end_byte
    parts = [each for each in statement.children if each.type not in ("print", "line_continuation")]
    keywords = []
    if parts[-1].type == ",":
        end = parts[-2].end_byte
        keywords.append(f"end={work.string(' ')}")
    rest = work.analysis.syntax.text[start:end]
    begin = end - len(rest.lstrip(b" \t"))
    if parts[0].type == "chevron":
        keywords.append(f"file={work.text(parts[0].named_children[0])}")
        begin = parts[2].start_byte if len(parts) > 2 else end
    separator = ", " if begin < end and keywords else ""
    work.replace_between(start, begin, "(")
    closing = f"{separator}{', '.join(keywords)})"
    if end < statement.end_byte:
        work.replace_between(end, statement.end_byte, closing)
    else:
        work.insert_last(end, closing)


def _port_except(work: Work, clause: Node) -> None:
    """Write `except X, error:` as `except X as error:`."""
    values = clause.children_by_field_name("value")
    if len(values) == 2 and values[1].type == "identifier":
        work.replace_between(values[0].end_byte, values[1].start_byte, " as ")


def _port_exec(work: Work, statement: Node) -> None:
    """Write `exec code in names` as `exec(code, names)`."""
    code, *names = statement.named_children
    work.replace_between(statement.start_byte + len(b"exec"), code.start_byte, "(")
    if names:
        work.replace_between(code.end_byte, names[0].start_byte, ", ")
    work.insert_last(statement.end_byte, ")")


def _port_raise(work: Work, statement: Node) -> None:
    """Write `raise X, "text"` as `raise X("text")`; another value may be the exception itself."""
    given = statement.named_children[0] if statement.named_children else None
    if given is None or given.type != "expression_list" or len(given.named_children) != 2:
        return
    class_, value = given.named_children
    if class_.type in ("identifier", "attribute") and _is_text(value):
        work.replace_between(class_.end_byte, value.start_byte, "(")
        work.insert_last(value.end_byte, ")")


def _is_text(value: Node) -> bool:
    """Tell whether a value is a string, or one with what is formatted into it."""
    while value.type == "binary_operator":
        value = value.children[0]
    return value.type in ("string", "concatenated_string")


def _port_number(work: Work, number: Node) -> None:
    """Write `0777` as `0o777`, and `10L` as `10`."""
    written = work.slice(number)
    if _OCTAL.fullmatch(written):
        work.replace(number, f"0o{written.lstrip('0')}")
    elif written[-1] in "lL" and not written.startswith("0"):
        work.replace(number, written[:-1])


def _port_division(work: Work, operation: Node) -> None:
    """Write `/` of integers as `//`, which it is in Python 2."""
    sign = operation.child_by_field_name("operator")
    kinds = {kind_of(work, each) for each in parts_of(operation)}
    if sign is not None and work.slice(sign) == "/" and kinds == {"int"}:
        work.replace(sign, "//")


def _port_part(work: Work, node: Node) -> None:
    """Write `held.keys()[0]` as `list(held.keys())[0]`: views and iterators have no parts."""
    call = node.child_by_field_name("value")
    callee = call.child_by_field_name("function") if call is not None else None
    if call is None or call.type != "call" or callee is None:
        return
    part = callee.child_by_field_name("attribute")
    given = parts_of(call.child_by_field_name("arguments"))
    is_view = part is not None and work.slice(part) in _VIEWS and not given
    name = work.slice(callee)
    is_iterator = name in _ITERATORS and work.scope(callee).lookup(name) is None
    if is_iterator or (is_view and not work.bindings(callee)):
        work.insert(call.start_byte, "list(")
        work.insert(call.end_byte, ")")


def _port_method(work: Work, call: Node, callee: Node) -> None:
    part = callee.child_by_field_name("attribute")
    given = parts_of(call.child_by_field_name("arguments"))
    name = work.slice(part) if part is not None else ""
    if part is None or work.analysis.resolver.attribute_bindings(callee, work.scope(callee)):
        return
    if name in _METHODS and not given:
        work.replace(part, _METHODS[name])
    elif name == "has_key" and len(given) == 1:
        _port_has_key(work, call, callee, given[0])


def _port_has_key(work: Work, call: Node, callee: Node, key: Node) -> None:
    """Write `held.has_key(key)` as `key in held`, which binds less closely than a call."""
    holder, parent = callee.child_by_field_name("object"), call.parent
    if holder is None or parent is None or key.type not in _SIMPLE:
        work.mark(call, ".has_key", "`key in ...`, in Python 3")
        return
    if parent.type == "not_operator":
        work.replace(parent, f"{work.text(key)} not in {work.text(holder)}")
        return
    written = f"{work.text(key)} in {work.text(holder)}"
    work.replace(call, written if parent.type in _LOOSE else f"({written})")


_SIMPLE = frozenset({"identifier", "attribute", "string", "integer", "call", "subscript"})
_LOOSE = frozenset(
    {
        "if_statement",
        "elif_clause",
        "while_statement",
        "assignment",
        "argument_list",
        "boolean_operator",
        "return_statement",
        "parenthesized_expression",
        "expression_statement",
        "assert_statement",
    }
)
"""What binds less closely than `in`."""
