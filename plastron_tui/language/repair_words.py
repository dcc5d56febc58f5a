"""Words that are surely written for others of the language, and those that say nothing."""

from __future__ import annotations

from .undoing import UNDOING_PARTS, is_undoing

_SYNONYMS = {
    "subscribe": ("listen", "listens", "receive", "receives", "hear", "hears", "subscriber"),
    "publish": ("send", "sends", "emit", "emits", "publisher"),
    "client_requests": ("call", "calls", "ask", "asks", "client", "query", "queries"),
    "provides_service": ("serve", "serves", "offer", "offers", "answer", "answers", "server"),
    "repeats": ("call", "calls", "runs", "timer", "does", "loop", "loops"),
    "load": ("import",),
    "renames": ("remap", "remaps"),
    "described_as": ("description", "describes", "describe", "described", "documented_as"),
    "calling": ("callback", "call", "calls"),
    "using": ("library",),
    "hz": ("hertz",),
}
"""What others write for words of the language."""

_SAME_PARTS = {
    "mak": "creat", "new": "creat", "writ": "generat", "msg": "messag", "param": "parameter",
    "offer": "provid", "serv": "provid", "weight": "weigh", "srv": "servic",
}  # fmt: skip
"""Parts of words, as `_stem` leaves them, and the parts that the language has for them."""

_LEAST_STEM = 2
"""Letters that a word has besides its ending, at least one more than that."""

FILLERS = frozenset({"a", "an", "the", "please", "named", "called"})
"""Words that say nothing, and that a sentence has no place for."""

QOS_WORDS = frozenset(
    {"sensor_data", "system_default", "latched", "reliable", "best_effort", "volatile"}
    | {"transient_local", "keep_all", "depth", "deadline", "lifespan", "automatic"}
    | {"manual_by_topic", "lease"}
)
"""The words of quality of service."""

NOUNS = frozenset({"topic", "node", "service", "action", "parameter", "message", "type"})
"""Words that say what the name in quotes behind them is."""

DIRECTIONS = frozenset({"from", "to"})

_WRITTEN_FOR = {
    "of": {"with", "as", "of"},
    "as": {"to", "is", "="},
    "at": {"with"},
    "using": {"with", "in", "by"},
    "for_each": {"on", "for", "per"},
    "when": {"where", "if", "while"},
    "and input": {"with", "and", "values", "data", "input"},
    "with input": {"with", "and", "values", "data", "input"},
    "with default": {"with", "and", "=", "default", "initially"},
    "default": {"=", "initially"},
    "input": {"values", "data"},
    "between": {"from"},
    "from": {"between"},
    "and": {"to", ","},
    "with": {"of"},
    "with qos": {"with", "qos"},
    "qos": set[str](),
    "in": {"of", "to"},
    "in request": {"of", "to"},
    "returning": {"return", "returns", "returned", "gives", "answering"},
    "answering": {"reply", "respond", "returning", "return", "answer"},
}
"""What is written for words of a sentence, whatever statement they are of."""

_TYPES = frozenset({"type", "message_type", "service_type", "action_type", "parameter_type"})

_INTO = {
    "publish": {"on", "at"},
    "subscribe": {"on", "at", "from"},
    "stop_publishing": {"on", "from"},
    "renames": {"as", "into"},
    "has_joint": {"and"},
    "sends_goal": {"on"},
}
"""What is written for `to`, by the keyword of the statement: it may turn none round."""


def is_written_for(text: str, phrase: str, keyword: str) -> bool:
    """Tell whether a word may stand for words of the sentence of a statement."""
    text = text.lower()
    if phrase == "to":
        return text in _INTO.get(keyword, ())
    if phrase == "from" and keyword in ("unsubscribe", "has_joint"):
        return text == ("to" if keyword == "unsubscribe" else "between")
    if phrase in _TYPES:
        return text in _TYPES
    found = _WRITTEN_FOR.get(phrase, ())
    if phrase.startswith(("of ", "using ", "for_each ", "between ")):
        found = _WRITTEN_FOR[phrase.split(" ")[0]]
    return text in found or is_like(text, phrase)


def is_like(text: str, word: str) -> bool:
    """Tell whether a word may stand for one of the language: a synonym, or parts of it."""
    text = text.lower()
    if text in _SYNONYMS.get(word, ()):
        return True
    if is_undoing(text) != is_undoing(word):
        return False
    told, parts = (
        {_SAME_PARTS.get(each, each) for each in map(_stem, _telling(name))}
        for name in (text, word)
    )
    return bool(told) and told <= parts


def _telling(word: str) -> set[str]:
    """Return the parts of a word; of what takes back, those that tell what is taken back."""
    parts = set(word.split("_"))
    return parts - UNDOING_PARTS - {"has"} if is_undoing(word) else parts - {"has", "to"}


def _stem(word: str) -> str:
    """Return a word without the ending that it has in `publishes` and `listening`."""
    for ending in ("ing", "s", "e"):
        if word.endswith(ending) and len(word) > len(ending) + _LEAST_STEM:
            word = word.removesuffix(ending)
    return word
