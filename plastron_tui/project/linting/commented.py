"""Which files have comments that name rules, as an earlier run has seen them where it may."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from pathlib import Path

from plastron_tui.lint.comment_syntax import style_of
from plastron_tui.lint.suppression import may_name_rules
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.regular_files import read_regular

from .cache import FactCache, packed
from .fingerprints import Reads, digest_of_names, noted


def commented_files(
    files: Iterable[str], package_of: Callable[[str], str], cache: FactCache
) -> Iterator[str]:
    """Yield the files that may have comments which name rules.

    What was seen is remembered by package, so that a change has one package looked at again.

    Args:
        files: all files.
        package_of: returns the folder of the package that a file is in, "" for none.
        cache: what was read before.
    """
    by_package: dict[str, list[str]] = defaultdict(list)
    for path in files:
        name = Path(path)
        if not name.suffix or style_of(name) is not None:
            by_package[package_of(path)].append(path)
    for folder, paths in by_package.items():
        key = f"comments {folder} {digest_of_names(iter(paths)).hex()}"
        known = cache.get(key)
        if known is not None:
            yield from known[0]
            continue
        reads = Reads({}, {})
        with noted(reads):
            found = tuple(path for path in paths if _names_rules(path))
        cache.put(key, reads, packed(found))
        yield from found


def _names_rules(path: str) -> bool:
    with suppress(OSError, ValueError):
        text = read_regular(path, LARGEST_FILE)
        return may_name_rules(text) and style_of(Path(path), text) is not None
    return False
