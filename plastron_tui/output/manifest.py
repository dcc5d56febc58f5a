"""The memory of an output folder: which files Plastron wrote, and what it wrote.

A file whose text differs from what the manifest remembers was changed by hand. What a program
had when a file was written is remembered too: a later program is merged into the handwork from
there. Of a file that a program loaded, the text is remembered that the program started from: see
`patch_stack`. The manifest is a small JSON file in the folder itself, so that it moves with the
files that it speaks of.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeAlias

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.regular_files import read_regular, reason

from .own_files import MANIFEST
from .patch_stack import MOST_LAYERS, MOST_TEXTS, Layers, layer_json, read_layer
from .patch_stack import digest as digest

NAME = MANIFEST
"""The manifest's file name, in the output folder."""

VERSION = 3
"""The version that is written. Version 1 had digests only, version 2 no layers; both are read."""

Base = Mapping[str, Any]
"""What a program had when a file was written, as JSON; see `node_json`."""

LARGEST_MANIFEST = 32 * 1024 * 1024
"""The largest manifest that is read, in bytes; a file's entry takes some hundred."""

MOST_PARTS = 2_000_000
"""The most objects and lists of a manifest: Python needs a hundred bytes for `[]`."""

_SUPERSEDED = "superseded_by"
_GENERATOR = "plastron"
_DIGEST = re.compile(r"sha256:[0-9a-f]{64}")


@dataclass(frozen=True, slots=True)
class Manifest:
    """What Plastron remembers of the files of a folder, by file name.

    Attributes:
        digests: the digest of the last text that was all Plastron's own. A text that keeps
            handwork is none, so that a file that never was without has no digest.
        bases: what the program had when the file was written, handwork or not. Files of an older
            version, and files that no created node became, have none.
        layers: what programs made of a file that they loaded.
        is_foreign: the folder has a file of the manifest's name that is none: it counts as
            empty, and whoever replaces it keeps a backup.
    """

    digests: Mapping[str, str] = field(default_factory=dict)
    bases: Mapping[str, Base] = field(default_factory=dict)
    layers: Mapping[str, Layers] = field(default_factory=dict)
    is_foreign: bool = False

    def __contains__(self, name: str) -> bool:
        """Tell whether Plastron made a file of this name, whatever is in it now."""
        return name in self.digests or name in self.bases

    def has(self, name: str, text: bytes) -> bool:
        """Tell whether Plastron wrote exactly this text under this name."""
        return self.digests.get(name) == digest(text)

    def successor(self, name: str) -> str | None:
        """Return the file that a node went to, when an older version gave its file another name."""
        found = self.bases.get(name, {}).get(_SUPERSEDED)
        return found if isinstance(found, str) else None

    def agrees(self, other: Manifest, names: Collection[str], program: object) -> bool:
        """Tell whether another manifest says the same of some files, and of a program's nodes.

        Args:
            other: the other manifest.
            names: the files.
            program: the name of the program's file, None where there is no program.
        """
        bases = {**self.bases, **other.bases}
        own = {
            name
            for name in bases
            if any(each.bases.get(name, {}).get("program") == program for each in (self, other))
        }
        return all(
            one.get(name) == two.get(name)
            for name in {*names, *(own if program is not None else ())}
            for one, two in (
                (self.digests, other.digests),
                (self.bases, other.bases),
                (self.layers, other.layers),
            )
        )

    def updated(
        self,
        entries: Mapping[str, str],
        present: Collection[str],
        bases: Mapping[str, Base] | None = None,
        layers: Mapping[str, Layers] | None = None,
    ) -> Manifest:
        """Return the manifest with new entries, without those of files that are gone.

        Args:
            entries: digests by file name.
            present: the names of the files that are in the folder now.
            bases: what the program has now, by file name.
            layers: what programs made of loaded files, by file name; none forgets what there was.
        """
        digests = {**self.digests, **entries}
        known = {**self.bases, **(bases or {})}
        return Manifest(
            {name: value for name, value in digests.items() if name in present},
            {name: base for name, base in known.items() if name in present},
            {
                name: each[-MOST_LAYERS:]
                for name, each in {**self.layers, **(layers or {})}.items()
                if name in present and each
            },
        )

    def is_up_to_date(
        self,
        entries: Mapping[str, str],
        bases: Mapping[str, Base],
        layers: Mapping[str, Layers],
    ) -> bool:
        """Tell whether `updated` would remember nothing new."""
        return (
            not self.is_foreign
            and entries.items() <= self.digests.items()
            and all(self.bases.get(name) == base for name, base in bases.items())
            and all(
                self.layers.get(name, ()) == each[-MOST_LAYERS:] for name, each in layers.items()
            )
        )


Reading: TypeAlias = tuple[Manifest, tuple[Diagnostic, ...]]
"""A folder's manifest, and what is wrong with it."""


def load_manifest(folder: Path) -> Reading:
    """Read a folder's manifest; one that is missing is empty, one that is broken too.

    A broken manifest, one of a later version, and another program's file of that name each give
    the warning `bad-manifest`: every file that is in the way then counts as written by hand.
    """
    path = folder / NAME
    try:
        text = read_regular(path, LARGEST_MANIFEST)
    except (FileNotFoundError, NotADirectoryError):
        return Manifest(), ()
    except OSError as error:
        return _foreign(path, reason(error))
    if text.count(b"{") + text.count(b"[") > MOST_PARTS:
        return _foreign(path, f"it has more than {MOST_PARTS} parts")
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        return _foreign(path, "not JSON")
    if not isinstance(data, dict) or data.get("generator") != _GENERATOR:
        return _foreign(path, "not written by plastron")
    if data.get("version") not in range(1, VERSION + 1):
        return _foreign(path, f"its version is not {VERSION}")
    manifest = _entries(data.get("files"), data["version"])
    return _foreign(path, "its list of files is broken") if manifest is None else (manifest, ())


def _entries(files: object, version: int) -> Manifest | None:
    """Return the entries of a manifest, None when one is broken."""
    if not isinstance(files, dict):
        return None
    if version == 1:
        files = {name: {"digest": value} for name, value in files.items()}
    digests: dict[str, str] = {}
    bases: dict[str, Base] = {}
    layers: dict[str, Layers] = {}
    left = MOST_TEXTS
    for name, entry in files.items():
        if not isinstance(entry, dict):
            return None
        value, base, data = entry.get("digest"), entry.get("base"), entry.get("layers")
        if isinstance(value, str) and _DIGEST.fullmatch(value):
            digests[name] = value
        elif value is not None or (base is None and data is None):
            return None
        if isinstance(base, dict):
            bases[name] = base
        elif base is not None:
            return None
        if data is not None:
            if not isinstance(data, list) or not data:
                return None
            known = []
            for each in data:
                layer = read_layer(each, name, left)
                if layer is None:
                    return None
                known.append(layer)
                left -= layer.size
            layers[name] = tuple(known)
    return Manifest(digests, bases, layers)


def manifest_text(manifest: Manifest) -> bytes:
    """Return the manifest as its file's text: sorted, a file a line, kind to version control."""
    entries = []
    for name in sorted({*manifest.digests, *manifest.bases, *manifest.layers}):
        entry: dict[str, Any] = {}
        if name in manifest.digests:
            entry["digest"] = manifest.digests[name]
        if name in manifest.bases:
            entry["base"] = manifest.bases[name]
        if name in manifest.layers:
            entry["layers"] = [layer_json(each, name) for each in manifest.layers[name]]
        entries.append(f"    {json.dumps(name)}: {json.dumps(entry)}")
    files = "{\n" + ",\n".join(entries) + "\n  }" if entries else "{}"
    text = f'{{\n  "generator": "{_GENERATOR}",\n  "version": {VERSION},\n  "files": {files}\n}}\n'
    return text.encode()


def _foreign(path: Path, why: str) -> Reading:
    warning = Diagnostic(
        codes.BAD_MANIFEST,
        f"`{NAME}` is no manifest: {why}",
        file=path,
        help="files that are in the way count as written by hand until the next generate",
    )
    return Manifest(is_foreign=True), (warning,)
