"""What is said about the word at a place of a program."""

from .card_at import card_at
from .known import Known

__all__ = ["Known", "card_at"]
