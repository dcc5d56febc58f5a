"""What programs made of a file that they loaded: layers, one a program, the first at the bottom.

A program that loads what it wrote itself shall start from what it started from before, and not
from its own changes. So each layer keeps two texts: what the program found, and what it made of
it. What a file differs from the upper layer's is handwork.
"""

from __future__ import annotations

import base64
import binascii
import zlib
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple

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
        original: the text that it started from.
        written: the text that it made of it, without handwork.
        base: what the node had in the end, as `remembered` gives it.
        origin: the file that the original is of, from the folder of the manifest; None where it
            is the written file itself.
        seen: the digest of that file when it was read.
        is_clean: whether the original had no handwork when the layer was laid over it.
        text: the digest of the program's text.
        left: the digest of the file as the program left it, with handwork.
    """

    program: str
    original: bytes
    written: bytes
    base: Mapping[str, Any] = field(default_factory=dict)
    origin: str | None = None
    seen: str | None = None
    is_clean: bool = False
    text: str = ""
    left: str = ""

    @property
    def size(self) -> int:
        """The size of its texts, in bytes."""
        return len(self.original) + len(self.written)

    def shows_in(self, text: bytes) -> bool:
        """Tell whether a text has any of the lines that the program wrote, or lacks its cuts."""
        if self.origin is not None:
            return text != self.original
        before, after, now = (
            Counter(each.split(b"\n")) for each in (self.original, self.written, text)
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
    layers: Layers, text: bytes | None, shows: Callable[[Layer, bytes], bool]
) -> Layers:
    """Return the layers that a file still shows.

    A file that shows nothing of a program's work was put back to what it was, by version control
    perhaps, or is another: what it holds is an original again.

    Args:
        layers: what is remembered.
        text: what the file holds, None where there is none.
        shows: tells whether a text has any endpoint as the program left it, not as it found it.
    """
    if text is None:
        return ()
    if layers and (layers[-1].written == text or layers[-1].left == digest(text)):
        return layers
    for index, layer in enumerate(layers):
        if not layer.shows_in(text) and not shows(layer, text):
            return layers[:index]
    return layers


def are_untouched(layers: Layers, text: bytes | None) -> bool:
    """Tell whether nothing was changed by hand since the first of some programs wrote a file.

    Handwork between two programs is in what the second found, and the last one's text has it.

    Args:
        layers: what the programs made of it, one after the other.
        text: what the file holds.
    """
    found = (*(layer.original for layer in layers[1:]), text)
    return all(layer.written == after for layer, after in zip(layers, found, strict=True))


def layer_json(layer: Layer) -> dict[str, Any]:
    """Return a layer as the manifest keeps it; its two texts are much alike, and packed as one."""
    texts = zlib.compress(layer.original + layer.written, 9)
    data = {
        "program": layer.program,
        "text": layer.text,
        "left": layer.left,
        "origin": layer.origin,
        "seen": layer.seen,
        "clean": layer.is_clean,
        "base": layer.base,
        "size": len(layer.original),
        "texts": base64.b64encode(texts).decode("ascii"),
    }
    return {key: value for key, value in data.items() if value is not None}


def read_layer(data: object, most: int = LARGEST_TEXTS) -> Layer | None:
    """Return the layer that JSON tells of, None when it is broken, or has too much of a text.

    Args:
        data: what the manifest has.
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
    size, base, program = data.get("size"), data.get("base"), data.get("program")
    origin, seen = data.get("origin"), data.get("seen")
    if not (isinstance(size, int) and isinstance(base, dict) and isinstance(program, str)):
        return None
    is_named = isinstance(origin, str | None) and isinstance(seen, str | None)
    if not unpacker.eof or not 0 <= size <= len(texts) or not is_named:
        return None
    clean, text, left = data.get("clean") is True, data.get("text", ""), data.get("left", "")
    original, written = texts[:size], texts[size:]
    return Layer(program, original, written, base, origin, seen, clean, str(text), str(left))
