"""Changing the files of C++ nodes by splices, all of a unit or none."""

from .editor import edit_cpp

__all__ = ["edit_cpp"]
