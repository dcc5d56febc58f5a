"""The studio in a browser: who may come in, and what serves it."""
