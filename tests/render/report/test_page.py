from __future__ import annotations

import re
from dataclasses import replace
from html.parser import HTMLParser
from typing import Dict, List, Optional, Tuple

import pytest

from rqt_mrta_py.model import CommunicationGraph, Flow, TaskInterval, TaskRecord, TaskState
from rqt_mrta_py.render.report import ReportInput, report_html
from tests.render.report.missions import empty_mission, hostile_mission, usual_mission

MISSIONS = {"usual": usual_mission, "hostile": hostile_mission, "empty": empty_mission}
VOID = {"br", "col", "hr", "img", "input", "link", "meta"}


class Reader(HTMLParser):
    """Collects elements, and holds that each is closed where it should be."""

    def __init__(self) -> None:
        super().__init__()
        self.open: List[str] = []
        self.elements: List[Tuple[str, Dict[str, Optional[str]]]] = []

    def handle_starttag(self, tag: str, attrs: List[Tuple[str, Optional[str]]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def read(text: str) -> Reader:
    reader = Reader()
    reader.feed(text)
    reader.close()
    assert not reader.open
    return reader


@pytest.fixture(params=sorted(MISSIONS))
def given(request: pytest.FixtureRequest) -> ReportInput:
    return MISSIONS[request.param]()


def test_the_page_is_whole_and_asks_for_nothing(given: ReportInput) -> None:
    reader = read(report_html(given))
    tags = [tag for tag, _ in reader.elements]
    assert tags.count("script") == 2
    assert not {"img", "iframe", "link", "object", "form", "base"} & set(tags)
    for _, attributes in reader.elements:
        assert not [name for name in attributes if name.startswith("on") or name in ("src", "style", "srcset")]
        assert (attributes.get("href") or "#").startswith("#")


def test_ids_are_unique_and_links_lead_somewhere(given: ReportInput) -> None:
    reader = read(report_html(given))
    ids = [attributes["id"] for _, attributes in reader.elements if "id" in attributes]
    assert len(ids) == len(set(ids))
    links = {attributes["href"] for tag, attributes in reader.elements if tag == "a"}
    assert {link for link in links if not re.match(r"#t=-?[0-9.]+(&incident=\d+)?$", str(link))} <= {
        f"#{i}" for i in ids
    }


def test_equal_missions_give_equal_pages(given: ReportInput) -> None:
    assert report_html(given) == report_html(given)


def test_an_incident_is_told_with_its_cause_and_its_evidence() -> None:
    text = report_html(usual_mission())
    assert "robot3 fell silent while it held border_protection, last heard at 60.0 s" in text
    assert "Usual cause: </b>The robot was switched off, its program died, or the radio failed." in text
    assert '<a href="#t=60.000&amp;incident=1" class="when">60.0 s</a>' in text
    assert "<code>/alliance/inter_robot_communication</code> message 337" in text


def test_figures_stand_with_what_they_are_told_of() -> None:
    text = report_html(usual_mission())
    assert "messages per allocation" in text
    assert re.search(r'<th scope="col" class="number">utilisation</th>', text)
    assert "<dd>review</dd>" not in text
    assert "mrta review" in text
    assert "mission.bag: 12,345 messages, 2.3 MB" in text


def test_figures_of_a_build_are_explained_and_small_ones_not_rounded_away() -> None:
    """Errors of a third of a millimetre were told as 0.00, of nothing."""
    usual = usual_mission()
    build = {"placed": 14, "mean_error": 0.000349409, "max_height_error": 0.0}
    record = replace(usual.view.record, statistics={**usual.view.record.statistics, "build": build})
    text = report_html(replace(usual, view=replace(usual.view, record=record)))
    told = "<dd>placed 14, mean error 0.00035, max height error 0.00<small>blocks, how many of them lie right"
    assert told in text


def test_parameters_that_differ_name_their_robots() -> None:
    text = report_html(usual_mission())
    assert "<code>broadcast_rate</code></th><td>5.00</td>" in text
    assert "1 (robot1); 2 (robot2)" in text


def test_time_on_connections_is_told_where_somebody_measured() -> None:
    text = report_html(usual_mission())
    # 2.1 ms of offset, a drift of a millionth, ahead by at least 1.5 ms.
    assert '<td class="number">2.1</td><td class="number">1</td><td class="number">1.5</td>' in text
    assert '<a href="#t=20.000" class="when">20.0 s</a> for 0.3 s' in text
    assert 'id="clocks"' in text
    assert 'id="clocks"' not in report_html(replace(usual_mission(), clocks=None))


@pytest.mark.parametrize(
    ("start", "date"),
    [
        (1_795_407_306.474, "2026-11-23 04:15:06 to 2026-11-23 04:16:46 UTC"),
        (1e15, "1000000000000000 s after 1970-01-01 to 1000000000000100 s after 1970-01-01 UTC"),
        (1.0, None),
    ],
    ids=["wall clock", "past the calendar", "simulated"],
)
def test_a_clock_that_counts_from_1970_is_told_as_a_date(start: float, date: Optional[str]) -> None:
    given = usual_mission()
    record = replace(given.view.record, start=start, end=start + 100.0)
    text = report_html(replace(given, view=replace(given.view, record=record)))
    assert ("<dt>date</dt>" in text) == (date is not None)
    assert date is None or f"<dt>date</dt><dd>{date}" in text


def test_the_first_tiles_are_read_as_words() -> None:
    given = usual_mission()
    record = given.view.record
    tasks = tuple(
        TaskRecord(f"task{number}", (TaskInterval(state, 0.0, 9.0),))
        for number, state in enumerate((TaskState.DONE, TaskState.WAITING, TaskState.DONE))
    )
    few = replace(record, robots=record.robots[:1], tasks=tasks, allocations=record.allocations[:1])
    text = report_html(replace(given, view=replace(given.view, record=few)))
    for number, words in (("1", "robot"), ("2 of 3", "tasks done"), ("1", "allocation")):
        assert f'<b>{number}</b><span class="name">{words}</span>' in text
    assert '<b>5</b><span class="name">robots</span>' in report_html(given)


def test_nodes_and_topics_are_counted_in_words() -> None:
    said = CommunicationGraph((Flow("/yard", "/state", "std_msgs/String", 3, 1.0),))
    assert "1 node, 1 topic; a bag" in report_html(replace(usual_mission(), communication=said))
    assert "5 nodes, 2 topics; a bag" in report_html(usual_mission())


def test_a_task_that_somebody_asked_about_is_explained() -> None:
    text = report_html(usual_mission())
    section = text[text.index('id="why"') : text.index('id="statistics"')]
    assert '<th scope="row">no</th><td>robot2</td><td>lacks range_finder</td>' in section
    assert "when it was taken: robot1 idle" in section
    assert '<a href="#t=60.000" class="when">60.0 s</a>' in section
    assert "motivation reached the threshold 30" in section
    assert section.count("<details") == section.count('<details class="why" open>') == 1


def test_tasks_that_nobody_asked_about_are_not_explained() -> None:
    text = report_html(replace(usual_mission(), explanations=()))
    assert 'id="why"' not in text
    assert 'href="#why"' not in text


def test_of_many_tasks_and_grounds_as_many_are_explained_as_a_page_has_room_for() -> None:
    usual = usual_mission()
    (task,) = usual.explanations
    many = replace(task, grounds=task.grounds * 5000)
    text = report_html(replace(usual, explanations=(many,) * 250))
    assert text.count('<details class="why"') == 200
    assert text.count("9990 more in why.json") == 200
    assert "50 more are in why.json" in text


def test_a_mission_of_nothing_says_so() -> None:
    text = report_html(empty_mission())
    assert "No robot is known." in text
    assert "nothing was heard" in text
