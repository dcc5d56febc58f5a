"""The screens of the studio: the main one, and those that ask and tell."""
