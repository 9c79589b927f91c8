"""What holds for an agent whatever it hears, senses and is told."""

from __future__ import annotations

from typing import List, Tuple

from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Heard, TaskReport
from rqt_mrta_py.model import Progress
from tests.plugins.mrta_alliance.team import agent, announced, announcements, behaviour_set, motivations, nested, step

TASKS = ("patrol", "inspect", "report")

announcement = st.builds(
    lambda robot, task, age, expected, ahead: (robot, task, age, expected, ahead),
    st.sampled_from(["one", "two", "three", "stranger", ""]),
    st.sampled_from([*TASKS, "unknown"]),
    st.floats(0.0, 5.0),
    st.sampled_from([60.0, 5.0, 0.0, -1.0, float("nan"), 1e9]),
    st.sampled_from([0.0, 5.0, -5.0]),
)
report = st.builds(
    TaskReport,
    st.sampled_from([*TASKS, "unknown"]),
    st.sampled_from(list(Progress)),
    robot=st.sampled_from([None, "one", "two"]),
)
moment = st.tuples(
    st.floats(0.05, 3.0),
    st.lists(announcement, max_size=3),
    st.lists(report, max_size=1),
    st.lists(st.sampled_from(TASKS), max_size=2),
)


def messages(spoken: List[Tuple], now: float) -> List[Heard]:
    return [
        announced(robot, task, now - age, expected, max(0.0, now - age + ahead))
        for robot, task, age, expected, ahead in spoken
    ]


@settings(max_examples=60, deadline=None)
@given(st.lists(moment, max_size=60))
def test_agent_keeps_its_bounds_whatever_happens(moments: list) -> None:
    """At most one active set, motivation in [0, theta], inapplicable implies inactive, announced is what is done."""
    told = nested(behaviour_set("patrol", 10.0), behaviour_set("inspect", 7.5), behaviour_set("report", 5.0))
    one = agent("one", told, TASKS)
    now = 0.0
    for passed, spoken, reports, impossible in moments:
        now += passed
        decision = step(one, now, messages(spoken, now), reports=reports, impossible=impossible)
        said = motivations(decision)
        active = [task for task, fields in said.items() if fields["active"]]
        assert active == ([decision.task] if decision.task else [])
        for fields in said.values():
            assert 0.0 <= fields["motivation"] <= fields["threshold"]
            assert fields["active"] == (fields["motivation"] == fields["threshold"])
            assert fields["applicable"] or not fields["active"]
            assert 0.0 < fields["impatience"] <= 10.0
        for message in announcements(decision):
            assert message.fields["task_id"] == decision.task
            assert message.fields["expected_duration"] > 0.0


@settings(max_examples=20, deadline=None)
@given(st.lists(moment, max_size=30))
def test_equal_stories_lead_to_equal_decisions(moments: list) -> None:
    def tell() -> list:
        one = agent("one", nested(behaviour_set("patrol", 10.0), behaviour_set("inspect", 7.5)), TASKS)
        now, decisions = 0.0, []
        for passed, spoken, reports, impossible in moments:
            now += passed
            decisions.append(step(one, now, messages(spoken, now), reports=reports, impossible=impossible))
        return decisions

    assert tell() == tell()
