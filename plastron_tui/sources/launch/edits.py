"""Changes of launch files in XML: each is one splice, and what stands around it stays."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.launch import Argument, Item, StartedNode, items_of, named_nodes
from plastron_tui.ros.launch_text import Kind, Text
from plastron_tui.sources.xml.document import Element, XmlDocument
from plastron_tui.sources.xml.edits import (
    XmlEdit,
    insert_after,
    insert_before,
    insert_last,
    remove_element,
)

from .new_elements import CannotWriteError, new_element
from .substitutions import parse_text
from .xml_reader import LaunchRead, read_launch_xml


def add(document: XmlDocument, item: Item, ros_version: int) -> XmlEdit:
    """Write something into a launch file, behind the last of its like.

    An argument comes before what may use it.
    """
    try:
        new = new_element(item, ros_version)
    except CannotWriteError as error:
        message = f"ROS {ros_version} has no words for {error} in a launch file"
        return XmlEdit(None, (Diagnostic(codes.EDIT_REFUSED, message),))
    root = document.root
    like = [child for child in root.children if child.name == new.name]
    if isinstance(item, Argument):
        # One that a condition hangs on, say, may stand anywhere; the first run of them is the head.
        head = _head(root, new.name)
        if head is not None:
            edit = insert_after(document, head, new)
        elif root.children:
            edit = insert_before(document, root.children[0], new)
        else:
            edit = insert_last(document, root, new)
    elif like:
        edit = insert_after(document, like[-1], new)
    else:
        edit = insert_last(document, root, new)
    return _checked(document, edit, ros_version, item, 1)


def remove(document: XmlDocument, kind: type[Item], name: str, ros_version: int) -> XmlEdit:
    """Take an argument, a node or an included file out of a launch file, by its name."""
    read = _read(document, ros_version)
    items = () if read.launch is None else read.launch.items
    found: list[Item] = []
    if kind is StartedNode:
        found += (node for full_name, node in named_nodes(items) if full_name == name)
    else:
        found += (item for item in items_of(items, kind) if item.called == name)
    if len(found) != 1:
        how_many = "no" if not found else str(len(found))
        places = tuple(_spans(found))
        message = f"the launch file has {how_many} `{name}`, and one was to be taken out"
        span = places[0] if places else None
        return XmlEdit(None, (Diagnostic(codes.EDIT_REFUSED, message, span, document.file),))
    span = next(_spans(found), None)
    element = next((each for each in document.root.walk() if each.span == span), None)
    if element is None:
        message = f"`{name}` is a container; take it out by hand"
        return XmlEdit(None, (Diagnostic(codes.EDIT_REFUSED, message, file=document.file),))
    used = _use(document, element, name, ros_version) if kind is Argument else None
    if used is not None:
        message = f"`{name}` is still used here, and cannot be taken out"
        return XmlEdit(None, (Diagnostic(codes.EDIT_REFUSED, message, used, document.file),))
    # A file without anything in it is one that people write something into.
    is_outermost = document.parents.get(element) is document.root
    edit = remove_element(document, element, closes=not is_outermost)
    return _checked(document, edit, ros_version, found[0], -1)


def _head(root: Element, name: str) -> Element | None:
    """Return the last element of the first run of a name."""
    last = None
    for child in root.children:
        if child.name == name:
            last = child
        elif last is not None:
            break
    return last


def _use(document: XmlDocument, removed: Element, name: str, ros_version: int) -> Span | None:
    """Return where an argument is asked for beside its own element."""

    def is_used(source: str) -> bool:
        return "$(" in source and _asks(parse_text(source, ros_version), name)

    for element in document.root.walk():
        if element is removed:
            continue
        for each in element.attributes:
            if is_used(each.value):
                return each.value_span
        if is_used(element.text):
            return element.value_span(document.text)
    return None


def _asks(of: Text, name: str) -> bool:
    """Tell whether a text asks for an argument; what is evaluated may, where it names the word."""
    for part in of.parts:
        if isinstance(part, str):
            continue
        if part.kind is Kind.ARGUMENT and part.argument.literal == name:
            return True
        if part.kind is Kind.OTHER and _has_word(str(part.argument), name):
            return True
        if _asks(part.argument, name) or (part.default is not None and _asks(part.default, name)):
            return True
    return False


def _has_word(source: str, word: str) -> bool:
    if not word.isidentifier():
        return word in source
    return word in "".join(x if x.isalnum() or x == "_" else " " for x in source).split()


def _spans(items: list[Item]) -> Iterator[Span]:
    for item in items:
        if item.place is not None:
            yield Span(item.place.start, item.place.end)


def _checked(
    before: XmlDocument, edit: XmlEdit, ros_version: int, item: Item, change: int
) -> XmlEdit:
    """Return an edit if the file says what it is to say, read again."""
    if edit.document is None:
        return edit
    old, new = _read(before, ros_version).launch, _read(edit.document, ros_version).launch
    kind: type[Item] = type(item)
    if old is not None and new is not None:
        was, now = list(items_of(old.items, kind)), list(items_of(new.items, kind))
        more, less = (now, was) if change > 0 else (was, now)
        if len(more) == len(less) + 1 and more.count(item) == less.count(item) + 1:
            return edit
    message = "the launch file would not say what was asked for"
    return XmlEdit(None, (Diagnostic(codes.EDIT_REFUSED, message, file=before.file),))


def _read(document: XmlDocument, ros_version: int) -> LaunchRead:
    return read_launch_xml(document.text, document.file, ros_version)
