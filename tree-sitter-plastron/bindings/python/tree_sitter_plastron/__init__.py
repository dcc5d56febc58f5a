"""The Plastron grammar for tree-sitter, and its queries."""

from pathlib import Path

from ._binding import language

__all__ = [
    "FOLDS_QUERY",
    "HIGHLIGHTS_QUERY",
    "INDENTS_QUERY",
    "INJECTIONS_QUERY",
    "LOCALS_QUERY",
    "TAGS_QUERY",
    "language",
]

_QUERIES = {
    "FOLDS_QUERY": "folds.scm",
    "HIGHLIGHTS_QUERY": "highlights.scm",
    "INDENTS_QUERY": "indents.scm",
    "INJECTIONS_QUERY": "injections.scm",
    "LOCALS_QUERY": "locals.scm",
    "TAGS_QUERY": "tags.scm",
}


def __getattr__(name: str) -> str:
    """Read a query when it is first asked for."""
    if name not in _QUERIES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    # Beside a compiled module, so never in an archive; `importlib.resources` is slow to import.
    text = Path(__file__).with_name("queries").joinpath(_QUERIES[name]).read_text("utf-8")
    globals()[name] = text
    return text
