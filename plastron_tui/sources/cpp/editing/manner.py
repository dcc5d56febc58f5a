"""How a unit names what its endpoints are held by and what they call."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace

from plastron_tui.model.source import EndpointKind
from plastron_tui.model.unique_names import numbered

from ..analysis import Analysis, Site
from ..keywords import is_taken
from ..scopes import Variable
from .creation import creation_of

K = EndpointKind

_HELD = {
    K.PUBLISHER: ("pub", "publisher"),
    K.SUBSCRIPTION: ("sub", "subscriber", "subscription"),
    K.SERVICE: ("server", "service", "srv", "ser"),
    K.CLIENT: ("client", "cli"),
    K.TIMER: ("timer",),
    K.ACTION_SERVER: ("server", "action", "as"),
    K.ACTION_CLIENT: ("client", "action", "ac"),
    K.PARAMETER: ("",),
}
_CALLED = ("callback", "cb", "on", "handle", "handler", "process", "call", "back", "srv", "service")
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z0-9]+|[A-Z]")
_IDENTIFIER = re.compile(rb"[A-Za-z_]\w*")


@dataclass(frozen=True, slots=True)
class Naming:
    """How names are made.

    Attributes:
        casing: `snake`, `camel` or `pascal`.
        before: the word before what is named, "" for none.
        behind: the word behind it.
        start: what a name begins with: `m_`.
        end: what it ends with: `_`.
    """

    casing: str = "snake"
    before: str = ""
    behind: str = ""
    start: str = ""
    end: str = ""

    @property
    def bare(self) -> Naming:
        """The names of what no word stands for: in the same manner, without one."""
        return replace(self, before="", behind="")

    def name(self, words: str) -> str:
        """Return the name of something that small words say."""
        parts = [each for each in (self.before, *words.split("_"), self.behind) if each]
        if len(parts) > 1 and parts[-1] == parts[-2]:
            parts.pop()
        if self.casing == "snake":
            text = "_".join(parts)
        else:
            text = "".join(each[:1].upper() + each[1:] for each in parts)
            if self.casing == "camel":
                text = text[:1].lower() + text[1:]
        return f"{self.start}{text}{self.end}"


def identifiers(analysis: Analysis) -> set[str]:
    """Return all names that the files of a unit have."""
    found: set[str] = set()
    for file in analysis.unit.files:
        found.update(each.decode("ascii") for each in _IDENTIFIER.findall(file.syntax.text))
    return found


def free_name(taken: set[str], wanted: str, end: str = "") -> str:
    """Take a name that is free: the one wanted, or one with a number before its end."""
    core = wanted.removesuffix(end) if end else wanted
    name = next(
        f"{each}{end}"
        for each in numbered(core)
        if f"{each}{end}" not in taken and not is_taken(f"{each}{end}")
    )
    taken.add(name)
    return name


def held_by(analysis: Analysis, site: Site) -> Variable | None:
    """Return the variable that holds what a call creates."""
    made = creation_of(analysis, site)
    return made.variable if made is not None else None


def variable_naming(
    analysis: Analysis, kind: EndpointKind, sites: Iterable[Site], *, is_member: bool
) -> Naming:
    """Return how variables are named that hold endpoints of a kind."""
    held = [
        (site, variable)
        for site in sites
        if (variable := held_by(analysis, site)) is not None
        and (variable.kind == "member") == is_member
        and site.endpoint.kind is not K.PARAMETER
    ]
    like = [variable.name for site, variable in held if site.endpoint.kind is kind]
    names = [variable.name for _, variable in held] or _others(analysis, is_member=is_member)
    start, end = _decoration(names) if is_member else ("", "")
    casing = _casing([_core(each, start, end) for each in names])
    words = _HELD[kind]
    affixes = [_affix(_core(each, start, end), words) for each in like]
    known = Counter(each for each in affixes if each is not None)
    if known:
        before, behind = known.most_common(1)[0][0]
    else:
        before, behind = "", "" if like else words[0]
        if not like:
            others = Counter(
                each
                for site, variable in held
                if (each := _affix(_core(variable.name, start, end), _HELD[site.endpoint.kind]))
            )
            if others and others.most_common(1)[0][0][0]:
                before, behind = behind, ""
    if casing == "pascal":
        casing = "camel"
    return Naming(casing, before, behind, start, end)


def _others(analysis: Analysis, *, is_member: bool) -> list[str]:
    return [
        name
        for scope in analysis.unit.scopes()
        if (scope.kind == "class") == is_member and (is_member or scope.kind == "function")
        for name in scope.variables
    ]


def is_marked_global(analysis: Analysis) -> bool:
    """Tell whether the names of a unit's variables of files begin with `g_`."""
    names = [name for scope in analysis.unit.scopes() if scope.kind in ("file", "namespace")
             for name, found in scope.variables.items() if found[0].kind == "global"]  # fmt: skip
    return sum(each.startswith("g_") for each in names) * 2 > len(names)


def _decoration(names: list[str]) -> tuple[str, str]:
    if not names:
        return "", "_"
    found = Counter(
        (
            "m_" if each.startswith("m_") else "_" if each.startswith("_") else "",
            "_" if each.endswith("_") else "",
        )
        for each in names
    )
    return found.most_common(1)[0][0]


def _core(name: str, start: str, end: str) -> str:
    return name.removeprefix(start).removesuffix(end)


def _casing(names: list[str]) -> str:
    found: Counter[str] = Counter()
    for each in names:
        bare = each.strip("_")
        if "_" in bare:
            found["snake"] += 1
        elif re.search(r"[a-z0-9][A-Z]", bare):
            found["pascal" if bare[:1].isupper() else "camel"] += 1
        elif bare[:1].isupper() and len(bare) > 1 and not bare.isupper():
            found["pascal"] += 1
    return found.most_common(1)[0][0] if found else "snake"


def split_words(name: str) -> list[str]:
    """Return the words of a name of any casing, in small letters."""
    return [each.lower() for part in name.split("_") for each in _WORD.findall(part)]


def _affix(core: str, words: Iterable[str]) -> tuple[str, str] | None:
    """Return the word before or behind that says what a variable is, None where none does."""
    parts = split_words(core)
    known = [*words]
    if not parts:
        return None
    if parts[-1] in known:
        return "", parts[-1]
    if parts[0] in known:
        return (parts[0], "") if len(parts) > 1 else ("", parts[0])
    return None


def callback_naming(
    analysis: Analysis, kind: EndpointKind, called: Iterable[tuple[EndpointKind, str]]
) -> Naming:
    """Return how functions are named that endpoints of a kind call.

    Args:
        analysis: what is known of the files.
        kind: the kind.
        called: what the node's endpoints call, with the kind of each.
    """
    found = [*called]
    like = [name for each, name in found if each is kind] or [name for _, name in found]
    methods = [
        name
        for scope in analysis.unit.scopes()
        if scope.kind == "class"
        for name in scope.functions
        if name != scope.name and not name.startswith(("~", "operator"))
    ]
    usual = "snake" if analysis.ros_version == 2 else "camel"
    # What names of one word do not show, others do.
    plain, every = ([each.strip("_") for each in names] for names in (like, [x for _, x in found]))
    shown = next((each for each in (plain, every, methods) if _has_casing(each)), [])
    casing = _casing(shown) if shown else usual
    for names in (plain, every):
        affixes = Counter(each for name in names if (each := _called_affix(name)) is not None)
        if affixes:
            before, behind = affixes.most_common(1)[0][0]
            break
    else:
        before, behind = ("on", "") if casing == "snake" else ("", "callback")
    end = "_" if like and sum(each.endswith("_") for each in like) * 2 > len(like) else ""
    return Naming(casing, before, behind, "", end)


def _has_casing(names: list[str]) -> bool:
    return any("_" in each or re.search(r"[a-z][A-Z]|^[A-Z]", each) for each in names)


def _called_affix(name: str) -> tuple[str, str] | None:
    parts = split_words(name)
    if parts[-2:] == ["call", "back"]:
        return "", "callBack" if "_" not in name else "call_back"
    if len(parts) > 1 and parts[0] in ("on", "handle", "process", "cb"):
        return parts[0], ""
    if parts and parts[-1] in ("callback", "cb", "handler"):
        return "", parts[-1]
    if len(parts) > 1 and parts[0] == "callback":
        return parts[0], ""
    return None


def method_naming(analysis: Analysis, verb: str) -> Naming:
    """Return how a method is named that does something: `publish_chatter`."""
    names = [
        name
        for scope in analysis.unit.scopes()
        for name in scope.functions
        if scope.kind in ("class", "file", "namespace")
        and name != scope.name
        and not name.startswith(("~", "operator", "main"))
    ]
    own = {scope.name for scope in analysis.unit.scopes() if scope.kind == "class"}
    names = [each for each in names if each not in own]
    usual = "snake" if analysis.ros_version == 2 else "camel"
    return Naming(_casing(names) if _has_casing(names) else usual, verb)
