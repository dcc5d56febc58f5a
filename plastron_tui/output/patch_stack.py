"""What programs made of a file that they loaded: layers, one a program, the first at the bottom.

A program that loads what it wrote itself shall start from what it started from before, and not
from its own changes. So each layer keeps two texts: what the program found, and what it made of
it. Where what came after differs from that (the next layer's original; for the top layer the file)
somebody wrote by hand.
"""

from __future__ import annotations

import base64
import binascii
import zlib
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path, PurePath, PurePosixPath
from typing import Any, NamedTuple

from plastron_tui.model.source import FileSet

MOST_LAYERS = 8
"""How many programs' changes of one file are remembered; the lowest layers are forgotten."""

LARGEST_TEXTS = 16 * 1024 * 1024
"""The size of the texts of one layer, in bytes, beyond which it is taken for a broken one."""

MOST_TEXTS = 128 * 1024 * 1024
"""The same for all layers of a manifest: what is packed can be a thousandth of what it holds."""


@dataclass(frozen=True, slots=True)
class Layer:
    """What one program made of a file.

    Attributes:
        program: the name of the program's file.
        original: what it started from.
        written: what it made of that, without handwork.
        base: what the node had in the end, as `node_json` gives it.
        origin: the file that the original is of, from the folder of the manifest; None where it
            is the written file itself.
        seen: the digest of that file when it was read.
        is_clean: whether the original had no handwork when the layer was laid over it.
        text: the digest of the program's text.
        left: the digest of the file as the program left it, with handwork.
    """

    program: str
    original: FileSet
    written: FileSet
    base: Mapping[str, Any] = field(default_factory=dict)
    origin: str | None = None
    seen: str | None = None
    is_clean: bool = False
    text: str = ""
    left: str = ""

    @property
    def size(self) -> int:
        """The size of its texts, in bytes."""
        return len(_joined(self.original)) + len(_joined(self.written))

    def is_of(self, files: FileSet) -> bool:
        """Tell whether it is of no other files than those that a set has."""
        return {*self.original.names, *self.written.names} <= {*files.names}

    def shows_in(self, files: FileSet) -> bool:
        """Tell whether files have any of the lines that the program wrote, or lack its cuts."""
        if self.origin is not None:
            return files != self.original
        before, after, now = (
            Counter(_joined(each, b"\n").split(b"\n"))
            for each in (self.original, self.written, files)
        )
        added, cut = after - before, before - after
        if not added and not cut:
            return True
        return any(now[line] > before[line] for line in added if line.strip()) or any(
            now[line] < before[line] for line in cut if line.strip()
        )


Layers = tuple[Layer, ...]


def digest(text: bytes) -> str:
    """Return the digest of a file's text, as the manifest keeps it."""
    return f"sha256:{sha256(text).hexdigest()}"


def digest_of(files: FileSet) -> str:
    """Return the digest of files: of one file that of its text, whatever it is called."""
    if len(files.texts) == 1:
        return digest(files.main)
    return digest("\n".join(f"{digest(text)} {name}" for name, text in files.texts).encode())


def _joined(files: FileSet, between: bytes = b"") -> bytes:
    return between.join(text for _, text in files.texts)


class Author(NamedTuple):
    """A program: the name of its file ("" where it has none), its text's digest, its folder."""

    name: str
    text: str
    folder: Path

    def place(self, layers: Layers) -> int | None:
        """Return the place of the program's own layer, None where it has none.

        A program that has another name than before is known by its text.
        """
        if not self.name:
            return None
        own = [i for i, layer in enumerate(layers) if layer.program == self.name]
        own += [i for i, layer in enumerate(layers) if self._is_renamed(layer)]
        return own[0] if own else None

    def _is_renamed(self, layer: Layer) -> bool:
        return layer.text == self.text and not (self.folder / layer.program).exists()


def live_layers(
    layers: Layers, files: FileSet | None, shows: Callable[[Layer, FileSet], bool]
) -> Layers:
    """Return the layers that files still show.

    Files that show nothing of a program's work were put back to what they were, by version
    control perhaps, or are others: what they hold is an original again. What is remembered of
    files that the main one does not lead to counts for nothing.

    Args:
        layers: what is remembered.
        files: what there is, None for nothing.
        shows: tells whether files have any endpoint as the program left it, not as it found it.
    """
    if files is None:
        return ()
    if not all(layer.is_of(files) for layer in layers):
        return ()
    if layers and (layers[-1].written == files or layers[-1].left == digest_of(files)):
        return layers
    for index, layer in enumerate(layers):
        if not layer.shows_in(files) and not shows(layer, files):
            return layers[:index]
    return layers


def are_untouched(layers: Layers, files: FileSet | None) -> bool:
    """Tell whether nothing was changed by hand since the first of some programs wrote files.

    Handwork between two programs is in what the second found, and the last one's text has it.

    Args:
        layers: what the programs made of them, one after the other.
        files: what there is.
    """
    found = (*(layer.original for layer in layers[1:]), files)
    return all(layer.written == after for layer, after in zip(layers, found, strict=True))


def layer_json(layer: Layer, name: str) -> dict[str, Any]:
    """Return a layer as the manifest keeps it; its texts are much alike, and packed as one.

    Of one file each, which both are called as the file that the layer is of, the size of the
    first is enough.
    """
    texts = zlib.compress(_joined(layer.original) + _joined(layer.written), 9)
    sets = (layer.original, layer.written)
    usual = (_main_name(name),)
    is_usual = all(files.names == usual for files in sets)
    sizes = [[[each, len(text)] for each, text in files.texts] for files in sets]
    data = {
        "program": layer.program,
        "text": layer.text,
        "left": layer.left,
        "origin": layer.origin,
        "seen": layer.seen,
        "clean": layer.is_clean,
        "base": layer.base,
        "size": len(layer.original.main) if is_usual else None,
        "sizes": None if is_usual else sizes,
        "texts": base64.b64encode(texts).decode("ascii"),
    }
    return {key: value for key, value in data.items() if value is not None}


def read_layer(data: object, name: str, most: int = LARGEST_TEXTS) -> Layer | None:
    """Return the layer that JSON tells of, None when it is broken, or has too much of a text.

    Args:
        data: what the manifest has.
        name: the file that the layer is of.
        most: the most bytes that its texts may have, where that is less than `LARGEST_TEXTS`.
    """
    if not isinstance(data, dict):
        return None
    try:
        packed = base64.b64decode(data["texts"], validate=True)
        unpacker = zlib.decompressobj()
        # It takes 0 for no limit.
        texts = unpacker.decompress(packed, max(1, min(most, LARGEST_TEXTS)))
    except (KeyError, TypeError, ValueError, binascii.Error, zlib.error):
        return None
    base, program, origin, seen = (data.get(key) for key in ("base", "program", "origin", "seen"))
    if not (isinstance(base, dict) and isinstance(program, str) and unpacker.eof):
        return None
    if not (isinstance(origin, str | None) and isinstance(seen, str | None)):
        return None
    clean, text, left = data.get("clean") is True, data.get("text", ""), data.get("left", "")
    sets = _cut(texts, data, name)
    if sets is None:
        return None
    return Layer(program, *sets, base, origin, seen, clean, str(text), str(left))


def _cut(texts: bytes, data: Mapping[str, Any], name: str) -> tuple[FileSet, FileSet] | None:
    """Return the two sets of files of a layer, None where their sizes are broken."""
    size, usual = data.get("size"), _main_name(name)
    if isinstance(size, int) and 0 <= size <= len(texts):
        return FileSet(((usual, texts[:size]),)), FileSet(((usual, texts[size:]),))
    sets, start = [], 0
    try:
        for listed in data["sizes"]:
            found = []
            for each, length in listed:
                if not isinstance(length, int) or length < 0 or not _is_within(each):
                    return None
                found.append((each, texts[start : start + length]))
                start += length
            sets.append(FileSet(tuple(found)))
        original, written = sets
    except (KeyError, TypeError, ValueError):
        return None
    is_whole = start == len(texts) and original.texts and written.texts
    return (original, written) if is_whole else None


_MOST_ABOVE = 4
"""How far above its source a header may lie."""


def _is_within(name: str) -> bool:
    """Tell whether a name may be that of a file of a set: a manifest may be anybody's.

    It leads to none that the main file does not lead to as well: see `live_layers`.
    """
    path = PurePosixPath(name)
    above = 0
    while above < len(path.parts) and path.parts[above] == "..":
        above += 1
    inner = path.parts[above:]
    return bool(inner) and not path.is_absolute() and ".." not in inner and above <= _MOST_ABOVE


def _main_name(name: str) -> str:
    """Return what a file is called in the set that it is the main file of."""
    return FileSet.single(PurePath(name).suffix, b"").names[0]
