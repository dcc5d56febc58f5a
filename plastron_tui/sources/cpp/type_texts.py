"""Types as texts: their template arguments, and what smart pointers point to."""

from __future__ import annotations

import re

_POINTER = re.compile(
    r"(?:std|boost)::(?:shared_ptr|unique_ptr|weak_ptr|optional|reference_wrapper|scoped_ptr)<(.+)>"
)
_SUFFIX = re.compile(r"::(?:(?:Const)?(?:SharedPtr|UniquePtr|WeakPtr|Ptr|RawPtr)|SharedConstPtr)\Z")
_INNERMOST = re.compile(r"<[^<>]*>")


def without_templates(text: str) -> str:
    """Return a name without template arguments: `A::f` for `A<B<C>>::f`."""
    for _ in range(16):
        shorter = _INNERMOST.sub("", text)
        if shorter == text:
            break
        text = shorter
    return text


def template_arguments(text: str) -> list[str]:
    """Return the parts of a text between commas that are in no brackets."""
    return split_outside(text, ",")


def split_outside(text: str, mark: str) -> list[str]:
    """Return the parts of a text between marks that are in no brackets."""
    if mark not in text:
        return [text]
    found, depth, start, at = [], 0, 0, 0
    while at < len(text):
        letter = text[at]
        if letter in "<([{":
            depth += 1
        elif letter in ">)]}":
            depth -= 1
        elif depth == 0 and text.startswith(mark, at):
            found.append(text[start:at])
            at += len(mark)
            start = at
            continue
        at += 1
    found.append(text[start:])
    return found


def without_pointer(text: str) -> str:
    """Return what a smart pointer points to; what is none stays as it is."""
    for _ in range(4):
        text = text.rstrip("&*")
        if text in ("ros::NodeHandlePtr", "ros::NodeHandleConstPtr"):
            return "ros::NodeHandle"
        if found := _POINTER.fullmatch(text):
            text = template_arguments(found[1])[0]
        elif _SUFFIX.search(text):
            text = _SUFFIX.sub("", text)
        else:
            break
    return text
