"""What is found, as other programs take it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from pydantic_sarif.model import StaticAnalysisResultsFormatSarifVersion210JsonSchema as SarifLog

from plastron_tui.diagnostics import Code, Diagnostic, Edit, Fix, Label, LineIndex, Severity, Span
from plastron_tui.diagnostics.github import as_annotation
from plastron_tui.diagnostics.sarif import RuleText, as_sarif

FIRST = Code("RC901", "It is wrong.", severity=Severity.WARNING)
OTHER = Code("other-code", "It is not right.")
ROOT = Path("/a b/ws")
FILE = ROOT / "p" / "ä%.py"
TEXT = "x = 'ä🤖'\r\ny = 1\n".encode()


def _lines(file: Path | None) -> LineIndex | None:
    return LineIndex(TEXT) if file == FILE else None


def _found() -> list[Diagnostic]:
    fix = Fix("mend it", (Edit(Span(0, 1), "z\n"), Edit(Span(14, 15), "")))
    labels = (Label(Span(14, 15), "the other one"), Label(Span(0, 1), "far away", Path("/c/d.py")))
    return [
        Diagnostic(FIRST, "it is `wrong`", Span(4, 12), FILE, "write it right", fix, labels),
        Diagnostic(OTHER, "of the whole file", None, FILE),
        Diagnostic(OTHER, "of no file"),
        Diagnostic(OTHER, "of a file elsewhere", Span(3, 4), Path("/c/d.py")),
    ]


def _log(found: list[Diagnostic]) -> dict[str, Any]:
    rules = {FIRST: RuleText("first-rule", "Things break.")}
    return as_sarif(found, _lines, ROOT, "1.2.3", rules)


@pytest.mark.parametrize("count", range(5))
def test_sarif_is_as_its_schema_says(count: int) -> None:
    log = _log(_found()[:count])
    assert len(SarifLog.model_validate(log).runs[0].results) == count
    log["runs"][0]["results"].append({"rule": "x"})
    with pytest.raises(ValueError, match="rule"):
        SarifLog.model_validate(log)


def test_what_sarif_says() -> None:
    (run,) = _log(_found())["runs"]
    rules = run["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == ["RC901", "other-code"]
    first, whole, nowhere, elsewhere = run["results"]
    for result in run["results"]:
        assert rules[result["ruleIndex"]]["id"] == result["ruleId"]
    assert first["level"] == "warning"
    assert first["message"]["text"] == "it is `wrong`; write it right"
    (place,) = first["locations"]
    assert place["physicalLocation"] == {
        "artifactLocation": {"uri": "p/%C3%A4%25.py", "uriBaseId": "ROOT"},
        # Columns count code points.
        "region": {"startLine": 1, "startColumn": 5, "endLine": 1, "endColumn": 9},
    }
    assert run["originalUriBaseIds"]["ROOT"]["uri"] == "file:///a%20b/ws/"
    assert [each["message"]["text"] for each in first["relatedLocations"]] == [
        "the other one",
        "far away",
    ]
    (change,) = first["fixes"][0]["artifactChanges"]
    assert [each["insertedContent"]["text"] for each in change["replacements"]] == ["z\n", ""]
    assert "region" not in whole["locations"][0]["physicalLocation"]
    assert "locations" not in nowhere
    uri = elsewhere["locations"][0]["physicalLocation"]["artifactLocation"]
    assert uri == {"uri": "file:///c/d.py"}


def test_sarif_names_a_file_byte_by_byte() -> None:
    """A name of Linux need not be UTF-8."""
    found = Diagnostic(OTHER, "of a file", file=ROOT / "caf\udce9" / "b:c.py")
    rules = {OTHER: RuleText("other-rule", "Things break.")}
    (run,) = as_sarif([found], _lines, Path("/a\udce9"), "1.2.3", rules)["runs"]
    uri = run["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]
    assert uri == {"uri": "file:///a%20b/ws/caf%E9/b%3Ac.py"}
    assert run["originalUriBaseIds"]["ROOT"]["uri"] == "file:///a%E9/"


@pytest.mark.parametrize(
    ("found", "line"),
    [
        (
            _found()[0],
            "::warning title=plastron lint (RC901),file=p/ä%25.py,line=1,endLine=1,"
            "col=5,endColumn=9::it is `wrong`; write it right",
        ),
        (_found()[1], "::error title=plastron lint (other-code),file=p/ä%25.py::of the whole file"),
        (_found()[2], "::error title=plastron lint (other-code)::of no file"),
        (
            Diagnostic(OTHER, "a\n::error::b%\x1b[2J", file=ROOT / "a,b:c\n.py"),
            "::error title=plastron lint (other-code),file=a%2Cb%3Ac%0A.py::"
            r"a\n::error::b%25\x1b[2J",
        ),
        # A space of another script stays, for GitHub to find the file; so it does in SARIF.
        (
            Diagnostic(OTHER, "a", file=ROOT / "a\udcff\u3000\x1b[31m\u202e\r.py"),
            r"::error title=plastron lint (other-code),file=a\udcff"
            "\u3000"
            r"\x1b[31m\u202e%0D.py::a",
        ),
        # Columns are of one line.
        (
            Diagnostic(OTHER, "a", Span(4, 15), FILE),
            "::error title=plastron lint (other-code),file=p/ä%25.py,line=1,endLine=2::a",
        ),
    ],
)
def test_github_annotation(found: Diagnostic, line: str) -> None:
    assert as_annotation(found, _lines, ROOT) == line
