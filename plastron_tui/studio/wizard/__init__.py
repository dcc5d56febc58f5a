"""The wizard: a program built from menus and forms that follow from the declarations."""
