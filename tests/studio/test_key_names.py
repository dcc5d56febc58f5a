"""Keys as people write them, which of them come from a terminal, and who has them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.studio.actions import ACTIONS, BY_ID, key_owners
from plastron_tui.studio.config_reader import read_config
from plastron_tui.studio.key_display import key_name
from plastron_tui.studio.key_names import Arrival, another_key, arrival, read_key, read_keys

OWNERS = key_owners()


@pytest.mark.parametrize(
    ("written", "key"),
    [
        *[(each, "ctrl+k") for each in ("ctrl+k", "Ctrl-K", "^K", "^k", "C-k", "<C-k>")],
        *[(each, "alt+x") for each in ("alt+x", "Alt-X", "M-x", "meta+x", "Option+x", "<A-x>")],
        ("F5", "f5"), ("Shift+F5", "shift+f5"), ("S-Tab", "shift+tab"), ("shift+k", "K"),
        ("K", "K"), ("k", "k"), ("Page Up", "pageup"), ("PgDn", "pagedown"), ("Esc", "escape"),
        ("Return", "enter"), ("alt+-", "alt+minus"), ("alt++", "alt+plus"), ("?", "question_mark"),
        ("ctrl+,", "ctrl+comma"),
        ("shift+ctrl+z", "ctrl+shift+z"),
        ("cmd+s", "super+s"), ("^[", "ctrl+left_square_bracket"), ("/", "slash"), ("-", "minus"),
        ("alt+question_mark", "alt+question_mark"), ("ctrl+", None), ("", None), ("foo", None),
        ("ctrl+x ctrl+s", None), ("\x1b", None), ("hyperspace", None),
    ],
)  # fmt: skip
def test_a_key_is_read_as_people_write_it(written: str, key: str | None) -> None:
    assert read_key(written) == key


def test_several_keys_are_read_and_what_is_none_has_a_hint() -> None:
    assert read_keys(["F5, alt+r", "ctrl+,"]).keys == ("f5", "alt+r", "ctrl+comma")
    assert read_keys(["ctrl+,,f5"]).keys == ("ctrl+comma", "f5")
    assert read_keys(["ctrl++,f5"]).keys == ("ctrl+plus", "f5")
    assert read_keys(["ctrl+/"]).keys == ("ctrl+slash", "ctrl+underscore")
    assert read_keys(["ctrl+@"]).keys == ("ctrl+space", "ctrl+@")
    assert read_keys(["escap,f5"]) == (("f5",), ("no key `escap`; did you mean `escape`?",))


@given(st.text(max_size=12))
def test_what_is_read_as_a_key_is_read_again_as_the_same(text: str) -> None:
    key = read_key(text)
    assert key is None or read_key(key) == key


def test_a_key_is_read_as_messages_and_footer_write_it() -> None:
    keys = {key for owner in OWNERS for key in owner.keys if not key.startswith("f1")}
    for key in keys:
        assert key in read_keys([key_name(key)]).keys, key


def test_all_keys_of_the_studio_can_be_written_and_come_through() -> None:
    for action in ACTIONS:
        keys = action.keys.split(",")
        assert [read_key(key) for key in keys] == keys, action.id
        assert Arrival.ALWAYS in map(arrival, keys), action.id
    # What the menu and the help show for an action, and the template offers, is one of them.
    assert another_key("ctrl+shift+k", ()) == "alt+k"
    assert another_key("ctrl+1", [f"alt+{letter}" for letter in "acde"]) == "alt+g"


@pytest.mark.parametrize(
    ("yaml", "keys", "said"),
    [
        ("generate: Ctrl-B", {"generate": "ctrl+b"}, []),
        ("generate: ^B\n  run: [F11, alt+x]", {"generate": "ctrl+b", "run": "f11,alt+x"}, []),
        ("run: alt+r", {"run": "alt+r", "run_anew": ""},
         ["line 2: `Alt-R` was the key of `run_anew`, which has no key now"]),
        ("run: alt+a", {"run": "alt+a", "names": ""},
         ["line 2: `Alt-A` was the key of `names`, which has no key now"]),
        ("find.regex: alt+x", {"find.regex": "alt+x"}, []),
        ("find.regex: alt+c", {"find.regex": "alt+c", "find.case": "f7"},
         ["line 2: `Alt-C` is the key of `code` too, which it is not in the line that finds",
          "line 2: `Alt-C` was the key of `find.case`, which has `F7` left"]),
        ("find.next: n", {}, ["line 2: `n` writes into the text; `Alt-X` comes"]),
        ("run: f6\n  generate: f5", {"run": "f6", "generate": "f5"}, []),
        ("generate: f11\n  run: f11", {"generate": "f11"},
         ["line 3: `F11` is the key of `generate` in line 2 already"]),
        ("generate: f5", {"generate": "f5", "run": ""},
         ["line 2: `F5` was the key of `run`, which has no key now"]),
        ("zoom: alt+w", {"zoom": "alt+w", "wizard": "ctrl+u"},
         ["line 2: `Alt-W` was the key of `wizard`, which has `Ctrl-U` left"]),
        ("generate: ctrl+k", {"generate": "ctrl+k"},
         ["line 2: `Ctrl-K` stays the key of `editor.delete_line` in the editor"]),
        ("editor.find: f6", {"editor.find": "f6"},
         ["line 2: `F6` is the key of `generate` too, which it is not in the editor"]),
        ("editor.find: alt+x\n  generate: ctrl+f", {"editor.find": "alt+x", "generate": "ctrl+f"},
         []),
        ("graph.size: v", {"graph.size": "v"}, []),
        ("graph.size: k", {"graph.size": "k", "panel.up": "up"},
         ["line 2: `k` was the key of `panel.up`, which has `↑` left"]),
        ("robots.view: d", {"robots.view": "d"}, []),
        ("generate: x", {}, ["line 2: `x` writes into the text; `Alt-X` comes through"]),
        ("generate: ctrl+i", {}, ["line 2: `Ctrl-I` reaches the studio as Tab;"]),
        ("generate: ctrl+m", {}, ["line 2: `Ctrl-M` reaches the studio as Enter;"]),
        ("generate: Ctrl-H", {}, ["line 2: `Ctrl-H` reaches the studio as Backspace;"]),
        ("generate: ctrl+1", {"generate": "ctrl+1"}, ["line 2: no terminal sends `Ctrl-1`;"]),
        ("generate: cmd+g", {"generate": "super+g"}, ["line 2: no terminal sends `Super-G`;"]),
        ("generate: ctrl+shift+b", {"generate": "ctrl+shift+b"},
         ["line 2: few terminals send `Ctrl-Shift-B`; `Ctrl-B` comes through"]),
        ("generate: [ctrl+shift+b, f11]", {"generate": "ctrl+shift+b,f11"}, []),
        ("generate: escap", {}, ["line 2: no key `escap`; did you mean `escape`?"]),
        ("generat: f11", {}, ["line 2: no action `generat`; did you mean `generate`?"]),
        ("generate:", {}, ["line 2: the key of `generate` is no key"]),
        ("generate: {a: b}", {}, ["line 2: the key of `generate` is no key"]),
        ("generate: f9\n  generate: f11", {"generate": "f11"},
         ["line 2: `generate` comes again in line 3, which counts"]),
    ],
)  # fmt: skip
def test_conflicts_and_impossible_keys_are_said(
    yaml: str, keys: dict[str, str], said: list[str]
) -> None:
    config, problems = read_config(f"keys:\n  {yaml}\n".encode(), OWNERS, ())
    assert config.keys == keys
    found = [f"line {each.line}: {each.words}" for each in problems]
    assert len(found) == len(said)
    for line, wanted in zip(found, said, strict=True):
        assert line.startswith(wanted)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (b"run: f11\n", "`run` is an action: its key stands indented below `keys:`"),
        (b"theme: nrod\n", "no theme `nrod`; did you mean `nord`?"),
        (b"\n\nwarp: true\n", "no setting `warp`; did you mean `wrap`?"),
        (b"- 1\n", "this is not a mapping of settings"),
        (b"mouse: !!bool foo\n", "`mouse` has a value that it cannot have"),
        (b"mouse: !!int ''\n", "`mouse` has a value that it cannot have"),
        (b"keys: &k\n  run: *k\n", "the key of `run` is no key"),
        (b"? [a, b]\n: 1\n", "no setting `?`"),
        (b"\xff\xfe", "this is not UTF-8 text"),
        (b"[" * 1500, "this is not YAML"),
        (b"a: \x00", "this is not YAML"),
        (b"a: b: c", "this is not YAML"),
        (b"keys: {run: !!timestamp soon}\n", "no key `soon` (for `run`)"),
    ],
)
def test_no_yaml_is_too_strange(text: bytes, said: str) -> None:
    config, problems = read_config(text, OWNERS, ["nord"])
    assert config.keys == {}
    assert [each.words for each in problems] == [said]


@given(
    st.dictionaries(
        st.sampled_from([owner.id for owner in OWNERS if owner.id]),
        st.sampled_from(
            [
                "f5",
                "f6",
                "f11",
                "ctrl+k",
                "alt+w",
                "up",
                "k",
                "enter",
                "ctrl+shift+z",
                "ctrl+p",
                "x",
            ]
        ),
        max_size=6,
    )
)
def test_no_key_is_left_to_two_in_one_place(wanted: dict[str, str]) -> None:
    lines = "".join(f"  {action}: {key}\n" for action, key in wanted.items())
    keys = read_config(f"keys:\n{lines}".encode(), OWNERS, ())[0].keys
    owned: dict[tuple[str, str], set[str]] = {}
    for owner in OWNERS:
        for key in keys.get(owner.id, ",".join(owner.keys)).split(","):
            if owner.id and key:
                for place in owner.places:
                    owned.setdefault((place, key), set()).add(owner.id)
    changed = set(keys)
    clashes = {at: ids for at, ids in owned.items() if len(ids) > 1 and ids & changed}
    assert clashes == {}
    assert BY_ID["run"].keys == "f5"
