"""XML files that a program loads: packages, launch files, plugins. No program shows these."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code

BROKEN_XML = Code(
    "broken-xml",
    "An XML file is not well-formed: a tag is not closed, or closed by another name, an attribute "
    "has no quotes, or stands there twice. No tool of ROS can read it. Correct it first.",
)

UNSUPPORTED_XML = Code(
    "unsupported-xml",
    "An XML file is well-formed, and has what Plastron does not read: a document type with "
    "declarations of its own, an encoding other than UTF-8, or more elements within each other "
    "than a person writes. Write it without.",
)

BROKEN_PACKAGE = Code(
    "broken-package",
    "A package.xml says what the build tools refuse (REP 127, 140 and 149): a name, version or "
    "mail address that is none, a tag or an attribute that its format does not have, a dependency "
    "on itself; as a warning, what they take and complain of. Correct it first.",
)

BROKEN_PLUGINS = Code(
    "broken-plugins",
    "A plugin description is none, or has a library without a path, or a class without its type or "
    "that of its base class: pluginlib cannot load it. As a warning, two classes of one name.",
)
