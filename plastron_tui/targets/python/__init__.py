"""Reading and editing Python nodes, whoever wrote them and however."""

from .editor import edit_python
from .reader import read_python

__all__ = ["edit_python", "read_python"]
