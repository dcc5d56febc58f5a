"""Reading and changing the CMakeLists.txt of a package, whoever wrote it; nothing of it is run."""
