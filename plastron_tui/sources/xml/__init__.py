"""XML files that exist: package.xml, launch files, plugin descriptions, robots.

A file is read twice, and both have to agree. Expat, which the tools of ROS read these files with,
says whether the text is well-formed and what it means; tree-sitter-xml says where each tag and
each attribute stands. Nothing is loaded from elsewhere, and no entity is expanded.
"""
