"""The main screen: what it is composed of."""
