"""Whole teams under the template's default parameters, and what goes over the wire."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any, Dict, Sequence

import pytest

from rqt_mrta_py.hooks import Outgoing
from tests.plugins.mrta_alliance.team import Team, agent, announced, behaviour_set, motivations, nested, step


def by_default(tasks: Sequence[str], head_start: float = 0.5) -> Dict[str, Any]:
    """Give what the template fills in for an application that says nothing; what is left out is the same."""
    sets = [{"task_id": task, "motivational_behaviour": {"impatience": {"head_start": head_start}}} for task in tasks]
    return {"behaviour_sets": {f"behaviour_set{index}": each for index, each in enumerate(sets)}}


def team_of(robots: int, tasks: int, head_start: float = 0.5) -> Team:
    names = [f"robot{number}" for number in range(robots)]
    kinds = [f"task{number}" for number in range(tasks)]
    return Team({name: agent(name, by_default(kinds, head_start), kinds, names) for name in names}, kinds)


@pytest.mark.parametrize(("robots", "tasks"), [(1, 1), (1, 3), (2, 2), (2, 5), (3, 3), (5, 3), (8, 4), (10, 10)])
def test_equal_robots_share_out_their_tasks_under_default_parameters(robots: int, tasks: int) -> None:
    """After 20 s every robot that can have a task of its own has one, and for a minute it stays so."""
    team = team_of(robots, tasks)
    team.step_to(100)
    first = team.holders()
    assert sum(len(holders) for holders in first.values()) == min(robots, tasks)
    assert max(len(holders) for holders in first.values()) == 1
    for cycle in range(101, 400):
        team.step_to(cycle)
        assert team.holders() == first


def test_equal_robots_without_a_head_start_decide_alike_for_ever() -> None:
    """Why there is a head start: in lockstep the equations alone tell equal robots nothing to differ by."""
    team = team_of(2, 1, head_start=0.0)
    for cycle in range(1, 600):
        decisions = team.step_to(cycle)
        assert decisions["robot0"].task == decisions["robot1"].task


def test_head_start_quickens_fast_and_slow_rate_by_place_in_the_team() -> None:
    """Seniority 1, 1/2, 0 of three: times 1.5, 1.25, 1. Fast rate 2; slow rate 30 / 60 = 0.5 once robot9 is heard."""
    team = ("robot0", "robot1", "robot2")
    told = nested(behaviour_set("patrol", impatience={"fast_rate": 2.0, "head_start": 0.5}))
    growths = []
    for robot in (*team, "stranger"):
        one = agent(robot, told, ["patrol"], team)
        alone = motivations(step(one, 1.0))["patrol"]["impatience"]
        heard = motivations(step(one, 1.2, [announced("robot9", "patrol", 1.2)]))["patrol"]["impatience"]
        growths.append((alone, heard))
    assert growths == [(3.0, 0.75), (2.5, 0.625), (2.0, 0.5), (2.0, 0.5)]


def test_default_team_replaces_a_silent_robot_in_time() -> None:
    """Within tau + theta / (fast rate x spin rate) + one cycle = 3 + 6 + 0.2 s, whichever robot falls silent."""
    for robot in ("robot0", "robot1", "robot2"):
        team = team_of(5, 3)
        (task,) = (task for task, holders in team.step_to(150) and team.holders().items() if robot in holders)
        team.stopped.append(robot)
        team.step_to(150 + 46)
        assert len(team.holders()[task]) == 1


FIELD = re.compile(r"^\s*([\w/\[\]]+)\s+(\w+)\s*(?:#.*)?$")


def declared(root: Path, type_name: str) -> Sequence[str]:
    package, name = type_name.split("/")
    text = (root / "plugins" / "messages" / package / "msg" / f"{name}.msg").read_text(encoding="utf-8")
    return [match.group(2) for match in map(FIELD.match, text.splitlines()) if match]


def test_every_message_fills_every_field_of_its_type_in_order(root: Path) -> None:
    one = agent("one", nested(behaviour_set("patrol", 29.0)), ["patrol"])
    step(one, 1.0)
    messages: Dict[str, Outgoing] = {message.topic: message for message in step(one, 1.2).messages}
    assert {topic: message.type for topic, message in messages.items()} == {
        "alliance/motivation/patrol": "alliance_msgs/Motivation",
        "alliance/time_to_activation": "mrta_alliance_msgs/TimeToActivation",
        "alliance/sensory_feedback": "alliance_msgs/SensoryFeedback",
        "/alliance/inter_robot_communication": "alliance_msgs/InterRobotCommunication",
    }
    for message in messages.values():
        assert list(message.fields) == list(declared(root, message.type))
        assert message.fields["header"] == {"stamp": 1.2, "frame_id": "/one"}


def test_motivation_message_says_what_moved_the_set() -> None:
    one = agent("one", nested(behaviour_set("patrol", 1.5), behaviour_set("inspect", 1.0)), ["patrol", "inspect"])
    (message,) = (m for m in step(one, 1.0).messages if m.topic == "alliance/motivation/inspect")
    assert message.fields == {
        "header": {"stamp": 1.0, "frame_id": "/one"},
        "task_id": "inspect",
        "impatience": 1.0,
        "acquiescent": False,
        "suppressed": False,
        "resetted": False,
        "applicable": True,
        "motivation": 1.0,
        "threshold": 30.0,
        "active": False,
    }


def test_agent_says_motivations_times_feedback_then_its_announcement() -> None:
    one = agent("one", nested(behaviour_set("patrol", 29.0), behaviour_set("inspect", 1.0)), ["patrol", "inspect"])
    step(one, 1.0)
    assert [message.topic for message in step(one, 1.2).messages] == [
        "alliance/motivation/patrol",
        "alliance/motivation/inspect",
        "alliance/time_to_activation",
        "alliance/sensory_feedback",
        "alliance/sensory_feedback",
        "/alliance/inter_robot_communication",
    ]


def test_time_to_activation_is_told_for_every_set_in_file_order() -> None:
    """After one cycle patrol has 28.5 of 30 to go by 1.5 x 5 a second; inspect is not applicable."""
    told = nested(behaviour_set("patrol", 1.5), behaviour_set("inspect"))
    one = agent("one", told, ["patrol", "inspect"])
    (message,) = (m for m in step(one, 1.0, impossible=["inspect"]).messages if m.topic.endswith("time_to_activation"))
    assert message.fields["task_ids"] == ["patrol", "inspect"]
    assert message.fields["seconds"][0] == pytest.approx(3.8)
    assert math.isnan(message.fields["seconds"][1])


def test_time_to_activation_comes_true_while_impatience_stays() -> None:
    one = agent("one", nested(behaviour_set("patrol", 0.7)), ["patrol"])
    promised = []
    while True:
        now = 1.0 + 0.2 * len(promised)
        decision = step(one, now)
        (message,) = (m for m in decision.messages if m.topic.endswith("time_to_activation"))
        promised.append(now + message.fields["seconds"][0])
        if decision.task:
            break
    assert message.fields["seconds"] == [0.0]
    assert all(now - 0.2 <= time <= now + 1e-9 for time in promised)
