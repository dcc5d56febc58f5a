"""From rospy to rclpy: names and modules of Python 2 that Python 3 has elsewhere, or not at all."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.compiling import syntax_error
from plastron_tui.sources.python.references import is_member, statement_of
from plastron_tui.sources.python.syntax import parts_of

from .kinds import kind_of
from .port_state import Mark, Work, is_imported, walk

_RENAMED = {
    "raw_input": "input",
    "xrange": "range",
    "unicode": "str",
    "basestring": "str",
    "long": "int",
    "unichr": "chr",
}
_IMPORTED = {"reduce": "from functools import reduce", "reload": "from importlib import reload"}
_LOST = {
    "cmp": "`(a > b) - (a < b)`",
    "execfile": "`exec(open(path).read())`",
    "file": "`open(path)`",
    "apply": "`function(*arguments)`",
    "buffer": "`memoryview`",
    "intern": "`sys.intern`",
}
# `import Queue` goes on as `import queue as Queue`: all that a file asks of it is there.
_MODULES = {
    "Queue": "queue",
    "ConfigParser": "configparser",
    "Tkinter": "tkinter",
    "tkMessageBox": "tkinter.messagebox",
    "tkFileDialog": "tkinter.filedialog",
    "cPickle": "pickle",
    "StringIO": "io",
    "cStringIO": "io",
    "SocketServer": "socketserver",
    "BaseHTTPServer": "http.server",
    "SimpleHTTPServer": "http.server",
    "httplib": "http.client",
    "urlparse": "urllib.parse",
    "xmlrpclib": "xmlrpc.client",
    "thread": "_thread",
    "cookielib": "http.cookiejar",
    "__builtin__": "builtins",
}
_LOST_MODULES = {
    "cv": "`cv2`",
    "cv2.cv": "`cv2`",
    "urllib2": "`urllib.request`",
    "commands": "`subprocess`",
    "exceptions": "what it has is built in",
    "sets": "`set`",
    "md5": "`hashlib`",
}
_LOST_PARTS = {
    "sys.maxint": "`sys.maxsize`",
    "sys.setdefaultencoding": "Python 3 has UTF-8: it goes, with `reload(sys)`",
    "string.letters": "`string.ascii_letters`",
    "string.join": "`join` of the text between",
    "string.split": "`split` of the text",
    "os.getcwdu": "`os.getcwd`",
    "itertools.izip": "`zip`",
    "itertools.imap": "`map`",
    "urllib.urlopen": "`urllib.request.urlopen`",
    "urllib.urlencode": "`urllib.parse.urlencode`",
    "urllib.quote": "`urllib.parse.quote`",
    "time.clock": "`time.perf_counter`",
}
_ABOUT = "there `/` of integers has a fraction, text is no bytes, and `map` gives no list"


def port_names(work: Work) -> bool:
    """Rewrite or mark names and modules that Python 3 lacks; tell whether there are any."""
    found = False
    bound = {name for scope in work.analysis.scopes.all for name in scope.bindings}
    for node in walk(work.analysis.syntax.root):
        if work.is_gone(node) or is_imported(node):
            continue
        if node.type == "identifier":
            found |= _port_name(work, node, bound)
        elif node.type == "attribute":
            for name in set(work.qualified(node)) & (_LOST_PARTS.keys() | _LOST_MODULES.keys()):
                remedy = _LOST_PARTS.get(name) or _LOST_MODULES[name]
                work.mark(node, name, f"{remedy}, in Python 3")
                found = True
    for tag in ("import", "import_from"):
        for statement in work.analysis.captures.get(tag, []):
            if not work.is_gone(statement) and not _is_tried(statement):
                found |= _port_module(work, statement)
    for call in work.analysis.captures.get("call", []):
        _port_packed(work, call)
    return found


def mark_python_2(work: Work, *, has_names: bool) -> bool:
    """Warn once that a file is of Python 2: not all that Python 3 does otherwise can be seen.

    Returns:
        whether it is.
    """
    statements = [
        each for each in work.analysis.syntax.root.named_children if each.type != "comment"
    ]
    is_old = has_names or syntax_error(work.analysis.syntax.text) is not None
    is_old |= any(
        each.type == "future_import_statement" and "annotations" not in work.slice(each)
        for each in statements
    )
    if is_old:
        work.marks.append(Mark(statements[0], "Python 2", _ABOUT, has_comment=True))
    return is_old


def _port_name(work: Work, node: Node, bound: set[str]) -> bool:
    name = work.slice(node)
    if name not in _RENAMED and name not in _IMPORTED and name not in _LOST:
        return False
    is_called = node.parent is not None and node.parent.child_by_field_name("function") == node
    if is_member(node) or name in bound or (name in _LOST and not is_called):
        return False
    new = _RENAMED.get(name)
    if new is not None and new not in bound:
        work.replace(node, new)
    elif name in _IMPORTED:
        work.imports.add(_IMPORTED[name])
    else:
        work.mark(node, name, f"{_LOST.get(name, f'`{new}`')}, in Python 3")
    return True


def _is_tried(statement: Node) -> bool:
    """Tell whether an import is one of two that a file tries, or that it asks its Python for."""
    current: Node | None = statement
    while current is not None and current.type not in ("try_statement", "if_statement"):
        current = current.parent
    return current is not None


def _port_module(work: Work, statement: Node) -> bool:
    module = statement.child_by_field_name("module_name")
    is_found = False
    for part in [module] if module is not None else statement.children_by_field_name("name"):
        name = part.child_by_field_name("name") or part
        old = work.slice(name)
        if old in _LOST_MODULES:
            work.mark(statement, old, f"{_LOST_MODULES[old]}, in Python 3")
        elif old in _MODULES and not work.is_rewritten(name):
            is_bare = module is None and part.type != "aliased_import"
            work.replace(name, f"{_MODULES[old]} as {old}" if is_bare else _MODULES[old])
        else:
            continue
        is_found = True
    return is_found


def _port_packed(work: Work, call: Node) -> None:
    """Make bytes of a literal text that `struct.pack` takes; mark another text."""
    callee = call.child_by_field_name("function")
    if callee is None or set(work.qualified(callee)) != {"struct.pack"}:
        return
    for each in parts_of(call.child_by_field_name("arguments"))[1:]:
        literal = work.slice(each)
        if each.type == "string" and literal[0] in "\"'" and literal.isascii():
            work.insert(each.start_byte, "b")
        elif kind_of(work, each) == "str" and "encode" not in literal:
            work.mark(each, "struct.pack", "it takes bytes in Python 3: `encode` the text")


_CONSUMING = frozenset(
    {"list", "sorted", "sum", "min", "max", "set", "tuple", "any", "all", "enumerate", "zip"}
    | {"map", "filter", "dict", "frozenset", "iter", "reversed", "reduce"}
)
_LISTS = frozenset({"range", "map", "filter", "zip"})
_STORED = frozenset({"assignment", "return_statement", "keyword_argument", "binary_operator"})


def port_lists(work: Work) -> None:
    """Write `list(range(...))` where a file of Python 2 keeps a list, or hands it over."""
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        name = work.slice(callee) if callee is not None else ""
        if callee is None or name not in _LISTS or work.scope(callee).lookup(name) is not None:
            continue
        if not work.is_gone(call) and _is_kept(work, call):
            work.insert_first(call.start_byte, "list(")
            work.insert(call.end_byte, ")")


def _is_kept(work: Work, call: Node) -> bool:
    parent = call.parent
    if parent is None:
        return False
    if parent.type == "argument_list" and parent.parent is not None:
        taker = parent.parent.child_by_field_name("function")
        name = work.slice(taker) if taker is not None else ""
        is_own = taker is not None and bool(work.bindings(taker)) and not work.qualified(taker)
        return name == "len" or (name not in _CONSUMING and is_own)
    left = parent.child_by_field_name("left")
    is_unpacked = left is not None and left.type in ("pattern_list", "tuple_pattern")
    return parent.type in _STORED and not is_unpacked and statement_of(call).type != "for_statement"
