from __future__ import annotations

import json
import re
from html import unescape
from typing import Any, Dict

from tests.app.outputs import Outputs


def told(outputs: Outputs) -> Dict[str, Any]:
    """Give what the page's script draws from."""
    text = (outputs.folder / "report.html").read_text(encoding="utf-8")
    found = re.search(r'<script type="application/json" id="mission-data">(.*?)</script>', text)
    assert found is not None
    document: Dict[str, Any] = json.loads(found.group(1))
    return document


def words(outputs: Outputs) -> str:
    text = (outputs.folder / "report.html").read_text(encoding="utf-8")
    return unescape(re.sub(r"<[^>]*>", " ", text[text.index("<main>") : text.index("</main>")]))


def test_a_run_and_the_review_of_its_bag_tell_the_same(patrol: Outputs, patrol_review: Outputs) -> None:
    run, review = told(patrol), told(patrol_review)
    assert run == review
    assert [robot["id"] for robot in run["robots"]] == [f"robot{number}" for number in range(1, 6)]
    assert all(robot["track"] for robot in run["robots"])
    assert [panel["title"] for panel in run["panels"]] == ["Motivation / threshold"]


def test_incidents_of_the_summary_stand_on_the_page(patrol: Outputs) -> None:
    page = words(patrol)
    assert patrol.summary["incidents"]
    for incident in patrol.summary["incidents"]:
        assert incident["text"] in page


def test_the_page_says_where_it_comes_from(patrol: Outputs, patrol_review: Outputs) -> None:
    assert "mrta run" in words(patrol)
    assert "mrta review" in words(patrol_review)
    for outputs in (patrol, patrol_review):
        assert "mission.bag" in words(outputs)
        assert "/<robot>/agent" in words(outputs)
        assert "fairness" in words(outputs)
