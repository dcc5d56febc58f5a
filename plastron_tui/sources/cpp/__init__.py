"""C++: node files are read with the headers of their package."""
