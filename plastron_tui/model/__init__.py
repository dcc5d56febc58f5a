"""The workspace that a program builds, and the interpreter that builds it."""
