"""Launch files that are written anew."""
