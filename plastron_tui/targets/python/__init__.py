"""Reading and editing Python nodes, whoever wrote them and however."""

from .reader import read_python

__all__ = ["read_python"]
