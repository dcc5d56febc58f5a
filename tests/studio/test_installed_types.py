from __future__ import annotations

from types import SimpleNamespace

import pytest

from plastron_tui.session import Options
from plastron_tui.studio import app


def test_the_studio_wants_to_know_what_is_not_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    given: list[Options] = []

    def studio(path: object, options: Options, *_: object) -> SimpleNamespace:
        given.append(options)
        config = SimpleNamespace(config=SimpleNamespace(mouse=False))
        return SimpleNamespace(profile=config, run=lambda mouse: None, last_words="", return_code=0)

    monkeypatch.setattr(app, "StudioApp", studio)
    assert app.run(None) == app.run(None, Options("rospy")) == 0
    assert given == [Options(tells_absent=True), Options("rospy", tells_absent=True)]
