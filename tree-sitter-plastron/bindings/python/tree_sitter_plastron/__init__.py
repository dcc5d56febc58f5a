"""The Plastron grammar for tree-sitter, and its queries."""

from ._binding import language

__all__ = ["HIGHLIGHTS_QUERY", "LOCALS_QUERY", "TAGS_QUERY", "language"]

_QUERIES = {
    "HIGHLIGHTS_QUERY": "highlights.scm",
    "LOCALS_QUERY": "locals.scm",
    "TAGS_QUERY": "tags.scm",
}


def __getattr__(name: str) -> str:
    """Read a query when it is first asked for."""
    if name not in _QUERIES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib.resources import files  # slow to import, and needed for queries only

    text = files(__name__).joinpath("queries", _QUERIES[name]).read_text("utf-8")
    globals()[name] = text
    return text
