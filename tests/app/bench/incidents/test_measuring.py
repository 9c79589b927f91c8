"""``mrta bench incidents``: what it takes, and what it tells."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Tuple

import pytest

from rqt_mrta_py.app.bench.incidents.faults import RULES
from rqt_mrta_py.app.bench.incidents.measuring import PROOF_SEED
from rqt_mrta_py.app.cli.main import main


def test_a_quick_measurement_tells_rules_faults_and_nothing_wrong(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two faults are for each of the two rules, one of them a cheap one under ALLIANCE, and each is told of."""
    asked = ["--rules", "unknown_robot,unknown_task"]
    assert main(["bench", "incidents", "--quick", "--tuning", *asked, "--out", str(tmp_path / "out"), "-q"]) == 0

    document = json.loads((tmp_path / "out" / "bench.json").read_text())
    rules, faults = document["tables"]
    assert rules["title"].endswith("seeds from 101")
    assert [dict(zip(rules["columns"], row)) for row in rules["rows"]] == [
        {
            "rule": rule,
            "faulty": 2,
            "clean": 1,
            "found": 2,
            "missed": 0,
            "false alarms": 0,
            "followed": 0,
            "recall": 1.0,
            "precision": 1.0,
        }
        for rule in ("unknown_robot", "unknown_task")
    ]
    assert [row[2:5] for row in faults["rows"]] == [
        ["unknown_robot", 1, 1],
        ["unknown_robot", 1, 1],
        ["unknown_task", 1, 1],
        ["unknown_task", 1, 1],
    ]
    assert "## The faults" in (tmp_path / "out" / "tables.md").read_text()
    assert capsys.readouterr().out.startswith("Incidents found in 5 missions, seeds from 101\n")


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (
            ("--rules", "topic_gab"),
            "argument --rules: 'topic_gab': no fault is for such a rule; nearest is 'topic_gap'",
        ),
        (("--seeds", "0"), "argument --seeds: '0': a whole number from 1 to 1000 is expected"),
        (("--seeds", "many"), "argument --seeds: 'many': a whole number from 1 to 1000 is expected"),
    ],
)
def test_wrong_arguments_are_told(
    arguments: Tuple[str, ...], complaint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        status = main(["bench", "incidents", *arguments])
    except SystemExit as stop:
        status = int(stop.code or 0)
    assert status == 2
    assert complaint in capsys.readouterr().err


def test_the_page_names_every_rule_and_the_first_seeds(root: Path) -> None:
    page = (root / "docs" / "incidents.md").read_text()
    proved = page.split("## How well rules find faults")[1].split("\n## ")[0]
    assert [rule for rule in RULES if f"`{rule}`" not in proved] == []
    assert str(PROOF_SEED) in proved
