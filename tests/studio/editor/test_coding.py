"""What the editor does for those who write programs."""

from __future__ import annotations

import tempfile
from contextlib import nullcontext
from pathlib import Path

import pytest
from editor_host import PROGRAM, editing

from plastron_tui.studio.editor.external_editor import NO_EDITOR, external_editor
from plastron_tui.studio.editor.program_commands import rename


class TestCoding:
    async def test_definition(self) -> None:
        async with editing(PROGRAM, cursor=PROGRAM.index("hello to")) as at:
            await at.press("f12")
            assert at.editor.cursor_offset == PROGRAM.index("hello of")
            await at.press("home", "f12")
            assert at.app.said == ["nothing under the cursor leads anywhere"]

    async def test_rename_everywhere_is_one_step(self) -> None:
        async with editing(PROGRAM, cursor=PROGRAM.index("talker publish")) as at:
            await at.press("f2", "m", "e", "enter")
            assert at.editor.text.decode() == PROGRAM.replace("as talker", "as me").replace(
                "talker publish", "me publish"
            )
            await at.press("ctrl+z")
            assert at.editor.text.decode() == PROGRAM

    @pytest.mark.parametrize(
        ("name", "reason"),
        [
            ("hello", "`hello` is a variable already"),
            ("to", "`to` is a keyword and cannot be a variable"),
            ("1a", "`1a` is no variable: it has letters, digits and `_`, a letter first"),
        ],
    )
    async def test_a_name_that_cannot_be_is_refused(self, name: str, reason: str) -> None:
        async with editing(PROGRAM, cursor=PROGRAM.index("talker publish")) as at:
            rename(at.editor, name)
            assert (at.app.said, at.editor.text.decode()) == ([reason], PROGRAM)

    async def test_format(self) -> None:
        async with editing("load   a  as b\n\n\n\ngenerate_node   b", cursor=24) as at:
            await at.press("ctrl+l")
            assert at.editor.text == b"load a as b\n\ngenerate_node b\n"
            await at.press("ctrl+z")
            assert at.editor.text == b"load   a  as b\n\n\n\ngenerate_node   b"

    @pytest.mark.parametrize(
        ("script", "text", "said"),
        [
            # What is said of a file that is kept names it.
            ("sed -i \"s/'talker/'me/\" $1", PROGRAM.replace("'talker", "'me"), ""),
            ("printf 'a\\r\\nb' > $1", "a\r\nb", ""),
            ("true", PROGRAM, ""),
            ("exit 3", PROGRAM, "ended with status 3; the text is as it was"),
            ("echo oops > $1; exit 3", PROGRAM, "the text is as it was; what you wrote is"),
            ("rm $1; exit 3", PROGRAM, "ended with status 3; the text is as it was"),
            ("rm $1", PROGRAM, "`program.plastron` is gone; the text is as it was"),
            ("kill -9 $$", PROGRAM, "was ended by SIGKILL; the text is as it was"),
            (
                "printf 'caf\\351' > $1",
                PROGRAM,
                "the file is not UTF-8 (line 1); what you wrote is",
            ),
            ("truncate -s 17M $1", PROGRAM, "larger than 16 MB; what you wrote is"),
            ("rm $1; mkdir $1", PROGRAM, "cannot be read: is a directory; what you wrote is"),
        ],
    )
    async def test_an_editor_of_the_users(
        self,
        script: str,
        text: str,
        said: str,
        tmp_path: Path,
        monkeypatch: pytest.MonkeyPatch,
    ) -> None:
        editor, left = tmp_path / "an editor", tmp_path / "left"
        left.mkdir()
        editor.write_text(f"#!/bin/sh\n{script}\n")
        editor.chmod(0o755)
        monkeypatch.setenv("VISUAL", f"'{editor}'")
        monkeypatch.setattr(tempfile, "tempdir", str(left))
        async with editing(PROGRAM) as at:
            monkeypatch.setattr(at.app, "suspend", nullcontext)
            await at.press("ctrl+e")
            assert at.editor.text.decode() == text
            assert said in "".join(at.app.said)
            assert bool(said) == bool(at.app.said)
            await at.press("ctrl+z")
            assert at.editor.text.decode() == PROGRAM
            kept = list(left.glob("*/*"))
            assert len(kept) == ("what you wrote is" in said)
            assert all(str(file) in at.app.said[0] for file in kept)

    async def test_an_editor_that_is_not_there_is_said(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("EDITOR", "/nowhere/editor -x")
        async with editing("abc") as at:
            monkeypatch.setattr(at.app, "suspend", nullcontext)
            await at.press("ctrl+e")
            assert at.app.said == ["`/nowhere/editor` cannot be started: no such file or directory"]

    def test_the_system_has_an_editor_where_nobody_names_one(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.undo()
        for name in ("vi", "nano"):
            tmp_path.joinpath(name).write_text("#!/bin/sh\n")
            tmp_path.joinpath(name).chmod(0o755)
        environ = {"PATH": str(tmp_path), "VISUAL": " "}
        assert external_editor(environ) == [str(tmp_path / "nano")]
        assert external_editor({**environ, "EDITOR": "ed -x"}) == ["ed", "-x"]
        assert external_editor({"PATH": ""}) == NO_EDITOR
        told = external_editor({**environ, "EDITOR": "code 'x"})
        assert told == "$EDITOR is `code 'x`, where a quote is not closed"

    async def test_without_an_editor_it_says_so(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.delenv("VISUAL", raising=False)
        monkeypatch.delenv("EDITOR", raising=False)
        monkeypatch.setenv("PATH", str(Path(__file__).parent))
        async with editing("abc") as at:
            await at.press("ctrl+e")
            assert at.app.said == [NO_EDITOR]
