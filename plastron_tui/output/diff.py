"""What a plan would change, as a patch that `git apply` and `patch -p1` take.

Lines are bytes and end at a line feed only, so that text in any encoding, carriage returns and a
missing final newline come through exactly. What has a NUL character near its begin is no text, as
git tells it, and comes as a binary patch (`git apply`, gitformat-pack; `base85.c` of git).
"""

from __future__ import annotations

import difflib
import hashlib
import stat
import zlib
from base64 import b85encode
from collections.abc import Iterator

from .plan import FileState, PlannedFile

_BINARY = b"GIT binary patch\n"
_LOOKED_AT = 8_000
"""Bytes of a file in which git looks for a NUL character."""
_LINE = 52
"""Bytes in a line of a binary patch, whose first letter says how many they are."""
_NO_NEWLINE = b"\\ No newline at end of file\n"


def file_diff(file: PlannedFile) -> bytes:
    """Return the patch for a file; empty for one that is identical."""
    if file.state is FileState.IDENTICAL:
        return b""
    name = _quoted(file.name)
    is_new = file.before is None
    after = 0o100755 if file.is_executable else 0o100644
    lines = [b"diff --git a/%b b/%b\n" % (name, name)]
    if is_new:
        lines.append(b"new file mode %o\n" % after)
    elif file.is_executable and not (file.mode_before or 0) & stat.S_IXUSR:
        lines += [b"old mode 100644\n", b"new mode 100755\n"]
    if any(b"\0" in each[:_LOOKED_AT] for each in (file.before or b"", file.text)):
        return b"".join((*lines, *_binary(file.before, file.text)))
    lines += _hunks(
        file.before or b"",
        file.text,
        b"/dev/null" if is_new else b"a/" + name,
        b"b/" + name,
    )
    return b"".join(lines)


def text_diff(before: bytes, after: bytes) -> bytes:
    """Return how two texts differ, as the patch of a file without a name."""
    return b"".join(_hunks(before, after, b"before", b"after"))


def visible_patch(patch: bytes) -> str:
    r"""Return a patch for a terminal: what a terminal would obey or hide is shown escaped.

    A carriage return is shown as `^M`, a byte that is not UTF-8 as `\xff`. What is no text is
    only named.
    """
    head, is_binary, _ = patch.partition(b"\n" + _BINARY)
    patch = head + b"\nBinary files differ\n" if is_binary else patch
    text = patch.decode("utf-8", "backslashreplace")
    if text.replace("\n", "").replace("\t", "").isprintable():
        return text
    return "".join(_visible(character) for character in text)


def _visible(character: str) -> str:
    if character in "\n\t" or character.isprintable():
        return character
    code = ord(character)
    if code < 0x20:
        return f"^{chr(code + 0x40)}"
    # Spaces of other scripts are not "printable" to Python, and are harmless.
    return character if character.isspace() and code > 0xFF else ascii(character)[1:-1]


def _binary(before: bytes | None, after: bytes) -> Iterator[bytes]:
    yield b"index %b..%b\n" % (_blob(before), _blob(after))
    yield _BINARY
    for text in (after, before or b""):
        yield b"literal %d\n" % len(text)
        packed = zlib.compress(text)
        for at in range(0, len(packed), _LINE):
            line = packed[at : at + _LINE]
            letter = ord("A") + len(line) - 1 if len(line) <= 26 else ord("a") + len(line) - 27
            yield b"%c%b\n" % (letter, b85encode(line, pad=True))
        yield b"\n"


def _blob(text: bytes | None) -> bytes:
    """Return the name that git has for a file's content."""
    if text is None:
        return b"0" * 40
    named = b"blob %d\0" % len(text) + text
    return hashlib.sha1(named, usedforsecurity=False).hexdigest().encode()


def _hunks(before: bytes, after: bytes, old_name: bytes, new_name: bytes) -> Iterator[bytes]:
    for line in difflib.diff_bytes(
        difflib.unified_diff,
        _lines(before),
        _lines(after),
        old_name,
        new_name,
    ):
        if line.endswith(b"\n"):
            yield line
        else:
            yield line + b"\n"
            yield _NO_NEWLINE


def _lines(text: bytes) -> list[bytes]:
    lines = [line + b"\n" for line in text.split(b"\n")]
    last = lines.pop()[:-1]
    return [*lines, last] if last else lines


def _quoted(name: str) -> bytes:
    """Quote a name as git does, where it holds what git quotes."""
    plain = name.replace('"', '\\"')
    return (f'"{plain}"' if plain != name else name).encode("utf-8", "surrogateescape")
