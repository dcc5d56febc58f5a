"""The memory of an output folder: which files Plastron wrote, and what it wrote.

A file whose text differs from what the manifest remembers was changed by hand. The manifest
is a small JSON file in the folder itself, so that it moves with the files that it speaks of.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Severity

NAME = ".plastron.json"
"""The manifest's file name, in the output folder."""

VERSION = 1
_GENERATOR = "plastron"
_DIGEST = re.compile(r"sha256:[0-9a-f]{64}")


@dataclass(frozen=True, slots=True)
class Manifest:
    """The digest of each file that Plastron wrote into a folder, by file name.

    `is_foreign` says that the folder has a file of the manifest's name that is none: it counts
    as empty, and whoever replaces it keeps a backup.
    """

    digests: Mapping[str, str] = field(default_factory=dict)
    is_foreign: bool = False

    def has(self, name: str, text: bytes) -> bool:
        """Tell whether Plastron wrote exactly this text under this name."""
        return self.digests.get(name) == digest(text)

    def updated(self, entries: Mapping[str, str], present: Collection[str]) -> Manifest:
        """Return the manifest with new entries, without those of files that are gone.

        Args:
            entries: digests by file name.
            present: the names of the files that are in the folder now.
        """
        kept = {name: value for name, value in self.digests.items() if name in present}
        return Manifest({**kept, **entries})


def digest(text: bytes) -> str:
    """Return the digest of a file's text, as the manifest keeps it."""
    return f"sha256:{sha256(text).hexdigest()}"


def load_manifest(folder: Path) -> tuple[Manifest, tuple[Diagnostic, ...]]:
    """Read a folder's manifest; one that is missing is empty, one that is broken too.

    A broken manifest, one of a later version, and another program's file of that name each give
    the warning `bad-manifest`: every file that is in the way then counts as written by hand.
    """
    path = folder / NAME
    try:
        text = path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        return Manifest(), ()
    except OSError as error:
        return _foreign(path, (error.strerror or "cannot be read").lower())
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        return _foreign(path, "not JSON")
    if not isinstance(data, dict) or data.get("generator") != _GENERATOR:
        return _foreign(path, "not written by plastron")
    if data.get("version") != VERSION:
        return _foreign(path, f"its version is not {VERSION}")
    files = data.get("files")
    if not isinstance(files, dict) or not all(
        isinstance(value, str) and _DIGEST.fullmatch(value) for value in files.values()
    ):
        return _foreign(path, "its list of files is broken")
    return Manifest(files), ()


def manifest_text(manifest: Manifest) -> bytes:
    """Return the manifest as its file's text: sorted, a file a line, kind to version control."""
    data = {
        "generator": _GENERATOR,
        "version": VERSION,
        "files": dict(sorted(manifest.digests.items())),
    }
    return (json.dumps(data, indent=2) + "\n").encode()


def _foreign(path: Path, why: str) -> tuple[Manifest, tuple[Diagnostic, ...]]:
    warning = Diagnostic(
        "bad-manifest",
        f"`{NAME}` is no manifest: {why}",
        file=path,
        help="files that are in the way count as written by hand until the next generate",
        severity=Severity.WARNING,
    )
    return Manifest(is_foreign=True), (warning,)
