"""Launch files that exist: read, and changed in place where they are XML."""
