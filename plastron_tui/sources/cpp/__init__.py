"""C++: reading node files."""
