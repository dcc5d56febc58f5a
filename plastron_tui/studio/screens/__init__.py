"""The screens in front of the main one: those that ask and tell."""
